/** The flight in real time: play, pause, step. */

import { type Scene } from "../model/model.ts";
import { short } from "../model/numbers.ts";
import { type Store } from "../model/state.ts";
import { byId, setAttribute, setText, setValue } from "./dom.ts";

/** Parts of the flight that a step takes, and that motion reduced to steps takes each half second. */
const STEPS = 40;
const REDUCED_STEPS = 12;

export class Player {
  readonly #store: Store;
  readonly #button = byId<HTMLButtonElement>("play");
  readonly #slider = byId<HTMLInputElement>("time-slider");
  readonly #output = byId<HTMLOutputElement>("time-output");
  #flight = 0;
  #time = 0;
  #playing = false;
  #last = 0;

  constructor(store: Store) {
    this.#store = store;
    this.#button.addEventListener("click", () => (this.#playing ? this.pause() : this.#play()));
    byId("step-back").addEventListener("click", () => this.#step(-1));
    byId("step-on").addEventListener("click", () => this.#step(1));
    this.#slider.addEventListener("input", () => {
      this.pause();
      store.change({ time: (this.#flight * Number(this.#slider.value)) / Number(this.#slider.max) });
    });
  }

  show({ scales, time, flightTime }: Scene): void {
    this.#flight = flightTime * scales.time;
    this.#time = time * scales.time;
    const position = String(Math.round((Number(this.#slider.max) * time) / (flightTime || 1)));
    setValue(this.#slider, position);
    setAttribute(this.#slider, "aria-valuetext", `${short(this.#time, 4)} seconds`);
    setText(this.#output, `${short(this.#time, 4)} s`);
  }

  pause(): void {
    this.#playing = false;
    setText(this.#button, "Play");
    this.#button.setAttribute("aria-pressed", "false");
  }

  #play(): void {
    this.#playing = true;
    setText(this.#button, "Pause");
    this.#button.setAttribute("aria-pressed", "true");
    if (this.#time >= this.#flight) this.#store.change({ time: 0 });
    this.#last = performance.now();
    requestAnimationFrame((now) => this.#frame(now));
  }

  #frame(now: number): void {
    if (!this.#playing) return;
    const reduced = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const passed = (now - this.#last) / 1000;
    if (!reduced) {
      this.#last = now;
      this.#go(this.#time + Math.max(0, passed));
    } else if (passed >= 0.5) {
      this.#last = now;
      this.#go(this.#time + this.#flight / REDUCED_STEPS);
    }
    if (this.#playing) requestAnimationFrame((then) => this.#frame(then));
  }

  #step(by: number): void {
    this.pause();
    this.#go(this.#time + (by * this.#flight) / STEPS);
  }

  #go(time: number): void {
    this.#store.change({ time: Math.min(this.#flight, Math.max(0, time)) });
    if (time >= this.#flight) this.pause();
  }
}

/** The numbers of the current shot: six figures, or every digit. */

import { type Scene } from "../model/model.ts";
import { degrees, exact, lengthUnit, short } from "../model/numbers.ts";
import { byId, setText } from "./dom.ts";

export class Readout {
  readonly #box = byId<HTMLInputElement>("all-digits");
  readonly #section = byId("readout");

  constructor(redraw: () => void) {
    this.#box.addEventListener("change", () => {
      this.#section.classList.toggle("digits", this.#box.checked);
      redraw();
    });
  }

  show({ state, scales, apex }: Scene): void {
    const every = this.#box.checked;
    const text = (value: number) => (every ? exact(value) : short(value));
    // In full a length is in metres, so that the digits are those of Python.
    const length = (value: number): string => {
      const [unit, metres] = every ? (["m", 1] as const) : lengthUnit(value);
      return `${text(value / metres)} ${unit}`;
    };
    const values = {
      "launch-angle": `${text(state.angle)}°`,
      elevation: `${text(degrees(apex.elevation))}°`,
      x: length(apex.x * scales.length),
      y: length(apex.y * scales.length),
      distance: length(apex.distance * scales.length),
      curvature: text(apex.curvature),
      time: `${text(apex.time * scales.time)} s`,
    };
    for (const [name, value] of Object.entries(values)) setText(byId(`read-${name}`), value);
  }
}

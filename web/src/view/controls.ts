/** The controls: each shows a part of the state and changes it. */

import { exact, parsed, short } from "../model/numbers.ts";
import { PRESETS } from "../model/presets.ts";
import { DRAG_SCALES, SPEED_SCALE, type LogScale } from "../model/scale.ts";
import { type Scene } from "../model/model.ts";
import {
  dragSaidAs,
  LAYERS,
  MOST_COMPARED,
  type DragKind,
  type Layer,
  type State,
  type Store,
} from "../model/state.ts";
import { byId, lineSample, make, setAttribute, setText, setValue } from "./dom.ts";
import { compareStroke, type Palette } from "./palette.ts";

const DRAG_UNITS: Record<DragKind, string> = { epsilon: "", drag_rate: "1/s", terminal_speed: "m/s" };
const DRAG_NAMES: Record<DragKind, string> = {
  epsilon: "Drag parameter",
  drag_rate: "Drag rate, 1 a second",
  terminal_speed: "Terminal speed, metres a second",
};

/** A number as it stands in a field: the shortest digits that mean it. */
const fieldText = (value: number): string => (value === Infinity ? "∞" : exact(value).replace(/\.0$/, ""));

export class Controls {
  readonly #store: Store;
  readonly #complain: (sentence: string | undefined) => void;
  readonly #showing: ((scene: Scene, colors: Palette) => void)[] = [];

  constructor(store: Store, complain: (sentence: string | undefined) => void) {
    this.#store = store;
    this.#complain = complain;
    this.#preset();
    this.#choice("theme", "theme");
    this.#choice("curvature-by", "curvatureBy");
    this.#drag();
    this.#shot();
    this.#gravity();
    this.#compare();
    this.#layers();
  }

  show(scene: Scene, colors: Palette): void {
    for (const show of this.#showing) show(scene, colors);
  }

  #change(part: Partial<State>): boolean {
    const refused = this.#store.change(part);
    this.#complain(refused);
    return !refused;
  }

  #preset(): void {
    const select = byId<HTMLSelectElement>("preset");
    for (const [key, { name }] of Object.entries(PRESETS)) select.append(make("option", { value: key }, name));
    select.append(make("option", { value: "" }, "own"));
    select.addEventListener("change", () => {
      const preset = PRESETS[select.value];
      if (preset) this.#change({ ...preset.state, theme: this.#store.state.theme });
    });
    this.#showing.push(({ state }) => {
      const found = Object.entries(PRESETS).find(([, preset]) => sameView(preset.state, state));
      if (document.activeElement !== select || found) setValue(select, found?.[0] ?? "");
      setText(byId("about"), found?.[1].about ?? "");
    });
  }

  #choice(id: string, key: "theme" | "curvatureBy"): void {
    const select = byId<HTMLSelectElement>(id);
    select.addEventListener("change", () => this.#change({ [key]: select.value }));
    this.#showing.push(({ state }) => {
      setValue(select, state[key]);
    });
  }

  /** A slider and a field for one number of the state. */
  #number(
    slider: HTMLInputElement | undefined,
    field: HTMLInputElement,
    read: (state: State) => number,
    write: (value: number) => Partial<State>,
    scale?: (state: State) => LogScale,
    spoken: (state: State) => string = (state) => short(read(state)),
  ): void {
    let shown = NaN;
    slider?.addEventListener("input", () => {
      const position = Number(slider.value);
      this.#change(write(scale ? scale(this.#store.state).value(position) : position));
    });
    field.addEventListener("change", () => {
      const value = parsed(field.value);
      const taken = Number.isNaN(value)
        ? (this.#complain(`${field.getAttribute("aria-label")} must be a number, got ${field.value || "nothing"}`), false)
        : this.#change(write(value));
      field.setAttribute("aria-invalid", String(!taken));
    });
    let said = "";
    this.#showing.push(({ state }) => {
      const value = read(state);
      const key = `${value} ${state.dragKind}`;
      if (key === said) return;
      said = key;
      if (slider) {
        const sliding = scale?.(state);
        if (sliding) setAttribute(slider, "max", String(sliding.last));
        setValue(slider, String(sliding ? sliding.position(value) : value));
        setAttribute(slider, "aria-valuetext", spoken(state));
      }
      // What was typed stays until the number itself changes, also where it was refused.
      if (value === shown) return;
      shown = value;
      field.value = fieldText(value);
      field.removeAttribute("aria-invalid");
    });
  }

  #drag(): void {
    const radios = document.querySelectorAll<HTMLInputElement>('input[name="drag-kind"]');
    for (const radio of radios) {
      radio.addEventListener("change", () => {
        const { dragKind, drag } = dragSaidAs(radio.value as DragKind, this.#store.state);
        this.#change({ dragKind, drag });
      });
    }
    const slider = byId<HTMLInputElement>("drag-slider");
    const field = byId<HTMLInputElement>("drag-number");
    this.#number(
      slider,
      field,
      (state) => state.drag,
      (drag) => ({ drag }),
      (state) => DRAG_SCALES[state.dragKind],
      (state) => `${short(state.drag)} ${DRAG_UNITS[state.dragKind]}`.trim(),
    );
    this.#showing.push(({ state, scales }) => {
      for (const radio of radios) radio.checked = radio.value === state.dragKind;
      setText(byId("drag-unit"), DRAG_UNITS[state.dragKind]);
      setAttribute(slider, "aria-label", DRAG_NAMES[state.dragKind]);
      setAttribute(field, "aria-label", `${DRAG_NAMES[state.dragKind]}, as a number`);
      const parts = {
        epsilon: `ε = ${short(scales.epsilon, 4)}`,
        drag_rate: `b = ${short(scales.dragRate, 4)} /s`,
        terminal_speed: `terminal speed ${short(scales.terminalSpeed, 4)} m/s`,
      };
      const others = (Object.keys(parts) as DragKind[]).filter((kind) => kind !== state.dragKind);
      setText(byId("drag-follows"), others.map((kind) => parts[kind]).join(", "));
    });
  }

  #shot(): void {
    const angle = byId<HTMLInputElement>("angle-slider");
    this.#showing.push(({ state }) => setAttribute(angle, "max", state.sides === "both" ? "180" : "90"));
    this.#number(
      angle,
      byId("angle-number"),
      (state) => state.angle,
      (angle) => ({ angle }),
      undefined,
      (state) => `${short(state.angle)} degrees`,
    );
    this.#number(
      byId("speed-slider"),
      byId("speed-number"),
      (state) => state.speed,
      (speed) => ({ speed }),
      () => SPEED_SCALE,
      (state) => `${short(state.speed)} metres a second`,
    );
  }

  #gravity(): void {
    const place = byId<HTMLSelectElement>("gravity-place");
    const field = byId<HTMLInputElement>("gravity-number");
    place.addEventListener("change", () => {
      if (place.value === "own") field.focus();
      else this.#change({ gravity: Number(place.value) });
    });
    this.#number(
      undefined,
      field,
      (state) => state.gravity,
      (gravity) => ({ gravity }),
    );
    this.#showing.push(({ state }) => {
      const known = [...place.options].find((option) => Number(option.value) === state.gravity);
      if (document.activeElement !== place || known) setValue(place, known?.value ?? "own");
    });
  }

  #compare(): void {
    const field = byId<HTMLInputElement>("compare-number");
    const add = (): void => {
      const { compare } = this.#store.state;
      const value = field.value.trim() === "" ? this.#epsilonNow : parsed(field.value);
      if (compare.includes(value)) this.#complain(`ε = ${short(value)} is compared already`);
      else if (this.#change({ compare: [...compare, value] })) field.value = "";
    };
    byId("compare-add").addEventListener("click", add);
    field.addEventListener("keydown", (event) => {
      if (event.key === "Enter") add();
    });
    const list = byId("compare-list");
    let shown = "";
    this.#showing.push(({ state, scales }, colors) => {
      this.#epsilonNow = scales.epsilon;
      byId<HTMLButtonElement>("compare-add").disabled = state.compare.length >= MOST_COMPARED;
      const key = `${state.compare.join(" ")} ${colors.locus}`;
      if (key === shown) return;
      shown = key;
      const items = state.compare.map((epsilon, index) => {
        const button = make(
          "button",
          { type: "button", "aria-label": `Compare no longer with ε = ${short(epsilon)}` },
          lineSample(compareStroke(colors, index)),
          `${short(epsilon, 4)} ×`,
        );
        button.addEventListener("click", () => {
          this.#change({ compare: this.#store.state.compare.filter((other) => other !== epsilon) });
          field.focus();
        });
        return make("li", {}, button);
      });
      list.replaceChildren(...items);
    });
  }

  #epsilonNow = 0;

  #layers(): void {
    const boxes = (Object.keys(LAYERS) as Layer[]).map((layer) => {
      const box = make("input", { type: "checkbox", id: `layer-${layer}` });
      box.addEventListener("change", () => {
        const others = this.#store.state.layers.filter((other) => other !== layer);
        this.#change({ layers: box.checked ? [...others, layer] : others });
      });
      byId("layers").append(make("label", {}, box, LAYERS[layer]));
      return [layer, box] as const;
    });
    const both = byId<HTMLInputElement>("both-sides");
    both.addEventListener("change", () => this.#change({ sides: both.checked ? "both" : "right" }));
    const fit = byId<HTMLInputElement>("fit");
    fit.addEventListener("change", () => this.#change({ frame: fit.checked ? "fit" : "fixed" }));
    this.#showing.push(({ state }) => {
      for (const [layer, box] of boxes) box.checked = state.layers.includes(layer);
      fit.checked = state.frame === "fit";
      both.checked = state.sides === "both";
    });
  }
}

/** Whether two states show the same, whatever the theme and the time. */
function sameView(one: State, other: State): boolean {
  return (Object.keys(one) as (keyof State)[])
    .filter((key) => key !== "theme" && key !== "time")
    .every((key) => {
      const [a, b] = [one[key], other[key]];
      return Array.isArray(a) && Array.isArray(b) ? [...a].sort().join() === [...b].sort().join() : a === b;
    });
}

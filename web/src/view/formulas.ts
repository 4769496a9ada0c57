/** The typeset formulas, with the current numbers in their places and symbols that explain themselves. */

import formulas from "virtual:formulas";
import "katex/dist/katex.css";
import "virtual:formulas.css";
import { type Scene } from "../model/model.ts";
import { degrees, short } from "../model/numbers.ts";
import { byId, make, setText } from "./dom.ts";

const SYMBOLS: Readonly<Record<string, readonly [string, string]>> = {
  alpha: ["α", "launch angle, from the ground up"],
  theta: ["θ", "elevation: the angle at which the launch point sees the apex"],
  epsilon: ["ε", "drag parameter b V₀/g: launch speed over terminal speed"],
  rho: ["ρ", "unit of length, V₀²/g: the longest range without drag"],
  x: ["x", "horizontal distance of the apex from the launch point"],
  y: ["y", "height of the apex above the launch point"],
  r: ["r̃", "distance of the apex from the launch point, in units of ρ; an index θ means a derivative by θ"],
  t: ["t", "time from launch to apex"],
  K: ["K", "curvature of the locus: one over the radius of the circle that fits it best"],
  W: ["W", "Lambert W, the inverse of w ↦ w eʷ; its two real branches meet at −1/e"],
  speed: ["V₀", "launch speed"],
  gravity: ["g", "acceleration of free fall"],
  branch: ["branch", "W₀ where ε² y/ρ is at most 1, W₋₁ beyond; the paper takes W₀ throughout"],
};

export class Formulas {
  readonly #numbers = new Map<string, Element[]>();
  readonly #tooltip = byId("tooltip");
  #visible = true;

  constructor() {
    const list = byId("formula-list");
    for (const { id, equation, title, spoken, general, filled } of formulas) {
      const typeset = make("div", { class: "typeset", role: "group", "aria-label": `${title}: ${spoken}` });
      const first = make("div");
      first.innerHTML = general;
      const second = make("div", { class: "filled" });
      second.innerHTML = filled;
      typeset.append(first, second);
      const heading = make("h3", {}, title, make("span", {}, equation));
      list.append(make("article", { class: "formula", id: `formula-${id}` }, heading, typeset));
      this.#explain(typeset);
    }
    for (const element of list.querySelectorAll(".number")) {
      const name = [...element.classList].find((part) => part.startsWith("number-"))?.slice(7) ?? "";
      this.#numbers.set(name, [...(this.#numbers.get(name) ?? []), element]);
    }
    // Nobody sees the numbers change while they are off the screen.
    new IntersectionObserver(([entry]) => {
      this.#visible = entry?.isIntersecting ?? true;
      if (this.#visible && this.#last) this.show(this.#last);
    }).observe(list);
    document.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.#tooltip.hidden = true;
    });
  }

  #last: Scene | undefined;

  show(scene: Scene): void {
    this.#last = scene;
    if (!this.#visible) return;
    const { state, scales, apex, slopes } = scene;
    const { elevation } = apex;
    const theta = degrees(elevation);
    const values: Record<string, string> = {
      alpha: short(state.angle, 5),
      theta: short(theta, 6),
      epsilon: short(scales.epsilon, 5),
      rho: short(scales.length, 5),
      speed: short(state.speed, 5),
      gravity: short(state.gravity, 6),
      x: short(apex.x * scales.length),
      y: short(apex.y * scales.length),
      t: short(apex.time * scales.time),
      radius: short(apex.distance),
      r: short(apex.distance * scales.length),
      branch: scales.epsilon * scales.epsilon * apex.y <= 1 ? "W₀" : "W₋₁",
      free: short(scene.freeRadius),
      d1: short(slopes[0]),
      d2: short(slopes[1]),
      rhoK: short(apex.curvature),
      K: short(apex.curvature / scales.length),
    };
    for (const [name, elements] of this.#numbers) {
      for (const element of elements) setText(element, values[name] ?? "");
    }
  }

  /** One stop of the Tab key a formula; the arrow keys go from symbol to symbol. */
  #explain(group: HTMLElement): void {
    const symbols = [...group.querySelectorAll<HTMLElement>(".symbol")];
    symbols.forEach((symbol, index) => {
      const name = [...symbol.classList].find((part) => part.startsWith("symbol-"))?.slice(7) ?? "";
      const [sign, meaning] = SYMBOLS[name] ?? ["", ""];
      symbol.tabIndex = index === 0 ? 0 : -1;
      symbol.setAttribute("role", "button");
      symbol.setAttribute("aria-label", `${sign}: ${meaning}`);
      const show = (): void => this.#show(symbol, sign, meaning);
      const hide = (): void => {
        this.#tooltip.hidden = true;
      };
      symbol.addEventListener("pointerenter", show);
      symbol.addEventListener("pointerleave", hide);
      symbol.addEventListener("focus", show);
      symbol.addEventListener("blur", hide);
      symbol.addEventListener("click", show);
      symbol.addEventListener("keydown", (event) => {
        const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
        if (!by) return;
        event.preventDefault();
        symbol.tabIndex = -1;
        const next = symbols[(index + by + symbols.length) % symbols.length];
        next.tabIndex = 0;
        next.focus();
      });
    });
  }

  #show(symbol: HTMLElement, sign: string, meaning: string): void {
    const tooltip = this.#tooltip;
    tooltip.replaceChildren(make("b", {}, sign), ` ${meaning}`);
    tooltip.hidden = false;
    const box = symbol.getBoundingClientRect();
    const left = Math.min(box.left, document.documentElement.clientWidth - tooltip.offsetWidth - 8);
    tooltip.style.left = `${Math.max(8, left) + window.scrollX}px`;
    tooltip.style.top = `${box.bottom + 6 + window.scrollY}px`;
  }
}

/** What can be taken hold of in a chart: a knob that mouse, finger and keys move. */

import { make, setAttribute } from "./dom.ts";

export interface HandleOptions {
  readonly label: string;
  readonly kind: string;
  /** Steps of the arrow keys and of Page Up and Page Down. */
  readonly steps: readonly [number, number];
  /** Moves by some steps' worth, or to an end. */
  readonly move: (by: number) => void;
  readonly end: (which: "first" | "last") => void;
}

/** The place of a knob, which the chart draws: a slider to assistive technology. */
export class Handle {
  readonly element: HTMLElement;

  constructor(parent: HTMLElement, { label, kind, steps, move, end }: HandleOptions) {
    this.element = make("div", {
      class: `handle ${kind}`,
      role: "slider",
      tabindex: "0",
      "aria-label": label,
      "aria-valuemin": "0",
    });
    this.element.addEventListener("keydown", (event) => {
      const by = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
      const page = { PageUp: 1, PageDown: -1 }[event.key];
      if (by) move(by * steps[0]);
      else if (page) move(page * steps[1]);
      else if (event.key === "Home") end("first");
      else if (event.key === "End") end("last");
      else return;
      event.preventDefault();
    });
    // A finger on the knob drags it and does not scroll the page.
    this.element.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
    parent.append(this.element);
  }

  place([x, y]: readonly [number, number], value: number, max: number, text: string): void {
    this.element.style.transform = `translate(${x.toFixed(2)}px,${y.toFixed(2)}px)`;
    setAttribute(this.element, "aria-valuemax", String(max));
    setAttribute(this.element, "aria-valuenow", String(value));
    setAttribute(this.element, "aria-valuetext", text);
  }
}

/**
 * Follows a pointer that is pressed on the plot or on a handle in it, until it is released.
 *
 * A finger on the plot itself scrolls the page; on a handle it drags.
 */
export function follow(
  host: HTMLElement,
  start: (event: PointerEvent) => ((event: PointerEvent) => void) | undefined,
): void {
  host.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    const move = start(event);
    if (!move) return;
    host.setPointerCapture(event.pointerId);
    move(event);
    if (event.pointerType === "mouse") event.preventDefault();
    const handle = event.target instanceof Element ? event.target.closest<HTMLElement>(".handle") : null;
    handle?.focus();
    const stop = (): void => {
      host.removeEventListener("pointermove", move);
      host.removeEventListener("pointerup", stop);
      host.removeEventListener("pointercancel", stop);
    };
    host.addEventListener("pointermove", move);
    host.addEventListener("pointerup", stop);
    host.addEventListener("pointercancel", stop);
  });
}

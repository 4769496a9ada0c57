/** Sliders whose positions are powers of ten, three figures each, with room for 0 or ∞ at an end. */

import { rounded } from "./numbers.ts";

/** Positions a decade. */
const FINE = 100;

export class LogScale {
  readonly #low: number;
  readonly #steps: number;
  /** The value past the lower or the upper end, where there is one. */
  readonly #below: number | undefined;
  readonly #above: number | undefined;

  constructor(low: number, high: number, ends: { below?: number; above?: number } = {}) {
    this.#low = Math.round(Math.log10(low) * FINE);
    this.#steps = Math.round(Math.log10(high) * FINE) - this.#low;
    this.#below = ends.below;
    this.#above = ends.above;
  }

  /** Positions run from 0 to this. */
  get last(): number {
    return this.#steps + (this.#below === undefined ? 0 : 1) + (this.#above === undefined ? 0 : 1);
  }

  value(position: number): number {
    const step = position - (this.#below === undefined ? 0 : 1);
    if (step < 0 && this.#below !== undefined) return this.#below;
    if (step > this.#steps && this.#above !== undefined) return this.#above;
    return rounded(10 ** ((this.#low + step) / FINE), 3);
  }

  /** The position nearest to a value, which may lie between two or beyond the ends. */
  position(value: number): number {
    const first = this.#below === undefined ? 0 : 1;
    if (value === this.#below) return 0;
    if (value === this.#above) return this.last;
    const step = Math.round(Math.log10(value) * FINE) - this.#low;
    return first + Math.min(this.#steps, Math.max(0, step));
  }
}

export const DRAG_SCALES = {
  epsilon: new LogScale(1e-3, 1e3, { below: 0 }),
  drag_rate: new LogScale(1e-3, 1e3, { below: 0 }),
  terminal_speed: new LogScale(1e-2, 1e4, { above: Infinity }),
} as const;

export const SPEED_SCALE = new LogScale(0.1, 1000);

/**
 * Launch angles that deserve a name, each the zero of a condition on the kernels' own values.
 *
 * Along the locus dy/dα = x, so dθ/dα = (x² − y dx/dα)/r². Where the locus is farthest to the right
 * dx/dα = 0, that is x² dα/dθ = r²; where it is farthest from the launcher, x dx/dα = −y x, that is
 * dα/dθ = 1.
 */

import { type Column, type Kernels } from "./kernels.ts";

export const NAMED = {
  range: "longest range",
  curvature: "greatest curvature",
  rightmost: "rightmost apex",
  farthest: "farthest apex",
  receding: "never comes nearer",
} as const;
export type NamedAngle = keyof typeof NAMED;
export type NamedAngles = Readonly<Record<NamedAngle, Float64Array>>;

/** Weights of a central difference of eighth order, and its step in ln α. */
const DIFFERENCE = [4 / 5, -1 / 5, 4 / 105, -1 / 280];
const STEP = 0.002;

/** Solves for some drag parameters at once; in radians. */
export class NamedAngleSolver {
  readonly #kernels: Kernels;
  readonly #epsilon: Column;
  readonly #epsilon0: Column;
  readonly #a: Column;
  readonly #b: Column;
  readonly #c: Column;
  readonly #d: Column;

  constructor(kernels: Kernels, count: number) {
    const room = () => kernels.column(count);
    this.#kernels = kernels;
    this.#epsilon = room();
    this.#epsilon0 = room();
    [this.#a, this.#b, this.#c, this.#d] = [room(), room(), room(), room()];
  }

  solve(epsilons: ArrayLike<number>): NamedAngles {
    this.#epsilon.values.set(epsilons);
    const { functions: f } = this.#kernels;
    f.optimal_angle(this.#epsilon, this.#a);
    return {
      range: this.#a.values.slice(),
      curvature: this.#zero((alpha, out) => this.#bending(alpha, out)),
      rightmost: this.#zero((alpha, out) => {
        const { slope, x, y } = this.#seen(alpha);
        for (let k = 0; k < out.length; k += 1) out[k] = x[k] * x[k] * (slope[k] - 1) - y[k] * y[k];
      }),
      farthest: this.#zero((alpha, out) => {
        const { slope } = this.#seen(alpha);
        for (let k = 0; k < out.length; k += 1) out[k] = slope[k] - 1;
      }),
      receding: this.#receding(),
    };
  }

  /** dα/dθ and the coordinates of the apexes at these launch angles. */
  #seen(alpha: Column): { slope: Float64Array; x: Float64Array; y: Float64Array } {
    const { functions: f } = this.#kernels;
    f.apex_elevation(alpha, this.#epsilon, this.#b);
    f.locus_launch_angle_d1(this.#b, this.#epsilon, this.#c);
    f.apex_x(alpha, this.#epsilon, this.#b);
    f.apex_y(alpha, this.#epsilon, this.#d);
    return { slope: this.#c.values, x: this.#b.values, y: this.#d.values };
  }

  /** The slope of the curvature by ln α, up to a positive factor, from its values near by. */
  #bending(alpha: Column, out: Float64Array): void {
    const { functions: f } = this.#kernels;
    out.fill(0);
    DIFFERENCE.forEach((weight, index) => {
      for (const side of [1, -1]) {
        const factor = 1 + side * (index + 1) * STEP;
        for (let k = 0; k < out.length; k += 1) this.#b.values[k] = alpha.values[k] * factor;
        f.apex_curvature(this.#b, this.#epsilon, this.#c);
        for (let k = 0; k < out.length; k += 1) out[k] += side * weight * this.#c.values[k];
      }
    });
  }

  /** Where a condition, positive for flat shots and negative for steep ones, is zero: bisection. */
  #zero(condition: (alpha: Column, out: Float64Array) => void): Float64Array {
    const epsilons = this.#epsilon.values;
    const low = epsilons.map((epsilon) => 1 / (2 + epsilon));
    // Short of the right angle, so that the difference formula stays inside.
    const high = epsilons.map(() => Math.PI / 2.02);
    const value = new Float64Array(low.length);
    for (let halving = 0; halving < 90; halving += 1) {
      // The geometric mean: strong drag brings the angles down by orders of magnitude.
      for (let k = 0; k < low.length; k += 1) this.#a.values[k] = Math.sqrt(low[k] * high[k]);
      condition(this.#a, value);
      for (let k = 0; k < low.length; k += 1) {
        if (value[k] > 0) low[k] = this.#a.values[k];
        else high[k] = this.#a.values[k];
      }
      if (low.every((bound, k) => high[k] - bound <= 2e-16 * bound)) break;
    }
    return low.map((bound, k) => 0.5 * (bound + high[k]));
  }

  /**
   * The steepest shot that never comes nearer again.
   *
   * At time t all shots lie on a circle of radius R about (0, −C), so the squared distance of one
   * is R² + C² − 2 R C sin α. With R′ = 1 − εR and C′ = R, it stands still where
   * sin α = (R R′ + C R)/(C R′ + R²); the least such value over all times is the answer.
   */
  #receding(): Float64Array {
    const { functions: f } = this.#kernels;
    const epsilons = this.#epsilon.values;
    this.#epsilon0.values.fill(0); // Launch angle 0: the level shot.
    const sine = (times: Float64Array): Float64Array => {
      this.#a.values.set(times);
      f.flight_x(this.#a, this.#epsilon0, this.#epsilon, this.#b);
      f.flight_y(this.#a, this.#epsilon0, this.#epsilon, this.#c);
      return times.map((_, k) => {
        const radius = this.#b.values[k];
        const sunk = -this.#c.values[k];
        const speed = Math.max(0, 1 - epsilons[k] * radius);
        return (radius * speed + sunk * radius) / (sunk * speed + radius * radius);
      });
    };
    const golden = (Math.sqrt(5) - 1) / 2;
    let left = epsilons.map((epsilon) => Math.log(1 / (1 + epsilon)));
    let right = epsilons.map((epsilon) => Math.log((2 * (2 + Math.log1p(epsilon))) / (1 + epsilon)));
    for (let step = 0; step < 45; step += 1) {
      const first = right.map((end, k) => end - golden * (end - left[k]));
      const second = left.map((end, k) => end + golden * (right[k] - end));
      const early = sine(first.map(Math.exp));
      const late = sine(second.map(Math.exp));
      left = left.map((end, k) => (early[k] > late[k] ? first[k] : end));
      right = right.map((end, k) => (early[k] > late[k] ? end : second[k]));
    }
    return sine(left.map((end, k) => Math.exp(0.5 * (end + right[k])))).map(Math.asin);
  }
}

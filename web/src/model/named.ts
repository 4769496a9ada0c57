/**
 * Launch angles that deserve a name, each the zero of a condition on the kernels' own values.
 *
 * The conditions are those of the Python package (named_angles.py), where they are derived: written
 * so that nothing cancels, neither without drag nor under overwhelming drag. That of the greatest
 * curvature is the exception: its formula is long, and the slope of the kernel's own curvature has
 * the same zero. A test holds all of them to Python's.
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

/** Weights of a central difference of eighth order, and its step in ln α: good to 14 figures. */
const DIFFERENCE = [4 / 5, -1 / 5, 4 / 105, -1 / 280];
const STEP = 0.002;
const GOLDEN = (Math.sqrt(5) - 1) / 2;
/** e^{−w} is the power 2^HALVINGS of what is left after that part of w: no digit is lost. */
const HALVINGS = 10;

/** Solves for some drag parameters at once; in radians. */
export class NamedAngleSolver {
  readonly #kernels: Kernels;
  readonly #epsilon: Column;
  /** Stays 0: no drag, or the level shot's launch angle. */
  readonly #zeros: Column;
  readonly #alpha: Column;
  readonly #a: Column;
  readonly #b: Column;
  readonly #c: Column;
  #tolerance = 0;

  constructor(kernels: Kernels, count: number) {
    const room = () => kernels.column(count);
    this.#kernels = kernels;
    [this.#epsilon, this.#zeros, this.#alpha] = [room(), room(), room()];
    [this.#a, this.#b, this.#c] = [room(), room(), room()];
  }

  /** To the last digits, unless a larger relative tolerance is said. */
  solve(epsilons: ArrayLike<number>, tolerance = 2e-16): NamedAngles {
    this.#tolerance = tolerance;
    this.#epsilon.values.set(epsilons);
    const { functions: f } = this.#kernels;
    f.optimal_angle(this.#epsilon, this.#a);
    return {
      range: this.#a.values.slice(),
      curvature: this.#zero((out) => this.#bending(out)),
      rightmost: this.#zero((out) => this.#rightward(out)),
      farthest: this.#zero((out) => this.#outward(out)),
      receding: this.#receding(),
    };
  }

  /** sin²α: without drag the apex stands half of it high. */
  #sineSquared(): Float64Array {
    this.#kernels.functions.apex_y(this.#alpha, this.#zeros, this.#a);
    const squares = this.#a.values;
    for (let k = 0; k < squares.length; k += 1) squares[k] *= 2;
    return squares;
  }

  /** The slope of the curvature by ln α, up to a positive factor, from its values near by. */
  #bending(out: Float64Array): void {
    const alpha = this.#alpha.values;
    const [near, curvature] = [this.#a.values, this.#b.values];
    out.fill(0);
    for (let index = 0; index < DIFFERENCE.length; index += 1) {
      for (const side of [1, -1]) {
        const factor = 1 + side * (index + 1) * STEP;
        for (let k = 0; k < out.length; k += 1) near[k] = alpha[k] * factor;
        this.#kernels.functions.apex_curvature(this.#a, this.#epsilon, this.#b);
        for (let k = 0; k < out.length; k += 1) out[k] += side * DIFFERENCE[index] * curvature[k];
      }
    }
  }

  /** dx/dα, up to a positive factor: 1 − s²(2 + εs). */
  #rightward(out: Float64Array): void {
    const squares = this.#sineSquared();
    const epsilon = this.#epsilon.values;
    for (let k = 0; k < out.length; k += 1) out[k] = 1 - squares[k] * (2 + epsilon[k] * Math.sqrt(squares[k]));
  }

  /** dr/dα, up to a positive factor: 1 + y − s(2 + εs)t. */
  #outward(out: Float64Array): void {
    const { functions: f } = this.#kernels;
    f.apex_time(this.#alpha, this.#epsilon, this.#b);
    f.apex_y(this.#alpha, this.#epsilon, this.#c);
    const [squares, time, height] = [this.#sineSquared(), this.#b.values, this.#c.values];
    const epsilon = this.#epsilon.values;
    for (let k = 0; k < out.length; k += 1) {
      const sine = Math.sqrt(squares[k]);
      out[k] = 1 + height[k] - sine * (2 + epsilon[k] * sine) * time[k];
    }
  }

  /** Where a condition on `#alpha`, positive for flat shots and negative for steep ones, is zero: bisection. */
  #zero(condition: (out: Float64Array) => void): Float64Array {
    const middle = this.#alpha.values;
    const low = this.#epsilon.values.map((epsilon) => 1 / (2 + epsilon));
    // Short of the right angle, so that the difference formula stays inside.
    const high = new Float64Array(low.length).fill(Math.PI / 2.02);
    const value = new Float64Array(low.length);
    let open = true;
    for (let halving = 0; open && halving < 90; halving += 1) {
      open = false;
      // The geometric mean: strong drag brings the angles down by orders of magnitude.
      for (let k = 0; k < low.length; k += 1) middle[k] = Math.sqrt(low[k]) * Math.sqrt(high[k]);
      condition(value);
      for (let k = 0; k < low.length; k += 1) {
        if (value[k] > 0) low[k] = middle[k];
        else high[k] = middle[k];
        open ||= high[k] - low[k] > this.#tolerance * low[k];
      }
    }
    return low.map((bound, k) => 0.5 * (bound + high[k]));
  }

  /**
   * The steepest shot that never comes nearer again.
   *
   * At time t all shots lie on a circle of radius R about (0, −C), so the squared distance of one
   * is R² + C² − 2 R C sin α. With R′ = e^{−εt} and C′ = R, it stands still where
   * sin α = R (R′ + C)/(C R′ + R²); the least such value over all times is the answer.
   */
  #receding(): Float64Array {
    const epsilon = this.#epsilon.values;
    const left = epsilon.map((value) => -Math.log1p(value));
    const right = epsilon.map((value, k) => Math.log(2 * (2 + Math.log1p(value))) + left[k]);
    const sine = new Float64Array(left.length);
    const [early, late] = [new Float64Array(left.length), new Float64Array(left.length)];
    // The least value is flat: its place need only be known to the root of the tolerance.
    for (let step = 0; step < 45 && GOLDEN ** step > Math.sqrt(this.#tolerance) / 10; step += 1) {
      this.#sineAt((k) => right[k] - GOLDEN * (right[k] - left[k]), early);
      this.#sineAt((k) => left[k] + GOLDEN * (right[k] - left[k]), late);
      for (let k = 0; k < left.length; k += 1) {
        if (early[k] > late[k]) left[k] = right[k] - GOLDEN * (right[k] - left[k]);
        else right[k] = left[k] + GOLDEN * (right[k] - left[k]);
      }
    }
    this.#sineAt((k) => 0.5 * (left[k] + right[k]), sine);
    // The angle of this sine by the kernels: a browser's own arcsine may differ in the last digit.
    return this.#zero((out) => {
      const squares = this.#sineSquared();
      for (let k = 0; k < out.length; k += 1) out[k] = sine[k] * sine[k] - squares[k];
    });
  }

  /** sin α of the shot whose distance stands still at a time, given as its logarithm. */
  #sineAt(logarithm: (k: number) => number, out: Float64Array): void {
    const { functions: f } = this.#kernels;
    const epsilon = this.#epsilon.values;
    const time = this.#a.values;
    for (let k = 0; k < out.length; k += 1) time[k] = Math.exp(logarithm(k)) / 2 ** HALVINGS;
    f.flight_x(this.#a, this.#zeros, this.#epsilon, this.#b);
    // What is left of the speed after a small part of the time, from the way that part took.
    const left = this.#b.values.map((way, k) => 1 - epsilon[k] * way);
    for (let k = 0; k < out.length; k += 1) time[k] *= 2 ** HALVINGS;
    f.flight_x(this.#a, this.#zeros, this.#epsilon, this.#b);
    f.flight_y(this.#a, this.#zeros, this.#epsilon, this.#c);
    const [radius, height] = [this.#b.values, this.#c.values];
    for (let k = 0; k < out.length; k += 1) {
      let speed = left[k];
      for (let halving = 0; halving < HALVINGS; halving += 1) speed *= speed;
      const sunk = -height[k];
      out[k] = (radius[k] * (speed + sunk)) / (sunk * speed + radius[k] * radius[k]);
    }
  }
}

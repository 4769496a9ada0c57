/** Trajectories and their envelope, for drawing. Lengths in ρ, times in V₀/g. */

import { columnOf, linspace, type Column, type Kernels } from "./kernels.ts";
import { radians } from "./numbers.ts";

/** Launch angles of the fan, degrees: those of Figure 1. */
export const FAN_ANGLES: readonly number[] = Array.from({ length: 18 }, (_, index) => 5 * (index + 1));

/** Instants that all shots share. */
const INSTANTS = 2000;

/** One shot among the instants it shares with all. */
export interface Flight {
  readonly cosine: number;
  readonly sine: number;
  /** How many instants it is in the air. */
  readonly count: number;
  readonly range: number;
}

/**
 * Flights at any launch angles, from two calls of a kernel for all of them.
 *
 * At a time t all shots are on one circle, whose radius X and height Y the level shot shows: the
 * shot at α is at (X cos α, X sin α + Y). So all share their instants, from launch to the landing of
 * the steepest; half of them before its apex, and denser next to it, where strong drag turns a shot.
 */
export class Instants {
  epsilon = NaN;
  readonly #kernels: Kernels;
  readonly #one: readonly [Column, Column, Column];
  readonly #time: Column;
  readonly #level: Column;
  readonly #epsilon: Column;
  readonly #radius: Column;
  readonly #height: Column;

  constructor(kernels: Kernels) {
    const room = () => kernels.column(INSTANTS);
    this.#kernels = kernels;
    this.#one = [columnOf(kernels, [Math.PI / 2]), kernels.column(1), kernels.column(1)];
    [this.#time, this.#level, this.#epsilon, this.#radius, this.#height] = [room(), room(), room(), room(), room()];
  }

  /** Radius and height of the circle at each instant. */
  get radius(): Float64Array {
    return this.#radius.values;
  }
  get height(): Float64Array {
    return this.#height.values;
  }

  update(epsilon: number): this {
    if (epsilon === this.epsilon) return this;
    this.epsilon = epsilon;
    const { functions } = this.#kernels;
    const [steepest, drag, out] = this.#one;
    drag.values[0] = epsilon;
    functions.apex_time(steepest, drag, out);
    const apex = out.values[0];
    functions.flight_time(steepest, drag, out);
    this.#spread(apex, out.values[0]);
    this.#epsilon.values.fill(epsilon);
    functions.flight_x(this.#time, this.#level, this.#epsilon, this.#radius);
    functions.flight_y(this.#time, this.#level, this.#epsilon, this.#height);
    return this;
  }

  #spread(apex: number, landing: number): void {
    const times = this.#time.values;
    const half = INSTANTS / 2;
    for (let index = 0; index < half; index += 1) {
      times[index] = (apex * index) / half;
      const part = index / (half - 1);
      times[half + index] = apex + (landing - apex) * part * part;
    }
  }

  /** How many instants lie before a time. */
  before(time: number): number {
    const times = this.#time.values;
    let [low, high] = [0, times.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (times[middle] < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}

/** The shots of Figure 1. */
export class Fan {
  flights: readonly Flight[] = [];
  readonly #kernels: Kernels;
  readonly #angles: Column;
  readonly #epsilons: Column;
  readonly #landings: Column;
  readonly #ranges: Column;
  #epsilon = NaN;

  constructor(kernels: Kernels) {
    const room = () => kernels.column(FAN_ANGLES.length);
    this.#kernels = kernels;
    this.#angles = columnOf(kernels, FAN_ANGLES.map(radians));
    [this.#epsilons, this.#landings, this.#ranges] = [room(), room(), room()];
  }

  update(instants: Instants): this {
    if (instants.epsilon === this.#epsilon) return this;
    this.#epsilon = instants.epsilon;
    const { functions } = this.#kernels;
    this.#epsilons.values.fill(instants.epsilon);
    functions.flight_time(this.#angles, this.#epsilons, this.#landings);
    functions.flight_range(this.#angles, this.#epsilons, this.#ranges);
    const [angles, landings, ranges] = [this.#angles.values, this.#landings.values, this.#ranges.values];
    this.flights = FAN_ANGLES.map((_, shot) => ({
      cosine: Math.cos(angles[shot]),
      sine: Math.sin(angles[shot]),
      count: instants.before(landings[shot]),
      range: ranges[shot],
    }));
    return this;
  }
}

/** The curve that no shot passes, from the launcher's side to where it meets the ground. */
export class Envelope {
  readonly #kernels: Kernels;
  readonly #fractions: Float64Array;
  readonly #x: Column;
  readonly #epsilon: Column;
  readonly #y: Column;
  #key = NaN;

  constructor(kernels: Kernels, points: number) {
    this.#kernels = kernels;
    // Dense at the far end, where strong drag makes the envelope a wall.
    this.#fractions = linspace(1, 0, points).map((rest) => 1 - rest * rest * rest);
    this.#x = columnOf(kernels, this.#fractions);
    this.#epsilon = kernels.column(points);
    this.#y = kernels.column(points);
  }

  get x(): Float64Array {
    return this.#x.values;
  }
  get y(): Float64Array {
    return this.#y.values;
  }

  /** `reach` is the longest range. */
  update(epsilon: number, reach: number): this {
    if (epsilon === this.#key) return this;
    this.#key = epsilon;
    const x = this.#x.values;
    for (let index = 0; index < x.length; index += 1) x[index] = this.#fractions[index] * reach;
    this.#epsilon.values.fill(epsilon);
    this.#kernels.functions.envelope_height(this.#x, this.#epsilon, this.#y);
    this.#y.values[x.length - 1] = 0;
    return this;
  }
}

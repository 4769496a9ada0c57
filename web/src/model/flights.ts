/** Trajectories and their envelope, for drawing. Lengths in ρ, times in V₀/g. */

import { columnOf, linspace, type Column, type Kernels } from "./kernels.ts";
import { radians } from "./numbers.ts";

/** Points of a shot before its apex, and as many after: a fan's thin lines, the current one. */
export const FAN_HALF = 32;
export const SHOT_HALF = 200;
/** Launch angles of the fan, degrees: those of Figure 1. */
export const FAN_ANGLES: readonly number[] = Array.from({ length: 18 }, (_, index) => 5 * (index + 1));

/** Whole flights of some shots, one after the other in `x` and `y`, `samples` points each. */
export class Flights {
  readonly samples: number;
  readonly shots: number;
  readonly #kernels: Kernels;
  readonly #angles: Column;
  readonly #epsilons: Column;
  readonly #apexTimes: Column;
  readonly #flightTimes: Column;
  readonly #time: Column;
  readonly #angle: Column;
  readonly #epsilon: Column;
  readonly #x: Column;
  readonly #y: Column;
  readonly #half: number;
  #key = "";

  constructor(kernels: Kernels, shots: number, half: number) {
    const each = () => kernels.column(shots);
    this.#kernels = kernels;
    this.#half = half;
    this.shots = shots;
    this.samples = 2 * half;
    const all = () => kernels.column(shots * this.samples);
    [this.#angles, this.#epsilons, this.#apexTimes, this.#flightTimes] = [each(), each(), each(), each()];
    [this.#time, this.#angle, this.#epsilon, this.#x, this.#y] = [all(), all(), all(), all(), all()];
  }

  get x(): Float64Array {
    return this.#x.values;
  }
  get y(): Float64Array {
    return this.#y.values;
  }

  /** Computes the flights at these launch angles, in radians. */
  update(launchAngles: readonly number[], epsilon: number): this {
    const key = `${epsilon} ${launchAngles.join(" ")}`;
    if (key === this.#key) return this;
    this.#key = key;
    const { functions } = this.#kernels;
    this.#angles.values.set(launchAngles);
    this.#epsilons.values.fill(epsilon);
    functions.apex_time(this.#angles, this.#epsilons, this.#apexTimes);
    functions.flight_time(this.#angles, this.#epsilons, this.#flightTimes);
    this.#spread();
    this.#epsilon.values.fill(epsilon);
    functions.flight_x(this.#time, this.#angle, this.#epsilon, this.#x);
    functions.flight_y(this.#time, this.#angle, this.#epsilon, this.#y);
    return this;
  }

  /** As many times before the apex as after it, denser next to it, where strong drag turns a shot. */
  #spread(): void {
    const time = this.#time.values;
    const angle = this.#angle.values;
    for (let shot = 0; shot < this.shots; shot += 1) {
      const apex = this.#apexTimes.values[shot];
      const landing = this.#flightTimes.values[shot];
      const start = shot * this.samples;
      angle.fill(this.#angles.values[shot], start, start + this.samples);
      for (let index = 0; index < this.#half; index += 1) {
        time[start + index] = (apex * index) / this.#half;
        const part = index / (this.#half - 1);
        time[start + this.#half + index] = apex + (landing - apex) * part * part;
      }
    }
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

export const fanAngles = (): number[] => FAN_ANGLES.map(radians);

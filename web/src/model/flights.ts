/** Trajectories and their envelope, for drawing. Lengths in ρ, times in V₀/g. */

import { columnOf, linspace, type Column, type Kernels } from "./kernels.ts";
import { POINTS } from "./curves.ts";
import { radians } from "./numbers.ts";

/** Launch angles of the fan, degrees: those of Figure 1. */
export const FAN_ANGLES: readonly number[] = Array.from({ length: 18 }, (_, index) => 5 * (index + 1));
/** Instants that the fan's shots have in common, from launch to the landing of the steepest. */
export const FAN_INSTANTS = 1000;

/** As many times up to the apex as from there to the landing, denser next to it, where strong drag turns a shot. */
function spread(times: Float64Array, apex: number, landing: number): void {
  const half = times.length / 2;
  for (let index = 0; index < half; index += 1) {
    times[index] = (apex * index) / half;
    const part = index / (half - 1);
    times[half + index] = apex + (landing - apex) * part * part;
  }
}

/**
 * Flights at many launch angles, from two calls of a kernel for all of them.
 *
 * At a time t all shots are on one circle, whose radius X and height Y the level shot shows: the
 * shot at α is at (X cos α, X sin α + Y). So the fan shares its instants.
 */
export class Fan {
  readonly shots = FAN_ANGLES.length;
  /** Room for each shot in `x` and `y`, and how many points it has: those up to its landing. */
  readonly stride = FAN_INSTANTS + 1;
  readonly counts = new Uint16Array(FAN_ANGLES.length);
  readonly x = new Float64Array(FAN_ANGLES.length * (FAN_INSTANTS + 1));
  readonly y = new Float64Array(FAN_ANGLES.length * (FAN_INSTANTS + 1));
  readonly #kernels: Kernels;
  readonly #cosines = FAN_ANGLES.map((angle) => Math.cos(radians(angle)));
  readonly #sines = FAN_ANGLES.map((angle) => Math.sin(radians(angle)));
  readonly #angles: Column;
  readonly #epsilons: Column;
  readonly #landings: Column;
  readonly #ranges: Column;
  readonly #apexTimes: Column;
  readonly #time: Column;
  readonly #level: Column;
  readonly #epsilon: Column;
  readonly #radius: Column;
  readonly #height: Column;
  #key = NaN;

  constructor(kernels: Kernels) {
    const each = () => kernels.column(FAN_ANGLES.length);
    const all = () => kernels.column(FAN_INSTANTS);
    this.#kernels = kernels;
    this.#angles = columnOf(kernels, FAN_ANGLES.map(radians));
    [this.#epsilons, this.#landings, this.#ranges, this.#apexTimes] = [each(), each(), each(), each()];
    [this.#time, this.#level, this.#epsilon, this.#radius, this.#height] = [all(), all(), all(), all(), all()];
  }

  update(epsilon: number): this {
    if (epsilon === this.#key) return this;
    this.#key = epsilon;
    const { functions } = this.#kernels;
    this.#epsilons.values.fill(epsilon);
    functions.apex_time(this.#angles, this.#epsilons, this.#apexTimes);
    functions.flight_time(this.#angles, this.#epsilons, this.#landings);
    functions.flight_range(this.#angles, this.#epsilons, this.#ranges);
    const steepest = this.shots - 1;
    spread(this.#time.values, this.#apexTimes.values[steepest], this.#landings.values[steepest]);
    this.#epsilon.values.fill(epsilon);
    functions.flight_x(this.#time, this.#level, this.#epsilon, this.#radius);
    functions.flight_y(this.#time, this.#level, this.#epsilon, this.#height);
    for (let shot = 0; shot < this.shots; shot += 1) this.#place(shot);
    return this;
  }

  #place(shot: number): void {
    const { x, y } = this;
    const [cosine, sine, landing] = [this.#cosines[shot], this.#sines[shot], this.#landings.values[shot]];
    const [time, radius, height] = [this.#time.values, this.#radius.values, this.#height.values];
    const start = shot * this.stride;
    let index = 0;
    for (; index < FAN_INSTANTS && time[index] < landing; index += 1) {
      x[start + index] = cosine * radius[index];
      y[start + index] = sine * radius[index] + height[index];
    }
    x[start + index] = this.#ranges.values[shot];
    y[start + index] = 0;
    this.counts[shot] = index + 1;
  }
}

/** The whole flight of one shot. */
export class Flight {
  readonly #kernels: Kernels;
  readonly #time: Column;
  readonly #angle: Column;
  readonly #epsilon: Column;
  readonly #x: Column;
  readonly #y: Column;
  /** How often it was computed. */
  version = 0;
  #launchAngle = NaN;
  #drag = NaN;

  constructor(kernels: Kernels) {
    const room = () => kernels.column(POINTS);
    this.#kernels = kernels;
    [this.#time, this.#angle, this.#epsilon, this.#x, this.#y] = [room(), room(), room(), room(), room()];
  }

  get x(): Float64Array {
    return this.#x.values;
  }
  get y(): Float64Array {
    return this.#y.values;
  }

  update(launchAngle: number, epsilon: number, apexTime: number, flightTime: number): this {
    if (launchAngle === this.#launchAngle && epsilon === this.#drag) return this;
    if (launchAngle !== this.#launchAngle) this.#angle.values.fill(launchAngle);
    if (epsilon !== this.#drag) this.#epsilon.values.fill(epsilon);
    [this.#launchAngle, this.#drag] = [launchAngle, epsilon];
    this.version += 1;
    const { functions } = this.#kernels;
    spread(this.#time.values, apexTime, flightTime);
    functions.flight_x(this.#time, this.#angle, this.#epsilon, this.#x);
    functions.flight_y(this.#time, this.#angle, this.#epsilon, this.#y);
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

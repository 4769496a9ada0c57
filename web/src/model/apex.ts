/** One shot: its apex, where it is at a time, and the shot that has a given apex. */

import { type Column, type Kernels } from "./kernels.ts";

/** The apex of one shot. Angles in radians, lengths in ρ, time in V₀/g, curvature as ρK. */
export interface Apex {
  readonly launchAngle: number;
  readonly elevation: number;
  readonly x: number;
  readonly y: number;
  readonly distance: number;
  readonly time: number;
  readonly curvature: number;
}

export interface Point {
  readonly x: number;
  readonly y: number;
}

/** The kernels on single numbers. */
export class Shots {
  readonly #kernels: Kernels;
  readonly #inputs: readonly [Column, Column, Column];
  readonly #out: Column;

  constructor(kernels: Kernels) {
    this.#kernels = kernels;
    this.#inputs = [kernels.column(1), kernels.column(1), kernels.column(1)];
    this.#out = kernels.column(1);
  }

  apex(launchAngle: number, epsilon: number): Apex {
    const { functions: f } = this.#kernels;
    return {
      launchAngle,
      elevation: this.#two(f.apex_elevation, launchAngle, epsilon),
      x: this.#two(f.apex_x, launchAngle, epsilon),
      y: this.#two(f.apex_y, launchAngle, epsilon),
      distance: this.#two(f.apex_distance, launchAngle, epsilon),
      time: this.#two(f.apex_time, launchAngle, epsilon),
      curvature: this.#two(f.apex_curvature, launchAngle, epsilon),
    };
  }

  /** The launch angle of the shot whose apex stands at this elevation: the inverse of (10). */
  launchAngle(elevation: number, epsilon: number): number {
    return this.#two(this.#kernels.functions.locus_launch_angle, elevation, epsilon);
  }

  /** Distance of the apex that stands at this elevation. */
  radius(elevation: number, epsilon: number): number {
    return this.#two(this.#kernels.functions.locus_radius, elevation, epsilon);
  }

  /** dα/dθ and d²α/dθ² at an elevation. */
  slopes(elevation: number, epsilon: number): readonly [number, number] {
    const { functions: f } = this.#kernels;
    return [
      this.#two(f.locus_launch_angle_d1, elevation, epsilon),
      this.#two(f.locus_launch_angle_d2, elevation, epsilon),
    ];
  }

  flightTime(launchAngle: number, epsilon: number): number {
    return this.#two(this.#kernels.functions.flight_time, launchAngle, epsilon);
  }

  range(launchAngle: number, epsilon: number): number {
    return this.#two(this.#kernels.functions.flight_range, launchAngle, epsilon);
  }

  /** Launch angle of the longest shot. */
  optimalAngle(epsilon: number): number {
    return this.#one(this.#kernels.functions.optimal_angle, epsilon);
  }

  position(time: number, launchAngle: number, epsilon: number): Point {
    const { functions: f } = this.#kernels;
    return {
      x: this.#three(f.flight_x, time, launchAngle, epsilon),
      y: this.#three(f.flight_y, time, launchAngle, epsilon),
    };
  }

  /**
   * The circle on which all shots are at a time: its radius and the height of its centre.
   *
   * The horizontal shot sees both: it starts without a height of its own.
   */
  front(time: number, epsilon: number): { radius: number; centre: number } {
    const { x, y } = this.position(time, 0, epsilon);
    return { radius: x, centre: y };
  }

  #one(f: (a: Column, out: Column) => void, a: number): number {
    this.#inputs[0].values[0] = a;
    f(this.#inputs[0], this.#out);
    return this.#out.values[0];
  }

  #two(f: (a: Column, b: Column, out: Column) => void, a: number, b: number): number {
    this.#inputs[0].values[0] = a;
    this.#inputs[1].values[0] = b;
    f(this.#inputs[0], this.#inputs[1], this.#out);
    return this.#out.values[0];
  }

  #three(f: (a: Column, b: Column, c: Column, out: Column) => void, a: number, b: number, c: number): number {
    this.#inputs[0].values[0] = a;
    this.#inputs[1].values[0] = b;
    this.#inputs[2].values[0] = c;
    f(this.#inputs[0], this.#inputs[1], this.#inputs[2], this.#out);
    return this.#out.values[0];
  }
}

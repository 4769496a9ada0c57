/** The curves of the panels for one drag parameter, in units of ρ = V₀²/g; angles in radians. */

import { columnOf, linspace, type Column, type Kernels } from "./kernels.ts";
import { radians } from "./numbers.ts";

/** Points a curve. */
export const POINTS = 2000;

/** Angles from 0 to 90 degrees that the curves run over: launch angles and elevations alike. */
export class AngleGrid {
  readonly degrees: Float64Array;
  readonly radians: Column;

  constructor(kernels: Kernels, count = POINTS) {
    this.degrees = linspace(0, 90, count);
    this.radians = columnOf(kernels, this.degrees.map(radians));
  }
}

/** Everything about the locus of one ε, at the angles of a grid. */
export class LocusCurves {
  readonly grid: AngleGrid;
  readonly #kernels: Kernels;
  readonly #epsilon: Column;
  readonly #columns: Record<Quantity, Column>;
  #spare: readonly [Column, Column] | undefined;
  /** NaN until `update` has been called. */
  epsilon = NaN;
  /** How often the curves were computed: what has been drawn can tell whether it is still right. */
  version = 0;

  constructor(kernels: Kernels, grid: AngleGrid) {
    const room = () => kernels.column(grid.radians.length);
    this.grid = grid;
    this.#kernels = kernels;
    this.#epsilon = room();
    this.#columns = {
      x: room(),
      y: room(),
      elevation: room(),
      curvature: room(),
      launchAngleD1: room(),
      launchAngleD2: room(),
    };
  }

  update(epsilon: number): this {
    if (epsilon === this.epsilon) return this;
    this.epsilon = epsilon;
    this.version += 1;
    const { functions } = this.#kernels;
    const { x, y, elevation, curvature, launchAngleD1, launchAngleD2 } = this.#columns;
    const angle = this.grid.radians;
    this.#epsilon.values.fill(epsilon);
    functions.apex(angle, this.#epsilon, x, y, elevation, curvature);
    functions.locus_launch_angle_derivatives(angle, this.#epsilon, launchAngleD1, launchAngleD2);
    return this;
  }

  /** Distance from the launch point and time of flight of each apex: for files, not for pictures. */
  distances(): { distance: Float64Array; time: Float64Array } {
    const { functions, column } = this.#kernels;
    this.#spare ??= [column(this.grid.radians.length), column(this.grid.radians.length)];
    const [distance, time] = this.#spare;
    functions.apex_distance(this.grid.radians, this.#epsilon, distance);
    functions.apex_time(this.grid.radians, this.#epsilon, time);
    return { distance: distance.values, time: time.values };
  }

  /** Of the apex, by launch angle. */
  get x(): Float64Array {
    return this.#columns.x.values;
  }
  get y(): Float64Array {
    return this.#columns.y.values;
  }
  get elevation(): Float64Array {
    return this.#columns.elevation.values;
  }
  /** ρK, by launch angle. */
  get curvature(): Float64Array {
    return this.#columns.curvature.values;
  }
  /** dα/dθ, by elevation. */
  get launchAngleD1(): Float64Array {
    return this.#columns.launchAngleD1.values;
  }
  /** d²α/dθ², by elevation. */
  get launchAngleD2(): Float64Array {
    return this.#columns.launchAngleD2.values;
  }
}

type Quantity = "x" | "y" | "elevation" | "curvature" | "launchAngleD1" | "launchAngleD2";

/**
 * The named angles over the decades of ε, for their panel.
 *
 * They depend on nothing that can be moved, so they are computed once, a few at a time while the
 * page has nothing else to do.
 */

import { linspace, type Kernels } from "./kernels.ts";
import { POINTS } from "./curves.ts";
import { NAMED, NamedAngleSolver, type NamedAngle, type NamedAngles } from "./named.ts";

/** Powers of ten between which they are drawn. */
export const NAMED_DECADES = [-3, 3] as const;
/** Drag parameters solved for at once, some three milliseconds of work, and how well: for the eye. */
const AT_ONCE = 100;
const TOLERANCE = 1e-5;

export class NamedCurves {
  readonly decades = linspace(...NAMED_DECADES, POINTS);
  readonly angles: NamedAngles;
  /** How many points are there, from the weakest drag on. */
  count = 0;
  readonly #solver: NamedAngleSolver;

  constructor(kernels: Kernels) {
    this.#solver = new NamedAngleSolver(kernels, AT_ONCE);
    const names = Object.keys(NAMED) as NamedAngle[];
    this.angles = Object.fromEntries(names.map((name) => [name, new Float64Array(POINTS)])) as unknown as NamedAngles;
  }

  get complete(): boolean {
    return this.count === this.decades.length;
  }

  /** Computes the next points. */
  advance(): void {
    const next = this.decades.subarray(this.count, this.count + AT_ONCE);
    const solved = this.#solver.solve(next.map((decade) => 10 ** decade), TOLERANCE);
    for (const name of Object.keys(NAMED) as NamedAngle[]) {
      this.angles[name].set(solved[name].subarray(0, next.length), this.count);
    }
    this.count += next.length;
  }
}

/**
 * What equation (13) draws with the principal branch of W alone, as the paper takes it.
 *
 * With σ = ε² y the equation says r = −W(−σ e^{−σ})/(ε² sin θ), which is r only for the branch that
 * gives σ back. W₀ does so up to σ = 1; beyond it, it shortens r by the factor −W₀(−σ e^{−σ})/σ.
 */

import { type Column, type Kernels } from "./kernels.ts";
import { type LocusCurves } from "./curves.ts";

export class PrincipalBranch {
  readonly #kernels: Kernels;
  readonly #sigma: Column;
  readonly #level: Column;
  readonly #ones: Column;
  readonly #grown: Column;
  readonly #argument: Column;
  readonly #tree: Column;
  readonly x: Float64Array;
  readonly y: Float64Array;
  #key = NaN;

  constructor(kernels: Kernels, points: number) {
    const room = () => kernels.column(points);
    this.#kernels = kernels;
    this.#sigma = room();
    this.#level = room();
    this.#ones = room();
    this.#ones.values.fill(1);
    this.#grown = room();
    this.#argument = room();
    this.#tree = room();
    this.x = new Float64Array(points);
    this.y = new Float64Array(points);
  }

  /** How many of the points, from the first with σ > 1, the principal branch gets wrong. */
  update(locus: LocusCurves): number {
    const { x, y, epsilon } = locus;
    const from = y.findIndex((height) => epsilon * epsilon * height > 1);
    if (from < 0) return 0;
    if (epsilon !== this.#key) {
      this.#key = epsilon;
      const sigma = this.#sigma.values;
      for (let index = 0; index < sigma.length; index += 1) sigma[index] = epsilon * epsilon * y[index];
      // 1 − e^{−σ}: how far a level shot has come at time σ, when ε = 1.
      this.#kernels.functions.flight_x(this.#sigma, this.#level, this.#ones, this.#grown);
      const argument = this.#argument.values;
      const grown = this.#grown.values;
      for (let index = 0; index < sigma.length; index += 1) argument[index] = sigma[index] * (1 - grown[index]);
      this.#kernels.functions.tree(this.#argument, this.#tree);
      const tree = this.#tree.values;
      for (let index = from; index < sigma.length; index += 1) {
        const shortened = tree[index] / sigma[index];
        this.x[index - from] = x[index] * shortened;
        this.y[index - from] = y[index] * shortened;
      }
    }
    return y.length - from;
  }
}

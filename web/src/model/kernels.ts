/** The Rust kernels, loaded. All numbers of the page come through here. */

import { loadKernels, type Column, type Kernels } from "../../../crates/archerfish-wasm/js/kernels.js";

export { loadKernels };
export type { Column, Kernels };

/** A function of two vectors of 16 bytes: the smallest module that needs SIMD. */
const SIMD_PROBE = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

/** The sentence for a browser that cannot run the kernels, or nothing. */
export function unsupported(): string | undefined {
  if (typeof WebAssembly === "undefined" || !WebAssembly.validate(SIMD_PROBE)) {
    return (
      "This browser cannot run WebAssembly with SIMD, which computes everything here. " +
      "Chrome and Edge 91, Firefox 89, Safari 16.4 and later ones can."
    );
  }
  return undefined;
}

/** A column filled with these numbers. */
export function columnOf(kernels: Kernels, values: ArrayLike<number>): Column {
  const column = kernels.column(values.length);
  column.values.set(values);
  return column;
}

/** `count` numbers evenly spaced, ends included, by the operations of `numpy.linspace`. */
export function linspace(first: number, last: number, count: number): Float64Array {
  const step = (last - first) / (count - 1);
  const values = Float64Array.from({ length: count }, (_, index) => index * step + first);
  values[count - 1] = last;
  return values;
}

// Prints, as JSON, the least times of some functions of the WebAssembly build over the same columns,
// taken in turns, in those of the last: `node work.mjs KERNELS MODULE FUNCTION ...`.

import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [wrapper, module, ...names] = process.argv.slice(2);
const { loadKernels } = await import(pathToFileURL(wrapper));
const kernels = await loadKernels(readFileSync(module));

const [COUNT, TURNS] = [1000, 200];
const [angle, drag, out] = [0, 1, 2].map(() => kernels.column(COUNT));
for (let i = 0; i < COUNT; i++) {
  angle.values[i] = (1.5 * (i + 0.5)) / COUNT;
  drag.values[i] = 10 ** (-2 + (4 * ((7919 * i) % COUNT)) / COUNT);
}
const least = names.map(() => Infinity);
for (let turn = 0; turn < TURNS; turn++) {
  names.forEach((name, k) => {
    const start = performance.now();
    kernels.functions[name](angle, drag, out);
    least[k] = Math.min(least[k], performance.now() - start);
  });
}
console.log(JSON.stringify(least.map((time) => time / least.at(-1))));

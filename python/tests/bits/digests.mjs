// Prints, as JSON, the SHA-256 of what each function of the WebAssembly build makes of the columns
// in a folder: `node digests.mjs KERNELS MODULE FOLDER`. See digests.py.

import { createHash } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [wrapper, module, folder] = process.argv.slice(2);
const { loadKernels } = await import(pathToFileURL(wrapper));
const kernels = await loadKernels(readFileSync(module));
const types = { float64: Float64Array, float32: Float32Array };

function read(path, type) {
  const bytes = readFileSync(path);
  return new type(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

// Which functions fill the columns of those that compute several at once.
const PARTS = {
  apex: ["apex_x", "apex_y", "apex_elevation", "apex_curvature"],
  locus_launch_angle_derivatives: ["locus_launch_angle_d1", "locus_launch_angle_d2"],
};
const digests = {};
const together = {};
const columns = [];
for (const name of Object.keys(kernels.functions)) {
  for (const [place, part] of (PARTS[name] ?? [name]).entries()) {
    const outputs = PARTS[name]?.length ?? 1;
    for (const [element, type] of Object.entries(types)) {
      const inputs = [];
      for (let k = 0; existsSync(join(folder, `${part}.${element}.${k}`)); k++) {
        inputs.push(read(join(folder, `${part}.${element}.${k}`), type));
      }
      while (columns.length < inputs.length + outputs) {
        columns.push(kernels.column(inputs[0].length));
      }
      const used = columns.slice(0, inputs.length + outputs);
      inputs.forEach((input, k) => used[k].values.set(input));
      kernels.functions[name](...used);
      const values = type.from(used[inputs.length + place].values);
      const digest = createHash("sha256").update(values).digest("hex");
      (PARTS[name] ? together : digests)[`${part} ${element}`] = digest;
    }
  }
}
console.log(JSON.stringify({ isa: "wasm", digests, together }));

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

const digests = {};
const columns = [];
for (const name of Object.keys(kernels.functions)) {
  for (const [element, type] of Object.entries(types)) {
    const paths = [];
    for (let k = 0; existsSync(join(folder, `${name}.${element}.${k}`)); k++) {
      paths.push(join(folder, `${name}.${element}.${k}`));
    }
    const inputs = paths.map((path) => read(path, type));
    while (columns.length <= inputs.length) {
      columns.push(kernels.column(inputs[0].length));
    }
    const used = columns.slice(0, inputs.length + 1);
    inputs.forEach((input, k) => used[k].values.set(input));
    kernels.functions[name](...used);
    const values = type.from(used[inputs.length].values);
    digests[`${name} ${element}`] = createHash("sha256").update(values).digest("hex");
  }
}
console.log(JSON.stringify({ isa: "wasm", digests }));

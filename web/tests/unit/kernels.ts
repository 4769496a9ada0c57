import { readFileSync } from "node:fs";
import { loadKernels, type Kernels } from "../../src/model/kernels.ts";

const FILE = new URL("../../../crates/archerfish-wasm/js/archerfish.wasm", import.meta.url);

export const kernels = (): Promise<Kernels> => loadKernels(readFileSync(FILE));

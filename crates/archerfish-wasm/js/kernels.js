// The archerfish kernels by name, on columns of numbers in the module's own memory.
//
// Write into `column.values`, call a function, read `out.values`: nothing is copied. Columns live
// as long as the module, so make those you need once.

/** Doubles in the module's memory. */
export class Column {
  #memory;
  #address;
  #view;

  constructor(memory, address, length) {
    this.#memory = memory;
    this.#address = address;
    this.#view = new Float64Array(memory.buffer, address, length);
    this.length = length;
    Object.freeze(this);
  }

  get address() {
    return this.#address;
  }

  /** The numbers themselves. Memory that grows takes its old views away: ask anew after `column`. */
  get values() {
    if (this.#view.buffer !== this.#memory.buffer) {
      this.#view = new Float64Array(this.#memory.buffer, this.#address, this.length);
    }
    return this.#view;
  }
}

/** Instantiates the module, compiled or as bytes. */
export async function loadKernels(source) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  const core = (await WebAssembly.instantiate(module)).exports;
  const functions = {};
  for (let number = 0; core.inputs(number) > 0; number++) {
    functions[nameOf(core, number)] = functionOf(core, number);
  }
  return Object.freeze({
    functions: Object.freeze(functions),
    column(length) {
      const address = core.allocate(length);
      if (address === 0) {
        throw new RangeError(`no memory for a column of ${length} numbers`);
      }
      return new Column(core.memory, address, length);
    },
  });
}

function nameOf(core, number) {
  const text = new Uint8Array(core.memory.buffer, core.name(number), core.name_length(number));
  return String.fromCharCode(...text);
}

function functionOf(core, number) {
  const inputs = core.inputs(number);
  const count = inputs + core.outputs(number);
  return (...columns) => {
    if (columns.length !== count) {
      throw new TypeError(`${nameOf(core, number)} takes ${count} columns, got ${columns.length}`);
    }
    const { length } = columns[inputs];
    for (let k = 0; k < count; k++) {
      if (k >= inputs && columns.indexOf(columns[k]) < k) {
        throw new RangeError("a column of results must be none of the others");
      }
      if (columns[k].length < length) {
        throw new RangeError(`each column must have at least ${length} numbers, got ${columns[k].length}`);
      }
    }
    const address = (k, last) => columns[Math.min(k, last)].address;
    const x = (k) => address(k, inputs - 1);
    const out = (k) => address(inputs + k, count - 1);
    core.evaluate(number, length, x(0), x(1), x(2), out(0), out(1), out(2), out(3));
  };
}

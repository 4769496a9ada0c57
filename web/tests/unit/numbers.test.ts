import { execFileSync } from "node:child_process";
import { describe, expect, it } from "vitest";
import { exact, lengthUnit, parsed, short } from "../../src/model/numbers.ts";

/** Doubles of every size, the same at each run. */
function doubles(count: number): number[] {
  let seed = 12345n;
  const bits = new BigUint64Array(1);
  const value = new Float64Array(bits.buffer);
  const numbers = [0, -0, 0.1, 1, 1e16, 9999999999999998, 1e-4, 0.00012345, 1e-5, 5e-324, 1.7976931348623157e308];
  while (numbers.length < count) {
    seed = (seed * 6364136223846793005n + 1442695040888963407n) & 0xffffffffffffffffn;
    bits[0] = seed;
    if (Number.isFinite(value[0])) numbers.push(value[0], Math.fround(value[0] % 1000));
  }
  return numbers;
}

describe("exact", () => {
  it("writes what Python's repr writes", () => {
    const numbers = doubles(2000);
    const program = "import sys, json; print(json.dumps([repr(float.fromhex(h)) for h in json.load(sys.stdin)]))";
    const hex = JSON.stringify(numbers.map(hexadecimal));
    const reprs = JSON.parse(execFileSync("python3", ["-c", program], { input: hex, encoding: "utf8" }));
    expect(numbers.map(exact)).toEqual(reprs);
  });

  it("names what is no number as Python does", () => {
    expect([NaN, Infinity, -Infinity].map(exact)).toEqual(["nan", "inf", "-inf"]);
  });
});

/** The bits of a double as Python reads them, by no way through decimal digits. */
function hexadecimal(value: number): string {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  const bits = view.getBigUint64(0);
  const exponent = Number((bits >> 52n) & 0x7ffn);
  const fraction = (bits & 0xfffffffffffffn).toString(16).padStart(13, "0");
  const sign = bits >> 63n ? "-" : "";
  return exponent === 0 ? `${sign}0x0.${fraction}p-1022` : `${sign}0x1.${fraction}p${exponent - 1023}`;
}

describe("short", () => {
  it.each([
    [0, "0"],
    [-1.5, "−1.5"],
    [0.1 + 0.2, "0.3"],
    [123456.789, "123457"],
    [1e6, "10⁶"],
    [-2.5e-7, "−2.5 × 10⁻⁷"],
    [Infinity, "∞"],
    [NaN, "undefined"],
  ])("%f is %s", (value, text) => expect(short(value)).toBe(text));
});

describe("parsed", () => {
  it.each([
    ["0.1", 0.1],
    [" 1e-3 ", 1e-3],
    ["0,5", 0.5],
    ["−2", -2],
    ["∞", Infinity],
    ["inf", Infinity],
    ["", NaN],
    ["0x10", NaN],
    ["1 2", NaN],
    ["ten", NaN],
  ])("%s is %f", (text, value) => expect(parsed(text)).toBe(value));
});

it("chooses the unit in which a length is at least 1", () => {
  const units = ["nm", "µm", "mm", "m", "km"];
  for (const side of [1, -1]) {
    expect([2e-9, 5e-4, 0.02, 3, 2e4].map((length) => lengthUnit(side * length)[0])).toEqual(units);
  }
});

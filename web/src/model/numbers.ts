/** Numbers as text: every digit for files, a few for the eye. */

/** The shortest digits that give the same double back, written as Python's `repr` writes them. */
export function exact(value: number): string {
  if (Number.isNaN(value)) return "nan";
  if (!Number.isFinite(value)) return value < 0 ? "-inf" : "inf";
  if (Object.is(value, -0)) return "-0.0";
  const [digits = "", power = "0"] = value.toExponential().split("e");
  const exponent = Number(power);
  if (value !== 0 && (exponent < -4 || exponent >= 16)) {
    const size = String(Math.abs(exponent)).padStart(2, "0");
    return `${digits}e${exponent < 0 ? "-" : "+"}${size}`;
  }
  const plain = plainDigits(digits, exponent);
  return plain.includes(".") ? plain : `${plain}.0`;
}

/** Digits with the decimal point moved by `exponent`: JavaScript alone would turn to 1e-7 early. */
function plainDigits(mantissa: string, exponent: number): string {
  const sign = mantissa.startsWith("-") ? "-" : "";
  const digits = mantissa.replace("-", "").replace(".", "");
  if (exponent < 0) return `${sign}0.${"0".repeat(-exponent - 1)}${digits}`;
  const whole = digits.slice(0, exponent + 1).padEnd(exponent + 1, "0");
  const rest = digits.slice(exponent + 1);
  return sign + whole + (rest ? `.${rest}` : "");
}

/** At most `figures` significant figures, with a real minus and × 10ⁿ where that is shorter. */
export function short(value: number, figures = 6): string {
  if (Number.isNaN(value)) return "undefined";
  if (!Number.isFinite(value)) return value < 0 ? "−∞" : "∞";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) {
    const [digits = "", power = "0"] = value.toExponential(figures - 1).split("e");
    const mantissa = String(Number(digits));
    return `${mantissa === "1" ? "" : `${mantissa} × `}10${superscript(Number(power))}`.replace("-", "−");
  }
  return String(Number(value.toPrecision(figures))).replace("-", "−");
}

const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** A whole number as a superscript. */
export function superscript(power: number): string {
  const digits = String(Math.abs(power)).replace(/\d/g, (digit) => SUPERSCRIPTS[Number(digit)] ?? "");
  return (power < 0 ? "⁻" : "") + digits;
}

/** A number as a user typed it; NaN where it is none. Takes a comma, ∞ and inf as well. */
export function parsed(text: string): number {
  const plain = text.trim().replace("−", "-").replace(",", ".");
  if (/^\+?(∞|inf(inity)?)$/i.test(plain)) return Infinity;
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
}

/** The number nearest to `value` with this many significant figures. */
export function rounded(value: number, figures: number): number {
  return Number(value.toPrecision(figures));
}

export const radians = (degrees: number): number => degrees * (Math.PI / 180);
export const degrees = (radians: number): number => radians * (180 / Math.PI);

/** Units of length and their metres, rising. */
const LENGTH_UNITS: readonly (readonly [string, number])[] = [
  ["nm", 1e-9],
  ["µm", 1e-6],
  ["mm", 1e-3],
  ["m", 1],
  ["km", 1e3],
];

/** The unit in which a length, in metres, is from 1 to 1000 (2 to 2000 from metres on). */
export function lengthUnit(length: number): readonly [string, number] {
  const fitting = LENGTH_UNITS.filter(([, metres]) => metres <= Math.abs(length));
  return fitting.at(-1) ?? LENGTH_UNITS[0];
}

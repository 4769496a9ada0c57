/** Colours of the current theme, as style.css has them, and the strokes made of them. */

import { type Stroke } from "./painter.ts";

const NAMES = [
  "paper",
  "ink",
  "muted",
  "grid",
  "locus",
  "ellipse",
  "shot",
  "envelope",
  "circle",
  "comb",
  "ghost",
  "compare-1",
  "compare-2",
  "compare-3",
  "compare-4",
] as const;

export type Palette = Readonly<Record<(typeof NAMES)[number], string>>;

export function palette(): Palette {
  const style = getComputedStyle(document.documentElement);
  const entries = NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]);
  return Object.fromEntries(entries) as Palette;
}

/** Dashes keep curves apart where colour alone would not. */
export const DASHES = {
  ellipse: [6, 4],
  envelope: [2, 3],
  circle: [1, 3],
  ghost: [8, 3, 2, 3],
  compare: [[9, 3], [4, 2, 1, 2], [2, 2], [7, 2, 1, 2, 1, 2]],
} as const;

export function compareStroke(colors: Palette, index: number, width = 1.5): Stroke {
  const color = colors[`compare-${index + 1}` as keyof Palette];
  return { color, width, dash: DASHES.compare[index] ?? [] };
}

/** Colours and dashes of the five named angles. */
export function namedStroke(colors: Palette, index: number): Stroke {
  if (index === 0) return { color: colors.locus, width: 1.6 };
  return compareStroke(colors, index - 1);
}

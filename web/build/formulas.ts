/**
 * The formulas of the page, typeset when it is built: KaTeX's markup, with marked places for numbers.
 *
 * KaTeX itself stays out of the page, and so do its style attributes, which a strict content
 * security policy forbids: each becomes a class.
 */

import katex from "katex";
import { type Plugin } from "vite";

/** A symbol that explains itself, and a place where the current number of a quantity goes. */
const symbol = (name: string, tex: string): string => `\\htmlClass{symbol symbol-${name}}{${tex}}`;
const number = (name: string): string => `\\htmlClass{number number-${name}}{0}`;

const alpha = symbol("alpha", "\\alpha");
const theta = symbol("theta", "\\theta");
const epsilon = symbol("epsilon", "\\varepsilon");
const rho = symbol("rho", "\\rho");
const x = symbol("x", "x");
const y = symbol("y", "y");
const r = symbol("r", "\\tilde r");
const t = symbol("t", "t");
const K = symbol("K", "K");
const W = symbol("W", "W");
const sin = (angle: string): string => `\\sin ${angle}`;
const cos = (angle: string): string => `\\cos ${angle}`;
const numberAlpha = number("alpha");
const numberTheta = number("theta");
const numberEpsilon = number("epsilon");

interface Formula {
  readonly id: string;
  /** Number of the equation in the paper. */
  readonly equation: string;
  readonly title: string;
  /** The formula, read aloud. */
  readonly spoken: string;
  readonly general: string;
  /** The same with the current numbers put in; where ε = 0 this is the limit's value only. */
  readonly filled: string;
}

const FORMULAS: readonly Formula[] = [
  {
    id: "x",
    equation: "(7)",
    title: "How far the apex stands",
    spoken: "x is rho times sine alpha cosine alpha over one plus epsilon sine alpha",
    general: `${x} = ${rho}\\,\\frac{${sin(alpha)}\\,${cos(alpha)}}{1 + ${epsilon}\\,${sin(alpha)}}`,
    filled:
      `= ${number("rho")}\\,\\frac{\\sin ${numberAlpha}^\\circ \\cos ${numberAlpha}^\\circ}` +
      `{1 + ${numberEpsilon}\\,\\cdot\\,\\sin ${numberAlpha}^\\circ} = ${number("x")}\\ \\mathrm{m}`,
  },
  {
    id: "y",
    equation: "(8)",
    title: "How high it stands",
    spoken:
      "y is rho over epsilon squared, times the difference of epsilon sine alpha and the logarithm of one plus epsilon sine alpha",
    general: `${y} = \\frac{${rho}}{${epsilon}^2}\\bigl(${epsilon}\\,${sin(alpha)} - \\ln(1 + ${epsilon}\\,${sin(alpha)})\\bigr)`,
    filled:
      `= \\frac{${number("rho")}}{${numberEpsilon}^2}\\bigl(${numberEpsilon}\\,\\sin ${numberAlpha}^\\circ - ` +
      `\\ln(1 + ${numberEpsilon}\\,\\sin ${numberAlpha}^\\circ)\\bigr) = ${number("y")}\\ \\mathrm{m}`,
  },
  {
    id: "t",
    equation: "ẏ = 0",
    title: "When it is reached",
    spoken: "t is V zero over g epsilon, times the logarithm of one plus epsilon sine alpha",
    general: `${t} = \\frac{${symbol("speed", "V_0")}}{${symbol("gravity", "g")}\\,${epsilon}}\\,\\ln(1 + ${epsilon}\\,${sin(alpha)})`,
    filled:
      `= \\frac{${number("speed")}}{${number("gravity")}\\,\\cdot\\, ${numberEpsilon}}\\,` +
      `\\ln(1 + ${numberEpsilon}\\,\\sin ${numberAlpha}^\\circ) = ${number("t")}\\ \\mathrm{s}`,
  },
  {
    id: "theta",
    equation: "(10)",
    title: "The elevation at which it is seen",
    spoken:
      "tangent theta is one over epsilon squared, times the difference of epsilon sine alpha and the logarithm of one plus epsilon sine alpha, times one plus epsilon sine alpha, over sine alpha cosine alpha",
    general:
      `\\tan ${theta} = \\frac{1}{${epsilon}^2}\\,\\frac{${epsilon}\\,${sin(alpha)} - \\ln(1 + ${epsilon}\\,${sin(alpha)})}` +
      `{${sin(alpha)}\\,${cos(alpha)}\\,\\frac{1}{1 + ${epsilon}\\,${sin(alpha)}}}`,
    filled: `${theta} = ${numberTheta}^\\circ\\quad\\text{at}\\quad ${alpha} = ${numberAlpha}^\\circ,\\ ${epsilon} = ${numberEpsilon}`,
  },
  {
    id: "r",
    equation: "(13)",
    title: "The locus by elevation",
    spoken:
      "r tilde is minus W of minus epsilon squared, tangent theta, sine alpha, cosine alpha, e to the minus epsilon sine alpha, over epsilon squared sine theta",
    general:
      `${r} = \\frac{-${W}\\!\\left(-${epsilon}^2 \\tan ${theta}\\;${sin(alpha)}\\,${cos(alpha)}\\,e^{-${epsilon} \\sin ${alpha}}\\right)}` +
      `{${epsilon}^2\\,\\sin ${theta}}`,
    filled: `= ${number("radius")},\\qquad ${rho}\\,${r} = ${number("r")}\\ \\mathrm{m},\\qquad ${symbol("branch", "\\text{branch }")}${number("branch")}`,
  },
  {
    id: "ellipse",
    equation: "(15)",
    title: "The same without drag: an ellipse",
    spoken: "r tilde is two sine theta over one plus three sine squared theta",
    general: `${r} = \\frac{2\\,${sin(theta)}}{1 + 3\\,\\sin^2 ${theta}}`,
    filled: `= ${number("free")}\\quad\\text{at}\\quad ${theta} = ${numberTheta}^\\circ`,
  },
  {
    id: "slope",
    equation: "(18)",
    title: "How fast the launch angle follows the elevation",
    spoken: "d alpha by d theta is one over d theta by d alpha",
    general: `\\frac{d${alpha}}{d${theta}} = \\frac{1}{\\;\\frac{d${theta}}{d${alpha}}\\;}`,
    filled: `= ${number("d1")},\\qquad \\frac{d^2${alpha}}{d${theta}^2} = ${number("d2")}`,
  },
  {
    id: "curvature",
    equation: "(19)",
    title: "How sharply the locus bends",
    spoken:
      "rho K is r tilde squared plus two r tilde prime squared minus r tilde r tilde double prime, over r tilde squared plus r tilde prime squared to the power three halves",
    general:
      `${rho}${K} = \\frac{${r}^2 + 2\\,${r}_\\theta^{\\,2} - ${r}\\,${r}_{\\theta\\theta}}` +
      `{\\left(${r}^2 + ${r}_\\theta^{\\,2}\\right)^{3/2}}`,
    filled: `= ${number("rhoK")},\\qquad ${K} = ${number("K")}\\ \\mathrm{m}^{-1}`,
  },
];

export interface TypesetFormula {
  readonly id: string;
  readonly equation: string;
  readonly title: string;
  readonly spoken: string;
  /** Markup of the formula and of the formula with numbers in it. */
  readonly general: string;
  readonly filled: string;
}

/** The formulas as markup without style attributes, and the classes that replace those. */
export function typeset(): { formulas: TypesetFormula[]; css: string } {
  const classes = new Map<string, string>();
  const markup = (tex: string): string =>
    katex
      .renderToString(tex, { output: "html", displayMode: false, throwOnError: true, trust: true, strict: "ignore" })
      .replaceAll(' aria-hidden="true"', "")
      .replace(/<(\w+) class="([^"]*)" style="([^"]*)"/g, (_, tag, names, style) => `<${tag} class="${names} ${named(style)}"`)
      .replace(/<(\w+) style="([^"]*)"/g, (_, tag, style) => `<${tag} class="${named(style)}"`);
  const named = (style: string): string => {
    const name = classes.get(style) ?? `k${classes.size}`;
    classes.set(style, name);
    return name;
  };
  const formulas = FORMULAS.map((formula) => ({
    ...formula,
    general: markup(`\\displaystyle ${formula.general}`),
    filled: markup(`\\displaystyle ${formula.filled}`),
  }));
  const left = formulas.find(({ general, filled }) => (general + filled).includes("style="));
  if (left) throw new Error(`formula ${left.id} still has a style attribute`);
  const css = [...classes].map(([style, name]) => `.katex .${name}{${style}}`).join("\n");
  return { formulas, css };
}

/** Fonts of KaTeX that the formulas use. */
const FONTS = /KaTeX_(Main-Regular|Math-Italic|Size[1-4]-Regular)\.woff2/;

/** `virtual:formulas` and `virtual:formulas.css`; KaTeX's own style sheet with the fonts in use only. */
export function formulas(): Plugin {
  return {
    name: "formulas",
    enforce: "pre",
    resolveId: (id) => (id.startsWith("virtual:formulas") ? `/@${id}` : undefined),
    load(id) {
      if (id === "/@virtual:formulas") return `export default ${JSON.stringify(typeset().formulas)}`;
      if (id === "/@virtual:formulas.css") return typeset().css;
      return undefined;
    },
    transform(code, id) {
      if (!/katex(\.min)?\.css$/.test(id)) return undefined;
      return code
        .replace(/@font-face\s*\{[^}]*\}/g, (face) => (FONTS.test(face) ? face : ""))
        .replace(/,\s*url\([^)]*\.(woff|ttf)\)\s*format\(["'][^"']*["']\)/g, "");
    },
  };
}

import { describe, expect, it } from "vitest";
import { typeset } from "../../build/formulas.ts";

describe("the formulas", () => {
  const { formulas, css } = typeset();
  it("carry no style attribute, which the content security policy forbids", () => {
    for (const { general, filled } of formulas) expect(general + filled).not.toContain("style=");
  });

  it("have a rule for each class that replaces a style", () => {
    const used = new Set(formulas.flatMap(({ general, filled }) => (general + filled).match(/\bk\d+\b/g) ?? []));
    for (const name of used) expect(css).toContain(`.katex .${name}{`);
  });

  it("have places for numbers and symbols to explain", () => {
    for (const { general, filled } of formulas) {
      expect(general).toMatch(/symbol-\w+/);
      expect(filled).toMatch(/number-\w+/);
    }
  });
});

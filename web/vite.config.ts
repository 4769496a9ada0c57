import { defineConfig } from "vitest/config";
import { formulas } from "./build/formulas.ts";
import { contentSecurity, kernelsEarly, singleFile } from "./build/page.ts";

// `vite build` makes the files of the site, `vite build --mode single` the page in one file.
export default defineConfig(({ mode }) => ({
  base: "./",
  plugins: [formulas(), contentSecurity(), kernelsEarly(), ...(mode === "single" ? [singleFile()] : [])],
  build: {
    // Into the Python package, whose command serves it.
    outDir: "../python/archerfish/explorer",
    emptyOutDir: mode !== "single",
    target: "es2022",
    modulePreload: { polyfill: false },
    assetsInlineLimit: mode === "single" ? Number.MAX_SAFE_INTEGER : 0,
    cssCodeSplit: false,
  },
  test: { include: ["tests/unit/**/*.test.ts"], environment: "node" },
}));

import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { describe, expect, it } from "vitest";
import { DIST } from "../../tools/browser.mjs";
import { address, inBrowser, number, read, state, visit } from "./page.ts";

inBrowser();
const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

describe("the page", () => {
  it("loads, asks for nothing but its own files, and reads out Figure 1", async () => {
    await visit("", async ({ page, requests }) => {
      await page.check("#all-digits");
      expect(await read(page, "launch-angle")).toBe(45);
      expect(await read(page, "elevation")).toBeCloseTo(27.0845, 4);
      expect(requests.every((url) => url.startsWith(address()) || url.startsWith("data:"))).toBe(true);
      expect(await page.textContent("#summary-text")).toContain("4.762\u00a0m away and 2.435\u00a0m high");
      expect(await page.locator("#formula-x .number-x").textContent()).toBe("4.76187");
    });
  });

  it("has a strict content security policy that it keeps", async () => {
    await visit("", async ({ page }) => {
      const policy = await page.getAttribute('meta[http-equiv="Content-Security-Policy"]', "content");
      expect(policy).toContain("default-src 'none'");
      expect(policy).not.toContain("unsafe-inline");
      expect(policy).not.toContain("'unsafe-eval'");
    });
  });

  it("opens as one file, by double click", async () => {
    const file = `${DIST}/archerfish-explorer.html`;
    expect(existsSync(file)).toBe(true);
    await visit(
      "#epsilon=3",
      async ({ page, requests }) => {
        expect(await page.textContent("#drag-follows")).toContain("b = 2.942");
        expect(requests.filter((url) => !url.startsWith("data:"))).toHaveLength(1);
        await page.focus("#angle-slider");
        await page.keyboard.press("Home");
        expect(await number(page, "angle")).toBe(0);
      },
      { url: pathToFileURL(file).href },
    );
  });

  it("falls back from a corrupted address, with a message", async () => {
    await visit("#speed=fast&epsilon=-3&angle=30&rubbish", async ({ page }) => {
      const message = await page.textContent("#message p");
      expect(message).toContain("speed must be a number, got fast");
      expect(message).toContain("epsilon must be at least 0 and finite, got -3");
      const now = await state(page);
      expect([now.get("speed"), now.get("epsilon"), now.get("angle")]).toEqual(["10", "0.1", "30"]);
    });
  });

  it("goes to another address without loading anew", async () => {
    await visit("#epsilon=1", async ({ page }) => {
      await page.evaluate(() => {
        location.hash = "#epsilon=2&angle=20";
      });
      await page.waitForTimeout(400);
      expect(await page.textContent("#read-launch-angle")).toBe("20°");
      expect(await page.inputValue("#drag-number")).toBe("2");
    });
  });

  it.each([
    ["0", 5.099],
    ["1000000", 0],
    ["1e300", 0],
  ])("stands ε = %s", async (epsilon, x) => {
    await visit(`#epsilon=${epsilon}&layers=fan,drag_free,envelope,circle,comb,points,ghost&time=0.2&frame=fit`, async ({ page }) => {
      await page.check("#all-digits");
      await state(page);
      expect(await read(page, "x")).toBeCloseTo(x, 3);
      expect(await page.locator("body").innerText()).not.toMatch(/NaN|undefined/);
    });
  });

  it("says so where WebAssembly has no SIMD", async () => {
    await visit(
      "",
      async ({ page }) => {
        await page.waitForSelector(".refused");
        expect(await page.textContent(".refused")).toContain("This browser cannot run WebAssembly with SIMD");
      },
      {
        before: async (page) => void (await page.addInitScript(() => {
          WebAssembly.validate = () => false;
        })),
      },
    );
  });
});

describe("accessibility", () => {
  const everything = "#epsilon=0.5&compare=0.1,3&layers=fan,drag_free,envelope,circle,comb,points,ghost&time=0.3";
  it.each([
    ["light", 1280, 720],
    ["dark", 1280, 720],
    ["light", 390, 844],
    ["dark", 390, 844],
  ] as const)("axe finds nothing: %s, %i × %i", async (colorScheme, width, height) => {
    await visit(
      everything,
      async ({ page }) => {
        for (const details of await page.locator("#tables summary").all()) await details.click();
        await page.evaluate(AXE);
        const violations = await page.evaluate(async () => {
          const { axe } = window as unknown as { axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> } };
          const found = await axe.run();
          return found.violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" ").slice(0, 300)}`);
        });
        expect(violations).toEqual([]);
      },
      { colorScheme, viewport: { width, height } },
    );
  });

  it("explains each symbol on hover and focus", async () => {
    await visit("", async ({ page }) => {
      await page.locator("#formula-x .symbol-rho").first().hover();
      expect(await page.textContent("#tooltip")).toContain("unit of length");
      await page.focus("#formula-x .symbol-x");
      expect(await page.textContent("#tooltip")).toContain("horizontal distance");
      await page.keyboard.press("ArrowRight");
      expect(await page.textContent("#tooltip")).toContain("unit of length");
      await page.keyboard.press("Escape");
      expect(await page.isVisible("#tooltip")).toBe(false);
    });
  });

  it("has a table for each plot", async () => {
    await visit("", async ({ page }) => {
      const tables = page.locator("#tables details");
      expect(await tables.count()).toBe(5);
      for (const details of await tables.all()) {
        await details.locator("summary").click();
        await expect.poll(() => details.locator("tbody tr").count()).toBeGreaterThan(4);
      }
    });
  });
});

describe("layouts", () => {
  it.each([
    [1280, 720],
    [390, 844],
    [320, 640],
    [800, 1000],
    [1920, 1080],
  ])("nothing sticks out at %i × %i", async (width, height) => {
    await visit(
      "#epsilon=1234.5678&speed=123.456&angle=12.345&compare=0.001,0.02,30,400",
      async ({ page }) => {
        await page.check("#all-digits");
        await page.waitForTimeout(100);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        expect(wide).toBeLessThanOrEqual(width);
        const cut = await page.evaluate(() =>
          [...document.querySelectorAll("button, label, dd, dt, legend, output, h2, figcaption")]
            .filter((element) => element.scrollWidth > element.clientWidth + 1 && getComputedStyle(element).display !== "inline")
            .filter((element) => !element.classList.contains("visually-hidden"))
            .map((element) => `${element.tagName} ${element.textContent}`),
        );
        expect(cut).toEqual([]);
      },
      { viewport: { width, height } },
    );
  });
});

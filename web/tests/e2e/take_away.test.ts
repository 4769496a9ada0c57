import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { type Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { short } from "../../src/model/numbers.ts";
import { inBrowser, state, visit } from "./page.ts";

inBrowser();

/** A Python in which archerfish is installed: the project's own, unless told otherwise. */
const own = fileURLToPath(new URL("../../../.venv/bin/python", import.meta.url));
const PYTHON = process.env["ARCHERFISH_PYTHON"] ?? (existsSync(own) ? own : "python3");
const python = (...parts: string[]): string => execFileSync(PYTHON, parts, { encoding: "utf8", maxBuffer: 1e8 });

async function download(page: Page, button: string): Promise<Buffer> {
  const [file] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
  return readFileSync(await file.path());
}

const clipboard = (page: Page): Promise<string> => page.evaluate(() => navigator.clipboard.readText());

describe("CSV", () => {
  it.each([
    ["--epsilon 0.1", "#speed=10&epsilon=0.1"],
    ["--epsilon 0", "#speed=10&epsilon=0"],
    ["--epsilon 1000000", "#speed=10&epsilon=1e6"],
    ["--epsilon 3 --gravity 1.62", "#speed=10&epsilon=3&gravity=1.62"],
    ["--drag-rate 816", "#speed=10&drag_rate=816"],
    ["--terminal-speed 30", "#speed=10&terminal_speed=30"],
  ])("of %s is Python's to the last bit", async (flags, hash) => {
    const expected = python("-m", "archerfish", "locus", "--speed", "10", ...flags.split(" "), "--points", "2000", "--format", "csv");
    await visit(hash, async ({ page }) => {
      const csv = (await download(page, "#save-csv")).toString("utf8");
      expect(csv.split("\n").length).toBe(2002);
      expect(csv === expected, difference(csv, expected)).toBe(true);
    });
  });
});

/** The first lines that differ. */
function difference(one: string, other: string): string {
  const [left, right] = [one.split("\n"), other.split("\n")];
  const index = left.findIndex((line, at) => line !== right[at]);
  return `line ${index + 1}:\n${left[index]}\n${right[index]}`;
}

describe("the readout", () => {
  it("is what its line of Python gives, bit for bit", async () => {
    await visit("#speed=12.5&epsilon=0.7&angle=33.3", async ({ page }) => {
      await page.check("#all-digits");
      await page.click("#copy-python");
      const line = (await clipboard(page)).replace("print(", "point = (");
      const program = `${line}; import numpy; print(*map(float, (numpy.degrees(point.elevation), point.x, point.y, point.distance, point.time)))`;
      const expected = python("-c", program).trim().split(" ").map(Number);
      const shown = await Promise.all(
        ["elevation", "x", "y", "distance", "time"].map(async (name) =>
          Number.parseFloat((await page.textContent(`#read-${name}`)) ?? ""),
        ),
      );
      expect(shown).toEqual(expected);
    });
  });
});

describe("the table of the named angles", () => {
  it("shows only digits that are Python's", async () => {
    const program = `
import json, numpy
from archerfish import named_angles as named
epsilon = numpy.array([0, 0.1, 1, 10, 100, 1e6])
angles = [named.greatest_range_angle, named.greatest_curvature_angle, named.rightmost_angle, named.farthest_angle, named.receding_angle]
print(json.dumps(numpy.degrees([angle(epsilon) for angle in angles]).T.tolist()))`;
    const expected = (JSON.parse(python("-c", program)) as number[][]).map((row) => row.map((angle) => short(angle, 8)));
    await visit("#epsilon=1e6", async ({ page }) => {
      await page.locator("#tables summary").last().click();
      const rows = page.locator("#tables details[open] tbody tr");
      await expect.poll(() => rows.count()).toBe(6);
      const shown = await rows.evaluateAll((all) => all.map((row) => [...row.children].slice(1).map((cell) => cell.textContent)));
      expect(shown).toEqual(expected);
    });
  });
});

type Place = readonly [number, number];

/** The lines of a path made of M and L. */
function lines(path: string): Place[][] {
  return path
    .split("M")
    .slice(1)
    .map((line) => line.split("L").map((pair) => pair.split(",").map(Number) as unknown as Place));
}

/** How far a place is from the nearest of some lines. */
function distance(all: readonly Place[][], [x, y]: Place): number {
  let nearest = Infinity;
  for (const line of all) {
    for (let index = 1; index < line.length; index += 1) {
      const [[x0, y0], [x1, y1]] = [line[index - 1], line[index]];
      const square = (x1 - x0) ** 2 + (y1 - y0) ** 2;
      const part = Math.min(1, Math.max(0, ((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / (square || 1)));
      nearest = Math.min(nearest, Math.hypot(x0 + part * (x1 - x0) - x, y0 + part * (y1 - y0) - y));
    }
  }
  return nearest;
}

describe("pictures", () => {
  it("are SVG that stands alone", async () => {
    await visit("#epsilon=0.5&layers=fan,drag_free,envelope,circle,comb,points", async ({ page }) => {
      const svg = (await download(page, "#save-svg")).toString("utf8");
      expect(svg).toMatch(/^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
      expect(svg).not.toMatch(/NaN|undefined|var\(--|href=/);
      const shapes = await page.evaluate((text) => {
        const document = new DOMParser().parseFromString(text, "image/svg+xml");
        return [document.querySelectorAll("parsererror").length, document.querySelectorAll("path").length];
      }, svg);
      expect(shapes[0]).toBe(0);
      expect(shapes[1]).toBeGreaterThan(30);
    });
  });

  it("show the mirror image where both sides are shown", async () => {
    const curves = async (hash: string): Promise<number[]> => {
      let counts: number[] = [];
      await visit(hash, async ({ page }) => {
        const svg = (await download(page, "#save-svg")).toString("utf8");
        // Thick: the locus in the legend and itself, the shot, the curves of four panels. A curve begins with one M.
        const paths = [...svg.matchAll(/<path d="([^"]*)"[^>]*stroke-width="2(?:\.6)?"/g)];
        counts = paths.map(([, d = ""]) => d.match(/M/g)?.length ?? 0);
      });
      return counts;
    };
    expect(await curves("#angle=40&layers=")).toEqual([1, 1, 1, 1, 1, 1, 1]);
    expect(await curves("#angle=140&layers=")).toEqual([1, 2, 1, 2, 2, 2, 2]);
  });

  it.each([40, 140])("have the cursors on their curves, and the apex on shot and locus, at %d°", async (angle) => {
    await visit(`#angle=${angle}&epsilon=0.7&layers=`, async ({ page }) => {
      const svg = (await download(page, "#save-svg")).toString("utf8");
      const paths = [...svg.matchAll(/<path d="([^"]*)"[^>]*stroke-width="2(?:\.6)?"/g)].map(([, d = ""]) => lines(d));
      const handles = [".handle.apex", ...["elevation", "slope", "bend", "curvature"].map((name) => `#${name}-panel .handle`)];
      const places = await page.evaluate(
        (selectors) =>
          selectors.map((selector) => {
            const { transform } = (document.querySelector(selector) as HTMLElement).style;
            return (transform.match(/-?[\d.]+/g) ?? []).map(Number) as [number, number];
          }),
        handles,
      );
      const [apex, ...cursors] = places;
      const [, locus, shot, ...curves] = paths;
      expect(curves).toHaveLength(4);
      expect(distance(locus, apex)).toBeLessThan(0.5);
      expect(distance(shot, apex)).toBeLessThan(0.5);
      // Nowhere is the shot higher.
      expect(Math.min(...shot.flat().map(([, y]) => y))).toBeGreaterThan(apex[1] - 0.5);
      cursors.forEach((cursor, index) => expect(distance(curves[index], cursor), handles[index + 1]).toBeLessThan(0.5));
    });
  });

  it("are PNG of twice the size", async () => {
    await visit("", async ({ page }) => {
      const png = await download(page, "#save-png");
      expect(png.subarray(1, 4).toString()).toBe("PNG");
      const width = await page.evaluate(() => document.querySelector("#main-panel")!.clientWidth);
      expect(png.readUInt32BE(16)).toBeGreaterThanOrEqual(2 * width);
      expect(png.length).toBeGreaterThan(20_000);
    });
  });
});

describe("the link", () => {
  it("brings the whole view back", async () => {
    const hash = "#speed=3.3&gravity=1.62&drag_rate=0.123&angle=61.7&time=0.25&compare=0.5,2&layers=fan,comb&curvature_by=elevation&frame=fit&sides=right&theme=dark";
    await visit(hash, async ({ page }) => {
      await page.click("#copy-link");
      const link = await clipboard(page);
      expect(new URL(link).hash).toBe(hash);
      expect((await state(page)).toString()).toBe(new URLSearchParams(hash.slice(1)).toString());
      const [words, csv] = [await page.textContent("#summary-text"), await download(page, "#save-csv")];
      await page.goto("about:blank");
      await page.goto(link);
      await page.waitForFunction(() => document.querySelector("#summary-text")?.textContent !== "");
      expect(await page.textContent("#summary-text")).toBe(words);
      expect((await download(page, "#save-csv")).equals(csv)).toBe(true);
    });
  });
});

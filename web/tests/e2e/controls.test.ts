import { describe, expect, it } from "vitest";
import { inBrowser, middle, number, read, state, visit } from "./page.ts";

inBrowser();

describe("keyboard", () => {
  it.each([
    ["#drag-slider", "epsilon", [["ArrowRight", 0.102], ["Home", 0], ["End", 1000], ["PageDown", 245]]],
    ["#angle-slider", "angle", [["ArrowRight", 45.1], ["PageUp", 54.1], ["Home", 0], ["End", 90]]],
    ["#speed-slider", "speed", [["ArrowLeft", 9.77], ["Home", 0.1], ["End", 1000]]],
  ] as const)("moves %s", async (selector, name, keys) => {
    await visit("", async ({ page }) => {
      await page.focus(selector);
      for (const [key, value] of keys) {
        await page.keyboard.press(key);
        expect(await number(page, name)).toBeCloseTo(value, name === "epsilon" && value > 1 ? -2 : 6);
      }
    });
  });

  it.each([
    [".handle.apex", [["ArrowUp", 45.5], ["ArrowLeft", 45], ["PageUp", 50], ["Home", 0], ["End", 90], ["PageDown", 85]]],
    [".handle.direction", [["ArrowRight", 45.5], ["End", 90], ["PageUp", 95], ["End", 180], ["Home", 0]]],
    ["#curvature-panel .handle", [["ArrowRight", 45.5], ["PageDown", 40.5]]],
  ] as const)("turns the shot by %s", async (selector, keys) => {
    await visit("", async ({ page }) => {
      await page.focus(selector);
      for (const [key, angle] of keys) {
        await page.keyboard.press(key);
        expect(await number(page, "angle")).toBe(angle);
      }
    });
  });

  it("moves the drag in the panel of the named angles", async () => {
    await visit("", async ({ page }) => {
      await page.focus("#named-panel .handle");
      await page.keyboard.press("ArrowRight");
      expect(await number(page, "epsilon")).toBe(0.102);
      await page.keyboard.press("Home");
      expect(await number(page, "epsilon")).toBe(0);
    });
  });

  it("reaches every control by Tab", async () => {
    await visit("", async ({ page }) => {
      const seen = new Set<string>();
      for (let press = 0; press < 80; press += 1) {
        await page.keyboard.press("Tab");
        const name = await page.evaluate(() => {
          const element = document.activeElement;
          return element?.id || element?.getAttribute("aria-label") || element?.getAttribute("name") || element?.tagName || "";
        });
        seen.add(name);
      }
      const wanted = await page.evaluate(() =>
        [...document.querySelectorAll("header [id], #controls input[id], #controls select, #controls button[id]")]
          .filter((element) => element.matches("input, select, button") && !(element as HTMLInputElement).disabled)
          .map((element) => element.id),
      );
      expect(wanted.length).toBeGreaterThan(20);
      for (const id of wanted) expect(seen, id).toContain(id);
      for (const label of ["Apex of the shot", "Launch direction"]) expect(seen).toContain(label);
    });
  });
});

describe("pointer", () => {
  it("drags the apex along the locus, and the launch direction", async () => {
    await visit("", async ({ page }) => {
      await page.check("#all-digits");
      const before = await read(page, "elevation");
      const apex = await middle(page, ".handle.apex");
      await page.mouse.move(apex.x, apex.y);
      await page.mouse.down();
      await page.mouse.move(apex.x - 60, apex.y - 100, { steps: 4 });
      await page.mouse.up();
      const after = await read(page, "elevation");
      expect(after).toBeGreaterThan(before + 5);
      // The apex lies under the ray from the launch point to the pointer.
      const origin = await page.evaluate(() => {
        const ray = document.querySelector(".handle.direction")!.getBoundingClientRect();
        return ray.top;
      });
      expect(origin).toBeGreaterThan(0);
      await state(page);
      const now = await middle(page, ".handle.apex");
      expect(Math.abs(now.x - apex.x) + Math.abs(now.y - apex.y)).toBeGreaterThan(20);

      const tip = await middle(page, ".handle.direction");
      await page.mouse.move(tip.x, tip.y);
      await page.mouse.down();
      await page.mouse.move(tip.x + 90, tip.y + 60, { steps: 4 });
      await page.mouse.up();
      expect(await read(page, "launch-angle")).toBeLessThan(after);
    });
  });

  it("takes the locus where it is pressed", async () => {
    await visit("", async ({ page }) => {
      const box = (await page.locator("#main-panel").boundingBox())!;
      await page.mouse.click(box.x + 200, box.y + 80);
      expect(await number(page, "angle")).toBeGreaterThan(60);
    });
  });

  it("moves one cursor in all panels", async () => {
    await visit("", async ({ page }) => {
      const panels = ["elevation", "slope", "bend", "curvature"].map((name) => `#${name}-panel .handle`);
      const before = await Promise.all(panels.map((selector) => middle(page, selector)));
      const box = (await page.locator("#slope-panel").boundingBox())!;
      await page.mouse.click(box.x + box.width * 0.8, box.y + box.height / 2);
      await state(page);
      const after = await Promise.all(panels.map((selector) => middle(page, selector)));
      after.forEach(({ x }, index) => expect(x).toBeGreaterThan(before[index].x + 20));
      const named = (await page.locator("#named-panel").boundingBox())!;
      await page.mouse.click(named.x + named.width - 30, named.y + 40);
      expect(await number(page, "epsilon")).toBeGreaterThan(100);
    });
  });

  it("takes shots to the left where both sides are shown", async () => {
    await visit("", async ({ page }) => {
      const box = (await page.locator("#main-panel").boundingBox())!;
      // One side: a pointer that strays over the vertical stays on it.
      await page.mouse.click(box.x + 10, box.y + 80);
      expect(await number(page, "angle")).toBe(90);
      await page.check("#both-sides");
      // A click counts where the picture shows it: wait until it shows both sides.
      await state(page);
      await page.mouse.click(box.x + box.width * 0.3, box.y + 130);
      const angle = await number(page, "angle");
      expect(angle).toBeGreaterThan(100);
      expect(await page.textContent("#read-x")).toMatch(/^−/);
      expect(await page.textContent("#summary-text")).toContain("to the left");
      expect(await page.getAttribute("#angle-slider", "max")).toBe("180");
      await page.uncheck("#both-sides");
      expect(await number(page, "angle")).toBeCloseTo(180 - angle, 9);
    });
  });

  it("draws again only what moved", async () => {
    await visit("#compare=1&angle=40", async ({ page }) => {
      await page.evaluate(() => {
        const drawn = { strokes: 0, svg: 0, pictures: 0 };
        const prototype = CanvasRenderingContext2D.prototype;
        const [stroke, drawImage] = [prototype.stroke, prototype.drawImage];
        prototype.stroke = function (this: CanvasRenderingContext2D) {
          drawn.strokes += 1;
          Reflect.apply(stroke, this, []);
        };
        prototype.drawImage = function (this: CanvasRenderingContext2D, ...parts: unknown[]) {
          drawn.pictures += 1;
          Reflect.apply(drawImage, this, parts);
        } as typeof drawImage;
        const watch = new MutationObserver((changes) => (drawn.svg += changes.length));
        for (const svg of document.querySelectorAll(".plot svg")) watch.observe(svg, { childList: true, subtree: true });
        Object.assign(window, { drawn });
      });
      const after = async (selector: string, key: string) => {
        await page.focus(selector);
        await page.keyboard.press(key);
        await state(page);
        return page.evaluate(() => {
          const { drawn } = window as unknown as { drawn: { strokes: number; svg: number; pictures: number } };
          const now = { ...drawn };
          Object.assign(drawn, { strokes: 0, svg: 0, pictures: 0 });
          return now;
        });
      };
      // The drag: fan, locus, shot, ray, arrow; a curve and a cursor in four panels; a cursor in the fifth.
      expect(await after("#drag-slider", "ArrowRight")).toEqual({ strokes: 14, svg: 0, pictures: 1 });
      await after("#angle-slider", "ArrowRight"); // Now the curves are kept.
      expect(await after("#angle-slider", "ArrowRight")).toEqual({ strokes: 8, svg: 0, pictures: 6 });
      // Flight time: nothing moves but the ball.
      expect(await after("#time-slider", "ArrowRight")).toEqual({ strokes: 3, svg: 0, pictures: 1 });
    });
  });

  it("drags by touch on a handle", async () => {
    await visit(
      "",
      async ({ page }) => {
        const { x, y } = await middle(page, ".handle.apex");
        const client = await page.context().newCDPSession(page);
        const touch = (type: string, dx: number, dy: number) =>
          client.send("Input.dispatchTouchEvent", {
            type: type as "touchStart",
            touchPoints: type === "touchEnd" ? [] : [{ x: x + dx, y: y + dy }],
          });
        await touch("touchStart", 0, 0);
        await touch("touchMove", -20, -30);
        await touch("touchMove", -30, -50);
        await touch("touchEnd", 0, 0);
        expect(await number(page, "angle")).toBeGreaterThan(55);
        expect(await page.evaluate(() => window.scrollY)).toBe(0);
      },
      { viewport: { width: 390, height: 844 }, hasTouch: true },
    );
  });
});

describe("controls", () => {
  it("say the drag in three ways", async () => {
    await visit("", async ({ page }) => {
      await page.check('input[value="terminal_speed"]');
      expect((await state(page)).get("terminal_speed")).toBe("100");
      await page.fill("#drag-number", "inf");
      await page.keyboard.press("Enter");
      expect((await state(page)).get("terminal_speed")).toBe("inf");
      expect(await page.textContent("#drag-follows")).toContain("ε = 0");
      await page.check('input[value="drag_rate"]');
      expect(await number(page, "drag_rate")).toBe(0);
    });
  });

  it("set speed and gravity", async () => {
    await visit("", async ({ page }) => {
      await page.selectOption("#gravity-place", "1.62");
      expect(await number(page, "gravity")).toBe(1.62);
      await page.fill("#gravity-number", "5");
      await page.keyboard.press("Enter");
      expect(await number(page, "gravity")).toBe(5);
      expect(await page.inputValue("#gravity-place")).toBe("own");
      await page.fill("#speed-number", "25");
      await page.keyboard.press("Tab");
      expect(await number(page, "speed")).toBe(25);
    });
  });

  it("refuse what cannot be, and say why", async () => {
    await visit("", async ({ page }) => {
      await page.fill("#drag-number", "-0.1");
      await page.keyboard.press("Enter");
      expect(await page.textContent("#message p")).toBe("epsilon must be at least 0 and finite, got -0.1");
      expect(await page.getAttribute("#drag-number", "aria-invalid")).toBe("true");
      expect(await number(page, "epsilon")).toBe(0.1);
      await page.click("#message button");
      expect(await page.isVisible("#message")).toBe(false);
    });
  });

  it("compare", async () => {
    await visit("", async ({ page }) => {
      await page.fill("#compare-number", "3");
      await page.click("#compare-add");
      await page.fill("#compare-number", "10");
      await page.keyboard.press("Enter");
      expect((await state(page)).get("compare")).toBe("3,10");
      await page.click('#compare-list button >> nth=0');
      expect((await state(page)).get("compare")).toBe("10");
    });
  });

  it("lay things over the picture", async () => {
    await visit("#layers=", async ({ page }) => {
      const pixels = async () => (await page.locator("#main-panel").screenshot()).toString("base64");
      let last = await pixels();
      for (const layer of ["fan", "drag_free", "envelope", "circle", "comb", "points", "ghost"]) {
        await page.check(`#layer-${layer}`);
        await page.waitForTimeout(60);
        const now = await pixels();
        expect(now, layer).not.toBe(last);
        last = now;
      }
      expect((await state(page)).get("layers")?.split(",")).toHaveLength(7);
      await page.check("#fit");
      expect((await state(page)).get("frame")).toBe("fit");
    });
  });

  it("play, pause and step the flight", async () => {
    await visit("", async ({ page }) => {
      await page.click("#step-on");
      const first = await number(page, "time");
      expect(first).toBeGreaterThan(0.02);
      await page.click("#step-back");
      expect(await number(page, "time")).toBe(0);
      const started = Date.now();
      await page.click("#play");
      await page.waitForTimeout(500);
      await page.click("#play");
      const [time, passed] = [await number(page, "time"), (Date.now() - started) / 1000];
      expect(time).toBeGreaterThan(0.3);
      expect(time).toBeLessThan(passed);
      expect(await page.textContent("#play")).toBe("Play");
      await page.focus("#time-slider");
      await page.keyboard.press("End");
      expect(await number(page, "time")).toBeCloseTo(1.41, 2);
    });
  });

  it("play in a few steps where motion is to be reduced", async () => {
    await visit(
      "",
      async ({ page }) => {
        await page.evaluate(() => {
          const times = new Set<string>();
          const output = document.querySelector("#time-output")!;
          new MutationObserver(() => times.add(output.textContent ?? "")).observe(output, { childList: true, characterData: true, subtree: true });
          Object.assign(window, { times });
        });
        await page.click("#play");
        await page.waitForTimeout(1300);
        const count = await page.evaluate(() => (window as unknown as { times: Set<string> }).times.size);
        expect(count).toBeGreaterThanOrEqual(1);
        expect(count).toBeLessThanOrEqual(3);
      },
      { reducedMotion: "reduce" },
    );
  });

  it("start from presets", async () => {
    await visit("", async ({ page }) => {
      const wanted = { branch3: "3", branch10: "10", figure1: "0.1" };
      for (const [preset, epsilon] of Object.entries(wanted)) {
        await page.selectOption("#preset", preset);
        expect((await state(page)).get("epsilon")).toBe(epsilon);
        expect(await page.textContent("#about")).not.toBe("");
      }
      await page.selectOption("#preset", "droplet");
      expect((await state(page)).get("drag_rate")).toBe("816");
      expect(await page.textContent("#read-x")).toMatch(/µm$/);
      await page.selectOption("#preset", "game");
      expect(await number(page, "speed")).toBe(12);
      await page.focus("#angle-slider");
      await page.keyboard.press("ArrowRight");
      await state(page);
      expect(await page.inputValue("#preset")).toBe("");
    });
  });

  it("change the theme", async () => {
    await visit("", async ({ page }) => {
      const paper = () => page.evaluate(() => getComputedStyle(document.querySelector("#stage")!).backgroundColor);
      const light = await paper();
      await page.selectOption("#theme", "dark");
      expect(await paper()).not.toBe(light);
      expect((await state(page)).get("theme")).toBe("dark");
    });
    await visit("", async ({ page }) => {
      expect(await page.getAttribute("html", "data-theme")).toBe("dark");
    }, { colorScheme: "dark" });
  });
});

// The explorer's bars, measured: npm run bench. Frames in headless Chromium, sizes of the built files.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { DIST, open, settled } from "./browser.mjs";

const STEPS = 600;
const MEMORY_STEPS = 10_000;
const BARS = {
  "frame, median (ms)": 8,
  "frame, 95th percentile (ms)": 16,
  "computing, median (ms)": 1,
  "first load without fonts (kB, gzip)": 150,
  "interactive from loopback (ms)": 1000,
  "memory gained in 10 000 steps (kB)": 500,
};

const quantile = (values, part) => [...values].sort((a, b) => a - b)[Math.floor(part * (values.length - 1))];

/** kB of everything the page loads, compressed, but its fonts. */
function weight() {
  const files = ["index.html", ...readdirSync(join(DIST, "assets")).map((name) => `assets/${name}`)];
  const kept = files.filter((name) => !name.endsWith(".woff2"));
  return kept.reduce((sum, name) => sum + gzipSync(readFileSync(join(DIST, name)), { level: 9 }).length, 0) / 1000;
}

/** Moves the drag slider to one position after the other; ms of each step, to the end of its frame. */
function slide(count) {
  return new Promise((done) => {
    const slider = document.querySelector("#drag-slider");
    const { port1, port2 } = new MessageChannel();
    const [frames, computing] = [[], []];
    let start = 0;
    const step = () => {
      start = performance.now();
      const next = Number(slider.value) + 1;
      slider.value = String(next > 500 ? 101 : next);
      slider.dispatchEvent(new Event("input"));
      // The explorer asked first, so its frame is drawn when this one's turn comes.
      requestAnimationFrame(() => port2.postMessage(0));
    };
    // A message is delivered after the frame has been laid out and painted.
    port1.onmessage = () => {
      frames.push(performance.now() - start);
      computing.push(window.archerfish.computing);
      if (frames.length < count) setTimeout(step);
      else done({ frames, computing });
    };
    step();
  });
}

// Frames as they come: what is measured is the work of a frame, not the wait for a screen.
const { browser, address, close } = await open(["--disable-frame-rate-limit", "--disable-gpu-vsync"]);
const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
await page.goto(address);
await settled(page);
const interactive = await page.evaluate(() => window.archerfish.interactive);
await page.evaluate(slide, 100); // The compiler has seen it all by then.

const results = {};
const { frames, computing } = await page.evaluate(slide, STEPS);
results["frame, median (ms)"] = quantile(frames, 0.5);
results["frame, 95th percentile (ms)"] = quantile(frames, 0.95);
results["computing, median (ms)"] = quantile(computing, 0.5);
results["first load without fonts (kB, gzip)"] = weight();
results["interactive from loopback (ms)"] = interactive;

const client = await page.context().newCDPSession(page);
const heap = async () => {
  await client.send("HeapProfiler.collectGarbage");
  return (await client.send("Runtime.getHeapUsage")).usedSize / 1000;
};
const before = await heap();
await page.evaluate(slide, MEMORY_STEPS);
results["memory gained in 10 000 steps (kB)"] = (await heap()) - before;
await close();

let failed = false;
for (const [name, value] of Object.entries(results)) {
  const within = value <= BARS[name];
  failed ||= !within;
  console.log(`${name.padEnd(40)} ${value.toFixed(2).padStart(9)}   at most ${BARS[name]}${within ? "" : "   MISSED"}`);
}
process.exitCode = failed ? 1 : 0;

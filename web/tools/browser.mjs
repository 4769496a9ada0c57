// The built page in a real browser without a window.

import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { serve } from "./serve.mjs";

export const DIST = fileURLToPath(new URL("../../python/archerfish/explorer", import.meta.url));
const BROWSERS = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** Flags that keep the browser from looking for its maker's hosts. */
const QUIET = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** The browser, the address of the built page, and how to end both. */
export async function open(flags = []) {
  const executablePath = BROWSERS.find((path) => path && existsSync(path));
  if (!executablePath) {
    throw new Error("the explorer's tests need Chromium: apt-get install chromium, or set CHROMIUM to its path");
  }
  const site = await serve(DIST);
  const browser = await chromium.launch({ executablePath, args: [...QUIET, ...flags] });
  return {
    browser,
    address: site.address,
    async close() {
      await browser.close();
      site.stop();
    },
  };
}

/** Waits until the page has drawn all there is and is at rest. */
export async function settled(page) {
  await page.waitForFunction(() => window.archerfish?.resting);
  await page.evaluate(() => document.fonts.ready.then(() => undefined));
}

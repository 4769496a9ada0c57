// Pictures of the page in each layout and theme, to be looked at: npm run screenshots [folder]

import { mkdirSync } from "node:fs";
import { open, settled } from "./browser.mjs";

const folder = process.argv[2] ?? "screenshots";
const SIZES = { desktop: [1280, 720], phone: [390, 844], projector: [1920, 1080] };
const VIEWS = {
  figure1: "",
  left: "#speed=10&epsilon=1&angle=130&time=0.3&layers=fan,drag_free,circle&sides=both",
  branch: "#speed=10&epsilon=10&angle=57.3&layers=fan,ghost&frame=fit",
  layers:
    "#speed=10&epsilon=0.5&angle=50&time=0.4&compare=0.1,3&layers=fan,drag_free,envelope,circle,comb,points&curvature_by=elevation",
};

mkdirSync(folder, { recursive: true });
const { browser, address, close } = await open();
for (const [size, [width, height]] of Object.entries(SIZES)) {
  for (const theme of ["light", "dark"]) {
    for (const [view, hash] of Object.entries(VIEWS)) {
      const context = await browser.newContext({
        viewport: { width, height },
        colorScheme: theme,
        deviceScaleFactor: size === "phone" ? 2 : 1,
        hasTouch: size === "phone",
      });
      const page = await context.newPage();
      await page.goto(address + hash);
      await settled(page);
      const path = `${folder}/${size}-${theme}-${view}.png`;
      await page.screenshot({ path });
      if (theme === "light" || view === "layers") {
        await page.screenshot({ path: path.replace(".png", "-whole.png"), fullPage: true });
      }
      await context.close();
    }
  }
}
await close();
console.log(`wrote ${folder}`);

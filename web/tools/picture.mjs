// The picture of the README, as the page itself saves it: npm run picture FILE

import { copyFileSync } from "node:fs";
import { open, settled } from "./browser.mjs";

const { browser, address, close } = await open();
const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
await page.goto(`${address}#speed=10&epsilon=0.5&angle=50&compare=0.1,3&layers=fan,drag_free,points&theme=light`);
await settled(page);
const [file] = await Promise.all([page.waitForEvent("download"), page.click("#save-svg")]);
copyFileSync(await file.path(), process.argv[2] ?? "explorer.svg");
await close();

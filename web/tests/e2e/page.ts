/** The built page in a browser, for tests. */

import { type BrowserContextOptions, type Page } from "playwright-core";
import { afterAll, beforeAll, expect } from "vitest";
import { open, settled } from "../../tools/browser.mjs";

export interface Opened {
  readonly page: Page;
  /** What the page complained about, and where it asked for something. */
  readonly problems: string[];
  readonly requests: string[];
}

let running: Awaited<ReturnType<typeof open>>;

/** Starts the browser before the tests of a file and ends it after them. */
export function inBrowser(): void {
  beforeAll(async () => {
    running = await open();
  });
  afterAll(async () => {
    await running.close();
  });
}

export const address = (): string => running.address;

/** Opens the page, does something with it, and demands that it had no problem of its own. */
export async function visit(
  hash: string,
  act: (opened: Opened) => Promise<void>,
  options: BrowserContextOptions & { readonly url?: string; readonly before?: (page: Page) => Promise<void> } = {},
): Promise<void> {
  const { url = running.address, before, ...rest } = options;
  const context = await running.browser.newContext({ viewport: { width: 1280, height: 720 }, ...rest });
  if (url.startsWith("http")) await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const page = await context.newPage();
  const [problems, requests]: [string[], string[]] = [[], []];
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error" || message.type() === "warning") problems.push(message.text());
  });
  page.on("request", (request) => requests.push(request.url()));
  try {
    await before?.(page);
    await page.goto(url + hash);
    if (!before) await settled(page);
    await act({ page, problems, requests });
    expect(problems).toEqual([]);
  } finally {
    await context.close();
  }
}

/** The state in the address, once the page has come to rest. */
export async function state(page: Page): Promise<URLSearchParams> {
  // A turn later: what was pressed last has been heard by then.
  await page.evaluate(() => new Promise((done) => setTimeout(done)));
  await page.waitForFunction(() => (window as unknown as { archerfish: { resting: boolean } }).archerfish.resting);
  return new URLSearchParams(new URL(page.url()).hash.slice(1));
}

export const number = async (page: Page, name: string): Promise<number> => Number((await state(page)).get(name));

/** A number read out, every digit of it. */
export async function read(page: Page, name: string): Promise<number> {
  return Number.parseFloat((await page.textContent(`#read-${name}`)) ?? "");
}

/** Middle of a handle, in the page's pixels. */
export async function middle(page: Page, selector: string): Promise<{ x: number; y: number }> {
  const box = await page.locator(selector).boundingBox();
  if (!box) throw new Error(`${selector} is not to be seen`);
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

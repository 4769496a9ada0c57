/** Taking the view away: as a picture, as data, as a line of Python, as an address. */

import { byId, setText } from "./dom.ts";
import { type Chart } from "./chart.ts";
import { escaped, FONT } from "./painter.ts";

export interface View {
  readonly charts: readonly [Chart, ...Chart[]];
  /** Below the picture: what it shows. */
  caption(): string;
  csv(): string;
  python(): string;
  link(): string;
}

const PNG_SCALE = 2;
const GAP = 18;

export class TakeAway {
  readonly #view: View;
  readonly #complain: (sentence: string | undefined) => void;

  constructor(view: View, complain: (sentence: string | undefined) => void) {
    this.#view = view;
    this.#complain = complain;
    byId("save-svg").addEventListener("click", () => save("archerfish.svg", new Blob([picture(view).svg], SVG_TYPE)));
    byId("save-png").addEventListener("click", () => void this.#png());
    byId("save-csv").addEventListener("click", () => save("archerfish.csv", new Blob([view.csv()], { type: "text/csv" })));
    byId("copy-python").addEventListener("click", () => void this.#copy("copy-python", view.python()));
    byId("copy-link").addEventListener("click", () => void this.#copy("copy-link", view.link()));
  }

  async #png(): Promise<void> {
    const { svg, width, height } = picture(this.#view);
    const image = new Image();
    const address = URL.createObjectURL(new Blob([svg], SVG_TYPE));
    try {
      image.src = address;
      await image.decode();
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [width * PNG_SCALE, height * PNG_SCALE];
      canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
      const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/png"));
      if (blob) save("archerfish.png", blob);
    } catch {
      this.#complain("This browser could not turn the picture into PNG; SVG works.");
    } finally {
      URL.revokeObjectURL(address);
    }
  }

  async #copy(id: string, text: string): Promise<void> {
    const button = byId(id);
    const label = button.dataset["label"] ?? (button.dataset["label"] = button.textContent ?? "");
    try {
      await navigator.clipboard.writeText(text);
      setText(button, "Copied");
      setTimeout(() => setText(button, label), 1500);
    } catch {
      // No clipboard (a page from a file, or no permission): to be copied by hand.
      this.#complain(text);
    }
  }
}

const SVG_TYPE = { type: "image/svg+xml" };

/** The main panel above the linked ones, as one SVG. */
function picture({ charts, caption }: View): { svg: string; width: number; height: number } {
  const [main, ...small] = charts;
  const { colors, fontSize } = main;
  const title = fontSize + 4;
  // As many beside each other as on the page.
  const first = small[0]?.host.getBoundingClientRect().top;
  const columns = Math.max(1, small.filter(({ host }) => host.getBoundingClientRect().top === first).length);
  const width = Math.ceil(Math.max(main.width, columns * (small[0]?.width ?? 0)));
  const parts = [main.toSvg(0, title)];
  let top = title + main.height + GAP;
  for (let row = 0; row < small.length; row += columns) {
    const line = small.slice(row, row + columns);
    line.forEach((chart, index) => parts.push(chart.toSvg(Math.round((index * width) / columns), top)));
    top += Math.max(...line.map((chart) => chart.height)) + GAP;
  }
  const height = Math.ceil(top + fontSize);
  const svg = [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img">`,
    `<title>${escaped(caption())}</title>`,
    `<rect width="100%" height="100%" fill="${colors.paper}"/>`,
    ...parts,
    `<text x="6" y="${height - 6}" fill="${colors.muted}" font-family="${FONT}" font-size="${0.9 * fontSize}">${escaped(caption())}</text>`,
    "</svg>\n",
  ].join("\n");
  return { svg, width, height };
}

function save(name: string, blob: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

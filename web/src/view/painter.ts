/** One way to draw for the screen and for a file: the same strokes on a canvas and as SVG. */

import { path as svgPath } from "d3-path";

/** What a canvas and d3-path both understand. */
export interface Pen {
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
  arc(x: number, y: number, radius: number, start: number, end: number): void;
  closePath(): void;
}

export interface Stroke {
  readonly color: string;
  readonly width: number;
  readonly dash?: readonly number[];
  readonly opacity?: number;
}

export interface Text {
  readonly color: string;
  readonly size: number;
  readonly anchor?: "start" | "middle" | "end";
  /** Colour of a rim that keeps it legible on curves. */
  readonly halo?: string;
}

export interface Painter {
  stroke(style: Stroke, build: (pen: Pen) => void): void;
  fill(color: string, opacity: number, build: (pen: Pen) => void): void;
  text(style: Text, x: number, y: number, text: string): void;
}

export const FONT = "system-ui, 'Segoe UI', 'Helvetica Neue', Arial, sans-serif";

export class CanvasPainter implements Painter {
  readonly #context: CanvasRenderingContext2D;

  constructor(context: CanvasRenderingContext2D) {
    this.#context = context;
    context.lineJoin = "round";
  }

  stroke({ color, width, dash, opacity }: Stroke, build: (pen: Pen) => void): void {
    const context = this.#context;
    context.strokeStyle = color;
    context.lineWidth = width;
    context.globalAlpha = opacity ?? 1;
    context.setLineDash((dash ?? []) as number[]);
    context.beginPath();
    build(context);
    context.stroke();
  }

  fill(color: string, opacity: number, build: (pen: Pen) => void): void {
    const context = this.#context;
    context.fillStyle = color;
    context.globalAlpha = opacity;
    context.beginPath();
    build(context);
    context.fill();
  }

  text({ color, size, anchor, halo }: Text, x: number, y: number, text: string): void {
    const context = this.#context;
    context.globalAlpha = 1;
    context.fillStyle = color;
    context.font = `${size}px ${FONT}`;
    context.textAlign = anchor === "middle" ? "center" : (anchor ?? "start");
    if (halo) {
      context.strokeStyle = halo;
      context.lineWidth = 4;
      context.setLineDash([]);
      context.strokeText(text, x, y);
    }
    context.fillText(text, x, y);
  }
}

export class SvgPainter implements Painter {
  readonly parts: string[] = [];

  stroke({ color, width, dash, opacity }: Stroke, build: (pen: Pen) => void): void {
    const pen = svgPath();
    build(pen);
    const dashes = dash ? ` stroke-dasharray="${dash.join(" ")}"` : "";
    this.parts.push(
      `<path d="${tenths(pen.toString())}" fill="none" stroke="${color}" stroke-width="${width}" ` +
        `stroke-linejoin="round" stroke-opacity="${opacity ?? 1}"${dashes}/>`,
    );
  }

  fill(color: string, opacity: number, build: (pen: Pen) => void): void {
    const pen = svgPath();
    build(pen);
    this.parts.push(`<path d="${tenths(pen.toString())}" fill="${color}" fill-opacity="${opacity}"/>`);
  }

  text({ color, size, anchor, halo }: Text, x: number, y: number, text: string): void {
    this.parts.push(
      `<text x="${x}" y="${y}" fill="${color}" font-size="${size}" font-family="${FONT}" ` +
        `text-anchor="${anchor ?? "start"}"` +
        (halo ? ` stroke="${halo}" stroke-width="4" paint-order="stroke"` : "") +
        `>${escaped(text)}</text>`,
    );
  }
}

/** Path data with one decimal: a tenth of a pixel. */
function tenths(path: string): string {
  return path.replace(/-?\d+\.\d{2,}(e-?\d+)?/g, (number) => String(Number(Number(number).toFixed(1))));
}

export function escaped(text: string): string {
  return text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");
}

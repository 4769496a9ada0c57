/** A chart: axes and curves that stand still as SVG, curves that move on a canvas above, handles on top. */

import { axisBottom, axisLeft, type Axis as D3Axis } from "d3-axis";
import { scaleLinear } from "d3-scale";
import { select } from "d3-selection";
import { CanvasPainter, escaped, FONT, type Painter, type Pen, SvgPainter } from "./painter.ts";
import { type Palette } from "./palette.ts";
import { short } from "../model/numbers.ts";

export interface Extent {
  readonly x: readonly [number, number];
  readonly y: readonly [number, number];
}

export interface Axis {
  readonly label: string;
  readonly ticks?: (extent: readonly [number, number]) => readonly number[];
  readonly format?: (value: number) => string;
}

export interface ChartOptions {
  /** Above the plot: what goes up and what goes right. */
  readonly title: string;
  readonly x: Axis;
  readonly y: Axis;
  readonly leftMargin: number;
}

/** A part of the picture. It is drawn again only where its key, or the chart's frame, is another. */
export interface Layer {
  readonly key: string;
  readonly draw: (painter: Painter) => void;
}

/** From the back to the front: what no slider of the moment touches, what the drag moves, what the shot moves. */
export interface Layers {
  readonly still: Layer;
  readonly curves: Layer;
  readonly live: Layer;
}

/** Which of a curve's numbers are taken, and where they go in the domain: multiplied, then shifted. */
export interface Placement {
  readonly to?: number;
  readonly xScale?: number;
  readonly yScale?: number;
  readonly xShift?: number;
  readonly yShift?: number;
  /** How much of a point's x goes into its y as well. */
  readonly shear?: number;
}

/** Pixels: the longest chord of a curve, and how far it may be from the tangent at its start (a quarter of that from the curve). */
const LONGEST = 10;
const DEVIATION = 0.2;

const SVG = "http://www.w3.org/2000/svg";
let charts = 0;

export class Chart {
  readonly host: HTMLElement;
  /** Holds the handles. */
  readonly handles: HTMLElement;
  readonly x = scaleLinear();
  readonly y = scaleLinear();
  width = 0;
  height = 0;
  fontSize = 11;
  colors: Palette;
  readonly #options: ChartOptions;
  readonly #back: SVGSVGElement;
  readonly #axes: SVGGElement;
  readonly #bottom: SVGGElement;
  readonly #side: SVGGElement;
  readonly #still: SVGGElement;
  readonly #clip: SVGRectElement;
  readonly #clipName = `clip-${(charts += 1)}`;
  readonly #screen = canvasContext();
  /** The curves without what the shot moves, kept once the shot moves alone. */
  readonly #kept = canvasContext();
  #isKept = false;
  #ratio = NaN;
  /** Of the canvas, in the chart. */
  #box = { left: 0, top: 0, width: 0, height: 0 };
  #axisLabels: { x: string; y: string };
  #extent: Extent = { x: [0, 1], y: [0, 1] };
  #layers: Layers | undefined;
  /** Of the axes: a frame of another size is another frame. */
  #frame = "";
  #keys = { axes: "", still: "", curves: "", live: "" };

  constructor(host: HTMLElement, colors: Palette, options: ChartOptions) {
    this.host = host;
    this.colors = colors;
    this.#options = options;
    this.#axisLabels = { x: options.x.label, y: options.y.label };
    this.#back = document.createElementNS(SVG, "svg");
    this.#back.setAttribute("aria-hidden", "true");
    this.#axes = document.createElementNS(SVG, "g");
    this.#still = document.createElementNS(SVG, "g");
    this.#clip = document.createElementNS(SVG, "rect");
    const clipPath = document.createElementNS(SVG, "clipPath");
    clipPath.id = this.#clipName;
    clipPath.append(this.#clip);
    this.#still.setAttribute("clip-path", `url(#${this.#clipName})`);
    this.handles = document.createElement("div");
    this.#axes.innerHTML = '<g></g><g></g><path class="frame"/><text class="right"/><text class="up"/>';
    [this.#bottom, this.#side] = [...this.#axes.children] as [SVGGElement, SVGGElement];
    this.#back.append(clipPath, this.#axes, this.#still);
    host.append(this.#back, this.#screen.canvas, this.handles);
  }

  get margin(): { top: number; right: number; bottom: number; left: number } {
    const font = this.fontSize;
    return { top: 1.9 * font, right: 0.9 * font, bottom: 2.8 * font, left: this.#options.leftMargin * font };
  }

  /** Size of the plot itself, without margins. */
  get plot(): { width: number; height: number } {
    const { top, right, bottom, left } = this.margin;
    return { width: Math.max(10, this.width - left - right), height: Math.max(10, this.height - top - bottom) };
  }

  /** Takes the size the page gives; says whether it changed. */
  measure(): boolean {
    const { clientWidth, clientHeight } = this.host;
    const font = parseFloat(getComputedStyle(this.host).fontSize);
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const same = clientWidth === this.width && clientHeight === this.height && font === this.fontSize;
    if (same && ratio === this.#ratio) return false;
    [this.width, this.height, this.fontSize] = [clientWidth, clientHeight, font];
    this.#place(ratio);
    this.#back.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    this.#forget();
    return true;
  }

  /** The canvas covers the plot without its margins, and a pixel more: lines along the edge keep their width. */
  #place(ratio: number): void {
    this.#ratio = ratio;
    const { margin, plot } = this;
    // Whole pixels: a box between them would blur it.
    const [left, top] = [Math.floor(margin.left - 1), Math.floor(margin.top - 1)];
    const [width, height] = [Math.ceil(margin.left + plot.width + 1) - left, Math.ceil(margin.top + plot.height + 1) - top];
    this.#box = { left, top, width, height };
    for (const context of [this.#screen, this.#kept]) {
      context.canvas.width = Math.round(width * ratio);
      context.canvas.height = Math.round(height * ratio);
      context.setTransform(ratio, 0, 0, ratio, -left * ratio, -top * ratio);
    }
    for (const [name, value] of Object.entries(this.#box)) {
      this.#screen.canvas.style.setProperty(name, `${value}px`);
    }
  }

  /** What the axes span, and what stands at them. */
  frame(extent: Extent, labels: { x?: string; y?: string } = {}): void {
    const { x = this.#options.x.label, y = this.#options.y.label } = labels;
    const frame = `${extent.x} ${extent.y} ${x} ${y}`;
    if (frame === this.#frame) return;
    this.#forget();
    this.#frame = frame;
    this.#extent = extent;
    this.#axisLabels = { x, y };
    const { top, left } = this.margin;
    const { width, height } = this.plot;
    this.x.domain([...extent.x]).range([left, left + width]);
    this.y.domain([...extent.y]).range([top + height, top]);
  }

  /** Draws what is not as it was the last time. */
  show(layers: Layers): void {
    this.#layers = layers;
    const keys = this.#keys;
    if (this.#frame !== keys.axes) {
      keys.axes = this.#frame;
      this.#drawAxes();
    }
    if (layers.still.key !== keys.still) {
      keys.still = layers.still.key;
      this.#still.innerHTML = this.#asSvg(layers.still);
    }
    if (layers.curves.key !== keys.curves) {
      this.#isKept = false;
      this.#paint(this.#screen, layers.curves, layers.live);
    } else if (layers.live.key !== keys.live) {
      if (!this.#isKept) this.#paint(this.#kept, layers.curves);
      this.#isKept = true;
      this.#paint(this.#screen, this.#kept, layers.live);
    }
    keys.curves = layers.curves.key;
    keys.live = layers.live.key;
  }

  /** Everything is drawn anew next time: the theme has changed. */
  recolor(colors: Palette): void {
    this.colors = colors;
    this.#forget();
  }

  /** The domain's coordinates of a pointer. */
  at(event: PointerEvent): { x: number; y: number } {
    const { x, y } = this.pixels(event);
    return { x: this.x.invert(x), y: this.y.invert(y) };
  }

  pixels(event: PointerEvent): { x: number; y: number } {
    const box = this.host.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  /** A curve through points, but for those that the eye would not miss. */
  curve(
    pen: Pen,
    xs: ArrayLike<number>,
    ys: ArrayLike<number>,
    { to = xs.length, xScale = 1, yScale = 1, xShift = 0, yShift = 0, shear = 0 }: Placement = {},
  ): void {
    const [x0 = 0, x1 = 1] = this.x.range();
    const [y0 = 0, y1 = 1] = this.y.range();
    const { x, y } = this.#extent;
    const xPixels = (x1 - x0) / (x[1] - x[0]);
    const yPixels = (y1 - y0) / (y[1] - y[0]);
    const [xFactor, xOffset] = [xPixels * xScale, x0 + xPixels * (xShift - x[0])];
    const [yFactor, yOffset] = [yPixels * yScale, y0 + yPixels * (yShift - y[0])];
    const mixed = yPixels * shear;
    // The hot loop of a frame: plain numbers only.
    let lastX = NaN;
    let lastY = NaN;
    let alongX = NaN;
    let alongY = NaN;
    for (let index = 0; index < to; index += 1) {
      const px = xs[index] * xFactor + xOffset;
      const py = ys[index] * yFactor + xs[index] * mixed + yOffset;
      const dx = px - lastX;
      const dy = py - lastY;
      const far = dx * dx + dy * dy;
      if (index < to - 1) {
        if (far < 1) continue;
        // Nearly straight on from the last chord, and near: the next point will do.
        const aside = alongX * dy - alongY * dx;
        if (far < LONGEST * LONGEST && aside < DEVIATION && aside > -DEVIATION) continue;
      }
      if (Number.isNaN(px + py)) continue;
      // Far outside the frame a canvas loses its grip on the slope; the clip hides the difference.
      const atX = Math.max(-9999, Math.min(9999, px));
      const atY = Math.max(-9999, Math.min(9999, py));
      if (Number.isNaN(lastX)) pen.moveTo(atX, atY);
      else pen.lineTo(atX, atY);
      const length = Math.sqrt(far);
      alongX = dx / length;
      alongY = dy / length;
      lastX = px;
      lastY = py;
    }
  }

  dot(pen: Pen, x: number, y: number, radius: number): void {
    const [px, py] = [this.x(x), this.y(y)];
    pen.moveTo(px + radius, py);
    pen.arc(px, py, radius, 0, 2 * Math.PI);
  }

  /** What can be taken hold of: a disc with a rim, at a place in pixels. */
  knob(painter: Painter, [x, y]: readonly [number, number], radius: number, color: string, rim: string, width = 2.3): void {
    for (const [fill, size] of [[rim, radius], [color, radius - width]] as const) {
      painter.fill(fill, 1, (pen) => {
        pen.moveTo(x + size, y);
        pen.arc(x, y, size, 0, 2 * Math.PI);
      });
    }
  }

  /** A line along the grid, sharp: in the middle of its pixels. */
  rule(pen: Pen, x0: number, y0: number, x1: number, y1: number): void {
    const sharp = (pixel: number): number => Math.round(pixel - 0.5) + 0.5;
    pen.moveTo(sharp(this.x(x0)), sharp(this.y(y0)));
    pen.lineTo(sharp(this.x(x1)), sharp(this.y(y1)));
  }

  line(pen: Pen, x0: number, y0: number, x1: number, y1: number): void {
    pen.moveTo(this.x(x0), this.y(y0));
    pen.lineTo(this.x(x1), this.y(y1));
  }

  /** The chart as SVG: what is on the screen, with its title, at `left`, `top` of a larger picture. */
  toSvg(left: number, top: number): string {
    const { margin, plot, colors, fontSize } = this;
    const { still, curves, live } = this.#layers ?? {};
    const parts = [still, curves, live].map((layer) => (layer ? this.#asSvg(layer) : ""));
    return [
      `<g transform="translate(${left},${top})">`,
      `<clipPath id="${this.#clipName}"><rect x="${margin.left}" y="${margin.top}" width="${plot.width}" height="${plot.height}"/></clipPath>`,
      `<text x="${margin.left}" y="-2" fill="${colors.ink}" font-family="${FONT}" font-size="${fontSize}" font-weight="600">${escaped(this.#options.title)}</text>`,
      this.#axes.outerHTML.replace(/ class="[^"]*"/g, ""),
      `<g clip-path="url(#${this.#clipName})">${parts.join("")}</g>`,
      "</g>",
    ].join("\n");
  }

  #forget(): void {
    this.#frame = "";
    this.#keys = { axes: "", still: "", curves: "", live: "" };
    this.#isKept = false;
  }

  #asSvg(layer: Layer): string {
    const painter = new SvgPainter();
    layer.draw(painter);
    return painter.parts.join("");
  }

  #paint(context: CanvasRenderingContext2D, ...parts: (Layer | CanvasRenderingContext2D)[]): void {
    const { left, top, width, height } = this.#box;
    context.clearRect(left, top, width, height);
    for (const part of parts) {
      if (part instanceof CanvasRenderingContext2D) context.drawImage(part.canvas, left, top, width, height);
      else part.draw(new CanvasPainter(context));
    }
  }

  #drawAxes(): void {
    const { top, left } = this.margin;
    const { width, height } = this.plot;
    const { x, y } = this.#options;
    const font = this.fontSize;
    const bottom = axisBottom<number>(this.x as never);
    const side = axisLeft<number>(this.y as never);
    ticked(bottom, x, this.#extent.x, width / (5.5 * font)).tickSize(-height);
    ticked(side, y, this.#extent.y, height / (3.2 * font)).tickSize(-width);
    for (const [name, value] of Object.entries({ x: left - 1, y: top - 1, width: width + 2, height: height + 2 })) {
      this.#clip.setAttribute(name, String(value));
    }
    for (const [group, axis, transform] of [
      [this.#bottom, bottom, `translate(0,${top + height})`],
      [this.#side, side, `translate(${left},0)`],
    ] as const) {
      const root = select(group).attr("transform", transform).call(axis as never);
      root.attr("font-size", 0.92 * font).attr("font-family", FONT).attr("color", this.colors.muted);
      root.selectAll(".tick line").attr("stroke", this.colors.grid);
      root.select(".domain").attr("stroke", "none");
    }
    const root = select(this.#axes);
    const frame = `M${left},${top}V${top + height}H${left + width}`;
    const { muted, ink } = this.colors;
    root.select(".frame").attr("d", frame).attr("fill", "none").attr("stroke", muted);
    for (const [name, text, px, py, anchor] of [
      [".right", this.#axisLabels.x, left + width, top + height + 2.5 * font, "end"],
      [".up", this.#axisLabels.y, 0.2 * font, 1.1 * font, "start"],
    ] as const) {
      const label = root.select(name).attr("x", px).attr("y", py).attr("text-anchor", anchor);
      label.attr("font-size", font).attr("font-family", FONT).attr("fill", ink).text(text);
    }
  }
}

function canvasContext(): CanvasRenderingContext2D {
  const context = document.createElement("canvas").getContext("2d");
  if (!context) throw new Error("this browser has no canvas to draw on");
  return context;
}

function ticked(
  axis: D3Axis<number>,
  { ticks, format }: Axis,
  extent: readonly [number, number],
  count: number,
): D3Axis<number> {
  if (ticks) axis.tickValues([...ticks(extent)]);
  else axis.ticks(Math.max(2, Math.round(count)));
  axis.tickFormat(format ?? ((value) => short(value)));
  return axis.tickPadding(5);
}

/** A chart: axes as SVG, curves on a canvas above them, handles on top. */

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
  readonly ticks?: readonly number[];
  readonly format?: (value: number) => string;
}

export interface ChartOptions {
  /** Above the plot: what goes up and what goes right. */
  readonly title: string;
  readonly x: Axis;
  readonly y: Axis;
  readonly leftMargin: number;
  /** The font's size in the units of the page's. */
  readonly fontScale?: number;
}

type Draw = (painter: Painter) => void;

const SVG = "http://www.w3.org/2000/svg";

export class Chart {
  readonly host: HTMLElement;
  /** Holds the handles: elements of their own, which move without anything being painted anew. */
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
  readonly #canvas: HTMLCanvasElement;
  #axisLabels: { x: string; y: string };
  #extent: Extent = { x: [0, 1], y: [0, 1] };
  #drawn: Draw | undefined;
  #key = "";
  #axesKey = "";

  constructor(host: HTMLElement, colors: Palette, options: ChartOptions) {
    this.host = host;
    this.colors = colors;
    this.#options = options;
    this.#axisLabels = { x: options.x.label, y: options.y.label };
    this.#canvas = document.createElement("canvas");
    this.#back = document.createElementNS(SVG, "svg");
    this.#back.setAttribute("aria-hidden", "true");
    this.#axes = document.createElementNS(SVG, "g");
    this.handles = document.createElement("div");
    this.#back.append(this.#axes);
    host.append(this.#back, this.#canvas, this.handles);
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
    const font = parseFloat(getComputedStyle(this.host).fontSize) * (this.#options.fontScale ?? 1);
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const same = clientWidth === this.width && clientHeight === this.height && font === this.fontSize;
    if (same && this.#canvas.width === Math.round(clientWidth * ratio)) return false;
    [this.width, this.height, this.fontSize] = [clientWidth, clientHeight, font];
    this.#canvas.width = Math.round(clientWidth * ratio);
    this.#canvas.height = Math.round(clientHeight * ratio);
    // Pixel for pixel: a box of broken width would blur it.
    this.#canvas.style.width = `${clientWidth}px`;
    this.#canvas.style.height = `${clientHeight}px`;
    this.#canvas.getContext("2d")?.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.#back.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    this.#key = "";
    this.#axesKey = "";
    return true;
  }

  frame(extent: Extent, labels: { x?: string; y?: string } = {}): void {
    this.#extent = extent;
    this.#axisLabels = { ...this.#axisLabels, ...labels };
    const { top, left } = this.margin;
    const { width, height } = this.plot;
    this.x.domain([...extent.x]).range([left, left + width]);
    this.y.domain([...extent.y]).range([top + height, top]);
  }

  /** Draws where `key`, or the frame, is not that of the last time. */
  draw(key: string, draw: Draw): void {
    this.#drawn = draw;
    const axes = `${this.#extent.x} ${this.#extent.y} ${this.#axisLabels.x} ${this.#axisLabels.y}`;
    if (axes !== this.#axesKey) {
      this.#axesKey = axes;
      this.#drawAxes();
      this.#key = "";
    }
    if (key === this.#key) return;
    this.#key = key;
    this.#paint(draw);
  }

  /** Everything is drawn anew next time: the theme has changed. */
  recolor(colors: Palette): void {
    this.colors = colors;
    this.#key = "";
    this.#axesKey = "";
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

  /** A curve through points given in the domain's units times `scale`, those within a pixel of the last dropped. */
  curve(
    pen: Pen,
    xs: ArrayLike<number>,
    ys: ArrayLike<number>,
    { from = 0, to = xs.length, xScale = 1, yScale = 1 } = {},
  ): void {
    // A file keeps fewer points: chords of two pixels stay within a hundredth of one of the curve.
    const tolerance = pen instanceof CanvasRenderingContext2D ? 1 : 2;
    const [x0 = 0, x1 = 1] = this.x.range();
    const [y0 = 0, y1 = 1] = this.y.range();
    const { x, y } = this.#extent;
    const xFactor = ((x1 - x0) / (x[1] - x[0])) * xScale;
    const yFactor = ((y1 - y0) / (y[1] - y[0])) * yScale;
    const xShift = x0 - ((x1 - x0) / (x[1] - x[0])) * x[0];
    const yShift = y0 - ((y1 - y0) / (y[1] - y[0])) * y[0];
    let [lastX, lastY] = [NaN, NaN];
    for (let index = from; index < to; index += 1) {
      const px = xs[index] * xFactor + xShift;
      // Far outside the frame a canvas loses its grip on the slope; the clip hides the difference.
      const py = Math.max(-9999, Math.min(9999, ys[index] * yFactor + yShift));
      if (Number.isNaN(px + py)) continue;
      if (Number.isNaN(lastX)) pen.moveTo(px, py);
      else if (Math.abs(px - lastX) < tolerance && Math.abs(py - lastY) < tolerance && index < to - 1) continue;
      else pen.lineTo(px, py);
      [lastX, lastY] = [px, py];
    }
  }

  dot(pen: Pen, x: number, y: number, radius: number): void {
    const [px, py] = [this.x(x), this.y(y)];
    pen.moveTo(px + radius, py);
    pen.arc(px, py, radius, 0, 2 * Math.PI);
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
    const painter = new SvgPainter();
    this.#drawn?.(painter);
    const { margin, plot, colors, fontSize } = this;
    const id = `clip-${left}-${top}`;
    return [
      `<g transform="translate(${left},${top})">`,
      `<clipPath id="${id}"><rect x="${margin.left}" y="${margin.top}" width="${plot.width}" height="${plot.height}"/></clipPath>`,
      `<text x="${margin.left}" y="-2" fill="${colors.ink}" font-family="${FONT}" font-size="${fontSize}" font-weight="600">${escaped(this.#options.title)}</text>`,
      this.#axes.outerHTML.replace(/ class="[^"]*"/g, ""),
      `<g clip-path="url(#${id})">${painter.parts.join("")}</g>`,
      "</g>",
    ].join("\n");
  }

  #paint(draw: Draw): void {
    const context = this.#canvas.getContext("2d");
    if (!context) return;
    context.clearRect(0, 0, this.width, this.height);
    context.save();
    const { top, left } = this.margin;
    context.beginPath();
    // A pixel more: lines along the edge keep their width.
    context.rect(left - 1, top - 1, this.plot.width + 2, this.plot.height + 2);
    context.clip();
    draw(new CanvasPainter(context));
    context.restore();
  }

  #drawAxes(): void {
    const { top, left } = this.margin;
    const { width, height } = this.plot;
    const { x, y } = this.#options;
    const font = this.fontSize;
    const bottom = axisBottom<number>(this.x.range([left, left + width]) as never);
    const side = axisLeft<number>(this.y.range([top + height, top]) as never);
    ticked(bottom, x, width / (5.5 * font)).tickSize(-height);
    ticked(side, y, height / (3.2 * font)).tickSize(-width);
    const root = select(this.#axes);
    root.selectAll("*").remove();
    for (const [axis, transform] of [
      [bottom, `translate(0,${top + height})`],
      [side, `translate(${left},0)`],
    ] as const) {
      const group = root.append("g").attr("transform", transform).call(axis as never);
      group.attr("font-size", 0.92 * font).attr("font-family", FONT).attr("color", this.colors.muted);
      group.selectAll(".tick line").attr("stroke", this.colors.grid);
      group.select(".domain").remove();
    }
    const frame = `M${left},${top}V${top + height}H${left + width}`;
    root.append("path").attr("d", frame).attr("fill", "none").attr("stroke", this.colors.muted);
    root
      .append("text")
      .attr("x", left + width)
      .attr("y", top + height + 2.5 * font)
      .attr("text-anchor", "end")
      .attr("font-size", font)
      .attr("font-family", FONT)
      .attr("fill", this.colors.ink)
      .text(this.#axisLabels.x);
    root
      .append("text")
      .attr("x", 0.2 * font)
      .attr("y", 1.1 * font)
      .attr("font-size", font)
      .attr("font-family", FONT)
      .attr("fill", this.colors.ink)
      .text(this.#axisLabels.y);
  }
}

function ticked(axis: D3Axis<number>, { ticks, format }: Axis, count: number): D3Axis<number> {
  if (ticks) axis.tickValues([...ticks]);
  else axis.ticks(Math.max(2, Math.round(count)));
  axis.tickFormat(format ?? ((value) => short(value)));
  return axis.tickPadding(5);
}

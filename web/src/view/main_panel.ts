/** The main panel: the shots, the locus of their apexes, and what can be laid over them. */

import { shows, type Model, type Scene } from "../model/model.ts";
import { type Flight } from "../model/flights.ts";
import { lengthUnit, short } from "../model/numbers.ts";
import { Chart, type Extent, type Placement } from "./chart.ts";
import { type Painter, type Pen, type Stroke } from "./painter.ts";
import { compareStroke, DASHES, type Palette } from "./palette.ts";

/** Teeth of the curvature comb. */
const TEETH = 90;
/** Length of the arrow of the launch direction, as a part of the plot's height. */
const ARROW = 0.3;

interface Entry {
  readonly label: string;
  readonly stroke: Stroke;
}

export class MainPanel {
  readonly chart: Chart;
  readonly #model: Model;
  /** Metres of the unit on the axes. */
  #metres = 1;

  constructor(host: HTMLElement, model: Model, colors: Palette) {
    this.#model = model;
    this.chart = new Chart(host, colors, {
      title: "Trajectories and the locus of their apexes",
      x: { label: "distance x (m)" },
      y: { label: "height y (m)" },
      leftMargin: 3.4,
    });
  }

  draw(scene: Scene): void {
    this.#frame(scene);
    const { state, scales, locus, compared, time } = scene;
    const wrong = shows(state, "ghost") ? this.#model.principal(locus).count : 0;
    const others = compared.map(({ epsilon }) => epsilon).join();
    const shown = `${state.layers} ${state.sides} ${scales.length / this.#metres}`;
    this.chart.show({
      still: { key: `${shown} ${others} ${wrong > 0}`, draw: (painter) => this.#still(painter, scene, wrong) },
      curves: { key: `${shown} ${locus.version}`, draw: (painter) => this.#curves(painter, scene) },
      live: {
        key: `${shown} ${locus.version} ${state.angle} ${time}`,
        draw: (painter) => this.#live(painter, scene),
      },
    });
  }

  /** Where the handles belong, in pixels: the apex, and the tip of the arrow. */
  places({ apex, scales }: Scene): { apex: [number, number]; direction: [number, number] } {
    const { chart } = this;
    const unit = scales.length / this.#metres;
    const length = ARROW * chart.plot.height;
    return {
      apex: [chart.x(apex.x * unit), chart.y(apex.y * unit)],
      direction: [
        chart.x(0) + length * Math.cos(apex.launchAngle),
        chart.y(0) - length * Math.sin(apex.launchAngle),
      ],
    };
  }

  #frame(scene: Scene): void {
    const { state, scales, reach, top } = scene;
    const { width, height } = this.chart.plot;
    const fit = state.frame === "fit";
    const sides = state.sides === "both" ? 2 : 1;
    const wide = sides * (fit ? 1.03 * reach : 1.03);
    const high = fit ? 1.08 * top : 0.535;
    const perPixel = Math.max(wide / width, high / height);
    // Steps of a tenth of a decade or so: the frame stands still while the curves move in it.
    const step = fit ? stepAbove(perPixel * width) / width : perPixel;
    const [unit, metres] = lengthUnit(0.5 * step * width * scales.length);
    this.#metres = metres;
    const far = (step * width * scales.length) / metres;
    const extent: Extent = {
      x: sides === 2 ? [-far / 2, far / 2] : [0, far],
      y: [0, (step * height * scales.length) / metres],
    };
    this.chart.frame(extent, { x: `distance x (${unit})`, y: `height y (${unit})` });
  }

  /** A curve of the right side, in units of ρ, and its mirror image where both sides are shown. */
  #curve(pen: Pen, { state, scales }: Scene, xs: Float64Array, ys: Float64Array, part: Placement = {}): void {
    const unit = scales.length / this.#metres;
    this.chart.curve(pen, xs, ys, { ...part, xScale: unit, yScale: unit });
    if (state.sides === "both") this.chart.curve(pen, xs, ys, { ...part, xScale: -unit, yScale: unit });
  }

  /** A shot, turned from the level shot that shows the circles, or its mirror image. */
  #flight(pen: Pen, { scales }: Scene, { cosine, sine, count, range }: Flight, side: 1 | -1): void {
    const { chart } = this;
    const unit = scales.length / this.#metres;
    const { radius, height } = this.#model.instants(scales.epsilon);
    const placement = { to: count, xScale: side * unit * cosine, yScale: unit, shear: unit * sine };
    chart.curve(pen, radius, height, placement);
    pen.lineTo(chart.x(side * range * unit), chart.y(0));
  }

  #still(painter: Painter, scene: Scene, wrong: number): void {
    const { colors } = this.chart;
    const { state, dragFree, compared } = scene;
    const strokes = this.#strokes();
    const entries: Entry[] = [{ label: "locus of the apexes", stroke: strokes.locus }];
    if (shows(state, "envelope")) entries.push({ label: "envelope", stroke: strokes.envelope });
    if (shows(state, "drag_free")) {
      painter.stroke(strokes.dragFree, (pen) => this.#curve(pen, scene, dragFree.x, dragFree.y));
      entries.push({ label: "without drag (ellipse)", stroke: strokes.dragFree });
    }
    compared.forEach((other, index) => {
      const stroke = compareStroke(colors, index, 2);
      painter.stroke(stroke, (pen) => this.#curve(pen, scene, other.x, other.y));
      entries.push({ label: `locus at ε = ${short(other.epsilon, 4)}`, stroke });
    });
    if (shows(state, "comb")) entries.push({ label: "curvature ρK, as a comb", stroke: strokes.comb });
    if (shows(state, "ghost")) {
      entries.push({ label: wrong ? "what W₀ would draw" : "W₀ draws the same here", stroke: strokes.ghost });
    }
    if (shows(state, "circle")) entries.push({ label: "all shots at time t", stroke: strokes.circle });
    this.#legend(painter, entries);
  }

  #curves(painter: Painter, scene: Scene): void {
    const { state, scales, locus } = scene;
    const strokes = this.#strokes();
    if (shows(state, "fan")) {
      const fan = this.#model.fan(scales.epsilon);
      painter.stroke(strokes.fan, (pen) => {
        for (const flight of fan.flights) {
          this.#flight(pen, scene, flight, 1);
          if (state.sides === "both") this.#flight(pen, scene, flight, -1);
        }
      });
    }
    if (shows(state, "envelope")) {
      const envelope = this.#model.envelope(scene);
      painter.stroke(strokes.envelope, (pen) => this.#curve(pen, scene, envelope.x, envelope.y));
    }
    if (shows(state, "comb")) this.#comb(painter, scene, strokes.comb);
    painter.stroke(strokes.locus, (pen) => this.#curve(pen, scene, locus.x, locus.y));
    if (shows(state, "ghost")) {
      const { curve, count } = this.#model.principal(locus);
      painter.stroke(strokes.ghost, (pen) => this.#curve(pen, scene, curve.x, curve.y, { to: count }));
    }
    if (shows(state, "points")) this.#points(painter, scene);
  }

  #live(painter: Painter, scene: Scene): void {
    const { chart } = this;
    const { colors } = chart;
    const { state, scales, apex, position, time } = scene;
    const unit = scales.length / this.#metres;
    const shot = this.#model.shot(scene);
    painter.stroke({ color: colors.shot, width: 2 }, (pen) => this.#flight(pen, scene, shot, 1));
    if (shows(state, "circle")) {
      const { radius, centre } = this.#model.shots.front(time, scales.epsilon);
      const pixels = chart.x(radius * unit) - chart.x(0);
      painter.stroke(this.#strokes().circle, (pen) => {
        const [x, y] = [chart.x(0), chart.y(centre * unit)];
        pen.moveTo(x + pixels, y);
        pen.arc(x, y, pixels, 0, 2 * Math.PI);
      });
    }
    // The ray at the elevation of the apex, and the launch direction.
    painter.stroke({ color: colors.muted, width: 1, dash: [3, 3] }, (pen) =>
      chart.line(pen, 0, 0, apex.x * unit, apex.y * unit),
    );
    const places = this.places(scene);
    painter.stroke({ color: colors.shot, width: 2.4 }, (pen) => {
      pen.moveTo(chart.x(0), chart.y(0));
      pen.lineTo(...places.direction);
    });
    chart.knob(painter, places.direction, 8.5, colors.paper, colors.shot);
    chart.knob(painter, places.apex, 8.5, colors.locus, colors.paper);
    if (time > 0) {
      chart.knob(painter, [chart.x(position.x * unit), chart.y(position.y * unit)], 6, colors.paper, colors.shot, 3.5);
    }
  }

  #strokes(): Record<"locus" | "fan" | "dragFree" | "envelope" | "circle" | "comb" | "ghost", Stroke> {
    const { colors } = this.chart;
    return {
      locus: { color: colors.locus, width: 2.6 },
      fan: { color: colors.ink, width: 0.8, opacity: 0.45 },
      dragFree: { color: colors.ellipse, width: 1.8, dash: DASHES.ellipse },
      envelope: { color: colors.envelope, width: 1.8, dash: DASHES.envelope },
      circle: { color: colors.circle, width: 1.8, dash: DASHES.circle },
      comb: { color: colors.comb, width: 1 },
      ghost: { color: colors.ghost, width: 2, dash: DASHES.ghost },
    };
  }

  #comb(painter: Painter, { state, locus, scales }: Scene, stroke: Stroke): void {
    const { chart } = this;
    const unit = scales.length / this.#metres;
    const { x, y, curvature } = locus;
    // The longest tooth takes a fifth of the plot.
    const greatest = curvature.reduce((most, value) => Math.max(most, value), 0);
    const pixelsPerCurvature = (0.2 * chart.plot.height) / greatest;
    const comb = (pen: Pen, side: number): void => {
      const tips: [number, number][] = [];
      for (let tooth = 0; tooth <= TEETH; tooth += 1) {
        const index = Math.round((tooth / TEETH) * (x.length - 1));
        const [before, after] = [Math.max(0, index - 1), Math.min(x.length - 1, index + 1)];
        // Outwards: to the right of the way from the launcher to the top.
        const [dx, dy] = [x[after] - x[before], y[after] - y[before]];
        const size = (curvature[index] * pixelsPerCurvature) / (Math.hypot(dx, dy) || 1);
        const [px, py] = [chart.x(side * x[index] * unit), chart.y(y[index] * unit)];
        const tip: [number, number] = [px + side * dy * size, py + dx * size];
        pen.moveTo(px, py);
        pen.lineTo(...tip);
        tips.push(tip);
      }
      tips.forEach((tip, index) => (index ? pen.lineTo(...tip) : pen.moveTo(...tip)));
    };
    painter.stroke(stroke, (pen) => {
      comb(pen, 1);
      if (state.sides === "both") comb(pen, -1);
    });
  }

  #points(painter: Painter, { scales }: Scene): void {
    const { chart } = this;
    const { colors, fontSize } = chart;
    const unit = scales.length / this.#metres;
    const angles = this.#model.named(scales.epsilon);
    for (const [name, label] of [
      ["curvature", "bends most"],
      ["rightmost", "rightmost"],
      ["farthest", "farthest"],
    ] as const) {
      const { x, y } = this.#model.shots.apex(angles[name][0], scales.epsilon);
      painter.fill(colors.paper, 1, (pen) => chart.dot(pen, x * unit, y * unit, 4.5));
      painter.stroke({ color: colors.locus, width: 2 }, (pen) => chart.dot(pen, x * unit, y * unit, 4.5));
      // The points may lie close together; their labels must not.
      const offset = { curvature: 1.5, farthest: -0.6, rightmost: 0.1 }[name] * fontSize;
      const [px, py] = [chart.x(x * unit) + 9, chart.y(y * unit) + offset];
      painter.text({ color: colors.ink, size: fontSize, halo: colors.paper }, px, py, label);
    }
  }

  /** In the upper right corner, where no shot comes. */
  #legend(painter: Painter, entries: readonly Entry[]): void {
    const { chart } = this;
    const { margin, plot, fontSize, colors } = chart;
    const row = 1.5 * fontSize;
    const right = margin.left + plot.width - 0.6 * fontSize;
    const widest = Math.max(...entries.map(({ label }) => label.length));
    const left = right - (0.6 * widest + 3.2) * fontSize;
    painter.fill(colors.paper, 0.85, (pen) => {
      const bottom = margin.top + 0.5 * row + entries.length * row;
      pen.moveTo(left - 6, margin.top + 1);
      pen.lineTo(right + 4, margin.top + 1);
      pen.lineTo(right + 4, bottom);
      pen.lineTo(left - 6, bottom);
      pen.closePath();
    });
    entries.forEach(({ label, stroke }, index) => {
      const y = margin.top + (index + 0.9) * row;
      painter.stroke(stroke, (pen) => {
        pen.moveTo(left, y - 0.33 * fontSize);
        pen.lineTo(left + 2.2 * fontSize, y - 0.33 * fontSize);
      });
      painter.text({ color: colors.ink, size: fontSize }, left + 2.8 * fontSize, y, label);
    });
  }
}

/** The first of these steps, times a power of ten, that is not below `value`. */
export function stepAbove(value: number, steps = [1, 1.25, 1.6, 2, 2.5, 3.2, 4, 5, 6.4, 8, 10]): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * (steps.find((step) => step * power >= value) ?? 10);
}

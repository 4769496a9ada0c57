/** The small panels: each a curve of the locus with the cursor of the current shot on it. */

import { NAMED, type NamedAngle } from "../model/named.ts";
import { NAMED_DECADES } from "../model/named_curves.ts";
import { type Model, type Scene } from "../model/model.ts";
import { type LocusCurves } from "../model/curves.ts";
import { degrees, radians, superscript } from "../model/numbers.ts";
import { Chart, type Axis, type Extent } from "./chart.ts";
import { type Pen } from "./painter.ts";
import { compareStroke, DASHES, namedStroke, type Palette } from "./palette.ts";
import { stepAbove } from "./main_panel.ts";

/** What a pointer or key in a panel asks for. */
export type Wish = { readonly launchAngle: number } | { readonly elevation: number } | { readonly epsilon: number };

export interface Panel {
  readonly chart: Chart;
  /** What the panel shows, for those who do not see it. */
  readonly name: string;
  draw(scene: Scene): void;
  /** Where the cursor's handle belongs, in pixels. */
  place(scene: Scene): [number, number];
  /** What a pointer at this abscissa asks for. */
  wish(x: number, scene: Scene): Wish;
}

const TO_DEGREES = degrees(1);
const angleTicks = ([, last]: readonly [number, number]): number[] =>
  last > 90 ? [0, 45, 90, 135, 180] : [0, 30, 60, 90];
const angleAxis = (label: string): Axis => ({ label, ticks: angleTicks });

interface CurvePanelOptions {
  readonly title: string;
  readonly name: string;
  readonly x: Axis;
  readonly y: Axis;
  readonly leftMargin: number;
  /** Abscissae and ordinates of a locus, in the units of the axes once multiplied. */
  readonly xs: (locus: LocusCurves, scene: Scene) => ArrayLike<number>;
  readonly ys: (locus: LocusCurves) => ArrayLike<number>;
  readonly xScale?: (scene: Scene) => number;
  readonly yScale?: number;
  /** Of the mirror image, for shots to the left: 180° less the angle, or the same with this sign. */
  readonly mirror: "angle" | 1 | -1;
  readonly yExtent: (curves: readonly LocusCurves[], scene: Scene) => readonly [number, number];
  readonly cursor: (scene: Scene) => readonly [number, number];
  readonly wish: (x: number, scene: Scene) => Wish;
  readonly xLabel?: (scene: Scene) => string;
}

/** A quantity of the locus against an angle. */
class CurvePanel implements Panel {
  readonly chart: Chart;
  readonly name: string;
  readonly #options: CurvePanelOptions;
  #extent: { key: string; y: readonly [number, number] } = { key: "", y: [0, 1] };

  constructor(host: HTMLElement, colors: Palette, options: CurvePanelOptions) {
    this.#options = options;
    this.name = options.name;
    this.chart = new Chart(host, colors, options);
  }

  draw(scene: Scene): void {
    const { yExtent, xLabel, cursor } = this.#options;
    const { chart } = this;
    const { state, locus, dragFree, compared } = scene;
    const others = `${compared.map(({ epsilon }) => epsilon)} ${state.curvatureBy} ${state.sides}`;
    const key = `${locus.version} ${others}`;
    if (key !== this.#extent.key) this.#extent = { key, y: yExtent([locus, dragFree, ...compared], scene) };
    const extent: Extent = { x: [0, lastAngle(scene)], y: this.#extent.y };
    chart.frame(extent, xLabel ? { x: xLabel(scene) } : {});
    const [cursorX, cursorY] = cursor(scene);
    const { colors } = chart;
    chart.show({
      still: {
        key: others,
        draw: (painter) => {
          painter.stroke({ color: colors.ellipse, width: 1.4, dash: DASHES.ellipse }, (pen) =>
            this.#curve(pen, dragFree, scene),
          );
          compared.forEach((other, index) =>
            painter.stroke(compareStroke(colors, index), (pen) => this.#curve(pen, other, scene)),
          );
        },
      },
      curves: {
        key,
        draw: (painter) =>
          painter.stroke({ color: colors.locus, width: 2 }, (pen) => this.#curve(pen, locus, scene)),
      },
      live: {
        key: `${cursorX} ${cursorY}`,
        draw: (painter) => {
          painter.stroke({ color: colors.shot, width: 1 }, (pen) => {
            chart.rule(pen, cursorX, extent.y[0], cursorX, extent.y[1]);
            chart.rule(pen, 0, cursorY, cursorX, cursorY);
          });
          chart.knob(painter, this.place(scene), 5.5, colors.paper, colors.shot);
        },
      },
    });
  }

  #curve(pen: Pen, locus: LocusCurves, scene: Scene): void {
    const { xs, ys, xScale, yScale = 1, mirror } = this.#options;
    const scale = xScale?.(scene) ?? 1;
    const [x, y] = [xs(locus, scene), ys(locus)];
    this.chart.curve(pen, x, y, { xScale: scale, yScale });
    if (scene.state.sides === "right") return;
    const flipped = mirror === "angle" ? { yScale: -yScale, yShift: 180 } : { yScale: mirror * yScale };
    this.chart.curve(pen, x, y, { xScale: -scale, xShift: 180, ...flipped });
  }

  place(scene: Scene): [number, number] {
    const [x, y] = this.#options.cursor(scene);
    return [this.chart.x(x), this.chart.y(y)];
  }

  wish(x: number, scene: Scene): Wish {
    return this.#options.wish(x, scene);
  }
}

/** The largest angle on the axes, degrees. */
const lastAngle = ({ state }: Scene): number => (state.sides === "both" ? 180 : 90);

/** Frames that hold still while their curves move a little, and end on round numbers. */
function roundExtent(low: number, high: number): readonly [number, number] {
  const above = (value: number): number => (value > 0 ? stepAbove(value * 1.02, [1, 2.5, 5, 10]) : 0);
  return [low < 0 ? -above(-low) : 0, above(high)];
}

function extremes(curves: readonly ArrayLike<number>[]): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const values of curves) {
    for (let index = 0; index < values.length; index += 1) {
      const value = values[index];
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return [low, high];
}

const byElevation = (x: number): Wish => ({ elevation: radians(x) });

export function elevationPanel(host: HTMLElement, colors: Palette): Panel {
  return new CurvePanel(host, colors, {
    title: "Elevation of the apex",
    name: "Elevation of the apex against launch angle",
    x: angleAxis("launch angle α (°)"),
    y: { label: "elevation θ (°)", ticks: angleTicks },
    leftMargin: 2.8,
    mirror: "angle",
    xs: (locus) => locus.grid.degrees,
    ys: (locus) => locus.elevation,
    yScale: TO_DEGREES,
    yExtent: (_, scene) => [0, lastAngle(scene)],
    cursor: ({ state, apex }) => [state.angle, degrees(apex.elevation)],
    wish: (x) => ({ launchAngle: radians(x) }),
  });
}

export function slopePanel(host: HTMLElement, colors: Palette): Panel {
  return new CurvePanel(host, colors, {
    title: "First derivative",
    name: "First derivative of the launch angle by elevation",
    x: angleAxis("elevation θ (°)"),
    y: { label: "dα/dθ" },
    leftMargin: 2.8,
    mirror: 1,
    xs: (locus) => locus.grid.degrees,
    ys: (locus) => locus.launchAngleD1,
    yExtent: (curves) => roundExtent(0, Math.max(2, extremes(curves.map((c) => c.launchAngleD1))[1])),
    cursor: ({ apex, slopes }) => [degrees(apex.elevation), slopes[0]],
    wish: byElevation,
  });
}

export function bendPanel(host: HTMLElement, colors: Palette): Panel {
  return new CurvePanel(host, colors, {
    title: "Second derivative",
    name: "Second derivative of the launch angle by elevation",
    x: angleAxis("elevation θ (°)"),
    y: { label: "d²α/dθ²" },
    leftMargin: 3.4,
    mirror: -1,
    xs: (locus) => locus.grid.degrees,
    ys: (locus) => locus.launchAngleD2,
    yExtent: (curves, { state }) => {
      const [low, high] = extremes(curves.map((c) => c.launchAngleD2));
      const most = Math.max(-low, high);
      return state.sides === "both" ? roundExtent(-most, most) : roundExtent(low, high);
    },
    cursor: ({ apex, slopes }) => [degrees(apex.elevation), slopes[1]],
    wish: byElevation,
  });
}

export function curvaturePanel(host: HTMLElement, colors: Palette): Panel {
  const byLaunch = (scene: Scene): boolean => scene.state.curvatureBy === "launch_angle";
  return new CurvePanel(host, colors, {
    title: "Curvature",
    name: "Curvature of the locus",
    x: angleAxis("launch angle α (°)"),
    y: { label: "curvature ρK" },
    leftMargin: 3.2,
    mirror: 1,
    xs: (locus, scene) => (byLaunch(scene) ? locus.grid.degrees : locus.elevation),
    xScale: (scene) => (byLaunch(scene) ? 1 : TO_DEGREES),
    ys: (locus) => locus.curvature,
    yExtent: (curves) => roundExtent(0, extremes(curves.map((c) => c.curvature))[1]),
    cursor: (scene) => [
      byLaunch(scene) ? scene.state.angle : degrees(scene.apex.elevation),
      scene.apex.curvature,
    ],
    wish: (x, scene) => (byLaunch(scene) ? { launchAngle: radians(x) } : byElevation(x)),
    xLabel: (scene) => (byLaunch(scene) ? "launch angle α (°)" : "elevation θ (°)"),
  });
}

/** The named angles against ε on a logarithmic axis; its cursor is the drag. */
export class NamedPanel implements Panel {
  readonly chart: Chart;
  readonly name = "Named launch angles against the drag parameter";
  readonly #model: Model;

  constructor(host: HTMLElement, model: Model, colors: Palette) {
    this.#model = model;
    const [low, high] = NAMED_DECADES;
    this.chart = new Chart(host, colors, {
      title: "Named angles",
      x: {
        label: "drag parameter ε",
        ticks: () => Array.from({ length: high - low + 1 }, (_, index) => low + index),
        // Every second one: more would touch.
        format: (decade) => (decade === 0 ? "1" : decade % 2 === 0 ? `10${superscript(decade)}` : ""),
      },
      y: { label: "launch angle α (°)", ticks: angleTicks },
      leftMargin: 2.5,
    });
  }

  draw(scene: Scene): void {
    const { chart } = this;
    chart.frame({ x: NAMED_DECADES, y: [0, 90] });
    const { decades, angles, complete } = this.#model.namedCurves;
    const [x, y] = [this.#decade(scene), acute(scene)];
    chart.show({
      still: {
        key: String(complete),
        draw: (painter) => {
          if (!complete) return;
          (Object.keys(NAMED) as NamedAngle[]).forEach((name, index) =>
            painter.stroke(namedStroke(chart.colors, index), (pen) =>
              chart.curve(pen, decades, angles[name], { yScale: TO_DEGREES }),
            ),
          );
        },
      },
      curves: { key: "", draw: () => undefined },
      live: {
        key: `${x} ${y}`,
        draw: (painter) => {
          painter.stroke({ color: chart.colors.shot, width: 1 }, (pen) => {
            chart.rule(pen, x, 0, x, 90);
            chart.rule(pen, NAMED_DECADES[0], y, x, y);
          });
          chart.knob(painter, this.place(scene), 5.5, chart.colors.paper, chart.colors.shot);
        },
      },
    });
  }

  place(scene: Scene): [number, number] {
    return [this.chart.x(this.#decade(scene)), this.chart.y(acute(scene))];
  }

  /** Left of the axis lies no drag at all. */
  wish(x: number): Wish {
    const [low, high] = NAMED_DECADES;
    return { epsilon: x <= low ? 0 : Number((10 ** Math.min(x, high)).toPrecision(3)) };
  }

  #decade({ scales: { epsilon } }: Scene): number {
    const [low, high] = NAMED_DECADES;
    return Math.min(high, Math.max(low, Math.log10(epsilon)));
  }
}

/** Launch angle of the shot, or of its mirror image to the right. */
const acute = ({ state: { angle } }: Scene): number => Math.min(angle, 180 - angle);

/** A data table for each plot: filled when it is opened, and kept up while it is. */

import { NAMED, type NamedAngle } from "../model/named.ts";
import { type Model, type Scene } from "../model/model.ts";
import { degrees, radians, short } from "../model/numbers.ts";
import { byId, make } from "./dom.ts";

interface Table {
  readonly title: string;
  readonly head: readonly string[];
  readonly rows: (scene: Scene, model: Model) => (number | string)[][];
}

const TENS = Array.from({ length: 10 }, (_, index) => 10 * index);

const TABLES: readonly Table[] = [
  {
    title: "Shots and their apexes",
    head: ["launch angle α (°)", "x (m)", "y (m)", "r (m)", "time to apex (s)", "range (m)", "flight time (s)"],
    rows: ({ scales }, { shots }) =>
      TENS.map((angle) => {
        const [alpha, epsilon] = [radians(angle), scales.epsilon];
        const apex = shots.apex(alpha, epsilon);
        const lengths = [apex.x, apex.y, apex.distance].map((value) => value * scales.length);
        const range = shots.range(alpha, epsilon) * scales.length;
        return [angle, ...lengths, apex.time * scales.time, range, shots.flightTime(alpha, epsilon) * scales.time];
      }),
  },
  {
    title: "Elevation of the apex by launch angle",
    head: ["launch angle α (°)", "elevation θ (°)", "θ without drag (°)"],
    rows: ({ scales }, { shots }) =>
      TENS.map((angle) => [
        angle,
        degrees(shots.apex(radians(angle), scales.epsilon).elevation),
        degrees(shots.apex(radians(angle), 0).elevation),
      ]),
  },
  {
    title: "Launch angle and its derivatives by elevation",
    head: ["elevation θ (°)", "launch angle α (°)", "dα/dθ", "d²α/dθ²"],
    rows: ({ scales }, { shots }) =>
      TENS.map((angle) => {
        const theta = radians(angle);
        return [angle, degrees(shots.launchAngle(theta, scales.epsilon)), ...shots.slopes(theta, scales.epsilon)];
      }),
  },
  {
    title: "Curvature of the locus",
    head: ["launch angle α (°)", "elevation θ (°)", "ρK", "ρK without drag"],
    rows: ({ scales }, { shots }) =>
      TENS.map((angle) => {
        const apex = shots.apex(radians(angle), scales.epsilon);
        return [angle, degrees(apex.elevation), apex.curvature, shots.apex(radians(angle), 0).curvature];
      }),
  },
  {
    title: "Named launch angles by drag parameter (°)",
    head: ["ε", ...Object.values(NAMED)],
    rows: ({ scales }, model) =>
      [...new Set([0, 0.1, 1, 10, 100, scales.epsilon])]
        .sort((one, other) => one - other)
        .map((epsilon) => {
          const angles = model.named(epsilon);
          return [epsilon, ...(Object.keys(NAMED) as NamedAngle[]).map((name) => degrees(angles[name][0]))];
        }),
  },
];

export class Tables {
  readonly #model: Model;
  readonly #filled: { details: HTMLDetailsElement; body: HTMLElement; table: Table }[];
  #scene: Scene | undefined;

  constructor(model: Model) {
    this.#model = model;
    const section = byId("tables");
    this.#filled = TABLES.map((table) => {
      const body = make("tbody");
      const head = make("tr", {}, ...table.head.map((name) => make("th", { scope: "col" }, name)));
      const grid = make("table", {}, make("caption", { class: "visually-hidden" }, table.title), make("thead", {}, head), body);
      const scroll = make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": table.title }, grid);
      const details = make("details", {}, make("summary", {}, table.title), scroll);
      details.addEventListener("toggle", () => this.#fill());
      section.append(details);
      return { details, body, table };
    });
  }

  show(scene: Scene): void {
    this.#scene = scene;
    this.#fill();
  }

  #fill(): void {
    const scene = this.#scene;
    if (!scene) return;
    for (const { details, body, table } of this.#filled) {
      if (!details.open) continue;
      const rows = table.rows(scene, this.#model).map((cells) =>
        make("tr", {}, ...cells.map((cell) => make("td", {}, typeof cell === "number" ? short(cell, 8) : cell))),
      );
      body.replaceChildren(...rows);
    }
  }
}

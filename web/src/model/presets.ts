/** Views worth starting from. */

import { INITIAL, STANDARD_GRAVITY, type State } from "./state.ts";

export interface Preset {
  readonly name: string;
  /** Where its numbers come from, in a sentence. */
  readonly about: string;
  readonly state: State;
}

export const PRESETS: Readonly<Record<string, Preset>> = {
  figure1: {
    name: "Figure 1 of the paper",
    about: "V₀ = 10 m/s and ε = 0.1: the shots, the locus and the drag-free ellipse.",
    state: INITIAL,
  },
  branch3: {
    name: "Beyond the branch, ε = 3",
    about: "Past ε sin α = 2.146 equation (13) needs the other branch of W; the ghost is what W₀ draws.",
    state: { ...INITIAL, drag: 3, angle: 75, layers: ["fan", "ghost"], frame: "fit" },
  },
  branch10: {
    name: "Beyond the branch, ε = 10",
    about: "Strong drag: with W₀ alone most of the locus would fall into the launch point.",
    state: { ...INITIAL, drag: 10, angle: 57.29577951308232, layers: ["fan", "ghost"], frame: "fit" },
  },
  droplet: {
    name: "A droplet of fog",
    about: "Water, 20 µm across, at 0.5 m/s in air: b = 18 µ/(ρd²) = 816/s, Reynolds number 0.7.",
    state: {
      ...INITIAL,
      speed: 0.5,
      dragKind: "drag_rate",
      drag: 816,
      angle: 30,
      layers: ["fan", "envelope"],
      frame: "fit",
    },
  },
  game: {
    name: "A game character's throw",
    about: "12 m/s, twice Earth's gravity and linear damping 0.8/s, as game engines have it.",
    state: {
      ...INITIAL,
      speed: 12,
      gravity: 2 * STANDARD_GRAVITY,
      dragKind: "drag_rate",
      drag: 0.8,
      angle: 40,
      layers: ["fan", "envelope", "points"],
      frame: "fit",
    },
  },
};

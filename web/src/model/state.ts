/** What the page shows: one frozen value, from which everything else follows. */

export type DragKind = "epsilon" | "drag_rate" | "terminal_speed";

export const LAYERS = {
  fan: "trajectories",
  drag_free: "drag-free ellipse",
  envelope: "envelope",
  circle: "circle at time t",
  comb: "curvature comb",
  points: "named points",
  ghost: "principal branch",
} as const;
export type Layer = keyof typeof LAYERS;

export type CurvatureBy = "launch_angle" | "elevation";
export type Frame = "fixed" | "fit";
/** Shots to the right only, or to both sides: those to the left are mirror images. */
export type Sides = "right" | "both";
export type Theme = "auto" | "light" | "dark";

export interface State {
  /** V₀, m/s. */
  readonly speed: number;
  /** g, m/s². */
  readonly gravity: number;
  /** The drag is kept as it was said; the other two ways to say it follow. */
  readonly dragKind: DragKind;
  readonly drag: number;
  /** Launch angle of the current shot, degrees: 0 to 180, above 90 only where both sides are shown. */
  readonly angle: number;
  /** Time since launch, s. */
  readonly time: number;
  /** Other drag parameters drawn beside the current one. */
  readonly compare: readonly number[];
  readonly layers: readonly Layer[];
  readonly curvatureBy: CurvatureBy;
  readonly frame: Frame;
  readonly sides: Sides;
  readonly theme: Theme;
}

export const STANDARD_GRAVITY = 9.80665;
export const MOST_COMPARED = 4;

export const INITIAL: State = {
  speed: 10,
  gravity: STANDARD_GRAVITY,
  dragKind: "epsilon",
  drag: 0.1,
  angle: 45,
  time: 0,
  compare: [],
  layers: ["fan", "drag_free"],
  curvatureBy: "launch_angle",
  frame: "fixed",
  sides: "right",
  theme: "auto",
};

/** What follows from a state, by the operations of Python's `Launcher`, in their order. */
export interface Scales {
  readonly epsilon: number;
  readonly dragRate: number;
  readonly terminalSpeed: number;
  /** ρ = V₀²/g, m. */
  readonly length: number;
  /** V₀/g, s. */
  readonly time: number;
}

export function scales({ speed, gravity, dragKind, drag }: State): Scales {
  const length = (speed * speed) / gravity;
  const time = speed / gravity;
  switch (dragKind) {
    case "epsilon":
      return { epsilon: drag, dragRate: (drag * gravity) / speed, terminalSpeed: speed / drag, length, time };
    case "drag_rate":
      return { epsilon: (drag * speed) / gravity, dragRate: drag, terminalSpeed: gravity / drag, length, time };
    case "terminal_speed":
      return { epsilon: speed / drag, dragRate: gravity / drag, terminalSpeed: drag, length, time };
  }
}

/** The same launcher with its drag said in another way. */
export function dragSaidAs(kind: DragKind, state: State): State {
  if (kind === state.dragKind) return state;
  const { epsilon, dragRate, terminalSpeed } = scales(state);
  const drag = { epsilon, drag_rate: dragRate, terminal_speed: terminalSpeed }[kind];
  return { ...state, dragKind: kind, drag };
}

/** The sentence that says why a state cannot be shown, or nothing. */
export function complaint(state: State): string | undefined {
  const positive = (name: string, value: number) =>
    value > 0 && Number.isFinite(value) ? undefined : `${name} must be above 0 and finite, got ${value}`;
  const notNegative = (name: string, value: number) =>
    value >= 0 && Number.isFinite(value) ? undefined : `${name} must be at least 0 and finite, got ${value}`;
  const { speed, gravity, dragKind, drag, angle, time, compare } = state;
  const { epsilon, length, time: timeScale } = scales(state);
  return (
    positive("speed", speed) ??
    positive("gravity", gravity) ??
    (dragKind === "terminal_speed"
      ? drag > 0
        ? undefined
        : `terminal speed must be above 0, got ${drag}`
      : notNegative(dragKind === "epsilon" ? "epsilon" : "drag rate", drag)) ??
    notNegative(`epsilon, from this ${dragKind.replace("_", " ")},`, epsilon) ??
    positive("length scale speed²/gravity", length) ??
    positive("time scale speed/gravity", timeScale) ??
    (angle >= 0 && angle <= 180 ? undefined : `angle must be from 0 to 180 degrees, got ${angle}`) ??
    notNegative("time", time) ??
    compare.map((other) => notNegative("compared epsilon", other)).find(Boolean) ??
    (compare.length > MOST_COMPARED
      ? `at most ${MOST_COMPARED} other epsilons can be compared, got ${compare.length}`
      : undefined)
  );
}

/** Shots to the left show both sides; where only the right one is wanted, they turn to it. */
function onItsSide(state: State, part: Partial<State>): State {
  if (state.angle <= 90 || state.sides === "both") return state;
  return part.sides === "right" && part.angle === undefined
    ? { ...state, angle: 180 - state.angle }
    : { ...state, sides: "both" };
}

export type Listener = (state: State, before: State) => void;

/** Holds the state and tells who listens. A state that cannot be shown is refused with a sentence. */
export class Store {
  #state: State;
  readonly #listeners: Listener[] = [];

  constructor(state: State) {
    this.#state = state;
  }

  get state(): State {
    return this.#state;
  }

  listen(listener: Listener): void {
    this.#listeners.push(listener);
  }

  /** The sentence that says why the change was refused, or nothing. */
  change(part: Partial<State>): string | undefined {
    const before = this.#state;
    const after = onItsSide({ ...before, ...part }, part);
    const refused = complaint(after);
    if (refused) return refused;
    this.#state = after;
    for (const listener of this.#listeners) listener(after, before);
    return undefined;
  }
}

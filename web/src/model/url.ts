/** The whole state as the part of an address after #, and back. */

import { parsed } from "./numbers.ts";
import { complaint, INITIAL, LAYERS, type Layer, type State } from "./state.ts";

const DRAG_KINDS = ["epsilon", "drag_rate", "terminal_speed"] as const;
const CHOICES = {
  curvature_by: ["launch_angle", "elevation"],
  frame: ["fixed", "fit"],
  sides: ["right", "both"],
  theme: ["auto", "light", "dark"],
} as const;

/** `speed=10&gravity=9.80665&epsilon=0.1&…`: the shortest digits that give the same double back. */
export function toHash(state: State): string {
  const entries: [string, string][] = [
    ["speed", String(state.speed)],
    ["gravity", String(state.gravity)],
    [state.dragKind, state.drag === Infinity ? "inf" : String(state.drag)],
    ["angle", String(state.angle)],
    ["time", String(state.time)],
    ["compare", state.compare.join(",")],
    ["layers", state.layers.join(",")],
    ["curvature_by", state.curvatureBy],
    ["frame", state.frame],
    ["sides", state.sides],
    ["theme", state.theme],
  ];
  return entries.map(([name, value]) => `${name}=${value}`).join("&");
}

export interface Read {
  readonly state: State;
  /** One sentence for each entry that was not taken. */
  readonly messages: readonly string[];
}

/** The state a hash speaks of. What it does not say, or says badly, is as at first. */
export function fromHash(hash: string): Read {
  const messages: string[] = [];
  let state = INITIAL;
  const take = (part: Partial<State>): void => {
    const next = { ...state, ...part };
    const refused = complaint(next);
    if (refused) messages.push(refused);
    else state = next;
  };
  const number = (name: string, text: string): number => {
    const value = parsed(text);
    if (Number.isNaN(value)) messages.push(`${name} must be a number, got ${shown(text)}`);
    return value;
  };
  const drags: string[] = [];
  for (const entry of hash.replace(/^#/, "").split("&").filter(Boolean)) {
    const cut = entry.indexOf("=");
    const name = cut < 0 ? entry : entry.slice(0, cut);
    const text = decoded(cut < 0 ? "" : entry.slice(cut + 1));
    if (name === "speed" || name === "gravity" || name === "angle" || name === "time") {
      const value = number(name, text);
      if (!Number.isNaN(value)) take({ [name]: value });
    } else if (isOneOf(name, DRAG_KINDS)) {
      drags.push(name);
      const value = number(name, text);
      if (!Number.isNaN(value)) take({ dragKind: name, drag: value });
    } else if (name === "compare") {
      const values = text.split(",").filter(Boolean).map((part) => number(name, part));
      if (!values.some(Number.isNaN)) take({ compare: values });
    } else if (name === "layers") {
      const names = text.split(",").filter(Boolean);
      const wrong = names.find((layer) => !(layer in LAYERS));
      if (wrong === undefined) take({ layers: [...new Set(names)] as Layer[] });
      else messages.push(`layers must be among ${Object.keys(LAYERS).join(", ")}, got ${shown(wrong)}`);
    } else if (name === "curvature_by" || name === "frame" || name === "sides" || name === "theme") {
      const key = name === "curvature_by" ? "curvatureBy" : name;
      if (isOneOf(text, CHOICES[name])) take({ [key]: text });
      else messages.push(`${name} must be one of ${CHOICES[name].join(", ")}, got ${shown(text)}`);
    } else {
      messages.push(`the address names ${shown(name)}, which is nothing here`);
    }
  }
  if (drags.length > 1) messages.push(`give one of ${DRAG_KINDS.join(", ")}; got ${drags.join(" and ")}`);
  // A shot to the left shows both sides, whatever else the address says.
  return { state: state.angle > 90 ? { ...state, sides: "both" } : state, messages };
}

function isOneOf<Text extends string>(text: string, choices: readonly Text[]): text is Text {
  return (choices as readonly string[]).includes(text);
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** Somebody else's text, cut short, for a message. */
function shown(text: string): string {
  const short = text.length > 24 ? `${text.slice(0, 24)}…` : text;
  return short === "" ? "nothing" : short;
}

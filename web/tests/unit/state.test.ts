import { describe, expect, it } from "vitest";
import { PRESETS } from "../../src/model/presets.ts";
import { DRAG_SCALES, SPEED_SCALE } from "../../src/model/scale.ts";
import { complaint, dragSaidAs, INITIAL, scales, Store, type State } from "../../src/model/state.ts";
import { fromHash, toHash } from "../../src/model/url.ts";

describe("the three ways to say the drag", () => {
  it("agree", () => {
    const state: State = { ...INITIAL, speed: 12, dragKind: "drag_rate", drag: 0.3 };
    const { epsilon, terminalSpeed } = scales(state);
    expect(epsilon).toBe((0.3 * 12) / 9.80665);
    expect(scales(dragSaidAs("terminal_speed", state)).epsilon).toBeCloseTo(epsilon, 14);
    expect(dragSaidAs("terminal_speed", state).drag).toBe(terminalSpeed);
  });

  it("reach no drag at all", () => {
    expect(scales({ ...INITIAL, drag: 0 }).terminalSpeed).toBe(Infinity);
    expect(scales({ ...INITIAL, dragKind: "terminal_speed", drag: Infinity })).toMatchObject({ epsilon: 0, dragRate: 0 });
  });
});

describe("a state that cannot be shown", () => {
  it.each<[Partial<State>, string]>([
    [{ speed: 0 }, "speed must be above 0 and finite, got 0"],
    [{ gravity: Infinity }, "gravity must be above 0 and finite, got Infinity"],
    [{ drag: -0.1 }, "epsilon must be at least 0 and finite, got -0.1"],
    [{ dragKind: "drag_rate", drag: NaN }, "drag rate must be at least 0 and finite, got NaN"],
    [{ dragKind: "terminal_speed", drag: 0 }, "terminal speed must be above 0, got 0"],
    [{ dragKind: "terminal_speed", drag: 5e-324 }, "epsilon, from this terminal speed, must be at least 0 and finite, got Infinity"],
    [{ speed: 1e200 }, "length scale speed²/gravity must be above 0 and finite, got Infinity"],
    [{ angle: 180.5 }, "angle must be from 0 to 180 degrees, got 180.5"],
    [{ compare: [1, -2] }, "compared epsilon must be at least 0 and finite, got -2"],
    [{ compare: [1, 2, 3, 4, 5] }, "at most 4 other epsilons can be compared, got 5"],
  ])("%j is refused", (part, sentence) => {
    const store = new Store(INITIAL);
    expect(store.change(part)).toBe(sentence);
    expect(store.state).toBe(INITIAL);
  });
});

describe("a shot to the left", () => {
  it("shows both sides, and keeps them", () => {
    const store = new Store(INITIAL);
    store.change({ angle: 120 });
    expect(store.state).toMatchObject({ angle: 120, sides: "both" });
    store.change({ angle: 60 });
    expect(store.state.sides).toBe("both");
  });

  it("turns to the right where only that is wanted", () => {
    const store = new Store({ ...INITIAL, angle: 120, sides: "both" });
    store.change({ sides: "right" });
    expect(store.state).toMatchObject({ angle: 60, sides: "right" });
  });

  it.each(["#angle=120", "#angle=120&sides=right", "#sides=right&angle=120"])("comes from %s", (hash) => {
    expect(fromHash(hash)).toEqual({ state: { ...INITIAL, angle: 120, sides: "both" }, messages: [] });
  });
});

it("tells who listens", () => {
  const store = new Store(INITIAL);
  const heard: [number, number][] = [];
  store.listen((state, before) => heard.push([state.angle, before.angle]));
  store.change({ angle: 30 });
  store.change({ angle: -1 });
  expect(heard).toEqual([[30, 45]]);
});

describe("the address", () => {
  const states: State[] = [
    INITIAL,
    ...Object.values(PRESETS).map(({ state }) => state),
    {
      speed: 1.2345678901234567,
      gravity: 1.62,
      dragKind: "terminal_speed",
      drag: Infinity,
      angle: 0.1 + 0.2,
      time: 1e-9,
      compare: [0, 5e-324, 1e6],
      layers: [],
      curvatureBy: "elevation",
      frame: "fit",
      sides: "both",
      theme: "dark",
    },
  ];
  it.each(states.map((state) => [toHash(state), state]))("%s comes back whole", (hash, state) => {
    expect(fromHash(`#${hash}`)).toEqual({ state, messages: [] });
  });

  it.each([
    ["epsilon=-1", "epsilon must be at least 0 and finite, got -1"],
    ["epsilon=abc", "epsilon must be a number, got abc"],
    ["speed=", "speed must be a number, got nothing"],
    ["layers=fan,sun", "layers must be among fan, drag_free, envelope, circle, comb, points, ghost, got sun"],
    ["theme=pink", "theme must be one of auto, light, dark, got pink"],
    ["%E0%A4%A", "the address names %E0%A4%A, which is nothing here"],
    ["epsilon=1&drag_rate=1", "give one of epsilon, drag_rate, terminal_speed; got epsilon and drag_rate"],
    ["compare=1,2,3,4,5", "at most 4 other epsilons can be compared, got 5"],
  ])("%s gets a message", (hash, message) => {
    expect(fromHash(hash).messages).toEqual([message]);
    expect(complaint(fromHash(hash).state)).toBeUndefined();
  });

  it("keeps what it can", () => {
    const { state, messages } = fromHash("#speed=20&epsilon=x&angle=30");
    expect(state).toEqual({ ...INITIAL, speed: 20, angle: 30 });
    expect(messages).toHaveLength(1);
  });
});

describe("sliders", () => {
  it.each(Object.values(DRAG_SCALES).concat(SPEED_SCALE))("know the position of each of their values", (scale) => {
    for (let position = 0; position <= scale.last; position += 1) {
      expect(scale.position(scale.value(position))).toBe(position);
    }
  });

  it("reach no drag exactly, and round numbers", () => {
    expect(DRAG_SCALES.epsilon.value(0)).toBe(0);
    expect(DRAG_SCALES.terminal_speed.value(DRAG_SCALES.terminal_speed.last)).toBe(Infinity);
    expect(DRAG_SCALES.epsilon.value(DRAG_SCALES.epsilon.position(0.1))).toBe(0.1);
    expect(DRAG_SCALES.epsilon.position(1e6)).toBe(DRAG_SCALES.epsilon.last);
  });
});

/** All views of one store, drawn together once a frame. */

import { NAMED, type NamedAngle } from "../model/named.ts";
import { type Model, type Scene } from "../model/model.ts";
import { degrees, short } from "../model/numbers.ts";
import { dragSaidAs, type Store } from "../model/state.ts";
import { toCsv, toPython, toWords } from "../model/text.ts";
import { toHash } from "../model/url.ts";
import { type Chart } from "./chart.ts";
import { Controls } from "./controls.ts";
import { byId, lineSample, make, setText } from "./dom.ts";
import { Formulas } from "./formulas.ts";
import { follow, Handle } from "./handles.ts";
import { bendPanel, curvaturePanel, elevationPanel, NamedPanel, type Panel, slopePanel, type Wish } from "./linked_panels.ts";
import { MainPanel } from "./main_panel.ts";
import { namedStroke, palette, type Palette } from "./palette.ts";
import { Player } from "./player.ts";
import { Readout } from "./readout.ts";
import { Tables } from "./tables.ts";
import { TakeAway } from "./take_away.ts";

/** Steps of arrow keys and page keys on a handle, degrees; and in ε, positions of its slider. */
const ANGLE_STEPS = [0.5, 5] as const;
const EPSILON_STEPS = [1, 10] as const;
/** Text that is read aloud, the address and the tables follow when the hand rests, ms. */
const REST = 150;

export class Explorer {
  readonly #store: Store;
  readonly #model: Model;
  readonly #main: MainPanel;
  readonly #panels: readonly Panel[];
  readonly #controls: Controls;
  readonly #player: Player;
  readonly #readout: Readout;
  readonly #tables: Tables;
  readonly #handles: { apex: Handle; direction: Handle };
  readonly #cursors: readonly Handle[];
  readonly #dark = matchMedia("(prefers-color-scheme: dark)");
  /** What the last frame took, and when the first was drawn, ms; whether nothing is left to do: for measurements and tests. */
  readonly timings = { computing: 0, drawing: 0, interactive: 0, resting: false };
  #formulas: Formulas | undefined;
  #colors: Palette;
  #complaint: string | undefined;
  #asked = false;
  #resized = true;
  #rest = 0;

  constructor(store: Store, model: Model) {
    this.#store = store;
    this.#model = model;
    this.#applyTheme();
    this.#colors = palette();
    this.#main = new MainPanel(byId("main-panel"), model, this.#colors);
    this.#panels = [
      elevationPanel(byId("elevation-panel"), this.#colors),
      slopePanel(byId("slope-panel"), this.#colors),
      bendPanel(byId("bend-panel"), this.#colors),
      curvaturePanel(byId("curvature-panel"), this.#colors),
      new NamedPanel(byId("named-panel"), model, this.#colors),
    ];
    const complain = (sentence: string | undefined): void => this.complain(sentence);
    this.#controls = new Controls(store, complain);
    this.#player = new Player(store);
    this.#readout = new Readout(() => this.#ask());
    this.#tables = new Tables(model);
    this.#handles = this.#mainHandles();
    this.#cursors = this.#panels.map((panel) => this.#cursor(panel));
    this.#takeAway(complain);
    this.#namedLegend();
    byId("message").querySelector("button")?.addEventListener("click", () => this.complain(undefined));
    store.listen((state, before) => {
      if (state.theme !== before.theme) this.#recolor();
      this.#ask();
    });
    this.#dark.addEventListener("change", () => this.#recolor());
    // Only then: asking for sizes in each frame would lay the page out twice.
    const sizes = new ResizeObserver(() => {
      this.#resized = true;
      this.#ask();
    });
    for (const { host } of this.#charts) sizes.observe(host);
    this.#draw();
    this.timings.interactive = performance.now();
    this.#whenIdle();
  }

  /** What can wait until the page stands: the formulas, then the curves of the named angles, some at a time. */
  #whenIdle(): void {
    const { namedCurves } = this.#model;
    const work = (): boolean => {
      if (!this.#formulas) {
        this.#formulas = new Formulas();
        this.#ask();
      } else {
        namedCurves.advance();
        if (namedCurves.complete) this.#ask();
      }
      return !namedCurves.complete;
    };
    const idle = window.requestIdleCallback ?? ((call: () => void) => setTimeout(call, 10));
    const next = (): void => void idle(() => work() && next(), { timeout: 200 });
    next();
  }

  /** Shows a sentence above the page, or none. */
  complain(sentence: string | undefined): void {
    if (sentence === this.#complaint) return;
    this.#complaint = sentence;
    const message = byId("message");
    message.hidden = sentence === undefined;
    const place = message.querySelector("p");
    if (place) setText(place, sentence ?? "");
  }

  /** One frame for all changes since the last. */
  #ask(): void {
    if (this.#asked) return;
    this.#asked = true;
    this.timings.resting = false;
    requestAnimationFrame(() => this.#draw());
  }

  #draw(): void {
    this.#asked = false;
    const start = performance.now();
    const scene = this.#model.scene(this.#store.state);
    const computed = performance.now();
    if (this.#resized) for (const chart of this.#charts) chart.measure();
    this.#resized = false;
    this.#main.draw(scene);
    for (const panel of this.#panels) panel.draw(scene);
    this.#placeHandles(scene, false);
    this.#controls.show(scene, this.#colors);
    this.#player.show(scene);
    this.#readout.show(scene);
    this.#formulas?.show(scene);
    clearTimeout(this.#rest);
    this.#rest = window.setTimeout(() => this.#settle(scene), REST);
    this.timings.computing = computed - start;
    this.timings.drawing = performance.now() - computed;
  }

  #settle(scene: Scene): void {
    this.#placeHandles(scene, true);
    setText(byId("summary-text"), toWords(scene));
    const code = byId("python-line").querySelector("code");
    if (code) setText(code, toPython(scene));
    this.#tables.show(scene);
    history.replaceState(null, "", `#${toHash(scene.state)}`);
    this.timings.resting = !this.#asked && this.#model.namedCurves.complete;
  }

  /**
   * The handle in use moves at once, the others when the hand rests: nobody sees them, since the
   * charts draw the knobs, and an element that moves is laid out and painted anew.
   */
  #placeHandles(scene: Scene, all: boolean): void {
    const { state, apex, scales } = scene;
    const used = document.activeElement;
    const moves = (handle: Handle): boolean => all || handle.element === used;
    const max = state.sides === "both" ? 180 : 90;
    const { apex: atApex, direction } = this.#handles;
    const turned = `launch angle ${short(state.angle, 5)} degrees`;
    if (moves(atApex)) {
      const elevation = degrees(apex.elevation);
      const where = `${short(apex.x * scales.length, 4)} m away, ${short(apex.y * scales.length, 4)} m high`;
      const text = `elevation ${short(elevation, 4)} degrees, ${where}`;
      atApex.place(this.#main.places(scene).apex, elevation, max, text);
    }
    if (moves(direction)) direction.place(this.#main.places(scene).direction, state.angle, max, turned);
    this.#panels.forEach((panel, index) => {
      const cursor = this.#cursors[index];
      if (!moves(cursor)) return;
      if (panel instanceof NamedPanel) {
        cursor.place(panel.place(scene), scales.epsilon, 1000, `epsilon ${short(scales.epsilon)}`);
      } else cursor.place(panel.place(scene), state.angle, max, turned);
    });
  }

  #wish(wish: Wish): void {
    const state = this.#store.state;
    if ("epsilon" in wish) {
      const { dragKind, drag } = dragSaidAs(state.dragKind, { ...dragSaidAs("epsilon", state), drag: wish.epsilon });
      this.#store.change({ dragKind, drag });
      return;
    }
    const launchAngle =
      "launchAngle" in wish
        ? wish.launchAngle
        : this.#model.shots.launchAngle(Math.min(Math.PI, Math.max(0, wish.elevation)), this.#scales.epsilon);
    this.#store.change({ angle: Math.min(180, Math.max(0, Number(degrees(launchAngle).toFixed(3)))) });
  }

  get #charts(): readonly [Chart, ...Chart[]] {
    return [this.#main.chart, ...this.#panels.map((panel) => panel.chart)];
  }

  get #scales(): Scene["scales"] {
    return this.#model.scene(this.#store.state).scales;
  }

  /** Moves the launch angle by keys. */
  #turn(by: number): void {
    this.#wish({ launchAngle: ((this.#store.state.angle + by) * Math.PI) / 180 });
  }

  #turnTo(which: "first" | "last"): void {
    this.#store.change({ angle: which === "first" ? 0 : this.#store.state.sides === "both" ? 180 : 90 });
  }

  #mainHandles(): { apex: Handle; direction: Handle } {
    const { chart } = this.#main;
    const keys = {
      steps: ANGLE_STEPS,
      move: (by: number) => this.#turn(by),
      end: (which: "first" | "last") => this.#turnTo(which),
    };
    const direction = new Handle(chart.handles, { label: "Launch direction", kind: "direction", ...keys });
    const apex = new Handle(chart.handles, { label: "Apex of the shot", kind: "apex", ...keys });
    follow(chart.host, (event) => {
      // On the plot itself: whichever of the two is nearer, but a finger there scrolls the page.
      const onHandle = event.target instanceof Element && event.target.closest(".handle");
      if (!onHandle && event.pointerType === "touch") return undefined;
      const places = this.#main.places(this.#model.scene(this.#store.state));
      const { x, y } = chart.pixels(event);
      const far = ([left, top]: [number, number]): number => Math.hypot(x - left, y - top);
      const dragsDirection = onHandle
        ? onHandle === direction.element
        : far(places.direction) < far(places.apex);
      if (!onHandle) (dragsDirection ? direction : apex).element.focus({ preventScroll: true });
      return (now) => {
        const at = chart.at(now);
        // Where only the right side is shown, a pointer that strays over the vertical stays on it.
        const right = this.#store.state.sides === "right";
        const angle = Math.atan2(Math.max(0, at.y), right ? Math.max(0, at.x) : at.x);
        this.#wish(dragsDirection ? { launchAngle: angle } : { elevation: angle });
      };
    });
    return { apex, direction };
  }

  #cursor(panel: Panel): Handle {
    const drag = panel instanceof NamedPanel;
    const slider = byId<HTMLInputElement>("drag-slider");
    const slideTo = (position: number): void => {
      slider.value = String(Math.min(Number(slider.max), Math.max(0, position)));
      slider.dispatchEvent(new Event("input"));
    };
    follow(panel.chart.host, (event) => {
      const onHandle = event.target instanceof Element && event.target.closest(".handle");
      if (!onHandle && event.pointerType === "touch") return undefined;
      return (now) => {
        const x = panel.chart.at(now).x;
        const [first = 0, last = 90] = panel.chart.x.domain();
        this.#wish(panel.wish(Math.min(last, Math.max(first, x)), this.#model.scene(this.#store.state)));
      };
    });
    return new Handle(panel.chart.handles, {
      label: `${panel.name}: cursor`,
      kind: "cursor",
      steps: drag ? EPSILON_STEPS : ANGLE_STEPS,
      move: (by) => (drag ? slideTo(Number(slider.value) + by) : this.#turn(by)),
      end: (which) => (drag ? slideTo(which === "first" ? -Infinity : Infinity) : this.#turnTo(which)),
    });
  }

  #takeAway(complain: (sentence: string | undefined) => void): void {
    const scene = (): Scene => this.#model.scene(this.#store.state);
    const view = {
      charts: this.#charts,
      caption: () => {
        const { state, scales } = scene();
        return (
          `V₀ = ${short(state.speed, 5)} m/s, g = ${short(state.gravity, 6)} m/s², ε = ${short(scales.epsilon, 5)}, ` +
          `α = ${short(state.angle, 5)}°. archerfish`
        );
      },
      csv: () => toCsv(scene(), scene().locus.distances()),
      python: () => toPython(scene()),
      link: () => `${location.href.split("#")[0]}#${toHash(this.#store.state)}`,
    };
    new TakeAway(view, complain);
  }

  #namedLegend(): void {
    const items = (Object.keys(NAMED) as NamedAngle[]).map((name, index) =>
      make("li", {}, lineSample(namedStroke(this.#colors, index)), NAMED[name]),
    );
    byId("named-legend").replaceChildren(...items);
  }

  #applyTheme(): void {
    const { theme } = this.#store.state;
    document.documentElement.dataset["theme"] = theme === "auto" ? (this.#dark.matches ? "dark" : "light") : theme;
  }

  #recolor(): void {
    this.#applyTheme();
    this.#colors = palette();
    for (const chart of this.#charts) chart.recolor(this.#colors);
    this.#namedLegend();
    this.#ask();
  }
}


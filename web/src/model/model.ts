/** Everything drawn and read out for a state: the kernels' values, computed once each. */

import { type Apex, type Point, Shots } from "./apex.ts";
import { AngleGrid, LocusCurves, POINTS } from "./curves.ts";
import { Envelope, Fan, type Flight, Instants } from "./flights.ts";
import { type Kernels } from "./kernels.ts";
import { NamedAngleSolver, type NamedAngles } from "./named.ts";
import { NamedCurves } from "./named_curves.ts";
import { radians } from "./numbers.ts";
import { PrincipalBranch } from "./principal.ts";
import { MOST_COMPARED, scales, type Layer, type Scales, type State } from "./state.ts";

/** What a frame is drawn from. Lengths in ρ, times in V₀/g, angles in radians. */
export interface Scene {
  readonly state: State;
  readonly scales: Scales;
  readonly apex: Apex;
  /** dα/dθ and d²α/dθ² at the apex. */
  readonly slopes: readonly [number, number];
  readonly flightTime: number;
  readonly range: number;
  /** r̃ of the drag-free locus at the elevation of the apex. */
  readonly freeRadius: number;
  /** Time since launch, not past the landing. */
  readonly time: number;
  readonly position: Point;
  /** Longest range of all shots. */
  readonly reach: number;
  /** Height of the highest apex. */
  readonly top: number;
  readonly locus: LocusCurves;
  readonly dragFree: LocusCurves;
  readonly compared: readonly LocusCurves[];
}

export class Model {
  readonly grid: AngleGrid;
  readonly shots: Shots;
  readonly #locus: LocusCurves;
  readonly #dragFree: LocusCurves;
  readonly #compared: readonly LocusCurves[];
  readonly namedCurves: NamedCurves;
  readonly #instants: Instants;
  readonly #fan: Fan;
  readonly #envelope: Envelope;
  readonly #principal: PrincipalBranch;
  readonly #namedHere: NamedAngleSolver;
  #named: { epsilon: number; angles: NamedAngles } | undefined;
  #atEpsilon: { epsilon: number; reach: number; top: number } = { epsilon: NaN, reach: 0, top: 0 };

  constructor(kernels: Kernels) {
    this.grid = new AngleGrid(kernels);
    this.shots = new Shots(kernels);
    this.#locus = new LocusCurves(kernels, this.grid);
    this.#dragFree = new LocusCurves(kernels, this.grid).update(0);
    this.#compared = Array.from({ length: MOST_COMPARED }, () => new LocusCurves(kernels, this.grid));
    this.namedCurves = new NamedCurves(kernels);
    this.#instants = new Instants(kernels);
    this.#fan = new Fan(kernels);
    this.#envelope = new Envelope(kernels, POINTS);
    this.#principal = new PrincipalBranch(kernels, POINTS);
    this.#namedHere = new NamedAngleSolver(kernels, 1);
  }

  scene(state: State): Scene {
    const scale = scales(state);
    const { epsilon } = scale;
    const launchAngle = radians(state.angle);
    const apex = this.shots.apex(launchAngle, epsilon);
    const flightTime = this.shots.flightTime(launchAngle, epsilon);
    const time = Math.min(state.time / scale.time, flightTime);
    if (epsilon !== this.#atEpsilon.epsilon) {
      const reach = this.shots.range(this.shots.optimalAngle(epsilon), epsilon);
      const top = this.shots.apex(Math.PI / 2, epsilon).y;
      this.#atEpsilon = { epsilon, reach, top };
    }
    const scene = {
      state,
      scales: scale,
      apex,
      slopes: this.shots.slopes(apex.elevation, epsilon),
      flightTime,
      range: this.shots.range(launchAngle, epsilon),
      freeRadius: this.shots.radius(apex.elevation, 0),
      time,
      position: this.shots.position(time, launchAngle, epsilon),
      reach: this.#atEpsilon.reach,
      top: this.#atEpsilon.top,
      locus: this.#locus.update(epsilon),
      dragFree: this.#dragFree,
      compared: state.compare.map((other, index) => this.#compared[index].update(other)),
    };
    this.#prepare(scene);
    return scene;
  }

  /** Computes what the layers draw, so that drawing finds it ready. */
  #prepare(scene: Scene): void {
    const { state, locus, scales: { epsilon } } = scene;
    this.#instants.update(epsilon);
    if (shows(state, "fan")) this.fan(epsilon);
    if (shows(state, "envelope")) this.envelope(scene);
    if (shows(state, "ghost")) this.principal(locus);
    if (shows(state, "points")) this.named(epsilon);
  }

  instants(epsilon: number): Instants {
    return this.#instants.update(epsilon);
  }

  fan(epsilon: number): Fan {
    return this.#fan.update(this.instants(epsilon));
  }

  /** The current shot. */
  shot({ apex: { launchAngle }, flightTime, range, scales: { epsilon } }: Scene): Flight {
    const count = this.instants(epsilon).before(flightTime);
    return { cosine: Math.cos(launchAngle), sine: Math.sin(launchAngle), count, range };
  }

  envelope({ reach, scales: { epsilon } }: Scene): Envelope {
    return this.#envelope.update(epsilon, reach);
  }

  /** The principal branch's curve and how many of its points are wrong. */
  principal(locus: LocusCurves): { curve: PrincipalBranch; count: number } {
    return { count: this.#principal.update(locus), curve: this.#principal };
  }

  /** The named angles of one drag parameter. */
  named(epsilon: number): NamedAngles {
    if (this.#named?.epsilon !== epsilon) {
      this.#named = { epsilon, angles: this.#namedHere.solve([epsilon]) };
    }
    return this.#named.angles;
  }
}

export const shows = (state: State, layer: Layer): boolean => state.layers.includes(layer);

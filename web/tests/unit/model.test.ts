import { describe, expect, it } from "vitest";
import { FAN_ANGLES, type Flight } from "../../src/model/flights.ts";
import { unsupported } from "../../src/model/kernels.ts";
import { Model } from "../../src/model/model.ts";
import { NAMED, NamedAngleSolver, type NamedAngle } from "../../src/model/named.ts";
import { degrees, radians } from "../../src/model/numbers.ts";
import { INITIAL } from "../../src/model/state.ts";
import { toCsv, toPython, toWords } from "../../src/model/text.ts";
import { kernels } from "./kernels.ts";

const core = await kernels();
const model = new Model(core);
/** The points of a shot, up to its landing. */
function points({ cosine, sine, count }: Flight, epsilon: number): { x: Float64Array; y: Float64Array } {
  const { radius, height } = model.instants(epsilon);
  const x = radius.slice(0, count).map((away) => away * cosine);
  return { x, y: radius.slice(0, count).map((away, index) => away * sine + height[index]) };
}
const at = (epsilon: number, angle = 45) => model.scene({ ...INITIAL, drag: epsilon, angle });

it("knows that node runs WebAssembly with SIMD", () => expect(unsupported()).toBeUndefined());

describe("the scene", () => {
  it("has the textbook's apex without drag", () => {
    const { apex, reach, top, flightTime } = at(0);
    expect(apex.x).toBeCloseTo(0.5, 15);
    expect(apex.y).toBeCloseTo(0.25, 15);
    expect(degrees(apex.elevation)).toBeCloseTo(26.5650511770780, 12);
    expect(apex.curvature).toBeCloseTo(8, 13);
    expect(reach).toBeCloseTo(1, 15);
    expect(top).toBeCloseTo(0.5, 15);
    expect(flightTime).toBeCloseTo(Math.SQRT2, 15);
  });

  it("finds the shot of an apex again", () => {
    for (const epsilon of [0, 0.1, 3, 1e6]) {
      const { apex } = at(epsilon, 33);
      expect(degrees(model.shots.launchAngle(apex.elevation, epsilon))).toBeCloseTo(33, 12);
    }
  });

  it("stops at the landing", () => {
    const scene = model.scene({ ...INITIAL, time: 1e9 });
    expect(scene.time).toBe(scene.flightTime);
    expect(scene.position.y).toBeCloseTo(0, 14);
    expect(scene.position.x).toBeCloseTo(model.shots.range(radians(45), 0.1), 14);
  });

  it("is finite where drag is overwhelming", () => {
    const { locus, apex, slopes } = at(1e6, 45);
    for (const values of [locus.x, locus.y, locus.elevation, locus.curvature, locus.launchAngleD1, locus.launchAngleD2]) {
      expect(values.every(Number.isFinite)).toBe(true);
    }
    expect([...Object.values(apex), ...slopes].every(Number.isFinite)).toBe(true);
  });
});

describe("flights", () => {
  it.each([0, 0.1, 10, 1e4])("rise to their apexes and come down, ε = %f", (epsilon) => {
    const fan = model.fan(epsilon);
    FAN_ANGLES.forEach((angle, shot) => {
      const { range } = fan.flights[shot];
      const { x, y } = points(fan.flights[shot], epsilon);
      const apex = model.shots.apex(radians(angle), epsilon);
      expect(1 - Math.max(...y) / apex.y).toBeLessThan(2e-4); // A hundredth of a pixel.
      expect([x[0], y[0]]).toEqual([0, 0]);
      expect(Math.min(...y)).toBeGreaterThanOrEqual(0);
      expect(range).toBe(model.shots.range(radians(angle), epsilon));
      expect(range / x[x.length - 1]).toBeGreaterThan(1 - 1e-15);
    });
    // The steepest is in the air at each instant but the last.
    expect(fan.flights.at(-1)?.count).toBe(1999);
  });

  it.each([0, 0.1, 10, 1e4])("are where the kernels have them, ε = %f", (epsilon) => {
    for (const angle of [10, 45, 85, 120]) {
      const scene = at(epsilon, angle);
      const { x, y } = points(model.shot(scene), epsilon);
      const count = x.length;
      expect(count).toBeGreaterThan(100);
      // Not next to the wall of strong drag, where the distance says nothing of the time.
      for (let index = 0; Math.abs(x[index]) < 0.9 * Math.abs(scene.range) && index < count; index += 37) {
        // The time of a point from its distance, by bisection on the kernel.
        let [early, late] = [0, scene.flightTime];
        for (let halving = 0; halving < 60; halving += 1) {
          const middle = 0.5 * (early + late);
          if (Math.abs(model.shots.position(middle, radians(angle), epsilon).x) < Math.abs(x[index])) early = middle;
          else late = middle;
        }
        const { y: height } = model.shots.position(0.5 * (early + late), radians(angle), epsilon);
        expect(Math.abs(height - y[index]) / scene.top).toBeLessThan(1e-9);
      }
    }
  });

  it("stay under the envelope", () => {
    const scene = at(2);
    const { x, y } = model.envelope(scene);
    expect(y[0]).toBeCloseTo(model.scene({ ...INITIAL, drag: 2 }).top, 13);
    expect(x[x.length - 1]).toBe(scene.reach);
    expect(Math.abs(y[y.length - 1])).toBe(0);
  });

  it("are all on one circle", () => {
    const { radius, centre } = model.shots.front(0.3, 0.5);
    for (const angle of FAN_ANGLES) {
      const { x, y } = model.shots.position(0.3, radians(angle), 0.5);
      expect(Math.hypot(x, y - centre)).toBeCloseTo(radius, 14);
    }
  });
});

describe("the principal branch", () => {
  it("is right until ε sin α = 2.146…", () => {
    expect(model.principal(at(2.1461).locus).count).toBe(0);
    expect(model.principal(at(3).locus).count).toBeGreaterThan(500);
  });

  it("draws what the paper's formula gives at ε = 10, α = 1 rad", () => {
    const { locus } = at(10);
    const { curve, count } = model.principal(locus);
    const wanted = locus.grid.degrees.findIndex((angle) => angle >= degrees(1));
    const index = wanted - (locus.x.length - count);
    expect(Math.hypot(locus.x[wanted], locus.y[wanted])).toBeCloseTo(0.07837, 4);
    expect(Math.hypot(curve.x[index], curve.y[index])).toBeCloseTo(0.000165639, 5);
    expect(curve.y[index] / curve.x[index]).toBeCloseTo(locus.y[wanted] / locus.x[wanted], 10);
  });
});

describe("named angles", () => {
  const epsilons = [0, 0.1, 1, 10];
  const angles = new NamedAngleSolver(core, 4).solve(epsilons);
  /** The table of the model: degrees. */
  const known: Record<NamedAngle, number[]> = {
    range: [45, 43.7096921819, 35.5896941068, 15.8287214478],
    curvature: [45, 43.7869703699, 35.9889139986, 16.8599371883],
    rightmost: [45, 44.0375634638, 38.172707627, 23.9642438],
    farthest: [54.7356103172, 54.0365143493, 49.7491455747, 39.1265680437],
    receding: [70.5287793655, 69.2844661792, 60.039409929, 26.7041359196],
  };
  it.each(Object.keys(NAMED) as NamedAngle[])("%s", (name) => {
    epsilons.forEach((_, index) => expect(degrees(angles[name][index])).toBeCloseTo(known[name][index], 7));
  });

  it("stay in order from weak to overwhelming drag, at 2000 points", () => {
    const { namedCurves } = model;
    while (!namedCurves.complete) namedCurves.advance();
    expect(namedCurves.decades).toHaveLength(2000);
    const { angles: curves } = namedCurves;
    for (const name of Object.keys(NAMED) as NamedAngle[]) {
      const values = curves[name];
      expect(values.every((angle, index) => index === 0 || angle < values[index - 1] * (1 + 1e-5))).toBe(true);
      expect(values[0] / new NamedAngleSolver(core, 1).solve([1e-3])[name][0]).toBeCloseTo(1, 4);
    }
  });
});

describe("what is taken away", () => {
  it("is a table of 2000 apexes with every digit", () => {
    const scene = at(0.1);
    const lines = toCsv(scene, scene.locus.distances()).trimEnd().split("\n");
    expect(lines[0]).toBe("launch_angle_deg,elevation_deg,x_m,y_m,distance_m,time_s,curvature_per_m");
    expect(lines).toHaveLength(2001);
    expect(lines[1]).toBe("0.0,0.0,0.0,0.0,0.0,0.0,0.0980665");
    expect(lines[2000].startsWith("90.0,90.0,")).toBe(true);
  });

  it("is a line of Python", () => {
    expect(toPython(at(0.1))).toBe(
      "import math, archerfish; print(archerfish.Launcher(10.0, gravity=9.80665, epsilon=0.1).locus.at_launch_angle(math.radians(45.0)))",
    );
    const still = model.scene({ ...INITIAL, dragKind: "terminal_speed", drag: Infinity });
    expect(toPython(still)).toContain('terminal_speed=float("inf")');
  });

  it("is a summary in words", () => {
    expect(toWords(at(0))).toContain("without drag: the apex stands 5.099\u00a0m away and 2.549\u00a0m high");
  });
});

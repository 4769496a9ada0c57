/** The view as text: a file of the locus, the line of Python, a summary in words. */

import { type Scene } from "./model.ts";
import { degrees, exact, short } from "./numbers.ts";

/** The columns of `archerfish locus --format csv`, of the apex at each of the grid's launch angles. */
export function toCsv(scene: Scene, { distance, time }: { distance: Float64Array; time: Float64Array }): string {
  const { locus, scales } = scene;
  const lines = ["launch_angle_deg,elevation_deg,x_m,y_m,distance_m,time_s,curvature_per_m"];
  locus.grid.degrees.forEach((angle, index) => {
    const row = [
      angle,
      degrees(locus.elevation[index]),
      locus.x[index] * scales.length,
      locus.y[index] * scales.length,
      distance[index] * scales.length,
      time[index] * scales.time,
      locus.curvature[index] / scales.length,
    ];
    lines.push(row.map(exact).join(","));
  });
  return `${lines.join("\n")}\n`;
}

/** One line of Python that gives the numbers read out. */
export function toPython({ state }: Scene): string {
  const drag = state.drag === Infinity ? 'float("inf")' : exact(state.drag);
  return (
    "import math, archerfish; print(archerfish.Launcher(" +
    `${exact(state.speed)}, gravity=${exact(state.gravity)}, ${state.dragKind}=${drag})` +
    `.locus.at_launch_angle(math.radians(${exact(state.angle)})))`
  );
}

/** What a picture would tell, in words. */
export function toWords(scene: Scene): string {
  const { state, scales, apex, flightTime, reach } = scene;
  const metres = (value: number) => `${short(value * scales.length, 4)}\u00a0m`;
  const away = `${metres(Math.abs(apex.x))} ${apex.x < 0 ? "to the left" : "away"}`;
  const drag =
    scales.epsilon === 0
      ? "without drag"
      : `with drag parameter ε\u00a0=\u00a0${short(scales.epsilon, 4)} (terminal speed ${short(scales.terminalSpeed, 4)}\u00a0m/s)`;
  const compared = state.compare.length
    ? ` Compared with ε = ${state.compare.map((other) => short(other, 4)).join(", ")}.`
    : "";
  return (
    `Launched at ${short(state.speed, 4)}\u00a0m/s and ${short(state.angle, 5)}°, gravity ${short(state.gravity, 4)}\u00a0m/s², ${drag}: ` +
    `the apex stands ${away} and ${metres(apex.y)} high, at an elevation of ` +
    `${short(degrees(apex.elevation), 5)}°, and is reached after ${short(apex.time * scales.time, 4)}\u00a0s. ` +
    `The shot lands after ${short(flightTime * scales.time, 4)}\u00a0s; the longest shot of this speed flies ${metres(reach)}. ` +
    `There the locus bends with ρK\u00a0=\u00a0${short(apex.curvature, 4)}.${compared}`
  );
}

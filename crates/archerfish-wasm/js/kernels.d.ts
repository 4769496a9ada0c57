/** A function of one number: `z`, `d`, `x` or `eps`. */
export type UnaryName =
  | "lambertw0"
  | "lambertwm1"
  | "lambertw0_offset"
  | "lambertwm1_offset"
  | "tree"
  | "log1pmx"
  | "optimal_angle";

/** A function of an angle in radians (launch angle, or elevation) or an abscissa, and of `eps`. */
export type BinaryName =
  | "apex_x"
  | "apex_y"
  | "apex_time"
  | "apex_distance"
  | "apex_elevation"
  | "apex_curvature"
  | "locus_launch_angle"
  | "locus_launch_angle_d1"
  | "locus_launch_angle_d2"
  | "locus_radius"
  | "locus_curvature"
  | "flight_time"
  | "flight_range"
  | "envelope_height";

/**
 * A function of three numbers: a time or an abscissa, the launch angle and `eps`; for `aim_low` and
 * `aim_high` the target's `x` and `y`, and `eps`.
 */
export type TernaryName =
  | "flight_x"
  | "flight_y"
  | "trajectory_height"
  | "aim_low"
  | "aim_high";

/** Doubles in the module's memory. */
export interface Column {
  readonly length: number;
  /** The numbers themselves. Memory that grows takes its old views away: ask anew after `column`. */
  readonly values: Float64Array;
}

/** Functions of the same two numbers, computed together: what they share is most of the work. */
export interface JointFunctions {
  /** Fills four columns, with `apex_x`, `apex_y`, `apex_elevation` and `apex_curvature`. */
  apex(
    alpha: Column, eps: Column, x: Column, y: Column, elevation: Column, curvature: Column,
  ): void;
  /** Fills two columns, with `locus_launch_angle_d1` and `locus_launch_angle_d2`. */
  locus_launch_angle_derivatives(theta: Column, eps: Column, d1: Column, d2: Column): void;
}

/** Each fills its last column, or columns, as long as the first of them is. */
export type Functions = Readonly<
  JointFunctions &
  Record<UnaryName, (x: Column, out: Column) => void> &
    Record<BinaryName, (x: Column, eps: Column, out: Column) => void> &
    Record<TernaryName, (x: Column, second: Column, eps: Column, out: Column) => void>
>;

export interface Kernels {
  readonly functions: Functions;
  /** Room for `length` numbers, all 0, as long as the module lives. */
  column(length: number): Column;
}

/** Instantiates the module, compiled or as bytes. */
export function loadKernels(source: WebAssembly.Module | BufferSource): Promise<Kernels>;

//! Which arguments the functions of this module take.

use core::f64::consts::{PI, TAU};

/// Whether ε is a drag parameter.
#[inline(always)]
pub(super) fn is_drag(epsilon: f64) -> bool {
    // not `< INFINITY`: that comparison the compiler makes a test of bits, in five instructions
    (epsilon >= 0.0) & (epsilon <= f64::MAX)
}

/// Whether α is the angle of a shot that comes down on level ground: in [0, π].
#[inline(always)]
pub(super) fn is_rising(alpha: f64) -> bool {
    (alpha >= 0.0) & (alpha <= PI)
}

/// Whether α is the angle of a direction: in [−2π, 2π].
#[inline(always)]
pub(super) fn is_direction(alpha: f64) -> bool {
    alpha.abs() <= TAU
}

/// Whether t is a time after the launch: in [0, ∞).
#[inline(always)]
pub(super) fn is_later(t: f64) -> bool {
    (t >= 0.0) & (t <= f64::MAX)
}

/// Below this, 2⁻²⁰⁰, a double's low half may be subnormal; times `LARGE` it is not.
pub(super) const SMALL: f64 = f64::from_bits((1023 - 200) << 52);
pub(super) const LARGE: f64 = f64::from_bits((1023 + 200) << 52);

//! Which arguments the functions of this module take.

use super::super::real::{Mask, Number, Order};

use core::f64::consts::{PI, TAU};

/// Whether ε is a drag parameter.
#[inline(always)]
pub(super) fn is_drag(epsilon: Number) -> Mask {
    // not `< INFINITY`: that comparison the compiler makes a test of bits, in five instructions
    epsilon.is_at_least(0.0) & epsilon.is_at_most(f64::MAX)
}

/// Whether α is the angle of a shot that comes down on level ground: in [0, π].
#[inline(always)]
pub(super) fn is_rising(alpha: Number) -> Mask {
    alpha.is_at_least(0.0) & alpha.is_at_most(PI)
}

/// Whether α is the angle of a direction: in [−2π, 2π].
#[inline(always)]
pub(super) fn is_direction(alpha: Number) -> Mask {
    alpha.abs().is_at_most(TAU)
}

/// Whether t is a time after the launch: in [0, ∞).
#[inline(always)]
pub(super) fn is_later(t: Number) -> Mask {
    t.is_at_least(0.0) & t.is_at_most(f64::MAX)
}

/// Below this, 2⁻²⁰⁰, a double's low half may be subnormal; times `LARGE` it is not.
pub(super) const SMALL: f64 = f64::from_bits((1023 - 200) << 52);
pub(super) const LARGE: f64 = f64::from_bits((1023 + 200) << 52);

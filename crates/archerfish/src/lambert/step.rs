//! From a good start to the last digit in one step.
//!
//! Method: with `r = z e^{−w} − w`, the sought w + Δ has `(w + Δ) e^Δ = w + r`, that is
//! `r = (1+w)Δ + (1 + w/2)Δ² + (1/2 + w/6)Δ³ + …`, whose reversion to the third order leaves an
//! error of the fourth. r is the difference of nearly equal numbers, the greater of which is a
//! sum of two doubles; everything after it is small and needs few digits.

use super::super::real::double_double::{DoubleDouble, two_sum};
use super::super::real::{
    Exponential, Number, Order, exponent_and_significand, polynomial, power_of_two, select,
};

// rough_log: minimax on [-0.293, 0.4143], degree 7,
// weighted error 1.71e-7: reference/coefficients.py rough_log
const ROUGH_LOG: [f64; 8] = [
    0.9999999176098452,
    -0.5000034516359143,
    0.33335615548167746,
    -0.24971518975421436,
    0.19883968481586123,
    -0.172126859130448,
    0.16340497412692495,
    -0.10380861720687219,
];

/// Δ, so that w + Δ is Lambert W of z; w is within a twentieth of that.
///
/// e^{−w} may overflow where z is tiny: z is multiplied by 2^lift and the power by 2^−lift.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub(super) fn correction(z: DoubleDouble, w: Number, lift: f64) -> Number {
    let exponential = Exponential::of(-w);
    let scaled =
        z.scale(power_of_two(Number::from(lift))).scale(power_of_two(exponential.n - lift));
    let product = scaled.times(exponential.loose_significand());
    // exact: they are nearly equal
    let r = (product.hi - w) + product.lo;

    let inverse = 1.0 / (1.0 + w);
    let t = r * inverse;
    let a = (1.0 + 0.5 * w) * inverse;
    let b = (0.5 + w * (1.0 / 6.0)) * inverse;
    t - t * t * (a - t * (2.0 * a * a - b))
}

/// 1 + Lambert W of z, w being near W.
#[inline(always)]
pub(super) fn one_plus_corrected(z: DoubleDouble, w: Number, lift: f64) -> Number {
    let sum = two_sum(1.0, w);
    sum.hi + (sum.lo + correction(z, w, lift))
}

/// `ln w` of a positive normal number, to 2⁻²² of itself.
#[inline(always)]
pub(super) fn rough_ln(w: Number) -> Number {
    let (k, m) = exponent_and_significand(w);
    rough(k, m - 1.0)
}

/// `ln(1 + x)` for x > −1, to 2⁻²² of itself.
#[inline(always)]
pub(super) fn rough_ln_1p(x: Number) -> Number {
    let (k, m) = exponent_and_significand(1.0 + x);
    rough(k, select(k.equals(0.0), x, m - 1.0))
}

/// `k ln 2 + ln(1 + f)`
#[inline(always)]
fn rough(k: Number, f: Number) -> Number {
    k * core::f64::consts::LN_2 + f * polynomial(f, &ROUGH_LOG)
}

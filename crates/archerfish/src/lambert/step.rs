//! From a good start to the last digit in one step.
//!
//! Method: with `r = z e^{−w} − w`, the sought w + Δ has `(w + Δ) e^Δ = w + r`, that is
//! `r = (1+w)Δ + (1 + w/2)Δ² + (1/2 + w/6)Δ³ + …`, whose reversion to the third order leaves an
//! error of the fourth. r is the difference of nearly equal numbers, the greater of which is a
//! sum of two doubles; everything after it is small and needs few digits.

use super::super::real::double_double::{
    DoubleDouble, fast_two_difference, fast_two_sum, two_product, two_sum,
};
use super::super::real::{
    Exponential, LN2_HI, LN2_LO, MAGIC, Number, Order, exponent_and_significand, polynomial,
    power_of_shifted, power_of_two, select,
};

// rough_log: minimax on [-0.293, 0.4143], degree 5,
// weighted error 7.46e-6: reference/coefficients.py rough_log
const ROUGH_LOG: [f64; 6] = [
    1.0000055461317217,
    -0.4999139121064647,
    0.3324815187847988,
    -0.2535939339813336,
    0.22170489975637603,
    -0.1466367434233358,
];
// residual_tail: minimax on [-0.346608, 0.346608], degree 9,
// weighted error 1.0e-17: reference/coefficients.py residual_tail
const RESIDUAL_TAIL: [f64; 10] = [
    0.5000000000000012,
    -0.166666666666667,
    0.04166666666651553,
    -0.008333333333306561,
    0.0013888888946995866,
    -0.00019841269918684953,
    2.480148995565963e-05,
    -2.7557215223671626e-06,
    2.763127744196558e-07,
    -2.5118177338853923e-08,
];

/// The series of Δ by r.
struct Step {
    /// `1/(1 + w)`
    first: Number,
    second: Number,
    third: Number,
}

impl Step {
    /// At a w within a twentieth of Lambert W.
    #[inline(always)]
    fn at(w: Number) -> Self {
        let i = 1.0 / (1.0 + w);
        // (1 + w/2) i = (1 + i)/2 =: a, and 2a² − (1/2 + w/6) i
        Step { first: i, second: 0.5 + 0.5 * i, third: 1.0 / 3.0 + i * (2.0 / 3.0 + 0.5 * i) }
    }

    /// Δ
    #[inline(always)]
    fn of(&self, r: Number) -> Number {
        let t = r * self.first;
        t - t * t * (self.second - t * self.third)
    }
}

/// `z e^{−w} − w`, given 2^lift z.
///
/// As by `Exponential`, but shorter: with r = w + n ln 2, `e^{−w} = 2ⁿ (1 − r + r² (1/2 − …))`.
#[inline(always)]
fn residual(lifted: Number, w: Number, lift: f64) -> Number {
    let shifted = w * -core::f64::consts::LOG2_E + MAGIC;
    let n = shifted - MAGIC;
    let r = fast_two_sum(w + n * LN2_HI, n * LN2_LO);
    let tail = r.hi * r.hi * polynomial(r.hi, &RESIDUAL_TAIL);
    let linear = fast_two_difference(1.0, r.hi);
    let scaled = lifted * power_of_shifted(shifted, -lift);
    let product = two_product(scaled, linear.hi);
    // both sums are exact, of nearly equal numbers
    ((product.hi - w) + scaled * ((linear.lo - r.lo * linear.hi) + tail)) + product.lo
}

/// Δ, so that w + Δ is Lambert W of z; w is within a twentieth of that, and 2^lift z is given.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub(super) fn correction(lifted: Number, w: Number, lift: f64) -> Number {
    // its division is under way while the residual is computed (bench/NOTES.md, "Order")
    let step = Step::at(w);
    step.of(residual(lifted, w, lift))
}

/// 1 + Lambert W of z, w being near W.
///
/// e^{−w} may overflow where z is tiny: z is multiplied by 2^lift and the power by 2^−lift.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub(super) fn one_plus_corrected(z: DoubleDouble, w: Number, lift: f64) -> Number {
    let step = Step::at(w);
    let exponential = Exponential::of(-w);
    let lifted = z.scale(power_of_two(Number::from(lift)));
    let product =
        lifted.scale(power_of_two(exponential.n - lift)).times(exponential.loose_significand());
    // exact: they are nearly equal
    let r = (product.hi - w) + product.lo;
    let sum = two_sum(1.0, w);
    sum.hi + (sum.lo + step.of(r))
}

/// `ln w` of a positive normal number, to 2⁻¹⁷ of itself.
#[inline(always)]
pub(super) fn rough_ln(w: Number) -> Number {
    let (k, m) = exponent_and_significand(w);
    rough(k, m - 1.0)
}

/// `ln(1 + x)` for x > −1, to 2⁻¹⁷ of itself.
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

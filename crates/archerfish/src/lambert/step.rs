//! From a good start to the last digit in one step.
//!
//! Method: with `r = z e^{−w} − w`, the sought w + Δ has `(w + Δ) e^Δ = w + r`, that is
//! `r = (1+w)Δ + (1 + w/2)Δ² + (1/2 + w/6)Δ³ + …`, whose reversion to the third order leaves an
//! error of the fourth. r is the difference of nearly equal numbers, the greater of which is a
//! sum of two doubles; everything after it is small and needs few digits.

use super::super::real::double_double::{DoubleDouble, two_product};
use super::super::real::{Exponential, LN2_HI, LN2_LO, MAGIC, Number, polynomial, power_of_two};

// residual_tail: minimax on [-0.346608, 0.346608], degree 10,
// weighted error 1.76e-18: reference/coefficients.py residual_tail
const RESIDUAL_TAIL: [f64; 11] = [
    1.3591409142295225,
    -0.4530469714098411,
    0.11326174285246031,
    -0.022652348570460192,
    0.003775391428409307,
    -0.0005393416338509471,
    6.741770423976329e-05,
    -7.490835610221106e-06,
    7.4908351770126e-07,
    -6.82534609033018e-08,
    5.6878665623887865e-09,
];

/// The series of Δ by r.
struct Step {
    /// `1/(1 + w)`
    first: Number,
    second: Number,
    third: Number,
}

impl Step {
    /// At a w within a twentieth of Lambert W, given 1 + w.
    #[inline(always)]
    fn at(above: Number) -> Self {
        let first = 1.0 / above;
        // (1 + w/2) first =: a, and 2a² − (1/2 + w/6) first
        let second = 0.5 + 0.5 * first;
        Step { first, second, third: 1.0 / 3.0 + first * (1.0 / 6.0 + second) }
    }

    /// Δ
    #[inline(always)]
    fn of(&self, r: Number) -> Number {
        let t = r * self.first;
        t - t * t * (self.second - t * self.third)
    }
}

/// MAGIC + n, n being the power of two in e^{−w}, given 1 + w.
#[inline(always)]
pub(super) fn shifted_exponent(above: Number) -> Number {
    above * -core::f64::consts::LOG2_E + MAGIC
}

/// `z e^{−w} − w`, given w and 1 + w, no finer than 2⁻⁵², MAGIC + n and z 2ⁿ.
///
/// With `r = (1 + w) + n ln 2`, `e^{−w} = 2ⁿ e (1 − r + r² (1/2 − …))`. So n is 0 and r is 1 + w around
/// the branch point, and what is rounded is as small as its square: there is no other formula there.
#[inline(always)]
fn residual(w: Number, above: Number, shifted: Number, scaled: Number) -> Number {
    const E: f64 = core::f64::consts::E;
    /// (e − E)/e
    const E_REST: f64 = 5.318237706605892e-17;
    let n = shifted - MAGIC;
    // r and 1 − r are exact, being no finer than 2⁻⁵²
    let r = n * LN2_HI + above;
    let r_rest = n * LN2_LO - E_REST;
    let linear = two_product(Number::from(E), 1.0 - r);
    let tail = r * r * polynomial(r, &RESIDUAL_TAIL);
    let small = linear.lo - r_rest * (linear.hi + tail);
    let product = two_product(scaled, linear.hi);
    // both sums are exact, of nearly equal numbers
    ((product.hi - w) + scaled * tail) + (product.lo + scaled * small)
}

/// Lambert W of z, given a w within a twentieth of it, and what `residual` is given.
#[inline(always)]
pub(super) fn corrected(w: Number, above: Number, shifted: Number, scaled: Number) -> Number {
    // its division is under way while the residual is computed (bench/NOTES.md, "Order")
    let step = Step::at(above);
    w + step.of(residual(w, above, shifted, scaled))
}

/// 1 + Lambert W of z, w being near W and 1 + w a double.
///
/// e^{−w} may overflow where z is tiny: z is multiplied by 2^lift and the power by 2^−lift.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub(super) fn one_plus_corrected(z: DoubleDouble, w: Number, lift: f64) -> Number {
    let above = 1.0 + w;
    let step = Step::at(above);
    let exponential = Exponential::of(-w);
    let lifted = z.scale(power_of_two(Number::from(lift)));
    let product =
        lifted.scale(power_of_two(exponential.n - lift)).times(exponential.loose_significand());
    // exact: they are nearly equal
    let r = (product.hi - w) + product.lo;
    above + step.of(r)
}

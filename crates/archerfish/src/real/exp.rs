//! Exponential function.
//!
//! Method: `x = n ln 2 + r` with |r| ≤ ln 2 / 2, `eˣ = 2ⁿ (1 + m)` with
//! `m = eʳ − 1 = r + r²/2 + r³ p(r)`, the first two terms as exact sums.

use super::double_double::{DoubleDouble, fast_two_difference, fast_two_sum, two_square, two_sum};
use super::{
    LN2_HI, LN2_LO, Number, Order, greater, lesser, nearest_integer, polynomial, power_of_two,
    select,
};

// exp_tail: minimax on [-0.346608, 0.346608], degree 9,
// weighted error 5.67e-19: reference/coefficients.py exp_tail
const EXP_TAIL: [f64; 10] = [
    0.16666666666666682,
    0.0416666666666667,
    0.008333333333316862,
    0.001388888888886544,
    0.00019841269896814676,
    2.4801587364565682e-05,
    2.755723444112762e-06,
    2.7557239111025226e-07,
    2.511217853920545e-08,
    2.0925553806370703e-09,
];

/// `eˣ = 2ⁿ (1 + r + half_square + rest)`, n an integer, |r| < 0.35, the sum to 2⁻⁵⁹ of itself.
pub(crate) struct Exponential {
    pub n: Number,
    pub r: Number,
    /// `(eʳ − 1 − r − r²/2)/r³`
    pub bend: Number,
    half_square: Number,
    rest: Number,
}

impl Exponential {
    /// Of a number below 2¹⁰ in size.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn of(x: Number) -> Self {
        let n = nearest_integer(x * core::f64::consts::LOG2_E);
        let r = fast_two_difference(x - n * LN2_HI, n * LN2_LO);
        let square = two_square(r.hi);
        let bend = polynomial(r.hi, &EXP_TAIL);
        let tail = r.hi * square.hi * bend;
        // r.lo enters with its derivative 1 + r + …
        let rest = 0.5 * square.lo + (tail + r.lo * (1.0 + r.hi));
        Exponential { n, r: r.hi, bend, half_square: 0.5 * square.hi, rest }
    }

    /// `eˣ/2ⁿ − 1`, as it falls: hi alone is good to 2⁻⁵ of it.
    #[inline(always)]
    pub fn loose_excess(&self) -> DoubleDouble {
        let sum = fast_two_sum(self.r, self.half_square);
        DoubleDouble { hi: sum.hi, lo: sum.lo + self.rest }
    }

    /// `eˣ/2ⁿ − 1`
    #[inline(always)]
    fn excess(&self) -> DoubleDouble {
        let sum = self.loose_excess();
        fast_two_sum(sum.hi, sum.lo)
    }

    /// `eˣ/2ⁿ`, as it falls: hi alone is good to 2⁻⁶ only.
    #[inline(always)]
    pub fn loose_significand(&self) -> DoubleDouble {
        let linear = fast_two_sum(1.0, self.r);
        let sum = fast_two_sum(linear.hi, self.half_square);
        DoubleDouble { hi: sum.hi, lo: linear.lo + (sum.lo + self.rest) }
    }

    /// `eˣ/2ⁿ`
    #[inline(always)]
    pub fn significand(&self) -> DoubleDouble {
        let sum = self.loose_significand();
        fast_two_sum(sum.hi, sum.lo)
    }
}

/// Arguments beyond which nothing changes any more: e⁷¹⁰ overflows, e⁻⁷⁴⁶ is zero.
#[inline(always)]
fn clamp(x: Number) -> Number {
    greater(-746.0, lesser(710.0, x))
}

/// `eˣ`.
#[inline(always)]
pub fn exp(x: Number) -> Number {
    let exponential = Exponential::of(clamp(x));
    let half = nearest_integer(0.5 * exponential.n);
    // in two steps: neither overflows before the result does, and a subnormal is rounded once
    exponential.loose_significand().round()
        * power_of_two(half)
        * power_of_two(exponential.n - half)
}

/// `eˣ − 1`.
#[inline(always)]
pub fn exp_m1(x: Number) -> Number {
    // below −60 the result is −1 to the last bit, and a smaller power of two would be useless
    let exponential = Exponential::of(greater(-60.0, clamp(x)));
    // half of the power, so that x between 709.4 and 709.78 does not overflow on the way
    let half_power = power_of_two(exponential.n - 1.0);
    let whole = two_sum(half_power, -0.5);
    let scaled = exponential.excess().scale(half_power);
    let sum = two_sum(whole.hi, scaled.hi);
    let regular = 2.0 * (sum.hi + (sum.lo + (whole.lo + scaled.lo)));
    select(x.abs().is_below(1e-300), x, regular)
}

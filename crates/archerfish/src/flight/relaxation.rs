//! The two functions of w = εt that carry every flight.
//!
//! Method: up to w = 0.7 `E₂ = 1/2 − w/6 + w² p(w)` and `E₁ = 1 − w E₂`; beyond, from e⁻ʷ,
//! `E₁ = (1 − e⁻ʷ)/w` and `E₂ = (1 − E₁)/w`, which lose a bit or two of more than there need be.

use super::super::real::double_double::{DoubleDouble, fast_two_sum};
use super::super::real::{Exponential, Order, lesser, polynomial, power_of_two, select};

// fall_tail: minimax on [0.0, 0.7001], degree 9,
// weighted error 1.54e-18: reference/coefficients.py fall_tail
const FALL_TAIL: [f64; 10] = [
    0.04166666666666656,
    -0.008333333333328374,
    0.001388888888800521,
    -0.00019841269757258273,
    2.4801582479425382e-05,
    -2.7557141833785712e-06,
    2.7553030940579955e-07,
    -2.498410201421811e-08,
    2.0191435273508916e-09,
    -1.2012402872530096e-10,
];
const MINUS_SIXTH: DoubleDouble =
    DoubleDouble::constant(-0.16666666666666666, -9.25185853854297e-18);

/// E₁ and E₂ at one w.
pub(super) struct Relaxation {
    /// `E₁(w) = (1 − e⁻ʷ)/w`, from 1 to 0
    pub speed: DoubleDouble,
    /// `E₂(w) = (w − 1 + e⁻ʷ)/w²`, from 1/2 to 0
    pub fall: DoubleDouble,
}

impl Relaxation {
    /// Of w in [0, 700].
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn at(w: DoubleDouble) -> Self {
        let exponential = Exponential::of(-w.hi);
        let significand = exponential.significand();
        let power = power_of_two(exponential.n);
        let low = significand.lo - w.lo * significand.hi;
        let rest = fast_two_sum(power * significand.hi, power * low);
        let gone = DoubleDouble::from(1.0).sub_smaller(rest);
        let inverse = 1.0 / w.hi;
        let speed_far = gone.div_by(w, inverse);
        let fall_far = DoubleDouble::from(1.0).sub_smaller(speed_far).div_by(w, inverse);

        let linear = DoubleDouble::from(0.5).add_smaller(w.times(MINUS_SIXTH));
        let tail = w.hi * w.hi * polynomial(w.hi, &FALL_TAIL);
        let fall_near = linear.add_smaller(DoubleDouble::from(tail));
        let speed_near = DoubleDouble::from(1.0).sub_smaller(w.times(fall_near));

        let near = w.hi.is_below(0.7);
        Relaxation {
            speed: DoubleDouble::select(near, speed_near, speed_far),
            fall: DoubleDouble::select(near, fall_near, fall_far),
        }
    }
}

/// w beyond which e⁻ʷ is nothing beside 1, whatever the digits kept.
pub(super) const RELAXED: f64 = 75.0;

/// `w` up to `RELAXED`.
#[inline(always)]
pub(super) fn clamped(w: DoubleDouble) -> DoubleDouble {
    DoubleDouble { hi: lesser(RELAXED, w.hi), lo: select(w.hi.is_above(RELAXED), 0.0, w.lo) }
}

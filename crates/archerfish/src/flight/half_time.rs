//! The time of flight over level ground.
//!
//! The shot lands at εT = 2h where `h + (h coth h − 1) = u`, u = ε sin α: the symmetric form of
//! `(1 − e^{−τ})/τ = 1/(1 + u)`. Sought is η = h/u, falling from 1 without drag to 1/2.
//!
//! Method: a rational start, good to 2⁻¹⁴, and one step of fourth order. Its residual
//! `1 − η − (h coth h − 1)/u`, in sums of two doubles, is formed as `1 − η (1 + h/3 + …)` for
//! small h, and as `((1 + u)(1 − e^{−2h}) − 2h) / (u (1 − e^{−2h}))` beyond, where nothing cancels
//! but in the one difference that makes a residual small.

use super::super::real::double_double::{DoubleDouble, fast_two_sum};
use super::super::real::{Exponential, polynomial, power_of_two, select};

// half_time_tail: minimax on [0.0, 0.5626], degree 7,
// weighted error 4.01e-18: reference/coefficients.py half_time_tail
const HALF_TIME_TAIL: [f64; 8] = [
    -0.02222222222221888,
    0.002116402116249357,
    -0.00021164020906156545,
    2.137777714404582e-05,
    -2.1642971781181246e-06,
    2.1894858540030265e-07,
    -2.167870775474207e-08,
    1.7362237136604283e-09,
];
// half_time_start: 0.87 of the error that can be borne: reference/coefficients.py half_time_start
const HALF_TIME_START_TOP: [f64; 4] = [1.000005008, 0.4149945055, 0.07041051379, 0.0186885149];
const HALF_TIME_START_BOTTOM: [f64; 4] = [1.0, 0.7473879479, 0.1029244719, 0.03737900548];
const THIRD: DoubleDouble = DoubleDouble { hi: 0.3333333333333333, lo: 1.850371707708594e-17 };

/// `h/u`, for u ≥ 0 and q = 1 + u; hi alone is good to 2⁻¹⁴.
#[inline(always)]
pub(super) fn half_time(u: DoubleDouble, q: DoubleDouble) -> DoubleDouble {
    // beyond 10⁶ the guess is right to 10⁻⁶ and the equation linear
    let size = select(u.hi > 1e6, 1e6, u.hi);
    let eta = polynomial(size, &HALF_TIME_START_TOP) / polynomial(size, &HALF_TIME_START_BOTTOM);
    let h = u.times_double(eta);

    let z = h.hi * h.hi;
    let small = DoubleDouble::from(z * h.hi * polynomial(z, &HALF_TIME_TAIL));
    let near = h.times(THIRD).add_smaller(small).add_positive(1.0).times_double(eta);
    // exact, as near is nearly 1
    let near = (1.0 - near.hi) - near.lo;

    // beyond 2h = 80, 1 − e^{−2h} is 1 to the last bit of the second double but a few
    let far = h.hi > 40.0;
    let exponential = Exponential::of(select(far, -80.0, -2.0 * h.hi));
    let significand = exponential.loose_significand();
    let low = significand.lo - 2.0 * select(far, 0.0, h.lo) * significand.hi;
    let power = power_of_two(exponential.n);
    let rest = fast_two_sum(1.0, -(power * significand.hi)); // 1 − e^{−2h}
    let rest = DoubleDouble { hi: rest.hi, lo: rest.lo - power * low };
    let half = q.scale(0.5).times(rest);
    let beyond = ((half.hi - h.hi) + (half.lo - h.lo)) / (u.hi * 0.5 * rest.round());

    let residual = select(h.hi < 0.75, near, beyond);

    // with g = h coth h − 1: g/h, g′, h g″ and h² g‴
    let inverse = 1.0 / eta;
    let ratio = (1.0 - eta - residual) * inverse;
    let g = ratio * h.hi;
    let first = select(far, 1.0, h.hi - ratio * (1.0 + g));
    let second = select(far, 0.0, 2.0 * (h.hi - first * (1.0 + g)));
    let third = -2.0 * ((1.0 + g) * (second - first) + h.hi * first * first);
    let third = select(far, 0.0, third);
    let slope = 1.0 / (1.0 + first);
    let newton = residual * inverse * slope;
    let (a, b) = (0.5 * second * slope, third * slope * (1.0 / 6.0));
    let change = newton - newton * newton * (a - newton * (2.0 * a * a - b));
    DoubleDouble { hi: eta, lo: eta * change }
}

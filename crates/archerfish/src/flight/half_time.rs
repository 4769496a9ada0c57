//! The time of flight over level ground.
//!
//! The shot lands at εT = 2h where `h + (h coth h − 1) = u`, u = ε sin α: the symmetric form of
//! `(1 − e^{−τ})/τ = 1/(1 + u)`.
//!
//! Method: a rational start for h/u, good to 2⁻¹⁷ where it has to be, and one step of third order.
//! With w = 2h and r = 1 − e⁻ʷ the equation is `(1 + u) r = w`; formed in sums of two doubles, for
//! the difference is small. For small w, where it would be small beside its terms, everything is a
//! multiple of a power of w: with `e⁻ʷ = 1 − w + w²/2 − w³ B`
//!
//! - `r = w D`, `D = 1 − w/2 + w² B`,
//! - `h coth h − 1 = w² C/D`, `C = 1/4 − B (1 + w/2)`.

use super::super::real::double_double::{DoubleDouble, fast_two_sum};
use super::super::real::{Exponential, polynomial, power_of_two, select};

// half_time_start: 0.96 of the error that can be borne: reference/coefficients.py half_time_start
const HALF_TIME_START_TOP: [f64; 5] =
    [0.9999649874, 1.341753945, 0.3869763464, 0.05513384793, 0.009946458742];
const HALF_TIME_START_BOTTOM: [f64; 5] =
    [1.0, 1.674860793, 0.7231062684, 0.08831008133, 0.01993010758];

/// `h`, for u > 0 and q = 1 + u; hi alone is good to 2⁻¹⁴.
#[inline(always)]
pub(super) fn half_time(u: DoubleDouble, q: DoubleDouble) -> DoubleDouble {
    // beyond 10⁶ the guess is right to 10⁻⁶ and the equation linear
    let size = select(u.hi > 1e6, 1e6, u.hi);
    let ratio = polynomial(size, &HALF_TIME_START_TOP) / polynomial(size, &HALF_TIME_START_BOTTOM);
    let h = u.hi * ratio;
    let w = 2.0 * h;

    // beyond w = 80 all of e⁻ʷ is below the last bit of the second double but a few
    let exponential = Exponential::of(-select(w > 80.0, 80.0, w));
    let significand = exponential.loose_significand();
    let power = power_of_two(exponential.n);
    let gone = fast_two_sum(1.0, -(power * significand.hi));
    let gone = DoubleDouble { hi: gone.hi, lo: gone.lo - power * significand.lo };
    let product = q.times(gone);
    let far_excess = (product.hi - w) + product.lo;
    let gone = gone.round();
    let rest = 1.0 - gone;

    // exponential.r is −w there
    let near = exponential.n == 0.0;
    let bend = exponential.bend;
    let gone_by_w = 1.0 - w * (0.5 - w * bend);
    let bulge = 0.25 - bend * (1.0 + h);
    let lacking = (u.hi - h) + u.lo;
    let near_excess = lacking * gone_by_w - w * (w * bulge);

    // Newton's step is excess · scale/slope, and of the second derivative over twice the first
    // remains 4 rest · bulge/(scale · slope)
    let excess = select(near, near_excess, far_excess);
    let scale = select(near, gone_by_w, gone);
    let slope = select(near, 1.0 - w * (1.0 - 2.0 * bend * (1.0 + w)), 2.0 * (gone - w * rest));
    let bulge = select(near, bulge, w - gone * (1.0 + h));
    let inverse = 1.0 / (scale * slope);
    let newton = excess * (scale * (scale * inverse));
    let half_bend = 4.0 * rest * (bulge * inverse);
    DoubleDouble { hi: h, lo: newton - newton * (newton * half_bend) }
}

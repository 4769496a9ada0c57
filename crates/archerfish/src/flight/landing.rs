//! The landing on level ground.
//!
//! The shot lands at εT = 2h where `h + (h coth h − 1) = u`, u = ε sin α: the symmetric form of
//! `(1 − e^{−τ})/τ = 1/(1 + u)`.
//!
//! Method: a rational start for h/u, good to 2⁻¹⁷ where it has to be, and one step of third order.
//! With w = 2h and r = 1 − e⁻ʷ the equation is `(1 + u) r = w`, whose two sides are nearly equal:
//! both in sums of two doubles, r to as many digits of its own. What the step is divided by needs
//! few digits; for small w, with `e⁻ʷ = 1 − w + w²/2 − w³ B`, it is
//!
//! - `r − w e⁻ʷ = w² (1/2 − w (1/2 − B (1 + w)))`,
//! - `w − r (1 + h) = w³ (1/4 − B (1 + h))`.

use super::super::real::double_double::{DoubleDouble, fast_two_difference};
use super::super::real::{Exponential, Number, Order, lesser, polynomial, power_of_two, select};

// half_time_start: 0.96 of the error that can be borne: reference/coefficients.py half_time_start
const HALF_TIME_START_TOP: [f64; 5] =
    [0.9999649874, 1.341753945, 0.3869763464, 0.05513384793, 0.009946458742];
const HALF_TIME_START_BOTTOM: [f64; 5] =
    [1.0, 1.674860793, 0.7231062684, 0.08831008133, 0.01993010758];

/// A double next to `h`, to 2⁻¹⁴.
#[inline(always)]
pub(super) fn start(u: Number) -> Number {
    // beyond 10⁶ the guess is right to 10⁻⁶ and the equation linear
    let size = lesser(1e6, u);
    let ratio = polynomial(size, &HALF_TIME_START_TOP) / polynomial(size, &HALF_TIME_START_BOTTOM);
    u * ratio
}

/// The landing: w = 2h is a start and a small step, and so is r.
pub(super) struct Landing {
    start: Number,
    step: Number,
    gone: DoubleDouble,
    rest: Number,
}

impl Landing {
    /// `w`; hi alone is good to 2⁻¹⁴.
    #[inline(always)]
    pub fn time(&self) -> DoubleDouble {
        DoubleDouble { hi: self.start, lo: self.step }
    }

    /// `r = 1 − e⁻ʷ`; hi alone is good to 2⁻¹³.
    #[inline(always)]
    pub fn gone(&self) -> DoubleDouble {
        // times e⁻ʷ from the start: where that is 0, the step may be great
        let change = self.rest * self.step;
        let change = change - change * self.step * (0.5 - self.step * (1.0 / 6.0));
        DoubleDouble { hi: self.gone.hi, lo: self.gone.lo + change }
    }
}

/// The landing for q = 1 + u, u at least 2⁻⁴⁰, given a start for h.
#[inline(always)]
pub(super) fn landing(q: DoubleDouble, h: Number) -> Landing {
    let w = 2.0 * h;
    // beyond w = 80 all of e⁻ʷ is below the last bit of the second double but a few
    let exponential = Exponential::of(-lesser(80.0, w));
    let power = power_of_two(exponential.n);
    let change = exponential.loose_excess().scale(power);
    let gone = fast_two_difference(1.0 - power, change.hi);
    let gone = DoubleDouble { hi: gone.hi, lo: gone.lo - change.lo };
    let product = q.times(gone);
    // exact: they are nearly equal
    let excess = (product.hi - w) + product.lo;
    let (exact, gone) = (gone, gone.round());
    let rest = 1.0 - gone;

    // exponential.r is −w there, and bend B
    let near = exponential.n.equals(0.0);
    let bend = exponential.bend;
    let square = w * w;
    let slope_near = square * (0.5 - w * (0.5 - bend * (1.0 + w)));
    let slope = select(near, slope_near, gone - w * rest);
    let bulge_near = square * w * (0.25 - bend * (1.0 + h));
    let bulge = select(near, bulge_near, w - gone * (1.0 + h));
    // in w, Newton's step is excess · gone/slope, and of the second derivative over twice the first
    // remains rest · bulge/(gone · slope)
    let inverse = 1.0 / (gone * slope);
    let newton = excess * (gone * (gone * inverse));
    let half_bend = rest * (bulge * inverse);
    Landing { start: w, step: newton - newton * (newton * half_bend), gone: exact, rest }
}

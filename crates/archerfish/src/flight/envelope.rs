//! The envelope of all trajectories of one speed.
//!
//! Method: the shot that touches it at x has `sin α = s = e/(εx² + √(x² + e))`, e = 1 − ε²x², in
//! which nothing cancels; it has gone the way p = x/cos α = 1/(s + ε) by then, and the envelope's
//! height is its own.

use super::super::real::double_double::{DoubleDouble, two_product, two_sum};
use super::super::real::{Number, Order, lesser, select};
use super::domain::is_drag;
use super::fall::fall;
use super::height::height_after;

/// The shot that touches the envelope at a given abscissa.
pub(super) struct Touching {
    /// `sin α`, positive
    pub sin: DoubleDouble,
    /// `p = |x|/cos α = 1/(sin α + ε)`
    pub way: DoubleDouble,
    /// `ψ(εp)`
    pub psi: DoubleDouble,
    /// `1 − ε|x|`; nothing is reached where it is not positive
    pub rest: Number,
}

impl Touching {
    /// At x, |x| < 1/ε.
    #[inline(always)]
    pub fn at(x: Number, epsilon: Number) -> Self {
        let one = DoubleDouble::from(1.0);
        let before_end = one.sub(two_product(epsilon, x.abs()));
        // so far out the height is −∞, and its parts would be infinite
        let x = lesser(1e160, x.abs());
        let product = two_product(epsilon, x);
        let rest = one.sub(product);
        let e = rest.times(one.add(product));
        // numerator and denominator divided by the greater of 1 and x: squares of x overflow
        let long = x.is_above(1.0);
        let unit = select(long, 1.0, x);
        let inverse = DoubleDouble::select(long, one.div(DoubleDouble::from(x)), one);
        let numerator = e.times(inverse);
        let square = DoubleDouble::select(long, one, two_product(x, x));
        let root = square.add(numerator.times(inverse)).sqrt();
        let sin = numerator.div(product.times_double(unit).add(root));
        let sum = two_sum(epsilon, sin.hi);
        let sum = DoubleDouble { hi: sum.hi, lo: sum.lo + sin.lo };
        let way = one.div(sum);
        // 1 − v = s/(s + ε)
        let psi = fall(way.times_double(epsilon), way.times(sin));
        Touching { sin, way, psi, rest: before_end.round() }
    }

    /// The envelope's height.
    #[inline(always)]
    pub fn height(&self) -> Number {
        let y = height_after(self.way, self.sin, self.psi);
        // where the terms are equal but for what they are rounded by, they are meant to be: a
        // drag-free shot reaches x = 1 at y = 0
        let noise = self.way.hi * self.sin.hi * f64::EPSILON * 1e-6;
        let y = select(y.abs().is_below(noise), 0.0, y);
        let y = select(self.rest.equals(0.0), f64::NEG_INFINITY, y);
        select(self.rest.is_at_least(0.0), y, f64::NAN)
    }
}

/// Height of the envelope of all trajectories at the abscissa x, in V₀²/g: what lies on or under
/// it can be reached, what lies above can not.
///
/// |x| ≤ 1/ε; −∞ at both ends, NaN beyond. Limit: `(1 − x²)/2` as ε → 0. Its error is small beside
/// the greater of sin α/(sin α + ε) and its difference from that, α being the touching shot's
/// launch angle.
#[inline(always)]
pub fn envelope_height(x: Number, eps: Number) -> Number {
    select(is_drag(eps) & x.abs().is_at_most(f64::MAX), Touching::at(x, eps).height(), f64::NAN)
}

//! The trajectory as a curve.

use super::super::real::double_double::{DoubleDouble, two_product};
use super::super::real::{Number, Order, lesser, select, sin_cos_extended};
use super::domain::{LARGE, SMALL, is_direction, is_drag};
use super::fall::fall;

/// `p (s − p ψ)`: the height of a shot of slope s/c that has gone the way p, given ψ(εp).
#[inline(always)]
pub(super) fn height_after(p: DoubleDouble, sin: DoubleDouble, psi: DoubleDouble) -> Number {
    let mean = sin.sub(p.times(psi));
    mean.hi * p.hi + (mean.hi * p.lo + mean.lo * p.hi)
}

/// Height of the trajectory at the abscissa x, in V₀²/g: `x tan α − (x/cos α)² φ(−εx/cos α)`.
///
/// α in [−2π, 2π], x on the side the shot goes to and nearer than the wall, cos α/ε, that it
/// never reaches; beyond, NaN. Its error is small beside the greater of the two terms, and beside
/// what the rounding of x makes of them next to the wall.
#[inline(always)]
pub fn trajectory_height(x: Number, alpha: Number, eps: Number) -> Number {
    let (sin, cos) = sin_cos_extended(alpha);
    // the low half of a subnormal quotient would be lost
    let tiny = x.abs().is_below(SMALL);
    let (factor, back) = (select(tiny, LARGE, 1.0), select(tiny, SMALL, 1.0));
    // so far out the height is −∞, and its parts would be infinite
    let size = lesser(1e160, x.abs()) * factor;
    let backward = cos.hi.is_below(0.0);
    let across = DoubleDouble::select(backward, cos.neg(), cos);
    let scaled = DoubleDouble::from(size).div(across);
    let p = scaled.scale(back);
    // what is left of the way to the wall, as a fraction of it
    let rest = across.sub(two_product(eps, x.abs())).div(across);
    let v = p.times_double(eps);
    let psi = fall(v, rest);
    let mean = sin.sub(p.times(psi));
    let y = select(tiny, mean.round() * scaled.round() * back, height_after(p, sin, psi));
    let ahead = x.equals(0.0) | !(x.is_below(0.0) ^ backward);
    let ahead = ahead & rest.hi.is_above(0.0);
    select(ahead & is_direction(alpha) & is_drag(eps), y, f64::NAN)
}

//! Where the projectile is at a given time.
//!
//! Method: `x = t cos α E₁(w)` and `y = t (sin α E₁(w) − t E₂(w))` with w = εt, in which nothing
//! cancels but the rise against the fall. Beyond w = 75 all that is left of the exponential is its
//! limit: `x = cos α / ε`, `y = (sin α + 1/ε − t)/ε`, and w itself, which may overflow, is not needed.

use super::super::real::double_double::{DoubleDouble, two_product};
use super::super::real::{Number, Order, select, sin_cos_extended};
use super::domain::{is_direction, is_drag, is_later};
use super::relaxation::{RELAXED, Relaxation, clamped};

/// Abscissa at time t of the shot at launch angle α, `cos α (1 − e^{−εt})/ε`, in V₀²/g.
///
/// t ≥ 0, α in [−2π, 2π]. Limits: `t cos α` as ε → 0; `cos α / ε` as t → ∞.
#[inline(always)]
pub fn flight_x(t: Number, alpha: Number, eps: Number) -> Number {
    let (_, cos) = sin_cos_extended(alpha);
    let w = two_product(eps, t);
    let on_the_way = cos.times(Relaxation::at(clamped(w)).speed).round() * t;
    let at_rest = cos.div(DoubleDouble::from(eps)).round();
    let x = select(w.hi.is_above(RELAXED), at_rest, on_the_way);
    select(is_later(t) & is_direction(alpha) & is_drag(eps), x, f64::NAN)
}

/// Height at time t of the shot at launch angle α, in V₀²/g; below the launch point negative.
///
/// t ≥ 0, α in [−2π, 2π]. It is `sin α (1 − e^{−εt})/ε`, where drag alone would have brought
/// the projectile, less `(εt − 1 + e^{−εt})/ε²`, what it has fallen; its error is small beside the
/// greater of the two. Limits: `t sin α − t²/2` as ε → 0; falling at the rate 1/ε as t → ∞.
#[inline(always)]
pub fn flight_y(t: Number, alpha: Number, eps: Number) -> Number {
    let (sin, _) = sin_cos_extended(alpha);
    let w = two_product(eps, t);
    let Relaxation { speed, fall, .. } = Relaxation::at(clamped(w));
    let on_the_way = sin.times(speed).sub(fall.times_double(t)).round() * t;
    let limit = DoubleDouble::from(1.0).div(DoubleDouble::from(eps));
    let falling = sin.sub_double(t).add(limit).round() / eps;
    let y = select(w.hi.is_above(RELAXED), falling, on_the_way);
    select(is_later(t) & is_direction(alpha) & is_drag(eps), y, f64::NAN)
}

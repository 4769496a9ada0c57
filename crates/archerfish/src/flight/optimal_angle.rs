//! The launch angle of the greatest range over level ground.
//!
//! With p = ε/sin α it solves `(1 + p) ln(1 + p) − p = ε²`, so that `sin²α = 1 − G(p)` and
//! `cos²α = G(p)`. In the fall's terms `1 − G(p) = (1 − v) ψ(v)`, v = p/(1 + p).
//!
//! Method: ln(1 + p) is 1 + W₀(−1/e + ε²/e); one Newton step, its residual in sums of two doubles.
//! Beyond ε = 2⁴⁰, `ε sin α = W` with `W + ln W = 2 ln ε − 1`, and α is its own sine.

use super::super::lambert::lambertw0_offset;
use super::super::real::double_double::{DoubleDouble, two_product};
use super::super::real::{Logarithm, Number, Order, angle, exp_m1, ln, ln_1p, select};
use super::domain::is_drag;
use super::fall::fall;

const INVERSE_E: f64 = 0.36787944117144233;
const STRONG: f64 = 1099511627776.0; // 2⁴⁰

/// For ε < 2⁴⁰.
#[inline(always)]
fn moderate(epsilon: Number) -> Number {
    let square = two_product(epsilon, epsilon);
    let p = exp_m1(lambertw0_offset(square.hi * INVERSE_E));
    let one = DoubleDouble::from(1.0);
    let rest = one.div(one.add_double(p));
    let sine_square = rest.times(fall(rest.times_double(p), rest));
    let residual = square.sub(two_product(p, p).times(sine_square)).round();
    let slowness = select(p.is_below(1e-20), 1.0, ln_1p(p) / p);
    // where ε² is next to nothing so is the change
    let change = select(epsilon.is_below(1e-8), 0.0, residual / (p * p * slowness));
    let sine_square = sine_square.add_double(change * (slowness - 2.0 * sine_square.hi));
    angle(sine_square.sqrt(), one.sub(sine_square).sqrt())
}

/// `ln x`, as a sum of two doubles.
#[inline(always)]
fn logarithm(x: Number) -> DoubleDouble {
    Logarithm::of(DoubleDouble::from(x)).value()
}

/// For ε > 2⁴⁰.
#[inline(always)]
fn strong(epsilon: Number) -> Number {
    let right = logarithm(epsilon).scale(2.0).add_double(-1.0);
    let mut w = right.hi - ln(right.hi);
    w *= (1.0 + right.hi - ln(w)) / (1.0 + w);
    w *= (1.0 + right.hi - ln(w)) / (1.0 + w);
    let residual = right.sub_double(w).sub(logarithm(w)).round();
    // divided by less: products next to the largest double lose their errors
    const LESS: f64 = f64::from_bits((1023 - 100) << 52);
    let sum = DoubleDouble::from(w).add_double(residual * w / (1.0 + w));
    sum.div(DoubleDouble::from(epsilon * LESS)).round() * LESS
}

/// Launch angle of the greatest range over level ground, in radians.
///
/// ε ≥ 0. π/4 without drag, falling to 0; there launch and landing are perpendicular.
#[inline(always)]
pub fn optimal_angle(eps: Number) -> Number {
    let angle = select(eps.is_above(STRONG), strong(eps), moderate(eps));
    select(is_drag(eps), angle, f64::NAN)
}

//! Derivatives of the launch angle by the elevation: equation (18) and the one after.
//!
//! Method: `θ′ = P/Q` with `P = G + cos²α a` and `Q = cos²α + G² sin²α`, and
//! `d²α/dθ² = −θ″/θ′³ = cos α (w P − p Q) Q / P³` where P′ = cos α p, Q′ = cos α w. On the locus Q is
//! (cos α/cos θ)² and G is tan θ/tan α; a is what then makes `P = cos²α + G (sin²α − cos²α/q)`, with
//! q = 1 + u. With `B = q sin α cos α cos θ + (q sin²α − cos²α) sin θ` that leaves
//!
//! - `dα/dθ = q sin α cos α / (B cos θ)`,
//! - `d²α/dθ² = −(W + (ε/q) f cos α C) f (dα/dθ) / (1 + q)`,
//! - `f = sin α / (sin θ + a sin α cos α cos θ)`,
//! - `W = 2 [sin α cos θ + cos α sin θ + a (q sin α cos θ − cos α sin θ)]`, a sum of positive terms,
//! - `C = cos²α − (q a/u) (1 + cos²α + q sin²α)`.
//!
//! f is q sin α/B as well; so written, the errors that the one of α makes in the factors cancel.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{Number, Order, greater, select};
use super::drag::logarithm;
use super::launch::{LARGE, LIFT, SMALL, within_domain};
use super::locus::{Digits, Elevated, Place};

/// 2⁻⁹⁰⁰, 2⁻⁸⁰⁰ and 2⁻³³⁰
const LEAST: f64 = f64::from_bits((1023 - 900) << 52);
const TINIEST: f64 = f64::from_bits((1023 - 800) << 52);
const WEAK: f64 = f64::from_bits((1023 - 330) << 52);
const MINUS_ONE: DoubleDouble = DoubleDouble::constant(-1.0, 0.0);

impl Elevated {
    /// dα/dθ and d²α/dθ² for θ > 0
    #[inline(always)]
    fn launch_angle_derivatives(&self) -> (Number, Number) {
        let Place { sin_theta, cos_theta, .. } = self.place;
        let (sin, cos) = self.direction();
        let u = sin.times_double(self.epsilon);
        let q = u.add_positive(1.0);
        let up = q.times(sin);
        let (up_sin, cos2) = (up.times(sin), cos.squared());
        let top = up.times(cos);
        let bottom = top.times(cos_theta).plus(up_sin.minus(cos2).times(sin_theta));
        let below = bottom.times(cos_theta);
        let inverse = 1.0 / below.hi;
        let first = top.div_by(below, inverse);

        // a = 2 r n (u n), n being 1/(2 + u) and r = ρ where a would cancel in the other form, in
        // which n is 1/u, u n is 1 and r = ln(1 + u)(1/2 + 1/u) − 1; n is lifted off the end of the range
        let near = q.hi.is_below(2.0);
        let logarithm = logarithm(q, near);
        let q_plus_one = u.add_positive(2.0);
        let lifted = DoubleDouble::from(LIFT).div(DoubleDouble::select(near, q_plus_one, u));
        let n = lifted.scale(1.0 / LIFT);
        let u_n = DoubleDouble::select(near, logarithm.s, DoubleDouble::from(1.0));
        let far = logarithm.value().times(n.add_positive(0.5)).add_smaller(MINUS_ONE);
        let r_n = DoubleDouble::select(near, logarithm.rho, far).times(lifted);
        let a = r_n.times(u_n);
        let q_a_by_u = r_n.times(n.add_positives(u_n));

        let (higher, lower) = (sin.times(cos_theta), cos.times(sin_theta));
        let stretched = up.times(cos_theta).minus(lower).scale(2.0 / LIFT);
        let w = higher.add_positives(lower).add_positives(a.times(stretched)).scale(2.0);
        let whole = cos2.add_positive(1.0).add_positives(up_sin).scale(2.0 / LIFT);
        let c = cos2.minus(q_a_by_u.times(whole)).times(cos);

        let f = sin.div(sin_theta.add_positives(higher.times(cos).scale(2.0 / LIFT).times(a)));
        let drag = DoubleDouble::from(self.epsilon).div(q).times(f);
        let second = w.plus(drag.times(c)).times(f).times(first);
        let sign = select(self.right, -1.0, 1.0);
        (first.round(), sign * second.quotient(q_plus_one))
    }
}

/// dα/dθ and d²α/dθ².
#[inline(always)]
fn derivatives(theta: Number, eps: Number) -> (Number, Number) {
    // 2 and −12θ − 8ε/3 where both are tiny: this is proportional to both, which a subnormal would
    // spoil; and f(εθ), ε f(εθ) where θ is nothing beside ε
    let (tiny, weak) = (theta.is_below(TINIEST), eps.is_below(WEAK));
    let scale = |weaker: f64, stronger: f64| select(tiny, select(weak, weaker, stronger), 1.0);
    // 0/0 at θ = 0, which is like anything much smaller than ε
    let angle = theta * scale(LARGE, LIFT);
    let angle = greater(LEAST, angle);
    let epsilon = eps * scale(LARGE, 1.0 / LIFT);
    let back = scale(SMALL, LIFT);
    let (first, second) = Elevated::new(angle, epsilon, Digits::More).launch_angle_derivatives();
    (within_domain(theta, eps, first), within_domain(theta, eps, second * back))
}

/// dα/dθ and d²α/dθ², each to the bit as its own function gives it.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub fn locus_launch_angle_derivatives(theta: Number, eps: Number) -> (Number, Number) {
    derivatives(theta, eps)
}

/// First derivative of the launch angle by the elevation, dα/dθ.  [Eq. 18]
///
/// 2 at θ = 0 for every drag; between 1/2 and 2 without drag.
#[inline(always)]
pub fn locus_launch_angle_d1(theta: Number, eps: Number) -> Number {
    derivatives(theta, eps).0
}

/// Second derivative of the launch angle by the elevation, d²α/dθ².
///
/// −8ε/3 at θ = 0, 0 at θ = π/2.
#[inline(always)]
pub fn locus_launch_angle_d2(theta: Number, eps: Number) -> Number {
    locus_launch_angle_derivatives(theta, eps).1
}

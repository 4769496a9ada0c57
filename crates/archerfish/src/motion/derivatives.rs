//! Derivatives of the launch angle by the elevation: equation (18) and the one after.
//!
//! Method: `θ′ = P/Q` with `P = G + cos²α a` and `Q = cos²α + G² sin²α`, both positive sums, and
//! `d²α/dθ² = −θ″/θ′³ = cos α (w P − p Q) Q / P³` where P′ = cos α p, Q′ = cos α w. With v = 1/(2 + u),
//!
//! - `p = ε v cos²α/(1 + u) − (a/sin α) (sin²α + 2v cos²α)`,
//! - `w = −2v sin α [a (1 + u − G) + 1 + G]`.
//!
//! On the locus G is tan θ/tan α.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{Logarithm, select};
use super::drag::excess_ratio;
use super::launch::{LARGE, SMALL, Scaled, TINY, within_domain};
use super::locus::Elevated;

/// 2⁻⁷⁰⁰ and 2¹⁶⁰
const FLAT: f64 = f64::from_bits((1023 - 700) << 52);
const STRONG: f64 = f64::from_bits((1023 + 160) << 52);
const MINUS_TWO: DoubleDouble = DoubleDouble { hi: -2.0, lo: 0.0 };
/// 2²⁰⁰
const LIFT: f64 = f64::from_bits((1023 + 200) << 52);

impl Elevated {
    /// `dα/dθ = Q/P`
    ///
    /// On the locus Q is (cos α/cos θ)² and G is tan θ/tan α; a is what then makes
    /// `P = cos²α + G (sin²α − cos²α/q)`. Over one denominator that is
    /// `q sin α cos α / (cos θ [q sin α cos α cos θ + (q sin²α − cos²α) sin θ])`.
    #[inline(always)]
    fn launch_angle_d1(&self) -> f64 {
        let (sin, cos) = self.direction();
        let up = sin.times_double(self.epsilon).add_positive(1.0).times(sin);
        let top = up.times(cos);
        let across = up.times(sin).minus(cos.squared()).times(self.sin_theta);
        top.quotient(top.times(self.cos_theta).plus(across).times(self.cos_theta))
    }

    /// `d²α/dθ²`
    #[inline(always)]
    fn launch_angle_d2(&self) -> f64 {
        let (sin, cos) = self.direction();
        let (sin2, cos2) = (sin.squared(), cos.squared());
        let u = sin.times_double(self.epsilon);
        let q = u.add_positive(1.0);
        let q_plus_one = u.add_positive(2.0);
        let v = DoubleDouble::from(1.0).div(q_plus_one);
        let q_inverse = DoubleDouble::from(1.0).div(q);
        // 0/0 at θ = 0
        let gain = self.sin_theta.times(cos).div(self.cos_theta.times(sin));
        let gain = DoubleDouble::select(sin.hi > 0.0, gain, DoubleDouble::from(0.5));

        // what is proportional to the result is lifted off the end of the range, then put back
        let far = u.hi > 1e100;
        let (lift, back) = (select(far, LIFT, 1.0), select(far, 1.0 / LIFT, 1.0));

        // a = ((2 + u) ln(1 + u)/u − 2)/u, or 2uv² ρ where that would cancel
        let near = u.hi < 1.0;
        let u_inverse = DoubleDouble::from(1.0).div(u);
        let logarithm = Logarithm::of(q).value();
        let far_a = logarithm.times(q_plus_one.times(u_inverse)).add_smaller(MINUS_TWO);
        let far_a = far_a.times(u_inverse.scale(lift));
        let series = v.squared().times(excess_ratio(u.times(v))).scale(2.0);
        let a = DoubleDouble::select(near, series.times(u), far_a.scale(back));
        let far_by_sin = far_a.times_double(self.epsilon).times(u_inverse);
        let a_by_sin = DoubleDouble::select(near, series.times_double(self.epsilon), far_by_sin);

        let lifted = v.scale(lift);
        let p = lifted.times_double(self.epsilon).times(q_inverse).times(cos2);
        let p = p.minus(a_by_sin.times(sin2.add_positives(v.scale(2.0).times(cos2))));
        let bracket = a.times(q.minus(gain)).add_positives(gain.add_positive(1.0));
        let w = lifted.scale(-2.0).times(sin).times(bracket);
        let slope = gain.add_positives(cos2.times(a));
        let stretch = cos2.add_positives(sin2.times(gain.squared()));
        let difference = w.times(slope).minus(p.times(stretch));
        let top = cos.times(difference).times(stretch);
        let sign = select(self.mirrored, -1.0, 1.0);
        sign * top.quotient(slope.squared().times(slope)) * back
    }
}

/// First derivative of the launch angle by the elevation, dα/dθ.  [Eq. 18]
///
/// 2 at θ = 0 for every drag; between 1/2 and 2 without drag.
#[inline(always)]
pub fn locus_launch_angle_d1(theta: f64, eps: f64) -> f64 {
    // 2 at θ = 0, where the ratio of sines is 0/0
    let Scaled { angle, epsilon, .. } = Scaled::new(theta, eps);
    let regular = Elevated::new(angle, epsilon).launch_angle_d1();
    within_domain(theta, eps, select(theta == 0.0, 2.0, regular))
}

/// Second derivative of the launch angle by the elevation, d²α/dθ².
///
/// −8ε/3 at θ = 0, 0 at θ = π/2.
#[inline(always)]
pub fn locus_launch_angle_d2(theta: f64, eps: f64) -> f64 {
    // −12θ − 8ε/3 where both are tiny: proportional to both, which a subnormal would spoil
    let tiny = (theta < TINY) & (eps < TINY);
    // and ε f(εθ) where θ is nothing beside ε, or −8ε/3 where εθ is nothing beside 1
    let flat = (theta < FLAT) & !tiny;
    let strong = flat & (eps > STRONG);
    let angle = theta * select(tiny | strong, LARGE, 1.0);
    let angle = select(flat & !strong, FLAT, angle);
    let epsilon = eps * select(tiny, LARGE, select(strong, SMALL, 1.0));
    let back = select(tiny, SMALL, select(strong, LARGE, 1.0));
    within_domain(theta, eps, Elevated::new(angle, epsilon).launch_angle_d2() * back)
}

//! Derivatives of the launch angle by the elevation: equation (18) and the one after.
//!
//! Method: `θ′ = P/Q` with `P = G + cos²α a` and `Q = cos²α + G² sin²α`, both positive sums;
//! `P′ = cos α p` and `Q′ = cos α w`. For b = ε(1 − σ)²/2, dG/dα is cos α b ρ, and a is
//! sin α b ρ; so most terms unite, and no difference of large ones is left:
//!
//! - `p = b [cos²α/(1 + σ) − ρ (sin²α + (1 − σ) cos²α)]`,
//! - `w = −sin α [a (1 + σ − (1 − σ) G) + (1 − σ)(1 + G)]`,
//!
//! and `d²α/dθ² = −θ″/θ′³ = cos α (w P − p Q) Q / P³`.

use super::super::real::double_double::DoubleDouble;
use super::super::real::select;
use super::drag::Drag;
use super::launch::{LARGE, Launch, SMALL, Scaled, TINY, within_domain};
use super::locus::Elevated;

/// 2⁻⁷⁰⁰ and 2¹⁶⁰
const FLAT: f64 = f64::from_bits((1023 - 700) << 52);
const STRONG: f64 = f64::from_bits((1023 + 160) << 52);
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
}

impl Launch {
    /// `d²α/dθ²`
    #[inline(always)]
    fn launch_angle_d2(&self) -> f64 {
        let drag = Drag::<DoubleDouble>::at(self.u);
        let (gain, sigma_plus_one) = (drag.gain(), drag.sigma_plus_one());
        let Drag { sigma_rest, rho, a, .. } = drag;
        let (sin2, cos2) = (self.sin.squared(), self.cos.squared());
        // what is proportional to the result is lifted off the end of the range, then put back
        let far = self.u.hi > 1e100;
        let (factor, back) = (select(far, LIFT, 1.0), select(far, 1.0 / LIFT, 1.0));
        let (lifted_rest, lifted_a) = (sigma_rest.scale(factor), a.scale(factor));
        let b = lifted_rest.times_double(self.epsilon).times(sigma_rest).scale(0.5);
        let p = b.times(cos2.div(sigma_plus_one).sub(rho.times(sin2.add(cos2.times(sigma_rest)))));
        let bracket = lifted_a
            .times(sigma_plus_one.sub(sigma_rest.times(gain)))
            .add(lifted_rest.times(gain.add_double(1.0)));
        let w = self.sin.times(bracket).neg();
        let slope = gain.add(cos2.times(a));
        let stretch = cos2.add(sin2.times(gain.squared()));
        let difference = w.times(slope).sub(p.times(stretch));
        let top = self.cos.times(difference).times(stretch);
        top.quotient(slope.squared().times(slope)) * back
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
    let launch = Elevated::new(angle, epsilon).launch();
    within_domain(theta, eps, launch.launch_angle_d2() * back)
}

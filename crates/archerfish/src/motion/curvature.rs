//! Curvature of the locus: equation (19) and its like by launch angle.
//!
//! Method: with k = 1/q, p = 1 − k, m = n/q = k(1 − 2 sin²α) − p sin²α (n = 0 is the rightmost
//! apex), `ρK = q (m (m + 2 p cos²α) + sin²α cos²α (3 + k)) / (sin²α cos²α + m²)^{3/2}`.
//! All of it stays of moderate size for every ε, and the denominator is never near zero.

use super::super::real::double_double::DoubleDouble;
use super::super::real::select;
use super::launch::{Launch, within_domain};
use super::locus::Elevated;

const SMALL: f64 = f64::from_bits((1023 - 600) << 52);
const LARGE: f64 = f64::from_bits((1023 + 600) << 52);
/// 2⁻⁷⁰⁰ and 2²⁰⁰
const NEAR: f64 = f64::from_bits((1023 - 700) << 52);
const LIFT: f64 = f64::from_bits((1023 + 200) << 52);

impl Launch {
    /// `ρK`, which grows with ε^{3/2} and overflows beyond ε = 10²⁰⁵
    #[inline(always)]
    pub fn curvature(&self) -> f64 {
        let one = DoubleDouble::from(1.0);
        let q = self.q();
        let k = one.div(q);
        let p = one.sub(k);
        let (sin2, cos2) = (self.sin.squared(), self.cos.squared());
        let sin2cos2 = sin2.times(cos2);
        let m = k.times(one.sub(sin2.scale(2.0))).sub(p.times(sin2));
        let denominator = sin2cos2.add(m.squared());
        let numerator =
            m.times(m.add(p.times(cos2).scale(2.0))).add(sin2cos2.times(k.add_double(3.0)));
        // far below the end of the range until the last multiplication, which may overflow
        let ratio = numerator.div(denominator);
        ratio.times(q.scale(SMALL)).quotient(denominator.sqrt()) * LARGE
    }
}

/// Curvature of the locus by launch angle, times V₀²/g.
///
/// 1 at α = 0; 1 + ε at α = π/2; at most 8 without drag, at 45°.
#[inline(always)]
pub fn apex_curvature(alpha: f64, eps: f64) -> f64 {
    within_domain(alpha, eps, Launch::at(alpha, eps).curvature())
}

/// Curvature of the locus by elevation, times V₀²/g.  [Eq. 19]
#[inline(always)]
pub fn locus_curvature(theta: f64, eps: f64) -> f64 {
    // so near the launch point it depends on ε sin α alone, and sin α would be subnormal
    let near = theta < NEAR;
    let (angle, epsilon) = (theta * select(near, LIFT, 1.0), eps * select(near, 1.0 / LIFT, 1.0));
    within_domain(theta, eps, Elevated::new(angle, epsilon).launch().curvature())
}

//! Curvature of the locus: equation (19) and its like by launch angle.
//!
//! Method: with k = 1/q, p = u/q, m = n/q = k(1 − 2 sin²α) − p sin²α (n = 0 is the rightmost
//! apex), `ρK = q (m² + 2 p cos²α m + sin²α cos²α (3 + k)) / (sin²α cos²α + m²)^{3/2}`.
//! All of it stays of moderate size for every ε, and the denominator is never near zero.

use super::launch::{Launch, within_domain};
use super::locus::Elevated;
use crate::real::double_double::DoubleDouble;

const SMALL: f64 = f64::from_bits((1023 - 600) << 52);
const LARGE: f64 = f64::from_bits((1023 + 600) << 52);

impl Launch {
    /// `ρK`, which grows with ε^{3/2} and overflows beyond ε = 10²⁰⁵
    #[inline(always)]
    pub fn curvature(&self) -> f64 {
        let q = self.q();
        let inverse = 1.0 / q.hi;
        let k = DoubleDouble::from(1.0).div_by(q, inverse);
        let p = self.u.div_by(q, inverse);
        let (sin2, cos2) = (self.sin.square(), self.cos.square());
        let sin2cos2 = sin2.mul(cos2);
        let one_less = DoubleDouble::from(1.0).sub(sin2.scale(2.0));
        let m = k.mul(one_less).sub(p.mul(sin2));
        let m2 = m.square();
        let denominator = sin2cos2.add(m2);
        let numerator = m2.add(p.mul(cos2).mul(m).scale(2.0)).add(sin2cos2.mul(k.add_double(3.0)));
        // far below the end of the range until the last multiplication, which may overflow
        let scaled = numerator.div(denominator).mul(q.scale(SMALL)).div(denominator.sqrt());
        scaled.round() * LARGE
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
    within_domain(theta, eps, Elevated::new(theta, eps).launch().curvature())
}

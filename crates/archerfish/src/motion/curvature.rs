//! Curvature of the locus: equation (19) and its like by launch angle.
//!
//! Method: with q = 1 + u and A = cos²α/q, from cos²α to 0, section 2's N and D over q² are
//! `sin²α + A (1 + cos²α − A)` and `sin²α cos²α + (A − sin²α)²` (A = sin²α is the rightmost apex),
//! so that `ρK = q N / D^{3/2}`. All but q stays of moderate size, and D is never near zero.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{Number, Order, select, sqrt};
use super::apex::apex;
use super::launch::{LIFT, Launch, within_domain};
use super::locus::Elevated;

const SMALL: f64 = f64::from_bits((1023 - 600) << 52);
const LARGE: f64 = f64::from_bits((1023 + 600) << 52);
/// 2⁻⁷⁰⁰
const NEAR: f64 = f64::from_bits((1023 - 700) << 52);

impl Launch {
    /// `ρK`, which grows with ε^{3/2} and overflows beyond ε = 10²⁰⁵
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn curvature(&self) -> Number {
        let q = self.q();
        let (sin2, cos2) = (self.sin.squared(), self.cos.squared());
        let share = cos2.div(q);
        let numerator = share.times(cos2.sub_smaller(share).add_positive(1.0)).add_positives(sin2);
        let rightmost = share.minus(sin2);
        let denominator = sin2.times(cos2).add_positives(rightmost.squared());

        // far below the end of the range until the last multiplication, which may overflow
        let inverse = 1.0 / denominator.hi;
        let root = sqrt(denominator.hi);
        let root_inverse = root * inverse;
        let root =
            DoubleDouble { hi: root, lo: denominator.less_square(root) * (0.5 * root_inverse) };
        let ratio = numerator.div_by(denominator, inverse);
        ratio.times(q.scale(SMALL)).quotient_by(root, root_inverse) * LARGE
    }
}

/// Curvature of the locus by launch angle, times V₀²/g.
///
/// 1 at α = 0; 1 + ε at α = π/2; at most 8 without drag, at 45°.
#[inline(always)]
pub fn apex_curvature(alpha: Number, eps: Number) -> Number {
    apex(alpha, eps).3
}

/// Curvature of the locus by elevation, times V₀²/g.  [Eq. 19]
#[inline(always)]
pub fn locus_curvature(theta: Number, eps: Number) -> Number {
    // so near the launch point it depends on ε sin α alone, and sin α would be subnormal
    let near = theta.is_below(NEAR);
    let (angle, epsilon) = (theta * select(near, LIFT, 1.0), eps * select(near, 1.0 / LIFT, 1.0));
    within_domain(theta, eps, Elevated::new(angle, epsilon).launch().curvature())
}

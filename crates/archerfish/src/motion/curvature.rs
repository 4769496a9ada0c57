//! Curvature of the locus: equation (19) and its like by launch angle.
//!
//! Method: with q = 1 + u, S = sin²α and A = cos²α/q, from cos²α to 0, section 2's N and D over q² are
//! `S + A + A (cos²α − A)` and `A² + S (1 − 2A)`, so that `ρK = q N / D^{3/2}`. All but q stays of
//! moderate size; S (1 − 2A) is negative where A > 1/2, but then A² is twice its size at least.

use super::super::real::double_double::{DoubleDouble, fast_two_sum, rest_of_product, two_product};
use super::super::real::{Number, Order, select, sqrt};
use super::apex::apex;
use super::launch::{LIFT, Launch, if_ordinary, within_domain};
use super::locus::{Digits, Elevated};

/// 2⁶⁰⁰
const LARGE: f64 = f64::from_bits((1023 + 600) << 52);
/// 2⁻⁷⁰⁰
const NEAR: f64 = f64::from_bits((1023 - 700) << 52);

impl Launch {
    /// `ρK`, which grows with ε^{3/2} and overflows beyond ε = 10²⁰⁵, by sin²α and cos²α
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn curvature(&self, sin2: DoubleDouble, cos2: DoubleDouble) -> Number {
        let q = self.q();
        let inverse = 1.0 / q.hi;
        let share = cos2.div_by(q, inverse);
        let denominator = share.squared().add_positives(sin2.times(share.twice().complement()));
        let root = sqrt(denominator.hi);

        // here, while the root is under way (bench/NOTES.md, "Order")
        let sum = sin2.add_positives(share);
        let across = cos2.hi - share.hi;
        let more = two_product(share.hi, across);
        let numerator = fast_two_sum(sum.hi, more.hi);
        let more_rest = more.lo + (share.lo * (across - share.hi) + share.hi * cos2.lo);
        let numerator = DoubleDouble { hi: numerator.hi, lo: numerator.lo + (sum.lo + more_rest) };

        // D^{3/2}, which may be as small as 10⁻⁴⁵⁰; the last multiplication may overflow
        let power = two_product(denominator.hi * LARGE, root);
        let root_rest = rest_of_product(denominator.hi, root, root);
        let change = (1.5 * LARGE) * denominator.lo + (0.5 * LARGE) * root_rest;
        let power = DoubleDouble { hi: power.hi, lo: power.lo + root * change };
        numerator.times(q).quotient(power) * LARGE
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
    within_domain(theta, eps, {
        let launch = Elevated::new(angle, epsilon, Digits::More).launch();
        // both squares: an error of one alone is up to eight times as great in 1 less it
        launch.curvature(launch.sin.squared(), launch.cos.squared())
    })
}

/// `locus_curvature` without what only angles next to 0 and to π need; ∞ for them, and outside the
/// domain. (Where ρK itself is ∞ the whole says so.)
#[allow(dead_code, reason = "for dispatch alone, which not every build has")]
#[inline(always)]
pub(crate) fn locus_curvature_ordinary(theta: Number, eps: Number) -> Number {
    let launch = Elevated::new(theta, eps, Digits::More).launch();
    let value = launch.curvature(launch.sin.squared(), launch.cos.squared());
    if_ordinary(theta, eps, f64::MAX, value)
}

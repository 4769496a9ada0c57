//! The apex of one shot, by launch angle: equations (7), (8), (10).

use super::super::real::double_double::{fast_two_difference, fast_two_sum};
use super::super::real::{Logarithm, Number, Order, atan_bend, select};
use super::drag::Quotients;
use super::launch::{LIFT, Launch, is_within, within_domain};

impl Launch {
    /// `x = sin α cos α / q`
    #[inline(always)]
    fn x(&self) -> Number {
        let lifted = self.cos.times_double(self.sin.hi * LIFT);
        lifted.quotient(self.q_of_rounded()) * (1.0 / LIFT)
    }

    /// `y = sin²α φ(u)`
    #[inline(always)]
    fn y(&self, drag: &Quotients) -> Number {
        let (top, bottom) = drag.fall(self.u.lo);
        let lifted = self.lifted().squared().times(top).quotient(bottom);
        lifted * (1.0 / LIFT / LIFT)
    }

    /// `t = sin α ln(1 + u)/u`
    #[inline(always)]
    fn time(&self) -> Number {
        let u = self.u.round();
        let slowed = self.lifted().times(Logarithm::of(self.q()).value());
        let divisor = fast_two_sum(self.u.hi, self.u.lo);
        // 1 + u has forgotten the end of a u this small, and 0/0 is at u = 0
        let first_order = self.lifted().times(fast_two_difference(1.0, 0.5 * u));
        select(u.is_below(1e-15), first_order.round(), slowed.quotient(divisor)) * (1.0 / LIFT)
    }

    /// `r = sin α √(cos²α + G² sin²α) / q`
    #[inline(always)]
    fn distance(&self) -> Number {
        let rise = self.sin.times(self.gain());
        let stretch = self.cos.squared().add_positives(rise.squared());
        self.lifted().times(stretch.sqrt()).quotient(self.q()) * (1.0 / LIFT)
    }

    /// `θ = α − arctan τ`, `τ = (1 − G) sin α cos α / (1 − (1 − G) sin²α)`: equation (10), and τ² is at
    /// most 1/8
    #[inline(always)]
    fn elevation(&self, alpha: Number, drag: &Quotients) -> Number {
        let (loss, whole) = drag.loss();
        let lifted = self.lifted().times(loss);
        let divisor = whole.sub_smaller(lifted.times(self.sin).scale(1.0 / LIFT));
        let tau = lifted.times(self.cos).div(divisor).scale(1.0 / LIFT);
        let sum = fast_two_difference(alpha, tau.hi);
        sum.hi + (sum.lo - (tau.lo + atan_bend(tau.hi)))
    }
}

/// x, y, elevation and curvature of the locus at the apex, each to the bit as its own function gives
/// it.
#[inline(always)]
pub fn apex(alpha: Number, eps: Number) -> (Number, Number, Number, Number) {
    let launch = Launch::at(alpha, eps);
    let drag = Quotients::at(launch.u.hi);
    let sin2 = launch.sin.squared();
    (
        // (which is NaN without a word where ε is infinite or NaN)
        select(is_within(alpha, eps), launch.x(), f64::NAN),
        within_domain(alpha, eps, launch.y(&drag)),
        within_domain(alpha, eps, launch.elevation(alpha, &drag)),
        within_domain(alpha, eps, launch.curvature(sin2, sin2.complement())),
    )
}

/// Horizontal distance of the apex, `sin α cos α / (1 + ε sin α)`, in V₀²/g.  [Eq. 7]
///
/// Limits: `sin α cos α` as ε → 0; `cos α / ε` as ε → ∞. Negative for α > π/2.
#[inline(always)]
pub fn apex_x(alpha: Number, eps: Number) -> Number {
    apex(alpha, eps).0
}

/// Height of the apex, `sin²α · φ(ε sin α)`, in V₀²/g.  [Eq. 8]
///
/// Limits: `sin²α / 2` as ε → 0; `sin α / ε` as ε → ∞.
#[inline(always)]
pub fn apex_y(alpha: Number, eps: Number) -> Number {
    apex(alpha, eps).1
}

/// Time from launch to apex, `ln(1 + ε sin α)/ε`, in V₀/g.
///
/// Limits: `sin α` as ε → 0; `ln(ε sin α)/ε` as ε → ∞.
#[inline(always)]
pub fn apex_time(alpha: Number, eps: Number) -> Number {
    within_domain(alpha, eps, Launch::at(alpha, eps).time())
}

/// Distance of the apex from the launch point, in V₀²/g.
#[inline(always)]
pub fn apex_distance(alpha: Number, eps: Number) -> Number {
    within_domain(alpha, eps, Launch::at(alpha, eps).distance())
}

/// Elevation θ of the apex seen from the launch point, in radians, in [0, π].  [Eq. 10]
///
/// Limits: `tan θ = tan α / 2` as ε → 0; `θ = α` as ε → ∞.
#[inline(always)]
pub fn apex_elevation(alpha: Number, eps: Number) -> Number {
    apex(alpha, eps).2
}

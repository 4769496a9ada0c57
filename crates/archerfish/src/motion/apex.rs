//! The apex of one shot, by launch angle: equations (7), (8), (10).

use super::super::real::double_double::fast_two_sum;
use super::super::real::{Logarithm, angle, select};
use super::launch::{LIFT, Launch, TINY, within_domain};

impl Launch {
    /// `x = sin α cos α / q`
    #[inline(always)]
    fn x(&self) -> f64 {
        self.lifted().times(self.cos).quotient(self.q()) * (1.0 / LIFT)
    }

    /// `y = sin²α φ(u)`, φ(u) being (1 − a)/(2 + u)
    #[inline(always)]
    fn y(&self) -> f64 {
        let rest = fast_two_sum(1.0, -self.a());
        let lifted = self.lifted().squared().times(rest).quotient(self.q_plus_one());
        lifted * (1.0 / LIFT / LIFT)
    }

    /// `t = sin α ln(1 + u)/u`
    #[inline(always)]
    fn time(&self) -> f64 {
        let u = self.u.round();
        let slowed = self.lifted().times(Logarithm::of(self.q()).value());
        let divisor = fast_two_sum(self.u.hi, self.u.lo);
        // 1 + u has forgotten the end of a u this small, and 0/0 is at u = 0
        let first_order = self.lifted().times(fast_two_sum(1.0, -0.5 * u));
        select(u < 1e-15, first_order.round(), slowed.quotient(divisor)) * (1.0 / LIFT)
    }

    /// `r = sin α √(cos²α + G² sin²α) / q`
    #[inline(always)]
    fn distance(&self) -> f64 {
        let rise = self.sin.times(self.gain(self.a()));
        let stretch = self.cos.squared().add_positives(rise.squared());
        self.lifted().times(stretch.sqrt()).quotient(self.q()) * (1.0 / LIFT)
    }

    /// θ, from `tan θ = G(u) tan α` with the denominator of G on the other side
    #[inline(always)]
    fn elevation(&self) -> f64 {
        let up = self.sin.times(self.q().times(fast_two_sum(1.0, -self.a())));
        // so small an angle is proportional to its tangent, which would be subnormal on the way
        let tiny = self.sin.hi < TINY;
        let up = up.scale(select(tiny, LIFT, 1.0));
        angle(up, self.cos.times(self.q_plus_one())) * select(tiny, 1.0 / LIFT, 1.0)
    }
}

/// x, y, elevation and curvature of the locus at the apex, each to the bit as its own function gives
/// it.
#[inline(always)]
pub fn apex(alpha: f64, eps: f64) -> (f64, f64, f64, f64) {
    let launch = Launch::at(alpha, eps);
    (
        within_domain(alpha, eps, launch.x()),
        within_domain(alpha, eps, launch.y()),
        within_domain(alpha, eps, launch.elevation()),
        within_domain(alpha, eps, launch.curvature()),
    )
}

/// Horizontal distance of the apex, `sin α cos α / (1 + ε sin α)`, in V₀²/g.  [Eq. 7]
///
/// Limits: `sin α cos α` as ε → 0; `cos α / ε` as ε → ∞. Negative for α > π/2.
#[inline(always)]
pub fn apex_x(alpha: f64, eps: f64) -> f64 {
    apex(alpha, eps).0
}

/// Height of the apex, `sin²α · φ(ε sin α)`, in V₀²/g.  [Eq. 8]
///
/// Limits: `sin²α / 2` as ε → 0; `sin α / ε` as ε → ∞.
#[inline(always)]
pub fn apex_y(alpha: f64, eps: f64) -> f64 {
    apex(alpha, eps).1
}

/// Time from launch to apex, `ln(1 + ε sin α)/ε`, in V₀/g.
///
/// Limits: `sin α` as ε → 0; `ln(ε sin α)/ε` as ε → ∞.
#[inline(always)]
pub fn apex_time(alpha: f64, eps: f64) -> f64 {
    within_domain(alpha, eps, Launch::at(alpha, eps).time())
}

/// Distance of the apex from the launch point, in V₀²/g.
#[inline(always)]
pub fn apex_distance(alpha: f64, eps: f64) -> f64 {
    within_domain(alpha, eps, Launch::at(alpha, eps).distance())
}

/// Elevation θ of the apex seen from the launch point, in radians, in [0, π].  [Eq. 10]
///
/// Limits: `tan θ = tan α / 2` as ε → 0; `θ = α` as ε → ∞.
#[inline(always)]
pub fn apex_elevation(alpha: f64, eps: f64) -> f64 {
    apex(alpha, eps).2
}

//! The apex of one shot, by launch angle: equations (7), (8), (10).

use super::super::real::double_double::{DoubleDouble, fast_two_difference, fast_two_sum};
use super::super::real::{
    Logarithm, Number, Order, Sign, atan_bend, greater, log_excess, select, sin_and_factors,
    sin_upper,
};
use super::drag::{self, Drag};
use super::launch::{LARGE, LIFT, Launch, Part, SMALL, if_ordinary, is_within, within_domain};

/// Drag parameters below it, 2⁻⁶⁰, make no difference to a height.
const WEAK: f64 = f64::from_bits((1023 - 60) << 52);
/// Drag parameters up to it, 2³⁰⁰, have squares; greater ones times STRONG_BACK, 2⁻⁶⁰⁰.
const STRONG: f64 = f64::from_bits((1023 + 300) << 52);
const STRONG_BACK: f64 = f64::from_bits((1023 - 600) << 52);
/// Where ε sin α is below it, 2⁻⁴⁰⁰, its square may underflow.
const FLAT: f64 = f64::from_bits((1023 - 400) << 52);
/// Its excess, 2⁻⁸⁰¹
const FLAT_EXCESS: f64 = f64::from_bits((1023 - 801) << 52);
/// Above this, ln(1 + u) is nothing beside u.
const HUGE: f64 = 1e100;

impl Launch {
    /// `x = sin α cos α / q`
    #[inline(always)]
    fn x(&self) -> Number {
        let lifted = self.cos.times_double(self.sin.hi * LIFT);
        lifted.quotient(self.q_of_rounded()) * (1.0 / LIFT)
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
}

/// `θ = α − arctan τ`, `τ = n sin α cos α/(u² − n sin²α)`, `n = u² (1 − G)`: equation (10), and τ² is at
/// most 1/8
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
fn elevation(alpha: Number, epsilon: Number, part: Part) -> Number {
    let (lift, back) = match part {
        Part::Whole => (LARGE, SMALL),
        Part::Ordinary => (1.0, 1.0),
    };
    let (sin, across, along) = sin_and_factors(alpha);
    let drag = match part {
        Part::Whole => Drag::at(epsilon * sin, drag::STRONG),
        Part::Ordinary => Drag::up_to_most(epsilon * sin),
    };
    // (what is left of the 1 is lost where u is above 2⁵³; by then the angle is α, nearly)
    let q = 1.0 + drag.u;
    let q = DoubleDouble { hi: q, lo: drag.u - (q - 1.0) };
    let (share, square) = drag.gain_and_square(q);
    let loss = square.sub_smaller(share);
    let divisor = fast_two_difference(square.hi, loss.round() * (sin * sin));
    let divisor = DoubleDouble { hi: divisor.hi, lo: divisor.lo + square.lo };
    let inverse = 1.0 / divisor.hi;
    // here, while the division is under way (bench/NOTES.md, "Order")
    let slant = across.scale(lift).times(along);
    let tau = loss.times(slant).div_by(divisor, inverse).scale(back);
    let sum = fast_two_difference(alpha, tau.hi);
    sum.hi + (sum.lo - (tau.lo + atan_bend(tau.round())))
}

/// `y = sin²α φ(u)`, as `(u − ln(1 + u))/ε²`, given sin α.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
fn height(sin: DoubleDouble, epsilon: Number, part: Part) -> Number {
    // φ is 1/2 − u/3 below WEAK, to 2⁻⁶⁰
    let epsilon = greater(WEAK, epsilon);
    let u = sin.times_double(epsilon);
    let (excess, slope) = log_excess(u.hi, Sign::Positive);
    let excess = DoubleDouble { hi: excess.hi, lo: excess.lo + u.lo * slope };
    if part == Part::Ordinary {
        return excess.div_double(epsilon * epsilon).round();
    }
    let excess = DoubleDouble::select(u.hi.is_above(HUGE), u, excess);
    let back = select(epsilon.is_above(STRONG), STRONG_BACK, 1.0);
    // (by the excess, not by u: around its computation the compiler would make a branch)
    let flat = excess.hi.is_below(FLAT_EXCESS);
    let half_square = sin.scale(LIFT).squared().scale(0.5);
    let top = DoubleDouble::select(flat, half_square, excess);
    let divisor = select(flat, 1.0, epsilon * back);
    let back = select(flat, 1.0 / LIFT, back);
    top.div_double(divisor * divisor).round() * back * back
}

/// x, y, elevation and curvature of the locus at the apex, each to the bit as its own function gives
/// it.
#[inline(always)]
pub fn apex(alpha: Number, eps: Number) -> (Number, Number, Number, Number) {
    let launch = Launch::at(alpha, eps);
    let sin2 = launch.sin.squared();
    (
        // (which is NaN without a word where ε is infinite or NaN)
        select(is_within(alpha, eps), launch.x(), f64::NAN),
        within_domain(alpha, eps, height(sin_upper(alpha), eps, Part::Whole)),
        within_domain(alpha, eps, elevation(alpha, eps, Part::Whole)),
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

/// `apex_y` without what only the strongest drag and next to none of it need; ∞ for them, and outside
/// the domain.
#[allow(dead_code, reason = "for dispatch alone, which not every build has")]
#[inline(always)]
pub(crate) fn apex_y_ordinary(alpha: Number, eps: Number) -> Number {
    let sin = sin_upper(alpha);
    let enough = (sin.hi * greater(WEAK, eps)).is_at_least(FLAT);
    let ordinary = enough & eps.is_at_most(STRONG) & is_within(alpha, eps);
    select(ordinary, height(sin, eps, Part::Ordinary), f64::INFINITY)
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

/// `apex_elevation` without what only angles next to 0 and to π need; ∞ for them, and outside the domain.
#[allow(dead_code, reason = "for dispatch alone, which not every build has")]
#[inline(always)]
pub(crate) fn apex_elevation_ordinary(alpha: Number, eps: Number) -> Number {
    let value = elevation(alpha, eps, Part::Ordinary);
    if_ordinary(alpha, eps, drag::STRONG, value)
}

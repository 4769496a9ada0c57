//! Derivatives of the launch angle by the elevation: equation (18) and the one after.
//!
//! Method: `θ′ = P/Q` with `P = G + cos²α a` and `Q = cos²α + G² sin²α`. On the locus Q is ζ², where
//! `ζ = cos α/cos θ = G sin α/sin θ`, so that with `f = sin α/(sin θ + a sin α cos α cos θ)`
//!
//! - `dα/dθ = f ζ`.
//!
//! P and Q are differentiated by α, with `u G′ = a`, `u a′ = e` and, with q = 1 + u, h = 1 − G, `m = u h`
//! and `w = 2G − 1`,
//!
//! - `q a = m − w`, `q (a + e) = w`, `q (2a + e) = m`,
//!
//! which leaves nothing but positive terms:
//!
//! - `d²α/dθ² = −f (dα/dθ) cos θ S/q`,
//! - `S = sin α [2 (1 − hG) + m (2 − dα/dθ)] + (w/sin α) dα/dθ`.
//!
//! `w/sin α` is ε times w/u, which for small u is taken from its series.

use super::super::real::double_double::{DoubleDouble, fast_two_difference, fast_two_sum};
use super::super::real::{Logarithm, Number, Order, greater, polynomial, select};
use super::launch::{LARGE, LIFT, Part, SMALL, if_ordinary, within_domain};
use super::locus::{Digits, Elevated, Place};

// weak_gain: minimax on [0.0, 0.0626], degree 7,
// weighted error 1.75e-18: reference/coefficients.py weak_gain
const WEAK_GAIN: [f64; 8] = [
    0.16666666666666433,
    -0.09999999999878359,
    0.06666666644995395,
    -0.047619028922528235,
    0.035713391214962094,
    -0.027752728437434034,
    0.021811587365773176,
    -0.01447882875088176,
];
const THIRD: DoubleDouble = DoubleDouble::constant(0.3333333333333333, 1.850371707708594e-17);
/// Below it, the series of w/u holds; from it on, enough of 1 − 2h is left, for there the table's number
/// is near 1/q.
const NEAR: f64 = 1.0 / 16.0;

/// 2²⁰: up to here l = u − ln(1 + u) keeps enough of the logarithm.
const STRONG: f64 = f64::from_bits((1023 + 20) << 52);

/// 2⁻⁹⁰⁰, 2⁻⁸⁰⁰ and 2⁻³³⁰
const LEAST: f64 = f64::from_bits((1023 - 900) << 52);
const TINIEST: f64 = f64::from_bits((1023 - 800) << 52);
const WEAK: f64 = f64::from_bits((1023 - 330) << 52);

/// The launch whose apex is seen, and how its angle changes, for θ > 0.
struct Found {
    sin: DoubleDouble,
    /// `u = ε sin α` and `q = 1 + u`
    u: DoubleDouble,
    q: DoubleDouble,
    /// `h = 1 − G`, G and 2G − 1
    rest: DoubleDouble,
    gain: DoubleDouble,
    w: DoubleDouble,
    /// `m = u h`
    m: DoubleDouble,
    /// 1/q and 1/sin α, to 2⁻³⁴ of themselves
    by_q: Number,
    by_sin: Number,
    f: DoubleDouble,
    /// dα/dθ
    first: DoubleDouble,
}

impl Found {
    #[inline(always)]
    fn new(elevated: &Elevated, part: Part) -> Self {
        let Place { sin_theta, .. } = elevated.place;
        let (sin, u, along) = elevated.sine();
        // (what is left of the 1 is lost where u is above 2⁵³)
        let q = fast_two_sum(1.0, u.hi);
        let q = DoubleDouble { hi: q.hi, lo: q.lo + u.lo };
        let (rest, by_q) = elevated.gain_rest(along);
        let (m, by_sin) = (u.times(rest), elevated.by_sin(along));
        let (m, by_q, by_sin) = match part {
            Part::Whole => {
                // where the excess of u over its logarithm has forgotten the latter
                let strong = u.hi.is_above(STRONG);
                let logarithm = Logarithm::of(q).value();
                let far = logarithm.sub_double(1.0 - logarithm.hi / u.hi);
                (
                    DoubleDouble::select(strong, far, m),
                    select(strong, 1.0 / q.hi, by_q),
                    select(strong, 1.0 / sin.hi, by_sin),
                )
            }
            Part::Ordinary => (m, by_q, by_sin),
        };
        let gain = rest.complement();
        let w = gain.sub_smaller(rest);
        let a = m.sub_smaller(w).div_by(q, by_q);
        let zeta = sin.div(sin_theta).times(gain);

        // sin α cos α cos θ, whose error the second derivative feels three times
        let slant = sin.hi * zeta.round();
        let slant = slant - slant * (sin_theta.hi * sin_theta.hi);
        let bend = a.times_double(slant);
        let bottom = fast_two_sum(sin_theta.hi, bend.hi);
        let bottom = DoubleDouble { hi: bottom.hi, lo: bottom.lo + (sin_theta.lo + bend.lo) };
        let f = sin.div(bottom);
        Found { sin, u, q, rest, gain, w, m, by_q, by_sin, f, first: f.times(zeta) }
    }

    /// |d²α/dθ²|
    #[inline(always)]
    fn second(&self, elevated: &Elevated) -> Number {
        let Found { sin, u, q, rest, gain, w, m, by_q, by_sin, f, first } = *self;
        let w_by_u = fast_two_difference(THIRD.hi, u.hi * polynomial(u.hi, &WEAK_GAIN));
        let w_by_u = DoubleDouble { hi: w_by_u.hi, lo: w_by_u.lo + THIRD.lo };
        let near = w_by_u.times_double(elevated.epsilon);
        let far = w.div_by(sin, by_sin);
        let w_by_sin = DoubleDouble::select(u.hi.is_below(NEAR), near, far);

        let flat = fast_two_difference(1.0, gain.hi * rest.hi).twice();
        let across = flat.add_positives(m.times_double(2.0 - first.round()));
        let sum = sin.times(across).add_positives(w_by_sin.times(first));
        f.times(first).times(elevated.place.cos_theta).times(sum).quotient_by(q, by_q)
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
    let elevated = Elevated::new(angle, epsilon, Digits::More);
    let found = Found::new(&elevated, Part::Whole);
    let (first, second) = (found.first.round(), found.second(&elevated));
    let sign = select(elevated.right, -1.0, 1.0);
    (within_domain(theta, eps, first), within_domain(theta, eps, sign * second * back))
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

/// `locus_launch_angle_d1`, as `locus_launch_angle_ordinary`, and up to drag that is already strong.
#[allow(dead_code, reason = "for dispatch alone, which not every build has")]
#[inline(always)]
pub(crate) fn locus_launch_angle_d1_ordinary(theta: Number, eps: Number) -> Number {
    let elevated = Elevated::new(theta, eps, Digits::More);
    let first = Found::new(&elevated, Part::Ordinary).first.round();
    if_ordinary(theta, eps, STRONG, first)
}

/// `locus_launch_angle_d2`, as `locus_launch_angle_d1_ordinary`.
#[allow(dead_code, reason = "for dispatch alone, which not every build has")]
#[inline(always)]
pub(crate) fn locus_launch_angle_d2_ordinary(theta: Number, eps: Number) -> Number {
    let elevated = Elevated::new(theta, eps, Digits::More);
    let second = Found::new(&elevated, Part::Ordinary).second(&elevated);
    let second = select(elevated.right, -1.0, 1.0) * second;
    if_ordinary(theta, eps, STRONG, second)
}

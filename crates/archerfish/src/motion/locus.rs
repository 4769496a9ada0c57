//! The locus by elevation: the inverse of equation (10), and equation (13).
//!
//! Method: write α = θ + β, 0 ≤ β < 0.34, τ = tan β and t = tan(β/2). Equation (10),
//! `tan θ = G(u) tan α`, u = ε sin α, says `sin β = (1 − G) sin α cos θ`, or
//! `2t = (1 − G) cos θ (1 + t²) sin α`.
//!
//! First τ is guessed (`guess.rs`), and gives t. One step of third order on the equation for α leaves an
//! error far below the last digit; its residual alone is formed in sums of two doubles. t has the sine
//! and the cosine of θ + β with it, without a further series or a root. Derivatives of G are rational in
//! G and u (`drag.rs`), and cost next to nothing.

use super::super::real::double_double::{
    DoubleDouble, fast_two_difference, fast_two_sum, rest_of_product, two_product, two_square,
};
use super::super::real::{Mask, Mirrored, Number, polynomial, select};
use super::drag::{self, Drag};
use super::guess::Guess;
use super::launch::{Launch, Scaled, if_ordinary, q_without_one_rest, within_domain};

/// How well the launch is wanted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Digits {
    /// for what magnifies its error
    More,
    /// for itself
    Enough,
}

// half_tan: minimax on [0.0, 0.126], degree 3,
// weighted error 4.29e-8: reference/coefficients.py half_tan
const HALF_TAN: [f64; 4] =
    [0.49999995705855144, -0.1249888393506859, 0.062044781068730306, -0.033003663798861486];
// half_atan_tail: minimax on [0.0, 0.0298], degree 6,
// weighted error 3.71e-18: reference/coefficients.py half_atan_tail
const HALF_ATAN_TAIL: [f64; 7] = [
    -0.6666666666666609,
    0.399999999994961,
    -0.28571428424883,
    0.22222201996602586,
    -0.1818032236300385,
    0.1532357060686162,
    -0.12028720885296493,
];

/// A direction α₀ = θ + β₀ near that of the launch.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub sin_theta: DoubleDouble,
    /// |cos θ|
    pub cos_theta: DoubleDouble,
    /// `t = tan(β₀/2)`
    half_tan: Number,
    /// `1 − t²`
    rest: DoubleDouble,
    /// `1/(1 + t²)`
    inverse: DoubleDouble,
    /// `(1 + t²) sin α₀ = (1 − t²) sin θ + 2t cos θ`
    up: DoubleDouble,
}

/// The shot whose apex is seen at a given elevation.
pub(crate) struct Elevated {
    pub place: Place,
    pub epsilon: Number,
    /// whether θ ≤ π/2
    pub right: Mask,
    theta: Number,
    /// `u₀ = ε sin α₀`
    u: DoubleDouble,
    pub step: Step,
}

/// The way from α₀ to α.
#[derive(Clone, Copy)]
pub(super) struct Step {
    /// `α − α₀`, for θ ≤ π/2
    angle: Number,
    /// `cos α₀`
    cos_alpha: Number,
    /// `1/u₀`, between the bounds of `Drag`
    by_u: Number,
    /// `1 + u₀`
    q: Number,
    /// `1 − G(u₀)`
    gain_rest: DoubleDouble,
}

impl Place {
    /// The step of third order from α₀ to where `F = sin(α − θ) − h sin α cos θ` is zero, h = 1 − G.
    ///
    /// With `u h′ = −a`, `q (h − a) = G` and `q (a + e) = 2G − 1 = w`,
    /// `q F′ = q cos β − G cos α cos θ` and
    /// `q F″ = cos θ (G sin α + (w/sin α) cos²α) − q sin β`. All are taken times 1 + t².
    #[inline(always)]
    fn step(&self, u: Number, epsilon: Number, digits: Digits) -> Step {
        let up = self.up;
        let (sin, cos) = (self.sin_theta.hi, self.cos_theta);
        let twice = self.half_tan + self.half_tan;
        let along = cos.hi * self.rest.hi - twice * sin;
        let cos_alpha = along * self.inverse.hi;
        let drag = Drag::at(u, drag::STRONGEST);
        let u = drag.u;
        let inverse = 1.0 / u;
        let gain_rest = drag.gain_rest(inverse);

        // −F
        let value = match digits {
            Digits::More => {
                let product = up.times(cos).times(gain_rest);
                (product.hi - twice) + product.lo
            }
            Digits::Enough => {
                let across = DoubleDouble { hi: up.hi * cos.hi, lo: up.lo * cos.hi };
                let product = gain_rest.times(across);
                (product.hi - twice) + product.lo
            }
        };
        let cos = cos.hi;
        let gain = 1.0 - gain_rest.hi;
        let q = 1.0 + u;
        let slope = q * self.rest.hi - (along * cos) * gain;
        let by_slope = 1.0 / slope;
        // here, while the division is under way (bench/NOTES.md, "Order")
        let w_by_sin = (gain - gain_rest.hi) * (epsilon * inverse);
        let bend = cos * (up.hi * gain + w_by_sin * (cos_alpha * along)) - q * twice;
        let newton = (value * q) * by_slope;
        let angle = newton - (0.5 * newton) * ((bend * newton) * by_slope);
        Step { angle, cos_alpha, by_u: inverse, q, gain_rest }
    }
}

impl Elevated {
    /// Solves equation (10) for the launch, given the elevation θ of its apex in [0, π].
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn new(theta: Number, epsilon: Number, digits: Digits) -> Self {
        let mirrored = Mirrored::of(theta);
        // a guess waits for itself; between its parts there is time for the sine and the cosine
        let guess = Guess::new(mirrored.angle.round(), epsilon);
        let quarter = mirrored.quarter();
        let guess = guess.with_root();
        let (sin_theta, cos_theta) = quarter.sin_cos();
        let tau = guess.tan_by_slant() * (sin_theta.hi * cos_theta.hi);
        let half_tan = tau * polynomial(tau * tau, &HALF_TAN);
        let square = two_square(half_tan);
        let whole = fast_two_sum(1.0, square.hi);
        let whole_rest = whole.lo + square.lo;
        let inverse = 1.0 / whole.hi;
        // here, while the division is under way (bench/NOTES.md, "Order")
        let rest = fast_two_difference(1.0, square.hi);
        let rest = DoubleDouble { hi: rest.hi, lo: rest.lo - square.lo };
        let up = match digits {
            Digits::More => {
                let turned = cos_theta.times_double(half_tan + half_tan);
                sin_theta.times(rest).add_smaller(turned)
            }
            Digits::Enough => {
                let across = (cos_theta.hi + cos_theta.hi) - half_tan * sin_theta.hi;
                sin_theta.add_smaller(two_product(half_tan, across))
            }
        };
        let inverse_rest = rest_of_product(1.0, whole.hi, inverse) - inverse * whole_rest;
        let inverse = DoubleDouble { hi: inverse, lo: inverse * inverse_rest };
        let u = match digits {
            Digits::More => {
                let u = up.times(inverse).times_double(epsilon);
                fast_two_sum(u.hi, u.lo)
            }
            Digits::Enough => DoubleDouble::from(up.hi * inverse.hi * epsilon),
        };
        let place = Place { sin_theta, cos_theta, half_tan, rest, inverse, up };
        let step = place.step(u.hi, epsilon, digits);
        Elevated { place, epsilon, right: mirrored.right, theta, u, step }
    }

    /// α in [0, π]
    #[inline(always)]
    pub fn launch_angle(&self) -> Number {
        let sign = select(self.right, 1.0, -1.0);
        let t = self.place.half_tan;
        let sum = fast_two_sum(self.theta, sign * (t + t));
        // β₀ − 2t
        let z = t * t;
        let bend = t * z * polynomial(z, &HALF_ATAN_TAIL);
        sum.hi + (sum.lo + sign * (self.step.angle + bend))
    }

    /// sin α, u = ε sin α and `(u − u₀)/u₀`
    #[inline(always)]
    pub fn sine(&self) -> (DoubleDouble, DoubleDouble, Number) {
        let Step { angle, cos_alpha, by_u, .. } = self.step;
        let sin = self.place.up.times(self.place.inverse);
        let change = angle * (cos_alpha - (0.5 * angle) * sin.hi);
        let u_change = self.u.lo + self.epsilon * change;
        let u = fast_two_sum(self.u.hi, u_change);
        (fast_two_sum(sin.hi, sin.lo + change), u, u_change * by_u)
    }

    /// `1 − G(u)`, given `(u − u₀)/u₀`: of second order, with `u h′ = −a` and `u² h″ = 2a − w/q`; and
    /// `1/(1 + u)` of first order
    #[inline(always)]
    pub fn gain_rest(&self, along: Number) -> (DoubleDouble, Number) {
        let Step { q, gain_rest: h, .. } = self.step;
        let inverse = 1.0 / q;
        let a = h.hi - (1.0 - h.hi) * inverse;
        let bend = a - (0.5 - h.hi) * inverse;
        let rest = fast_two_sum(h.hi, h.lo - along * (a - along * bend));
        (rest, inverse - inverse * (along * (1.0 - inverse)))
    }

    /// `1/sin α`, given `(u − u₀)/u₀`: of first order
    #[inline(always)]
    pub fn by_sin(&self, along: Number) -> Number {
        let by_sin = self.epsilon * self.step.by_u;
        by_sin - by_sin * along
    }

    /// sin α and |cos α|
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn direction(&self) -> (DoubleDouble, DoubleDouble) {
        let Place { sin_theta, cos_theta, half_tan, rest, inverse, up } = self.place;
        let along = cos_theta.times(rest).sub_smaller(sin_theta.times_double(half_tan + half_tan));
        let (sin, cos) = (up.times(inverse), along.times(inverse));
        let step = self.step.angle;
        let half_square = 0.5 * step * step;
        let sin_change = step * cos.hi - half_square * sin.hi;
        let cos_change = step * -sin.hi - half_square * cos.hi;
        (fast_two_sum(sin.hi, sin.lo + sin_change), fast_two_sum(cos.hi, cos.lo + cos_change))
    }

    /// The launch.
    #[inline(always)]
    pub fn launch(&self) -> Launch {
        let (sin, cos) = self.direction();
        Launch::new(sin, DoubleDouble::select(self.right, cos, cos.neg()), self.epsilon)
    }

    /// `r̃ = x / cos θ = sin α (cos α / cos θ) / (1 + u)`
    #[inline(always)]
    fn radius(&self) -> Number {
        let (sin, cos) = self.direction();
        let q = q_without_one_rest(sin, self.epsilon);
        sin.times(cos).quotient(q.times_double(self.place.cos_theta.hi))
    }
}

/// Launch angle α in [0, π] of the shot whose apex is seen at elevation θ: the inverse of [Eq. 10].
///
/// θ ≤ α ≤ arctan(2 tan θ) for θ ≤ π/2: the upper end without drag, the lower one as ε → ∞.
#[inline(always)]
pub fn locus_launch_angle(theta: Number, eps: Number) -> Number {
    let Scaled { angle, epsilon, back } = Scaled::new(theta, eps);
    within_domain(theta, eps, Elevated::new(angle, epsilon, Digits::Enough).launch_angle() * back)
}

/// Distance r̃(θ) of the locus from the launch point, in V₀²/g.  [Eq. 13]
///
/// Without drag `2 sin θ / (1 + 3 sin²θ)` [Eq. 15].
#[inline(always)]
pub fn locus_radius(theta: Number, eps: Number) -> Number {
    let Scaled { angle, epsilon, back } = Scaled::new(theta, eps);
    within_domain(theta, eps, Elevated::new(angle, epsilon, Digits::More).radius() * back)
}

/// `locus_launch_angle` without what only angles next to 0 and to π need; ∞ for them, and outside the
/// domain.
#[allow(dead_code, reason = "for dispatch alone, which not every build has")]
#[inline(always)]
pub(crate) fn locus_launch_angle_ordinary(theta: Number, eps: Number) -> Number {
    let value = Elevated::new(theta, eps, Digits::Enough).launch_angle();
    if_ordinary(theta, eps, f64::MAX, value)
}

/// `locus_radius`, as `locus_launch_angle_ordinary`.
#[allow(dead_code, reason = "for dispatch alone, which not every build has")]
#[inline(always)]
pub(crate) fn locus_radius_ordinary(theta: Number, eps: Number) -> Number {
    let value = Elevated::new(theta, eps, Digits::More).radius();
    if_ordinary(theta, eps, f64::MAX, value)
}

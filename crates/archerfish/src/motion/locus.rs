//! The locus by elevation: the inverse of equation (10), and equation (13).
//!
//! Method: write α = θ + β, 0 ≤ β < 0.34. As tan θ = G(u) tan α,
//! `sin β = (1 − G(u)) cos θ sin α` with u = ε sin α.
//!
//! First g = G(u) itself is found to 2⁻²¹ in ordinary arithmetic, from
//! `g = G(ε sin θ / √(sin²θ + g² cos²θ))`, whose right side hardly depends on g (a rational
//! guess, then two Newton steps). That gives β₀ from
//! `tan β = (1 − g) sin θ cos θ / (g cos²θ + sin²θ)`. One Halley step on the equation for β, its
//! residual in sums of two doubles, leaves an error far below the last digit; θ + β rounds once.

use super::drag::Drag;
use super::launch::{Launch, Scaled, within_domain};
use crate::real::double_double::{DoubleDouble, fast_two_sum, two_sum};
use crate::real::{atan, select, sin_cos_extended, sqrt};

/// The launch that has its apex at a given elevation.
pub(crate) struct Solution {
    pub launch: Launch,
    /// α in [0, π]
    pub launch_angle: f64,
}

/// Solves equation (10) for the launch, given the elevation θ of its apex in [0, π].
#[inline(always)]
pub(crate) fn launch_at_elevation(theta: f64, epsilon: f64) -> Solution {
    let (sin_theta, cos_signed) = sin_cos_extended(theta);
    let mirrored = cos_signed.hi < 0.0;
    let cos_theta = DoubleDouble::select(mirrored, cos_signed.neg(), cos_signed);

    let beta = starting_beta(sin_theta.hi, cos_theta.hi, epsilon);
    let (sin_beta, cos_beta) = sin_cos_extended(beta);
    let sin = sin_theta.mul(cos_beta).add(cos_theta.mul(sin_beta));
    let cos = cos_theta.mul(cos_beta).sub(sin_theta.mul(sin_beta));
    let drag = Drag::at(sin.mul_double(epsilon));

    // residual F of sin β = (1 − G) cos θ sin α and its derivatives by β
    let rest = drag.gain_rest();
    let residual = rest.mul(cos_theta).mul(sin).sub(sin_beta);
    let (s, c, a) = (sin.hi, cos.hi, drag.a.hi);
    let first = cos_theta.hi * c * (rest.hi - a) - cos_beta.hi;
    let (sigma, sigma_rest) = (drag.sigma.hi, drag.sigma_rest.hi);
    // dG/dα = cos α g1, da/dα = cos α a1
    let b = 0.5 * epsilon * sigma_rest * sigma_rest;
    let g1 = b * drag.rho.hi;
    let a1 = b * (1.0 / (1.0 + sigma) - (1.0 + sigma_rest) * drag.rho.hi);
    let second = sin_beta.hi - cos_theta.hi * (s * (rest.hi - a) + c * c * (g1 + a1));
    let newton = -residual.round() / first;
    let step = newton / (1.0 + 0.5 * newton * second / first);

    let half_square = 0.5 * step * step;
    let turn = |along: DoubleDouble, across: DoubleDouble| {
        let change =
            step * across.hi - half_square * along.hi - half_square * step / 3.0 * across.hi;
        fast_two_sum(along.hi, along.lo + change)
    };
    let (sin, cos) = (turn(sin, cos), turn(cos, sin.neg()));
    let cos = DoubleDouble::select(mirrored, cos.neg(), cos);
    let sign = select(mirrored, -1.0, 1.0);
    let sum = two_sum(theta, sign * beta);
    Solution {
        launch: Launch::new(sin, cos, epsilon),
        launch_angle: sum.hi + (sum.lo + sign * step),
    }
}

/// β to 2⁻²¹ or so.
#[inline(always)]
fn starting_beta(sin_theta: f64, cos_theta: f64, epsilon: f64) -> f64 {
    let (sin2, cos2) = (sin_theta * sin_theta, cos_theta * cos_theta);
    // u as a function of g
    let at = |g: f64| epsilon * (sin_theta / sqrt(sin2 + g * g * cos2));
    let u = at(0.7);
    let mut g = 1.0 - 1.5 / (3.0 + u);
    for _ in 0..2 {
        let drag = Drag::at(DoubleDouble::from(at(g)));
        // d/dg of G(u(g)) = −a g cos²θ / (sin²θ + g² cos²θ)
        let slope = drag.a.hi * g * cos2 / (sin2 + g * g * cos2);
        g += (drag.gain().hi - g) / (1.0 + slope);
    }
    atan((1.0 - g) * sin_theta * cos_theta / (g * cos2 + sin2))
}

/// Launch angle α in [0, π] of the shot whose apex is seen at elevation θ: the inverse of [Eq. 10].
///
/// θ ≤ α ≤ arctan(2 tan θ) for θ ≤ π/2: the upper end without drag, the lower one as ε → ∞.
#[inline(always)]
pub fn locus_launch_angle(theta: f64, eps: f64) -> f64 {
    let Scaled { angle, epsilon, back } = Scaled::new(theta, eps);
    within_domain(theta, eps, launch_at_elevation(angle, epsilon).launch_angle * back)
}

/// Distance r̃(θ) of the locus from the launch point, in V₀²/g.  [Eq. 13]
///
/// Without drag `2 sin θ / (1 + 3 sin²θ)` [Eq. 15].
#[inline(always)]
pub fn locus_radius(theta: f64, eps: f64) -> f64 {
    let Scaled { angle, epsilon, back } = Scaled::new(theta, eps);
    let radius = launch_at_elevation(angle, epsilon).launch.distance().round();
    within_domain(theta, eps, radius * back)
}

//! The locus by elevation: the inverse of equation (10), and equation (13).
//!
//! Method: write α = θ + β, 0 ≤ β < 0.34. As tan θ = G(u) tan α,
//! `sin β = (1 − G(u)) cos θ sin α` with u = ε sin α.
//!
//! First g = G(u) itself is found to 2⁻¹⁵ in ordinary arithmetic, from
//! `g = G(ε sin θ / √(sin²θ + g² cos²θ))`, whose right side hardly depends on g: one evaluation at
//! g = 0.7, then one Newton step, on rational approximations of G. That gives β₀ from
//! `tan β = (1 − g) sin θ cos θ / (g cos²θ + sin²θ)`. One step of fourth order on the equation for
//! β leaves an error far below the last digit, and θ + β is rounded once.

use super::super::real::double_double::{DoubleDouble, fast_two_sum, two_sum};
use super::super::real::{polynomial, select, sin_cos_reduced, sin_cos_upper, sqrt};
use super::drag::Drag;
use super::launch::{Launch, Scaled, within_domain};

// rough_gain: 0.95 of the error that can be borne: reference/coefficients.py rough_gain
const ROUGH_GAIN_TOP: [f64; 6] =
    [0.9999854613, 2849.150185, 510845.0506, 10432954.1, 26136751.73, 3135269.465];
const ROUGH_GAIN_BOTTOM: [f64; 6] =
    [1.0, 2857.938493, 526359.114, 12103264.36, 44542692.67, 23259829.02];
// rougher_gain: 0.79 of the error that can be borne: reference/coefficients.py rougher_gain
const ROUGHER_GAIN_TOP: [f64; 3] = [0.9984534505, 23.32839793, 10.33700643];
const ROUGHER_GAIN_BOTTOM: [f64; 3] = [1.0, 27.46378559, 40.64950412];
// rough_gain_slope: least squares, error 3.2e-05: reference/coefficients.py rough_gain_slope
const ROUGH_GAIN_SLOPE: [f64; 7] = [
    2.986460714e-06,
    7.810098246,
    12667.11828,
    1159012.716,
    7979813.174,
    -6034042.518,
    -3118251.951,
];
// rough_atan: minimax on [0.0, 0.1251], degree 4,
// weighted error 4.02e-9: reference/coefficients.py rough_atan
const ROUGH_ATAN: [f64; 5] = [
    0.9999999959832305,
    -0.3333316938899209,
    0.19989272785261564,
    -0.14037643445334563,
    0.08704472724246974,
];

/// The shot whose apex is seen at a given elevation.
pub(crate) struct Elevated {
    pub sin_theta: DoubleDouble,
    /// |cos θ|
    cos_theta: DoubleDouble,
    /// sin α and |cos α|
    sin: DoubleDouble,
    cos: DoubleDouble,
    epsilon: f64,
    /// whether θ > π/2
    mirrored: bool,
    theta: f64,
    beta: f64,
    step: f64,
}

impl Elevated {
    /// Solves equation (10) for the launch, given the elevation θ of its apex in [0, π].
    #[inline(always)]
    pub fn new(theta: f64, epsilon: f64) -> Self {
        let (sin_theta, cos_theta) = sin_cos_upper(theta);
        let mirrored = cos_theta.hi < 0.0;
        let cos_theta = DoubleDouble::select(mirrored, cos_theta.neg(), cos_theta);

        let beta = rough_beta(sin_theta.hi, cos_theta.hi, epsilon);
        let (sin_beta, cos_beta) = sin_cos_reduced(DoubleDouble::from(beta));
        let sin = sin_theta.times(cos_beta).add_smaller(cos_theta.times(sin_beta));
        let cos = cos_theta.times(cos_beta).sub_smaller(sin_theta.times(sin_beta));
        let launch = Launch::new(sin, cos, epsilon);
        let step = step(&launch, cos_theta, sin_beta, cos_beta.hi);

        let half_square = 0.5 * step * step;
        let turn = |along: DoubleDouble, across: DoubleDouble| {
            let cube = half_square * step * (1.0 / 3.0);
            let change = step * across.hi - half_square * along.hi - cube * across.hi;
            fast_two_sum(along.hi, along.lo + change)
        };
        let (sin, cos) = (turn(sin, cos), turn(cos, sin.neg()));
        Elevated { sin_theta, cos_theta, sin, cos, epsilon, mirrored, theta, beta, step }
    }

    /// The launch.
    #[inline(always)]
    pub fn launch(&self) -> Launch {
        let cos = DoubleDouble::select(self.mirrored, self.cos.neg(), self.cos);
        Launch::new(self.sin, cos, self.epsilon)
    }

    /// α in [0, π]
    #[inline(always)]
    pub fn launch_angle(&self) -> f64 {
        let sign = select(self.mirrored, -1.0, 1.0);
        let sum = two_sum(self.theta, sign * self.beta);
        sum.hi + (sum.lo + sign * self.step)
    }

    /// `cos α / cos θ`, which is √(cos²α + G² sin²α)
    #[inline(always)]
    pub fn cos_ratio(&self) -> DoubleDouble {
        self.cos.div(self.cos_theta)
    }

    /// `r̃ = x / cos θ = sin α (cos α / cos θ) / (1 + u)`
    #[inline(always)]
    fn radius(&self) -> f64 {
        let q = self.sin.times_double(self.epsilon).add_positive(1.0);
        self.sin.times(self.cos).quotient(q.mul(self.cos_theta))
    }
}

/// β to 2⁻¹⁵ or better.
#[inline(always)]
fn rough_beta(sin_theta: f64, cos_theta: f64, epsilon: f64) -> f64 {
    let (sin2, cos2) = (sin_theta * sin_theta, cos_theta * cos_theta);
    let v = epsilon * sin_theta;
    // u = v/√(sin²θ + g² cos²θ), as 1/(1 + u)
    let root = sqrt(sin2 + 0.49 * cos2);
    let x = root / (root + v);
    let g = polynomial(x, &ROUGHER_GAIN_TOP) / polynomial(x, &ROUGHER_GAIN_BOTTOM);
    let stretch = sin2 + g * g * cos2;
    let root = sqrt(stretch);
    let x = root / (root + v);
    let bottom = polynomial(x, &ROUGH_GAIN_BOTTOM);
    let gain = polynomial(x, &ROUGH_GAIN_TOP);
    let slope = polynomial(x, &ROUGH_GAIN_SLOPE);
    // d/dg of G(u(g)) is −a g cos²θ / (sin²θ + g² cos²θ); gain and slope carry the same bottom
    let g = g + (gain - g * bottom) * stretch / (bottom * stretch + slope * (g * cos2));
    let tan = (1.0 - g) * (sin_theta * cos_theta) / (g * cos2 + sin2);
    tan * polynomial(tan * tan, &ROUGH_ATAN)
}

/// The step from β to the root of `F(β) = cos θ sin α (1 − G) − sin β`, α = θ + β, of fourth order.
///
/// On functions of u, u d/du is tan α d/dα; with e = u da/du and h = u de/du that gives the
/// derivatives of sin α (1 − G). They grow with 1/sin α and 1/sin²α, the step shrinks with sin α: it
/// is computed in units of sin α.
#[inline(always)]
fn step(launch: &Launch, cos_theta: DoubleDouble, sin_beta: DoubleDouble, cos_beta: f64) -> f64 {
    let drag = Drag::<f64>::at(launch.u);
    let Drag { sigma, sigma_rest, rho, a } = drag;
    // 1 − G is (1 + (1 + u) a)/(2 + u)
    let rest = fast_two_sum(1.0, (1.0 + launch.u.round()) * a);
    let product = cos_theta.times(launch.sin).times(rest).div(launch.q_plus_one());
    let value = (product.hi - sin_beta.hi) + (product.lo - sin_beta.lo);
    let rest = drag.gain_rest();
    let (cos_theta, sin, cos) = (cos_theta.hi, launch.sin.hi, launch.cos.hi);
    // a, e and h are spread times ρ and these
    let spread = sigma * sigma_rest;
    let inverse = 1.0 / (1.0 + sigma);
    let e = inverse - (1.0 + sigma_rest) * rho;
    let h = (1.0 - 2.0 * sigma) * e + spread * (rho - inverse * inverse)
        - (1.0 + sigma_rest) * (inverse - 3.0 * sigma_rest * rho);

    let (sin2, cos2) = (sin * sin, cos * cos);
    let bend = spread * (rho + e);
    let first = cos_theta * cos * (rest - a) - cos_beta;
    let second = sin * sin_beta.hi - cos_theta * (sin2 * (rest - a) + cos2 * bend);
    let third = sin2 * cos_beta
        - cos_theta * cos * (sin2 * ((rest - a) - 3.0 * bend) - cos2 * (spread * (rho - h)));
    let inverse = 1.0 / first;
    let t = -value / select(sin > 0.0, sin, 1.0) * inverse;
    let quadratic = 0.5 * second * inverse;
    let cubic = (1.0 / 6.0) * third * inverse;
    sin * (t - t * t * (quadratic - t * (2.0 * quadratic * quadratic - cubic)))
}

/// Launch angle α in [0, π] of the shot whose apex is seen at elevation θ: the inverse of [Eq. 10].
///
/// θ ≤ α ≤ arctan(2 tan θ) for θ ≤ π/2: the upper end without drag, the lower one as ε → ∞.
#[inline(always)]
pub fn locus_launch_angle(theta: f64, eps: f64) -> f64 {
    let Scaled { angle, epsilon, back } = Scaled::new(theta, eps);
    within_domain(theta, eps, Elevated::new(angle, epsilon).launch_angle() * back)
}

/// Distance r̃(θ) of the locus from the launch point, in V₀²/g.  [Eq. 13]
///
/// Without drag `2 sin θ / (1 + 3 sin²θ)` [Eq. 15].
#[inline(always)]
pub fn locus_radius(theta: f64, eps: f64) -> f64 {
    let Scaled { angle, epsilon, back } = Scaled::new(theta, eps);
    within_domain(theta, eps, Elevated::new(angle, epsilon).radius() * back)
}

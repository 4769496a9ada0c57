//! A guess of the locus: τ, the tangent of what the launch is above the elevation of its apex.
//!
//! Method: g = G(u) solves `g = G(ε sin θ / √(sin²θ + g² cos²θ))`; then `τ = (1 − g) sin θ cos θ/(g cos²θ +
//! sin²θ)`. A first g, to 2⁻⁹, and one Newton step, on rational approximations of G; all in single
//! precision, which is half the work, and with divisions and a root that take a third of the time
//! (bench/NOTES.md, "Half the width"). It is a chain of results that wait for each other, and comes in
//! three parts that end with a division each, for others to compute something else between them.

use super::super::real::{Narrow, Number, Single, greater, lesser, polynomial, sqrt_single};

// rough_gain: 0.82 of the error that can be borne: reference/coefficients.py rough_gain
const ROUGH_GAIN_TOP: [f32; 5] = [1.0000031, 44.774776, 251.60535, 167.03201, -18.256607];
const ROUGH_GAIN_BOTTOM: [f32; 5] = [1.0, 44.78367, 260.84412, 362.00372, 223.68513];
// rougher_gain: 0.79 of the error that can be borne: reference/coefficients.py rougher_gain
const ROUGHER_GAIN_TOP: [f32; 3] = [0.99845344, 23.328398, 10.337007];
const ROUGHER_GAIN_BOTTOM: [f32; 3] = [1.0, 27.463785, 40.649506];
// stretch_root: 0.61 of the error that can be borne: reference/coefficients.py stretch_root
const STRETCH_ROOT_TOP: [f32; 3] = [0.13728783, 2.870998, 2.8284287];
const STRETCH_ROOT_BOTTOM: [f32; 3] = [1.0, 4.060205, 0.77661794];
// rough_sinc: minimax on [0.0, 2.4675], degree 3,
// weighted error 7.54e-7: reference/coefficients.py rough_sinc
const ROUGH_SINC: [f32; 4] = [0.9999992, -0.16665682, 0.008313257, -0.00018524306];
// rough_root: least greatest error, error 0.002: reference/coefficients.py rough_root
const ROUGH_ROOT: [f32; 3] = [0.46431735, 0.014176948, 0.3340497];

/// Between them G differs from its limits by what is seen here, and all powers of v are in the range of single
/// precision.
const LEAST: f64 = 1e-30;
const MOST: f64 = 1e9;

/// The first g.
#[derive(Clone, Copy)]
pub(super) struct Guess {
    /// `ε sin θ`
    v: Single,
    sin2: Single,
    cos2: Single,
    g: Single,
}

/// The same, and where G is to be taken next.
pub(super) struct GuessWithRoot {
    guess: Guess,
    /// `sin²θ + g² cos²θ`
    stretch: Single,
    /// `1/√(1 + u)`
    x: Single,
}

/// `c₀ x² + c₁ x y + c₂ y²`
#[inline(always)]
fn quadratic_form(c: &[f32; 3], x: Single, y: Single) -> Single {
    (c[0] * x + c[1] * y) * x + c[2] * (y * y)
}

impl Guess {
    /// For θ in [0, π/2].
    #[inline(always)]
    pub fn new(theta: Number, epsilon: Number) -> Self {
        let v = greater(LEAST, lesser(MOST, epsilon * theta)).narrow();
        let theta = theta.narrow();
        let sinc = polynomial(theta * theta, &ROUGH_SINC);
        let (v, sin) = (v * sinc, theta * sinc);
        let sin2 = sin * sin;
        let cos2 = 1.0 - sin2;

        // u = v/√stretch is nearly `v scale/root`
        let scale = 1.0 + ROUGH_ROOT[2] * v;
        let root = scale - (ROUGH_ROOT[0] + ROUGH_ROOT[1] * v) * cos2;
        let whole = root + v * scale;
        let g = quadratic_form(&ROUGHER_GAIN_TOP, whole, root)
            / quadratic_form(&ROUGHER_GAIN_BOTTOM, whole, root);
        Guess { v, sin2, cos2, g }
    }

    #[inline(always)]
    pub fn with_root(self) -> GuessWithRoot {
        let Guess { v, sin2, cos2, g } = self;
        let stretch = sin2 + g * g * cos2;
        // its root is a quotient too, so that x takes one division and one root
        let square = stretch * stretch;
        let over =
            (STRETCH_ROOT_TOP[0] + STRETCH_ROOT_TOP[1] * stretch) + STRETCH_ROOT_TOP[2] * square;
        let under = (1.0 + STRETCH_ROOT_BOTTOM[1] * stretch) + STRETCH_ROOT_BOTTOM[2] * square;
        let x = sqrt_single(over / (over + v * under));
        GuessWithRoot { guess: self, stretch, x }
    }
}

impl GuessWithRoot {
    /// `τ/(sin θ cos θ)`, such that θ + arctan τ is the launch angle to 2⁻¹⁷ of its sine or better.
    #[inline(always)]
    pub fn tan_by_slant(self) -> Number {
        let GuessWithRoot { guess: Guess { sin2, cos2, g, .. }, stretch, x } = self;
        let bottom = polynomial(x, &ROUGH_GAIN_BOTTOM);
        let top = polynomial(x, &ROUGH_GAIN_TOP);
        // u G′(u) = 1 − G (2 + u)/(1 + u); both carry the same bottom, and g the one that the step divides by
        let slope = bottom - top * (1.0 + x * x);
        let divisor = bottom * stretch + slope * (g * cos2);
        let g = g * divisor + (top - g * bottom) * stretch;
        Number::widen((divisor - g) / (g * cos2 + divisor * sin2))
    }
}

//! The lower branch, W ≤ −1.
//!
//! Method: w₀ = −1 + η R(η), η = √(−1 − ln(−z)), which is smooth even at the branch point, and one
//! step. The offset form has a series next to the branch point.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{Number, Order, polynomial_by, select, sqrt, times_power};
use super::branch::{INVERSE_E, NEAR, at_offset, lower_near};
use super::start::lower_logarithm;
use super::step::{corrected, one_plus_corrected, shifted_exponent};

// lower_start: 0.04 of the error that can be borne: reference/coefficients.py lower_start
const LOWER_START_TOP: [f64; 5] =
    [-162.9876242, -202.3218366, -96.82528763, -20.35772808, -0.9998057314];
const LOWER_START_BOTTOM: [f64; 4] = [115.2514689, 88.70729572, 20.32112868, 1.0];

/// z is as small as 2⁻¹⁰⁷⁴ where e^{−w} is as great as 2¹⁰⁸⁵: it is taken −2⁶⁴ times as large.
const LIFT: f64 = 64.0;
const LIFTED: f64 = -18446744073709551616.0;

/// W₋₁ to few digits, given −2⁶⁴ z for z in [−1/e, −5e-324], and z + 1/e.
#[inline(always)]
fn start(lifted: Number, offset: Number) -> Number {
    let square = lower_logarithm(lifted, LIFT, offset);
    let eta = sqrt(square);
    let top = polynomial_by(eta, square, &LOWER_START_TOP);
    eta * (top / polynomial_by(eta, square, &LOWER_START_BOTTOM)) - 1.0
}

/// Lambert W on the lower branch, W₋₁(z): the w ≤ −1 with `w eʷ = z`.
///
/// z in [−1/e, 0], NaN outside; −∞ at 0; the double nearest −1/e counts as the branch point and
/// gives −1.
#[inline(always)]
pub fn lambertwm1(z: Number) -> Number {
    let lifted = z * LIFTED;
    let w = start(lifted, (z + INVERSE_E.hi) + INVERSE_E.lo);
    let above = 1.0 + w;
    let shifted = shifted_exponent(above);
    let scaled = lifted * times_power(Number::from(1.0 / LIFTED), shifted);
    let regular = corrected(w, above, shifted, scaled);
    let regular = select(z.equals(0.0), f64::NEG_INFINITY, regular);
    // below and above its domain, and at the branch point, the root is that of a negative number
    select(regular.is_nan(), select(z.equals(-INVERSE_E.hi), -1.0, f64::NAN), regular)
}

/// `1 + W₋₁(−1/e + d)`, exact in d: like −√(2ed) for small d.
///
/// d in [0, 1/e], NaN outside; the double nearest 1/e counts as 1/e and gives −∞.
#[inline(always)]
pub fn lambertwm1_offset(d: Number) -> Number {
    let z = at_offset(d);
    let w = start(z.hi * LIFTED, d);
    let near = lower_near(DoubleDouble::from(d));
    let far = one_plus_corrected(z, w, LIFT);
    let regular = select(d.is_below(NEAR), near.round(), far);
    let regular = select(d.equals(INVERSE_E.hi), f64::NEG_INFINITY, regular);
    select(d.is_at_least(0.0) & d.is_at_most(INVERSE_E.hi), regular, f64::NAN)
}

//! The lower branch, W ≤ −1.
//!
//! Method: near the branch point its series; elsewhere −w₀ = 1 + η R(η), η = √(2(−1 − ln(−z))),
//! which is smooth even at the branch point, and one step.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{Number, Order, polynomial, select, sqrt};
use super::branch::{CLOSE, INVERSE_E, NEAR, at_offset, lower_close, lower_near, square};
use super::step::{correction, one_plus_corrected, rough_ln};

// lower_start: 0.35 of the error that can be borne: reference/coefficients.py lower_start
const LOWER_START_TOP: [f64; 5] =
    [0.9995551148, 1.535071764, 0.6231421455, 0.09941005262, 0.0002127198227];
const LOWER_START_BOTTOM: [f64; 5] =
    [1.0, 1.199183553, 0.1995972682, 0.0004137939309, 7.849663027e-08];

/// z is as small as 2⁻¹⁰⁷⁴ where e^{−w} is as great as 2¹⁰⁸⁵: it is taken 2⁶⁴ times as large.
const LIFT: f64 = 64.0;
const LIFTED: f64 = 18446744073709551616.0;

/// η², given 2⁶⁴ z for z in [−0.3606, −5e-324], to few digits; below zero for a positive z.
#[inline(always)]
fn eta_square(lifted: Number) -> Number {
    -2.0 * (rough_ln(-lifted) - (LIFT * core::f64::consts::LN_2 - 1.0))
}

/// W₋₁ to few digits, given η.
#[inline(always)]
fn start(eta: Number) -> Number {
    let quotient = polynomial(eta, &LOWER_START_TOP) / polynomial(eta, &LOWER_START_BOTTOM);
    -1.0 - eta * quotient
}

/// Lambert W on the lower branch, W₋₁(z): the w ≤ −1 with `w eʷ = z`.
///
/// z in [−1/e, 0], NaN outside; −∞ at 0; the double nearest −1/e counts as the branch point and
/// gives −1.
#[inline(always)]
pub fn lambertwm1(z: Number) -> Number {
    let lifted = z * LIFTED;
    let offset = (z + INVERSE_E.hi) + INVERSE_E.lo;
    let close = offset.is_below(CLOSE);
    // one square root for −p or η; NaN for z > 0
    let root = sqrt(select(close, square(offset), eta_square(lifted)));
    let w = start(root);
    // here, while the division of the start is under way (bench/NOTES.md, "Order")
    let near = lower_close(-root);
    let far = w + correction(lifted, w, LIFT);
    let regular = select(close, near, far);
    let regular = select(z.equals(0.0), f64::NEG_INFINITY, regular);
    select(z.is_at_least(-INVERSE_E.hi), regular, f64::NAN)
}

/// `1 + W₋₁(−1/e + d)`, exact in d: like −√(2ed) for small d.
///
/// d in [0, 1/e], NaN outside; the double nearest 1/e counts as 1/e and gives −∞.
#[inline(always)]
pub fn lambertwm1_offset(d: Number) -> Number {
    let z = at_offset(d);
    let w = start(sqrt(eta_square(z.hi * LIFTED)));
    let near = lower_near(DoubleDouble::from(d));
    let far = one_plus_corrected(z, w, LIFT);
    let regular = select(d.is_below(NEAR), near.round(), far);
    let regular = select(d.equals(INVERSE_E.hi), f64::NEG_INFINITY, regular);
    select(d.is_at_least(0.0) & d.is_at_most(INVERSE_E.hi), regular, f64::NAN)
}

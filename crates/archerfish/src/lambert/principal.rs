//! The principal branch, W ≥ −1.
//!
//! Method: near the branch point its series; elsewhere w₀ = ln(1+z) R(y),
//! y = √(ln(1+z) − ln(1 − 1/e)), which is smooth even at the branch point, and one step.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{Number, Order, polynomial, select, sqrt};
use super::branch::{CLOSE, INVERSE_E, NEAR, at_offset, principal_close, principal_near, square};
use super::step::{correction, one_plus_corrected, rough_ln_1p};

// principal_start: 0.09 of the error that can be borne: reference/coefficients.py principal_start
const PRINCIPAL_START_TOP: [f64; 8] = [
    2.179748376,
    -0.2294353813,
    0.7652975496,
    -0.2540921441,
    0.3593788241,
    -0.104256673,
    0.03504858493,
    0.00612627332,
];
const PRINCIPAL_START_BOTTOM: [f64; 8] = [
    1.0,
    1.744127204,
    0.2954763167,
    -0.05067542236,
    0.3079657516,
    -0.0607962086,
    0.0353382365,
    0.006124732064,
];

/// −ln(1 − 1/e)
const END: f64 = 0.45867514538708193;

/// W₀ to few digits, for z ≥ −0.3606, given ln(1+z) and y.
#[inline(always)]
fn start(logarithm: Number, y: Number) -> Number {
    let quotient = polynomial(y, &PRINCIPAL_START_TOP) / polynomial(y, &PRINCIPAL_START_BOTTOM);
    logarithm * quotient
}

/// Lambert W on the principal branch, W₀(z): the w ≥ −1 with `w eʷ = z`.
///
/// z ≥ −1/e, below it NaN; the double nearest −1/e counts as the branch point and gives −1.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub fn lambertw0(z: Number) -> Number {
    let offset = (z + INVERSE_E.hi) + INVERSE_E.lo;
    let close = offset.is_below(CLOSE);
    let logarithm = rough_ln_1p(z);
    // one square root for p or y
    let root = sqrt(select(close, square(offset), logarithm + END));
    let w = start(logarithm, root);
    // here, while the division of the start is under way (bench/NOTES.md, "Order")
    let near = principal_close(root);
    let far = w + correction(z, w, 0.0);
    // −0 where z is
    let regular = select(close, near, far).copysign(z);
    // (`== ∞` the compiler makes a test of bits, in more instructions)
    let regular = select(z.is_above(f64::MAX), z, regular);
    select(z.is_at_least(-INVERSE_E.hi), regular, f64::NAN)
}

/// `1 + W₀(−1/e + d)`, exact in d: like √(2ed) for small d.
///
/// d ≥ 0, below it NaN.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub fn lambertw0_offset(d: Number) -> Number {
    let z = at_offset(d);
    let logarithm = rough_ln_1p(z.hi);
    let w = start(logarithm, sqrt(logarithm + END));
    let near = principal_near(DoubleDouble::from(d));
    let far = one_plus_corrected(z, w, 0.0);
    let regular = select(d.is_below(NEAR), near.round(), far);
    let regular = select(d.equals(f64::INFINITY), d, regular);
    select(d.is_at_least(0.0), regular, f64::NAN)
}

/// The tree function, `T(z) = −W₀(−z)`.  [Eq. 14]
///
/// z ≤ 1/e, above it NaN; the double nearest 1/e counts as 1/e and gives 1.
#[inline(always)]
pub fn tree(z: Number) -> Number {
    -lambertw0(-z)
}

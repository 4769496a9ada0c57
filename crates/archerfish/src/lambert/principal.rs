//! The principal branch, W ≥ −1.
//!
//! Method: w₀ = ln(1+z) (1 + R(y)), y = √(ln(1+z) − ln(1 − 1/e)), which is smooth even at the branch
//! point, and one step. The offset form has a series next to the branch point.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{Number, Order, polynomial_by, select, sqrt, times_power};
use super::branch::{INVERSE_E, NEAR, at_offset, principal_near};
use super::start::principal_logarithms;
use super::step::{corrected, one_plus_corrected, shifted_exponent};

// principal_start: 0.25 of the error that can be borne: reference/coefficients.py principal_start
const PRINCIPAL_START_TOP: [f64; 7] = [
    304.58852848150946,
    -447.7719947,
    -3.133592681,
    13.99059586,
    -14.77832944,
    -8.231164637,
    -0.02323499656,
];
const PRINCIPAL_START_BOTTOM: [f64; 8] = [
    258.0838223,
    504.4391639,
    139.4163163,
    -4.996805384,
    80.55241104,
    -10.62345969,
    11.76634919,
    1.0,
];

/// 1 + W₀ to few digits, for z ≥ −1/e, given z and z + 1/e.
#[inline(always)]
fn start(z: Number, offset: Number) -> Number {
    let (logarithm, square) = principal_logarithms(z, offset);
    let y = sqrt(square);
    let top = polynomial_by(y, square, &PRINCIPAL_START_TOP);
    let excess = top / polynomial_by(y, square, &PRINCIPAL_START_BOTTOM);
    // no finer than 2⁻⁵¹
    ((3.0 + logarithm) + logarithm * excess) - 2.0
}

/// Lambert W on the principal branch, W₀(z): the w ≥ −1 with `w eʷ = z`.
///
/// z ≥ −1/e, below it NaN; the double nearest −1/e counts as the branch point and gives −1.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub fn lambertw0(z: Number) -> Number {
    let above = start(z, (z + INVERSE_E.hi) + INVERSE_E.lo);
    // next to nothing its square tells, and −0 is where z is; here, while a division is under way
    let square = z * z;
    let next = z - square;
    let shifted = shifted_exponent(above);
    let regular = corrected(above - 1.0, above, shifted, times_power(z, shifted));
    let regular = select(square.is_below(1e-24), next, regular);
    // (`== ∞` the compiler makes a test of bits, in more instructions)
    let regular = select(z.is_above(f64::MAX), z, regular);
    let special = select(z.equals(-INVERSE_E.hi), -1.0, f64::NAN);
    select(z.is_above(-INVERSE_E.hi), regular, special)
}

/// `1 + W₀(−1/e + d)`, exact in d: like √(2ed) for small d.
///
/// d ≥ 0, below it NaN.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub fn lambertw0_offset(d: Number) -> Number {
    let z = at_offset(d);
    let above = start(z.hi, d);
    let near = principal_near(DoubleDouble::from(d));
    let far = one_plus_corrected(z, above - 1.0, 0.0);
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

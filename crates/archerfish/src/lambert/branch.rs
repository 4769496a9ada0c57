//! 1 + W on both branches near their common point z = −1/e, W = −1, to its own last digit.
//!
//! Method: with `p = ±√(2(1 + ez))`, + on the principal branch, 1 + W is the analytic function
//! `v = p − p²/3 + 11p³/72 − …` of p, carried in two doubles. The offset δ = z + 1/e is what keeps the
//! digits.

use super::super::real::double_double::{DoubleDouble, fast_two_sum, two_sum};
use super::super::real::{Number, Order, polynomial, select};

// principal_tail: minimax on [0.0, 0.501], degree 13,
// weighted error 3.58e-18: reference/coefficients.py principal_tail
const PRINCIPAL_TAIL: [f64; 14] = [
    0.1527777777777723,
    -0.07962962962899472,
    0.04450231478539675,
    -0.025984714127409537,
    0.015635620680912708,
    -0.009616765136828732,
    0.006013585515819215,
    -0.0038060577718335435,
    0.0024197471042372016,
    -0.0015136208851403879,
    0.0008851035722127815,
    -0.0004384389435535073,
    0.00015591706565072131,
    -2.853638768609255e-05,
];
// lower_tail: minimax on [-0.501, 0.0], degree 15,
// weighted error 2.06e-18: reference/coefficients.py lower_tail
const LOWER_TAIL: [f64; 16] = [
    0.15277777777775078,
    -0.0796296296334441,
    0.04450231459902802,
    -0.02598472157672987,
    0.015635501639455974,
    -0.009618623399503687,
    0.005998304486424178,
    -0.003922434217690518,
    0.0018763580429592593,
    -0.003721574065453393,
    -0.005060594091995867,
    -0.013435693392132598,
    -0.01884808950342609,
    -0.020330165018691254,
    -0.01280549488434036,
    -0.00426457336092254,
];

/// 1/e. The nearest double is greater: what counts as the branch point lies just outside.
pub(super) const INVERSE_E: DoubleDouble =
    DoubleDouble::constant(0.36787944117144233, -1.2428753672788363e-17);
const TWO_E: DoubleDouble = DoubleDouble::constant(5.43656365691809, 2.8912937834585003e-16);
const MINUS_THIRD: DoubleDouble =
    DoubleDouble::constant(-0.3333333333333333, -1.850371707708594e-17);

/// Offsets up to which the series serve: |p| < 1/2.
pub(super) const NEAR: f64 = 0.045984;

/// `√(2eδ)`; 0 for δ ≤ 0.
#[inline(always)]
fn root(offset: DoubleDouble) -> DoubleDouble {
    // the square of a subnormal's rest would be lost: 2²⁰⁰ under the root, 2⁻¹⁰⁰ after it
    const LARGE: f64 = f64::from_bits((1023 + 200) << 52);
    const SMALL: f64 = f64::from_bits((1023 - 100) << 52);
    let tiny = offset.hi.is_below(1e-270);
    let scaled = offset.scale(select(tiny, LARGE, 1.0));
    let root = scaled.times(TWO_E).sqrt().scale(select(tiny, SMALL, 1.0));
    DoubleDouble::select(offset.hi.is_above(0.0), root, DoubleDouble::from(0.0))
}

/// `v = p − p²/3 + p³ t`
#[inline(always)]
fn series(p: DoubleDouble, tail: Number) -> DoubleDouble {
    let square = p.squared();
    let third = square.times(MINUS_THIRD);
    let sum = fast_two_sum(p.hi, third.hi);
    let small = p.lo + third.lo + square.hi * p.hi * tail;
    fast_two_sum(sum.hi, sum.lo + small)
}

/// `1 + W₀(−1/e + δ)` for δ in [0, NEAR].
#[inline(always)]
pub(super) fn principal_near(offset: DoubleDouble) -> DoubleDouble {
    let p = root(offset);
    series(p, polynomial(p.hi, &PRINCIPAL_TAIL))
}

/// `1 + W₋₁(−1/e + δ)` for δ in [0, NEAR].
#[inline(always)]
pub(super) fn lower_near(offset: DoubleDouble) -> DoubleDouble {
    let p = root(offset).neg();
    series(p, polynomial(p.hi, &LOWER_TAIL))
}

/// `z = −1/e + δ`.
#[inline(always)]
pub(super) fn at_offset(offset: Number) -> DoubleDouble {
    let z = two_sum(offset, -INVERSE_E.hi);
    fast_two_sum(z.hi, z.lo - INVERSE_E.lo)
}

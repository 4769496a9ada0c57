//! `ln(1 + x) − x`, without the cancellation near zero.
//!
//! Method: with `1 + x = 2ᵏ (1 + f)`, s = f/(2 + f) and h = f²/2,
//! `ln(1 + x) − x = (k ln 2 − x + f) − h + g + s (2s² ρ(s²) − g)`, g = h f/2 being what is left when
//! the first two terms of s are taken out of s h, `ρ(z) = (artanh(√z)/√z − 1)/z`. Where k = 0, f is x
//! and the bracket exactly zero; elsewhere nothing cancels but a few bits, which the exact errors of
//! the sums keep. 1 + f lies in [3/4, 3/2), for negative x in [0.6865, 1.373): so f is exact, and
//! where k is −1 or 1 no more than a few bits cancel.

use super::double_double::{fast_two_difference, fast_two_sum, two_product};
use super::{
    Bits, Integer, LN2_HI, LN2_LO, Number, Order, exponent_field, lesser, polynomial, select,
};

// log1pmx_tail: minimax on [0.0, 0.0401], degree 7,
// weighted error 1.11e-17: reference/coefficients.py log1pmx_tail
const LOG1PMX_TAIL: [f64; 8] = [
    0.6666666666666664,
    0.4000000000002586,
    0.2857142856244146,
    0.22222223623221649,
    0.18181702545113418,
    0.15390014071783853,
    0.13190637249344045,
    0.13735933609754403,
];

/// `ln(1 + x) − x` for an x that is neither tiny nor huge, nor −1 or below.
#[inline(always)]
fn regular(x: Number) -> Number {
    /// a little above, so that no x below 1/2 is rounded up to 3/2
    const THREE_QUARTERS: u64 = 0x3fe8_0000_0001_0000;
    /// how far below that 0.6865 is
    const LOWER: u64 = THREE_QUARTERS - 0x3fe5_f800_0000_0000;
    const ONE: u64 = 0x3ff0_0000_0000_0000;
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    let negative = x.is_below(0.0);
    let shifted = (1.0 + x).to_bits().wrapping_add(ONE - THREE_QUARTERS);
    let shifted = shifted.wrapping_add(Integer::when(negative, LOWER));
    let k = exponent_field(Number::from_bits(shifted));
    let power = shifted & EXPONENT;
    let inverse = Number::from_bits(Integer::from(2 * ONE).wrapping_sub(power));
    // exact: 2ᵏ − 1 and x are within a factor of two, or k is 0
    let f = (x - (Number::from_bits(power) - 1.0)) * inverse;
    let s = f / (2.0 + f);

    // k ln 2 and −x have opposite signs; where the second of two is the greater, the sum is exact
    let whole = k * LN2_HI;
    let below = fast_two_sum(select(negative, whole, -x), select(negative, -x, whole));
    let bracket = fast_two_sum(below.hi, f);
    let half_f = 0.5 * f;
    let half = two_product(half_f, f);
    let cubic = half.hi * half_f;
    let rest = (k * LN2_LO + (below.lo + bracket.lo)) - half.lo;
    let square = fast_two_difference(bracket.hi, half.hi);
    let sum = fast_two_sum(square.hi, cubic);

    let z = s * s;
    let small = s * (z * polynomial(z, &LOG1PMX_TAIL) - cubic);
    sum.hi + (sum.lo + ((square.lo + rest) + small))
}

/// Below this in size, the parts of x²/2 underflow before it does.
const TINY: f64 = 1e-140;
/// Above this, ln(1 + x) is nothing beside x.
const HUGE: f64 = 1e100;

/// `ln(1 + x) − x`.
#[inline(always)]
pub fn log1pmx(x: Number) -> Number {
    let value = select(x.abs().is_below(TINY), -(0.5 * x * x), regular(x));
    let value = select(x.is_above(HUGE), -x, value);
    let value = select(x.equals(-1.0), f64::NEG_INFINITY, value);
    select(x.is_at_least(-1.0), value, f64::NAN)
}

/// `log1pmx` without what only tiny and huge numbers and those up to −1 need; ∞ for them.
#[allow(dead_code, reason = "for dispatch alone, which not every build has")]
#[inline(always)]
pub(crate) fn log1pmx_ordinary(x: Number) -> Number {
    let above = 1.0 + x;
    let least = lesser(x.abs(), above);
    select(least.is_at_least(TINY) & x.is_at_most(HUGE), regular(x), f64::INFINITY)
}

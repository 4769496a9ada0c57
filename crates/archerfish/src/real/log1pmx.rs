//! `ln(1 + x) − x`, without the cancellation near zero.
//!
//! Method: with `1 + x = 2ᵏ (1 + f)`, 1 + f in [3/4, 3/2), and s = f/(2 + f),
//! `ln(1 + x) − x = (k ln 2 − x + f) − s f + 2s³ ρ(s²)`, `ρ(z) = (artanh(√z)/√z − 1)/z`. Where k = 0,
//! f is x and the bracket exactly zero; elsewhere |x| ≥ 1/4 and nothing cancels but a few bits,
//! which the exact errors of three sums keep.

use super::double_double::{DoubleDouble, fast_two_difference, fast_two_sum, two_product};
use super::{Integer, LN2_HI, LN2_LO, Number, Order, exponent_field, polynomial, select};

// log1pmx_tail: minimax on [0.0, 0.0401], degree 7,
// weighted error 1.85e-17: reference/coefficients.py log1pmx_tail
const LOG1PMX_TAIL: [f64; 8] = [
    0.3333333333333333,
    0.20000000000004028,
    0.14285714283615206,
    0.11111111527586501,
    0.09090868569856604,
    0.07694442809784058,
    0.06604692452482434,
    0.06805667795981751,
];

/// `ln(1 + x) − x`.
#[inline(always)]
pub fn log1pmx(x: Number) -> Number {
    const THREE_QUARTERS: u64 = 0x3fe8_0000_0000_0000;
    const ONE: u64 = 0x3ff0_0000_0000_0000;
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    let shifted = (1.0 + x).to_bits().wrapping_add(ONE - THREE_QUARTERS);
    let k = exponent_field(Number::from_bits(shifted));
    let power = shifted & EXPONENT;
    let inverse = Number::from_bits(Integer::from(2 * ONE).wrapping_sub(power));
    // exact: 2ᵏ − 1 and x are within a factor of two, or k is 0
    let f = (x - (Number::from_bits(power) - 1.0)) * inverse;

    let denominator = fast_two_sum(2.0, f);
    let inverse = 1.0 / denominator.hi;

    // k ln 2 and −x have opposite signs, and the negative one is the greater; the next two sums are
    // exact or of a greater and a smaller number too
    let whole = k * LN2_HI;
    let below =
        fast_two_sum(select(whole.is_below(-x), whole, -x), select(whole.is_below(-x), -x, whole));
    let bracket = fast_two_sum(below.hi, f);
    let rest = k * LN2_LO + (below.lo + bracket.lo);

    let s = DoubleDouble::from(f).div_by(denominator, inverse);
    let product = two_product(s.hi, f);
    let z = s.hi * s.hi;
    let tail = (2.0 * s.hi) * z * polynomial(z, &LOG1PMX_TAIL);

    let sum = fast_two_difference(bracket.hi, product.hi);
    // s.lo with the derivative of −s f + 2s³ρ
    let small = (tail - (product.lo + s.lo * (f - 2.0 * z))) + rest;
    let regular = sum.hi + (sum.lo + small);
    // the parts of x²/2 underflow before it does
    let regular = select(x.abs().is_below(1e-140), -(0.5 * x * x), regular);
    let regular = select(x.is_above(1e100), -x, regular);
    let regular = select(x.equals(-1.0), f64::NEG_INFINITY, regular);
    select(x.is_at_least(-1.0), regular, f64::NAN)
}

//! `ln(1 + x) − x`, without the cancellation near zero.

use super::double_double::two_sum;
use super::{LN2_HI, LN2_LO, Logarithm, select};

/// `ln(1 + x) − x`.
///
/// Method: with `1 + x = 2ᵏ (1 + f)`, `ln(1 + x) − x = (k ln 2 + f − x) + (ln(1 + f) − f)` and
/// `ln(1 + f) − f = −s f + 2s³ ρ`. Where k = 0, f is x and the first bracket is exactly zero;
/// elsewhere |x| > 0.29 and nothing cancels but a bit or two, which the second double keeps.
#[inline(always)]
pub fn log1pmx(x: f64) -> f64 {
    let logarithm = Logarithm::of(two_sum(1.0, x));
    let Logarithm { k, f, s, .. } = logarithm;
    let product = s.mul(f).neg();
    let linear = two_sum(f.hi, -x);
    let first = two_sum(k * LN2_HI, linear.hi);
    let small = logarithm.tail() + (k * LN2_LO + f.lo + linear.lo);
    let sum = two_sum(first.hi, product.hi);
    let regular = sum.hi + (sum.lo + (first.lo + (product.lo + small)));
    // the parts of x²/2 underflow before it does
    let regular = select(x.abs() < 1e-140, -(0.5 * x * x), regular);
    let regular = select(x == f64::INFINITY, f64::NEG_INFINITY, regular);
    let regular = select(x == -1.0, f64::NEG_INFINITY, regular);
    select(x >= -1.0, regular, f64::NAN)
}

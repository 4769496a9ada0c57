//! `ln(1 + x) − x`, without the cancellation near zero.
//!
//! Method: `1 + x = 2ᵏ m`, m in [1 − 1/64, 2 − 1/32), and r is near 1/m, from a table: so R = 2⁻ᵏ r is near
//! 1/(1 + x), and exactly 1 for x in [−1/64, 1/32). With f = x R − (1 − R), which is at most 1/32 in size,
//! `x − ln(1 + x) = (x − (k ln 2 − ln r)) − f + f²/2 − f³ q(f)`. Where R is 1, f is x and the bracket less
//! f exactly zero; elsewhere nothing cancels but a few bits, which the exact errors of the sums keep. There
//! is no division. r has 40 bits and is chosen such that ln r is almost a number of few bits.

use super::double_double::{
    DoubleDouble, fast_two_difference, fast_two_sum, two_difference, two_product,
};
use super::{
    LN2_HI, LN2_LO, Number, Order, Table, exponent_of_positive, lesser, look_up, polynomial, select,
};

// log_tail: minimax on [-0.0298, 0.03126], degree 7,
// weighted error 1.73e-17: reference/coefficients.py log_tail
const LOG_TAIL: [f64; 8] = [
    0.6666666666666623,
    -0.5000000000001017,
    0.40000000006532915,
    -0.3333333325914601,
    0.2857140273930991,
    -0.2500014722916857,
    0.22259804173898665,
    -0.19925955352661048,
];
// log_table: reference/coefficients.py log_table
const INVERSES: Table = [
    1.0,
    0.9411405527043826,
    0.8889489378452708,
    0.8420871858143073,
    0.7997814732452753,
    0.7619397251764894,
    0.7271917814650806,
    0.6956789095602289,
    0.6667352768590717,
    0.6400758219706404,
    0.6153771506869816,
    0.5925815168757254,
    0.5713919851541505,
    0.551644695898176,
    0.5333902886359283,
    0.5162076987890032,
];
const LOGARITHMS: Table = [
    0.0,
    0.06066278529624469,
    0.11771548286219513,
    0.17187172400258532,
    0.22341674707217862,
    0.2718878272423808,
    0.3185650377984075,
    0.3628670619350487,
    0.40536219811497176,
    0.4461686378165268,
    0.48551994598892634,
    0.5232668342114266,
    0.5596798159654099,
    0.5948511067986146,
    0.628501873931782,
    0.6612460774558713,
];
/// `INVERSES` times 2¹⁰²³, from whose bits those of a power of two may be taken.
const LIFTED_INVERSES: Table = {
    let mut lifted = INVERSES;
    let mut i = 0;
    while i < lifted.len() {
        lifted[i] *= f64::from_bits(2046 << 52);
        i += 1;
    }
    lifted
};

/// Which numbers a logarithm is for.
#[derive(Clone, Copy)]
pub(crate) enum Sign {
    /// none below zero
    Positive,
    Any,
}

/// `x − ln(1 + x)`, to 2⁻⁵⁵ of itself, hi alone to 2⁻⁵; and its slope `x/(1 + x)`, to 2⁻⁵ of itself: for
/// an x that is neither tiny nor huge, nor −1 or below.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub(crate) fn log_excess(x: Number, sign: Sign) -> (DoubleDouble, Number) {
    /// half a step of the table, in the bits of 1 + x
    const HALF_STEP: u64 = 1 << 47;
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    let shifted = (1.0 + x).to_bits().wrapping_add(HALF_STEP);
    let index = shifted >> 48;
    let k = exponent_of_positive(Number::from_bits(shifted));
    let lifted = look_up(&LIFTED_INVERSES, index).to_bits();
    let r = Number::from_bits(lifted.wrapping_sub(shifted & EXPONENT));
    let product = two_product(x, r);
    // exact, as are the sums of hi below, and 1 − R until its rounding is nothing beside x; near −1 the
    // error of the product is as great as f
    let f = product.hi - (1.0 - r);
    let DoubleDouble { hi: f, lo: rest } = match sign {
        Sign::Positive => DoubleDouble { hi: f, lo: product.lo },
        Sign::Any => fast_two_sum(f, product.lo),
    };

    let whole = k * LN2_HI + look_up(&LOGARITHMS, index);
    let below = match sign {
        Sign::Positive => fast_two_difference(x, whole),
        Sign::Any => two_difference(x, whole),
    };
    let bracket = fast_two_difference(below.hi, f);
    let half = two_product(0.5 * f, f);
    let sum = fast_two_sum(bracket.hi, half.hi);
    let f_rest = rest - f * rest;
    let cubic = half.hi * f * polynomial(f, &LOG_TAIL);
    let exact_rests = (below.lo + bracket.lo) + (sum.lo + half.lo);
    let lo = (exact_rests - (k * LN2_LO + f_rest)) - cubic;
    (DoubleDouble { hi: sum.hi, lo }, product.hi)
}

/// Below this in size, the parts of x²/2 underflow before it does.
const TINY: f64 = 1e-140;
/// Above this, ln(1 + x) is nothing beside x.
const HUGE: f64 = 1e100;

/// `ln(1 + x) − x` for such an x.
#[inline(always)]
fn regular(x: Number) -> Number {
    -log_excess(x, Sign::Any).0.round()
}

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
    let least = lesser(x.abs(), 1.0 + x);
    select(least.is_at_least(TINY) & x.is_at_most(HUGE), regular(x), f64::INFINITY)
}

//! `ln(1 + x) − x`, without the cancellation near zero.
//!
//! Method: `1 + x = 2ᵏ m`, m in [1 − 1/64, 2 − 1/32), and r, of few bits, is near 1/m, from a table:
//! so R = 2⁻ᵏ r is near 1/(1 + x), and exactly 1 for x in [−1/64, 1/32). With f = x R − (1 − R), which is
//! below 1/32 in size, `x − ln(1 + x) = (x − (k ln 2 − ln r)) − f + f²/2 − f³ q(f)`. Where R is 1, f is x
//! and the bracket less f exactly zero; elsewhere nothing cancels but a few bits, which the exact
//! errors of the sums keep. There is no division.

use super::double_double::{
    DoubleDouble, fast_two_difference, fast_two_sum, two_difference, two_product,
};
use super::{
    LN2_HI, LN2_LO, Number, Order, Table, exponent_of_positive, lesser, look_up, polynomial, select,
};

// log_tail: minimax on [-0.02918, 0.03126], degree 7,
// weighted error 1.62e-17: reference/coefficients.py log_tail
const LOG_TAIL: [f64; 8] = [
    0.6666666666666629,
    -0.5000000000001396,
    0.40000000005930586,
    -0.33333333227797785,
    0.28571404346796125,
    -0.250002197531488,
    0.22258597932673727,
    -0.19876158416435263,
];
// log_table: reference/coefficients.py log_table
const INVERSES: Table = [
    1.0,
    0.94140625,
    0.888671875,
    0.841796875,
    0.80078125,
    0.76171875,
    0.7265625,
    0.6953125,
    0.666015625,
    0.640625,
    0.615234375,
    0.591796875,
    0.572265625,
    0.55078125,
    0.533203125,
    0.515625,
];
const LOGARITHMS: Table = [
    0.0,
    0.060380510988807146,
    0.11802720608852724,
    0.172216534935842,
    0.2221674653410446,
    0.2721778859158803,
    0.3194307707663029,
    0.36339389418753854,
    0.4064421477560245,
    0.44531101665529604,
    0.485751986213927,
    0.5245918195300874,
    0.5581520160224045,
    0.5964175541014356,
    0.6288528298546225,
    0.6623755218931819,
];
const LOGARITHM_RESTS: Table = [
    0.0,
    1.0033424888676119e-13,
    3.013227959910772e-14,
    -8.199467511461324e-14,
    1.0970699320566433e-13,
    -6.465103064005256e-14,
    5.834357420090924e-14,
    -6.120773136055512e-14,
    -3.3501865852984494e-14,
    6.800902736039238e-14,
    -5.2289445585813614e-14,
    5.126483243291324e-14,
    3.5983072145504944e-14,
    -4.140144639843906e-14,
    -7.448926013624619e-14,
    9.681087609174425e-15,
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
    // exact, as are 1 − R, and the sums of hi below; near −1 the error of the product is half of f
    let f = product.hi - (1.0 - r);
    let DoubleDouble { hi: f, lo: rest } = match sign {
        Sign::Positive => DoubleDouble { hi: f, lo: product.lo },
        Sign::Any => fast_two_sum(f, product.lo),
    };

    let whole = k * LN2_HI + look_up(&LOGARITHMS, index);
    let whole_rest = k * LN2_LO + look_up(&LOGARITHM_RESTS, index);
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
    let lo = (exact_rests - (whole_rest + f_rest)) - cubic;
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

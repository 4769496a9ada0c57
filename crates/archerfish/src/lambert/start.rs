//! Where the starts of Lambert's W are read off: logarithms, to few digits.
//!
//! A start that is near in 1 + W, and not only in W, needs no other formula at the branch point. So
//! the logarithms there are those of `1 + f` with an f that is a multiple of the offset δ = z + 1/e.

use super::super::real::{Number, Order, exponent_and_significand, polynomial, select};

// rough_log: minimax on [-0.293, 0.4143], degree 4,
// weighted error 5.07e-5: reference/coefficients.py rough_log
const ROUGH_LOG: [f64; 5] = [
    0.9999728174257292,
    -0.4993855552078883,
    0.33593250129667523,
    -0.2720523526837367,
    0.1810552984507351,
];

/// Offsets up to which f is taken from them.
const CLOSE: f64 = 0.08;

/// `ln(1 + f)` for f in [−0.293, 0.4143], to 2⁻¹⁴ of itself.
#[inline(always)]
fn rough_ln_1p(f: Number) -> Number {
    f * polynomial(f, &ROUGH_LOG)
}

/// `ln(1 + z)` and `ln((1 + z)/(1 − 1/e))`, given z and `z + 1/e`; below zero for z < −1/e.
#[inline(always)]
pub(super) fn principal_logarithms(z: Number, offset: Number) -> (Number, Number) {
    /// 1/(1 − 1/e)
    const INVERSE_LEAST: f64 = 1.5819767068693265;
    /// −ln(1 − 1/e)
    const END: f64 = 0.4586751453870819;
    let close = offset.is_below(CLOSE);
    let (k, m) = exponent_and_significand(1.0 + z);
    let base = select(close, -END, k * core::f64::consts::LN_2);
    let excess = rough_ln_1p(select(close, offset * INVERSE_LEAST, m - 1.0));
    let logarithm = base + excess;
    (logarithm, select(close, excess, logarithm + END))
}

/// `−1 − ln(−z)`, given `−2^lift z` and `z + 1/e`; below zero for z < −1/e, and for a positive z.
#[inline(always)]
pub(super) fn lower_logarithm(lifted: Number, lift: f64, offset: Number) -> Number {
    const LN_2: f64 = core::f64::consts::LN_2;
    let close = offset.is_below(CLOSE);
    let (k, m) = exponent_and_significand(lifted);
    let base = select(close, 0.0, (lift * LN_2 - 1.0) - k * LN_2);
    base - rough_ln_1p(select(close, offset * -core::f64::consts::E, m - 1.0))
}

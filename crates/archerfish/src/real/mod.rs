//! Functions of one real number, branch-free, from +, −, ×, ÷, √ and integer operations alone.
//!
//! Every function is right to within one unit in the last place for every argument, subnormals,
//! infinities and NaN included, and gives the same bits on every machine. The trigonometric
//! functions take angles in [−2π, 2π] and give NaN outside. Worst errors: reference/accuracy.toml.
//!
//! Inside the crate the functions also come as sums of two doubles, for callers that go on
//! computing.

mod atan;
pub(crate) mod double_double;
mod exp;
mod log;
mod log1pmx;
mod polynomial;
mod sqrt;
mod trigonometric;

pub(crate) use super::{Integer, Mask, Number, Single, constant};
pub(crate) use crate::number::{Bits, LookUp, Narrow, Order, Table};

pub use atan::{atan, atan2};
pub use exp::{exp, exp_m1};
pub use log::{ln, ln_1p};
pub use log1pmx::log1pmx;
pub use sqrt::sqrt;
pub(crate) use sqrt::sqrt_single;
pub use trigonometric::{cos, sin, sin_cos, tan};

pub(crate) use atan::{angle, angle_all_round, atan_bend};
pub(crate) use exp::Exponential;
pub(crate) use log::Logarithm;
#[allow(unused_imports, reason = "for dispatch alone, which not every build has")]
pub(crate) use log1pmx::{Sign, log_excess, log1pmx_ordinary};
pub(crate) use polynomial::{polynomial, polynomial_by};
pub(crate) use trigonometric::{
    Mirrored, sin_and_factors, sin_cos_extended, sin_cos_upper, sin_upper,
};

/// The number of a table at the last four bits of the index.
#[inline(always)]
pub(crate) fn look_up(table: &Table, index: Integer) -> Number {
    Number::look_up(table, index)
}

/// `a` where the condition holds, else `b`: both are computed, one is kept.
#[inline(always)]
pub(crate) fn select(condition: Mask, a: operand!(), b: operand!()) -> Number {
    Number::select(condition, a.into(), b.into())
}

/// `a` where it is below b, else `b`: a NaN of b stays.
#[inline(always)]
pub(crate) fn lesser(a: operand!(), b: operand!()) -> Number {
    Number::lesser(a.into(), b.into())
}

/// `a` where it is above b, else `b`: a NaN of b stays.
#[inline(always)]
pub(crate) fn greater(a: operand!(), b: operand!()) -> Number {
    Number::greater(a.into(), b.into())
}

/// `2ⁿ` for an integer `n` in [−1022, 1023], held in a double.
#[inline(always)]
pub(crate) fn power_of_two(n: Number) -> Number {
    // 1.5·2⁵² + 1023 + n has 1023 + n in its low bits
    Number::from_bits((n + (MAGIC + 1023.0)).to_bits() << 52)
}

/// `2ⁿ x` for a normal x, given `MAGIC + n`, where that is normal; NaN may become a number.
#[inline(always)]
pub(crate) fn times_power(x: Number, shifted: Number) -> Number {
    Number::from_bits(x.to_bits().wrapping_add(shifted.to_bits() << 52))
}

/// Adding and subtracting this rounds a number below 2⁵¹ to an integer, which then also stands in
/// the low bits of the sum.
pub(crate) const MAGIC: f64 = 6755399441055744.0; // 1.5·2⁵²

/// The integer nearest to `x`, |x| < 2⁵¹.
#[inline(always)]
pub(crate) fn nearest_integer(x: Number) -> Number {
    (x + MAGIC) - MAGIC
}

/// `(k, m)` with `w = 2ᵏ m` and m in [√½, √2), for a positive normal w.
#[inline(always)]
pub(crate) fn exponent_and_significand(w: Number) -> (Number, Number) {
    const SQRT_HALF: u64 = 0x3fe6_a09e_667f_3bcd;
    const ONE: u64 = 0x3ff0_0000_0000_0000;
    const SIGNIFICAND: u64 = 0x000f_ffff_ffff_ffff;
    let shifted = w.to_bits().wrapping_add(ONE - SQRT_HALF);
    let k = exponent_field(Number::from_bits(shifted));
    let m = Number::from_bits((shifted & SIGNIFICAND).wrapping_add(SQRT_HALF));
    (k, m)
}

/// `(k, (2ᵏ, 2⁻ᵏ))` with 2ᵏ ≤ w < 2ᵏ⁺¹, for w ≥ 1; for w ≥ 2¹⁰²³ the last is 0.
#[inline(always)]
pub(crate) fn power_and_inverse(w: Number) -> (Number, (Number, Number)) {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    const TWICE_BIAS: u64 = 2046 << 52;
    let power = w.to_bits() & EXPONENT;
    let inverse = Number::from_bits(Integer::from(TWICE_BIAS).wrapping_sub(power));
    (exponent_field(w), (Number::from_bits(power), inverse))
}

/// The exponent that the bits of a positive normal number hold, as a double.
#[inline(always)]
pub(crate) fn exponent_field(w: Number) -> Number {
    // the bits of 2⁵² + n hold the integer n
    const TWO_52: f64 = 4503599627370496.0;
    Number::from_bits((w.to_bits() >> 52) | TWO_52.to_bits()) - (TWO_52 + 1023.0)
}

/// The same, where other numbers may give anything: by an instruction, where there is one.
#[inline(always)]
pub(crate) fn exponent_of_positive(w: Number) -> Number {
    match w.exponent() {
        Some(exponent) => exponent,
        None => exponent_field(w),
    }
}

/// High and low part of ln 2; the high part has 42 bits, so that integers below 2¹¹ multiply it
/// exactly.
pub(crate) const LN2_HI: f64 = f64::from_bits(0x3fe6_2e42_fefa_3800);
pub(crate) const LN2_LO: f64 = f64::from_bits(0x3d2e_f357_93c7_6730);

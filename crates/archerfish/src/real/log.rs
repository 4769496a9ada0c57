//! Natural logarithm.
//!
//! Method: `w = 2ᵏ (1 + f)` with 1 + f in [√½, √2); with s = f/(2 + f),
//! `ln(1 + f) = 2 artanh s = 2s + 2s³ ρ(s²)`, `ρ(z) = (artanh(√z)/√z − 1)/z`.
//! The argument may be a sum of two doubles, and s is one, so that only the small last term is
//! rounded.

use super::double_double::{DoubleDouble, fast_two_sum, two_sum};
use super::{
    LN2_HI, LN2_LO, Number, Order, exponent_and_significand, lesser, polynomial, power_of_two,
    select,
};

// atanh_tail: minimax on [0.0, 0.0294402], degree 6,
// weighted error 1.11e-18: reference/coefficients.py atanh_tail
const ATANH_TAIL: [f64; 7] = [
    0.20000000000000304,
    0.14285714285451925,
    0.1111111118773474,
    0.09090898493067041,
    0.07693090035210214,
    0.06635058852988684,
    0.06537250941124745,
];
const THIRD: DoubleDouble = DoubleDouble::constant(0.3333333333333333, 1.850371707708594e-17);

/// The pieces of `ln w`, `w = 2ᵏ (1 + f)`.
pub(crate) struct Logarithm {
    pub k: Number,
    /// `f / (2 + f)`
    pub s: DoubleDouble,
    /// `ρ(s²)`, between 1/3 and 0.34, to 2⁻⁵⁸ of itself
    pub rho: DoubleDouble,
}

impl Logarithm {
    /// `ρ(z)`, rounded, for z in [0, 0.0294].
    #[inline(always)]
    pub fn artanh_excess(z: Number) -> Number {
        THIRD.hi + z * polynomial(z, &ATANH_TAIL)
    }

    /// Of a positive normal number `w.hi + w.lo`.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn of(w: DoubleDouble) -> Self {
        let (k, m) = exponent_and_significand(w.hi);
        let s = Logarithm::ratio_of(w, k, m);
        let z = s.hi * s.hi;
        let rho = fast_two_sum(THIRD.hi, z * polynomial(z, &ATANH_TAIL));
        Logarithm { k, s, rho: fast_two_sum(rho.hi, rho.lo + THIRD.lo) }
    }

    /// `s`, of `w = 2ᵏ m + w.lo`.
    #[inline(always)]
    fn ratio_of(w: DoubleDouble, k: Number, m: Number) -> DoubleDouble {
        // beyond 2¹⁰²² the power would not be normal; a rest a few times too great is nothing beside ln w
        let low = w.lo * power_of_two(-lesser(1022.0, k));
        let f = fast_two_sum(m - 1.0, low);
        let sum = fast_two_sum(2.0, f.hi);
        let denominator = DoubleDouble { hi: sum.hi, lo: sum.lo + f.lo };
        f.div(denominator)
    }

    /// `2 s³ ρ(s²)`, the rounded part of `ln(1 + f)`; `2s` is the other.
    #[inline(always)]
    pub fn tail(&self) -> Number {
        2.0 * self.s.hi * (self.s.hi * self.s.hi) * self.rho.hi
    }

    /// `ln w`.
    #[inline(always)]
    pub fn value(&self) -> DoubleDouble {
        let sum = fast_two_sum(self.k * LN2_HI, 2.0 * self.s.hi);
        let small = self.tail() + 2.0 * self.s.lo + self.k * LN2_LO;
        fast_two_sum(sum.hi, sum.lo + small)
    }
}

/// `ln x`.
#[inline(always)]
pub fn ln(x: Number) -> Number {
    let subnormal = x.is_below(f64::MIN_POSITIVE);
    let scaled = select(subnormal, x * 18014398509481984.0, x); // 2⁵⁴
    let mut logarithm = Logarithm::of(DoubleDouble::from(scaled));
    logarithm.k -= select(subnormal, 54.0, 0.0);
    let regular = logarithm.value().round();
    let regular = select(x.equals(f64::INFINITY), x, regular);
    let regular = select(x.equals(0.0), f64::NEG_INFINITY, regular);
    select(x.is_at_least(0.0), regular, f64::NAN)
}

/// `ln(1 + x)`.
#[inline(always)]
pub fn ln_1p(x: Number) -> Number {
    let regular = Logarithm::of(two_sum(1.0, x)).value().round();
    let regular = select(x.equals(f64::INFINITY), x, regular);
    let regular = select(x.equals(-1.0), f64::NEG_INFINITY, regular);
    let regular = select(x.is_at_least(-1.0), regular, f64::NAN);
    select(x.abs().is_below(1e-300), x, regular)
}

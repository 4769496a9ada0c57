//! The one special function of linear drag.
//!
//! Everything drag does to an apex is `φ(u) = (u − ln(1+u))/u²` at u = ε sin α. With
//! σ = u/(2 + u) in [0, 1), `ln(1+u) = 2 artanh σ` and `ρ(σ²) = (artanh σ/σ − 1)/σ²`,
//!
//! - `a = u G′(u) = σ(1 − σ) ρ`, never negative, with nothing cancelling as u → 0;
//! - `φ(u) = (1 − a)/(2 + u)`;
//! - `G(u) = (1 + u) φ(u)`, from 1/2 to 1.
//!
//! Method: all three from the excess `l = u − ln(1 + u)` (`real/log1pmx.rs`), as quotients by u²:
//! `φ = l/u²`, `1 − G = n/u²` with `n = u (u − l) − l`, and `a = (n − l)/u²`.

use super::super::real::double_double::{
    DoubleDouble, fast_two_difference, fast_two_sum, two_product, two_square,
};
use super::super::real::{
    Logarithm, Mask, Number, Sign, exponent_and_significand, greater, lesser, log_excess,
    polynomial, select,
};

// artanh_tail: minimax on [0.0, 0.11112], degree 10,
// weighted error 1.36e-18: reference/coefficients.py artanh_tail
const ARTANH_TAIL: [f64; 11] = [
    0.20000000000000007,
    0.14285714285711484,
    0.11111111111614065,
    0.09090909045918469,
    0.0769231002682731,
    0.06666590683558438,
    0.058839668690026437,
    0.05240502638386737,
    0.049692086255873485,
    0.03173185332190979,
    0.07606561628673504,
];
const THIRD: DoubleDouble = DoubleDouble::constant(0.3333333333333333, 1.850371707708594e-17);
/// 2⁻⁶⁰ and 2²⁰⁰
const LEAST: f64 = f64::from_bits((1023 - 60) << 52);
const MOST: f64 = f64::from_bits((1023 + 200) << 52);

/// `ρ(z) − 1/3` for z up to 1/9.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
fn ratio_excess(z: Number) -> Number {
    z * polynomial(z, &ARTANH_TAIL)
}

/// `ρ(z)` for z up to 1/9, to 2⁻⁵⁸.
#[inline(always)]
fn ratio_of_square(z: Number) -> DoubleDouble {
    let sum = fast_two_sum(THIRD.hi, ratio_excess(z));
    DoubleDouble { hi: sum.hi, lo: sum.lo + THIRD.lo }
}

/// `ln(1 + u)`, of q = 1 + u: for u < 1, where q is below 2, its pieces are those of artanh σ itself.
#[inline(always)]
pub(super) fn logarithm(q: DoubleDouble, near: Mask) -> Logarithm {
    let (k, m) = exponent_and_significand(q.hi);
    let (k, m) = (select(near, 0.0, k), select(near, q.hi, m));
    let s = Logarithm::ratio_of(q, k, m);
    Logarithm { k, s, rho: ratio_of_square(s.hi * s.hi) }
}

/// Drag at one value of u = ε sin α.
pub(super) struct Drag {
    /// u, between the bounds that change nothing
    pub u: Number,
    /// `l = u − ln(1 + u)`
    excess: DoubleDouble,
    /// `n = u² (1 − G)`
    pub loss: DoubleDouble,
    /// `u²`
    pub square: DoubleDouble,
}

impl Drag {
    /// Of u ≥ 0.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn at(u: Number) -> Self {
        // G is 1/2 + u/6 below, to 2⁻⁶², and differs from 1 by nothing above
        let u = greater(LEAST, lesser(MOST, u));
        let square = two_square(u);
        let (excess, _) = log_excess(u, Sign::Positive);
        let excess = fast_two_sum(excess.hi, excess.lo);
        let logarithm = fast_two_difference(u, excess.hi);
        let product = two_product(u, logarithm.hi);
        let product_rest = product.lo + u * (logarithm.lo - excess.lo);
        let difference = fast_two_difference(product.hi, excess.hi);
        let loss =
            DoubleDouble { hi: difference.hi, lo: difference.lo + (product_rest - excess.lo) };
        Drag { u, excess, loss, square }
    }

    /// `1 − G(u)`, from 1/2 to 0, and `a = u G′(u)` to few digits, given the inverse of u²
    #[inline(always)]
    pub fn gain_rest_and_slope(&self, inverse: Number) -> (Number, Number) {
        let Drag { excess, loss, .. } = *self;
        let top = (loss.hi - excess.hi) + (loss.lo - excess.lo);
        (loss.hi * inverse, top * inverse)
    }
}

//! The one special function of linear drag.
//!
//! Everything drag does to an apex is `φ(u) = (u − ln(1+u))/u²` at u = ε sin α. With
//! σ = u/(2 + u) in [0, 1), `ln(1+u) = 2 artanh σ` and `ρ(σ²) = (artanh σ/σ − 1)/σ²`,
//!
//! - `a = u G′(u) = σ(1 − σ) ρ`, never negative, with nothing cancelling as u → 0;
//! - `φ(u) = (1 − a)/(2 + u)`;
//! - `G(u) = (1 + u) φ(u)`, from 1/2 to 1.
//!
//! Method: `1 + u = 2ᵏ m` with m in [1, 2), s = (m − 1)/(m + 1) and τ = (2ᵏ − 1)/(2ᵏ + 1), so that
//! σ = (τ + s)/(1 + τ s). Then `artanh σ − σ = (k ln 2/2 − τ) + s³ ρ(s²) + τ s σ`: a sum of positive
//! terms for every u, the polynomial needing s up to 1/3 only. Where k = 0, s is σ.

use super::super::real::double_double::{DoubleDouble, fast_two_sum};
use super::super::real::{
    LN2_HI, LN2_LO, Logarithm, Mask, Number, Order, exponent_and_significand, polynomial,
    power_and_inverse, select,
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
/// k ln 2/2 − τ for k = 1 and 2, where it would cancel: ln 2/2 − 1/3 and ln 2 − 3/5
const FIRST_EXCESSES: [f64; 2] = [0.013240256946639321, 0.09314718055994531];

/// `ρ(z)` for z up to 1/9, to 2⁻⁵⁸.
#[inline(always)]
fn ratio_of_square(z: Number) -> DoubleDouble {
    let sum = fast_two_sum(THIRD.hi, z * polynomial(z, &ARTANH_TAIL));
    DoubleDouble { hi: sum.hi, lo: sum.lo + THIRD.lo }
}

/// `ln(1 + u)`, of q = 1 + u: for u < 1, where q is below 2, its pieces are those of artanh σ itself.
#[inline(always)]
pub(super) fn logarithm(q: DoubleDouble, near: Mask) -> Logarithm {
    let (k, m) = exponent_and_significand(q.hi);
    Logarithm::of_parts(q, select(near, 0.0, k), select(near, q.hi, m), ratio_of_square)
}

/// Drag at one value of u = ε sin α.
pub(super) struct Drag {
    /// `σ = u/(2 + u)`
    pub sigma: Number,
    /// `1 − σ = 2/(2 + u)`
    pub sigma_rest: Number,
    /// `ρ(σ²)`
    pub rho: Number,
    /// `a = u G′(u)`
    pub a: Number,
}

impl Drag {
    /// Of u ≥ 0.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn at(u: Number) -> Self {
        let (k, (power, p)) = power_and_inverse(1.0 + u);
        let direct = k.equals(0.0);
        // exact, as 2ᵏ − 1 ≤ u < 2ᵏ⁺¹ − 1
        let f = (u - (power - 1.0)) * p;
        let s = f / (2.0 + f);
        let z = s * s;
        let rho_s = ratio_of_square(z).round();

        // with p = 2⁻ᵏ, C = 1 + p, A = C + f = p(2 + u), D = 1 − p + f = p u, by one division:
        // i = 1/D² and w = 1/(CA), so that τ = 1 − 2pAw, σ = CDw
        let (c, rest) = (1.0 + p, 1.0 - p);
        let (a, d) = (c + f, rest + f);
        let d_square = select(direct, 1.0, d * d);
        let product = c * a;
        let inverse = 1.0 / (product * d_square);
        let (w, i) = (d_square * inverse, product * inverse);
        let sigma = select(direct, s, c * (d * w));
        let sigma_rest = select(direct, 1.0 - s, 2.0 * p * (c * w));

        let first = (0.5 * k * LN2_HI - 1.0) + 0.5 * k * LN2_LO + 2.0 * p * (a * w);
        let first = select(k.equals(2.0), FIRST_EXCESSES[1], first);
        let first = select(k.equals(1.0), FIRST_EXCESSES[0], first);
        let excess = first + (z * s * rho_s + rest * (d * w) * s);

        // a = 2 (artanh σ − σ)(2 + u)/u² = 2pA (artanh σ − σ)/D², and ρ = (artanh σ − σ)/σ³
        let ratio = a * d * i;
        let above = 2.0 * p * (a * excess * i);
        let rho = select(direct, rho_s, excess * ratio * (ratio * ratio));
        Drag { sigma, sigma_rest, rho, a: select(direct, s * sigma_rest * rho_s, above) }
    }

    /// `1 − G(u) = ((1 − σ) + (1 + σ) a)/2`, from 1/2 to 0
    #[inline(always)]
    pub fn gain_rest(&self) -> Number {
        0.5 * (self.sigma_rest + (1.0 + self.sigma) * self.a)
    }
}

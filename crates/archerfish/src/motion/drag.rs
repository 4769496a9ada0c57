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

use super::super::real::double_double::{DoubleDouble, Number};
use super::super::real::{LN2_HI, LN2_LO, polynomial, power_and_inverse};

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
const THIRD: DoubleDouble = DoubleDouble { hi: 0.3333333333333333, lo: 1.850371707708594e-17 };
/// k ln 2/2 − τ for k = 1 and 2, where it would cancel: ln 2/2 − 1/3 and ln 2 − 3/5
const FIRST_EXCESSES: [DoubleDouble; 2] = [
    DoubleDouble { hi: 0.013240256946639321, lo: 3.0410896052784116e-20 },
    DoubleDouble { hi: 0.09314718055994531, lo: 9.860076459598653e-19 },
];

/// Drag at one value of u = ε sin α.
pub(crate) struct Drag<T> {
    /// `σ = u/(2 + u)`
    pub sigma: T,
    /// `1 − σ = 2/(2 + u)`
    pub sigma_rest: T,
    /// `ρ(σ²)`
    pub rho: T,
    /// `a = u G′(u)`
    pub a: T,
}

impl<T: Number> Drag<T> {
    /// Of u ≥ 0.
    #[inline(always)]
    pub fn at(u: DoubleDouble) -> Self {
        let number = T::from_double;
        // u as T holds it, everywhere: a hardly depends on u, but its parts must agree on one
        let u = T::from_sum(u.hi, u.lo);
        let (k, power) = power_and_inverse(1.0 + u.leading());
        let direct = k == 0.0;
        // exact, as 2ᵏ − 1 ≤ u < 2ᵏ⁺¹ − 1
        let f = u.less_exactly(power.0 - 1.0).scaled(power.1);
        let s = f / (number(2.0) + f);
        let square = s * s;
        let z = square.nearest();
        let tail = z * polynomial(z, &ARTANH_TAIL);
        let rho_s = T::from_sum(THIRD.hi, tail) + number(THIRD.lo);

        // with p = 2⁻ᵏ, C = 1 + p, A = C + f = p(2 + u), D = 1 − p + f = p u, by one division:
        // I = 1/D² and W = 1/(CA), so that τ = 1 − 2pAW, σ = CDW
        let (sum, rest) = (T::from_sum(1.0, power.1), T::from_sum(1.0, -power.1));
        let (a, d) = (sum + f, rest + f);
        let d_square = T::either(direct, number(1.0), d * d);
        let product = sum * a;
        let inverse = number(1.0) / (product * d_square);
        let (w, i) = (d_square * inverse, product * inverse);
        let dw = d * w;
        let p_double = 2.0 * power.1;
        let sigma = T::either(direct, s, sum * dw);
        let sigma_rest = T::either(direct, number(1.0) - s, (sum * w).scaled(p_double));

        let half_k = number(0.5 * k);
        let first = (half_k * number(LN2_HI) - number(1.0)) + half_k * number(LN2_LO);
        let first = first + (a * w).scaled(p_double);
        let first = T::either(k == 2.0, T::from_pair(FIRST_EXCESSES[1]), first);
        let first = T::either(k == 1.0, T::from_pair(FIRST_EXCESSES[0]), first);
        let excess = first + (square * s * rho_s + rest * dw * s);

        // a = 2 (artanh σ − σ)(2 + u)/u² = 2pA (artanh σ − σ)/D², and ρ = (artanh σ − σ)/σ³
        let ratio = a * d * i;
        let above = (a * excess * i).scaled(p_double);
        let rho = T::either(direct, rho_s, excess * ratio * ratio * ratio);
        Drag { sigma, sigma_rest, rho, a: T::either(direct, sigma * sigma_rest * rho_s, above) }
    }

    /// `1 − a`
    #[inline(always)]
    pub fn a_rest(&self) -> T {
        T::from_double(1.0) - self.a
    }

    /// `1 + σ`
    #[inline(always)]
    pub fn sigma_plus_one(&self) -> T {
        T::from_double(1.0) + self.sigma
    }

    /// `G(u) = (1 + σ)(1 − a)/2`
    #[inline(always)]
    pub fn gain(&self) -> T {
        (self.sigma_plus_one() * self.a_rest()).scaled(0.5)
    }

    /// `1 − G(u) = ((1 − σ) + (1 + σ) a)/2`, from 1/2 to 0
    #[inline(always)]
    pub fn gain_rest(&self) -> T {
        (self.sigma_rest + self.sigma_plus_one() * self.a).scaled(0.5)
    }
}

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

use super::super::real::double_double::{
    DoubleDouble, fast_two_difference, fast_two_sum, two_product,
};
use super::super::real::{
    Integer, LN2_HI, LN2_LO, Logarithm, Mask, Number, Order, exponent_and_significand, polynomial,
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

/// Drag at one value of u = ε sin α, in full, for what is found by it.
pub(super) struct Drag {
    /// `σ = u/(2 + u)`
    pub sigma: Number,
    /// `1 − σ = 2/(2 + u)`
    pub sigma_rest: Number,
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

        // with p = 2⁻ᵏ, C = 1 + p, A = C + f = p(2 + u), D = 1 − p + f = p u, by one division:
        // i = 1/D² and w = 1/(CA), so that τ = 1 − 2pAw, σ = CDw
        let (c, rest) = (1.0 + p, 1.0 - p);
        let (a, d) = (c + f, rest + f);
        let d_square = select(direct, 1.0, d * d);
        let product = c * a;
        let inverse = 1.0 / (product * d_square);
        // here, while both divisions are under way (bench/NOTES.md, "Order")
        let z = s * s;
        let rho = THIRD.hi + ratio_excess(z);
        let (w, i) = (d_square * inverse, product * inverse);
        let sigma = select(direct, s, c * (d * w));
        let sigma_rest = select(direct, 1.0 - s, 2.0 * p * (c * w));

        let first = (k * (0.5 * LN2_HI) - 1.0) + k * (0.5 * LN2_LO) + 2.0 * p * (a * w);
        let first = select(k.equals(2.0), FIRST_EXCESSES[1], first);
        let first = select(k.equals(1.0), FIRST_EXCESSES[0], first);
        let excess = first + s * (z * rho + rest * (d * w));

        // a = 2 (artanh σ − σ)(2 + u)/u² = 2pA (artanh σ − σ)/D²
        let above = 2.0 * p * (a * excess * i);
        Drag { sigma, sigma_rest, a: select(direct, s * sigma_rest * rho, above) }
    }

    /// `1 − G(u) = ((1 − σ) + (1 + σ) a)/2`, from 1/2 to 0
    #[inline(always)]
    pub fn gain_rest(&self) -> Number {
        0.5 * (self.sigma_rest + (1.0 + self.sigma) * self.a)
    }
}

/// `φ(u)` and `1 − G(u)` as quotients, to a unit in the last place or so, for what is computed from them.
///
/// Near, for u < 1, they are `(1 − a)/(2 + u)` and `(1 + (1 + u) a)/(2 + u)`; far, with
/// L = ln(1 + u), `(u − L)/u²` and `((1 + u) L − u)/u²`. Top and bottom are multiplied by p, so that
/// u² does not overflow.
pub(super) struct Quotients {
    u: Number,
    near: Mask,
    /// `2⁻¹⁻ᵏ`, 2ᵏ being the power of two up to 1 + u
    p: Number,
    /// `p u`
    share: Number,
    /// `a`, near
    a: Number,
    /// `L`, far
    logarithm: DoubleDouble,
    bottom: DoubleDouble,
}

impl Quotients {
    /// Of u ≥ 0.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn at(u: Number) -> Self {
        const TWICE_BIAS_AND_ONE: u64 = 2047 << 52;
        let (k, (power, _)) = power_and_inverse(1.0 + u);
        let near = k.equals(0.0);
        // by way of 2¹⁻ᵏ, for p itself may be subnormal
        let p = 0.25
            * Number::from_bits(Integer::from(TWICE_BIAS_AND_ONE).wrapping_sub(power.to_bits()));
        // exact, as 2ᵏ − 1 ≤ u < 2ᵏ⁺¹ − 1; half of what follows 1 in the significand
        let f = (u - (power - 1.0)) * p;
        let s = f / (1.0 + f);
        // here, while the division is under way (bench/NOTES.md, "Order")
        let share = u * p;
        let bottom = DoubleDouble::select(near, fast_two_sum(1.0, share), two_product(u, share));
        let (whole, whole_rest) = (k * LN2_HI, k * LN2_LO);

        let z = s * s;
        let rho = THIRD.hi + ratio_excess(z);
        let a = (s * (1.0 - s)) * rho;
        let twice = s + s;
        let sum = fast_two_sum(whole, twice);
        let logarithm = DoubleDouble { hi: sum.hi, lo: (twice * z) * rho + (sum.lo + whole_rest) };
        Quotients { u, near, p, share, a, logarithm, bottom }
    }

    /// `φ(u + rest)`, for a rest that is nothing but a rounding error.
    #[inline(always)]
    pub fn fall(&self, rest: Number) -> (DoubleDouble, DoubleDouble) {
        let Quotients { u, near, p, share, a, logarithm, bottom } = *self;
        let top = fast_two_difference(select(near, 1.0, u), select(near, a, logarithm.hi));
        let top = DoubleDouble { hi: top.hi, lo: top.lo - select(near, 0.0, logarithm.lo) };
        // φ falls like 1/(2 + u) near, and far like a power of u between −0.4 and −1
        let bottom_rest = rest * select(near, p, share * (1.0 - (p + p)));
        (top.scale(p), DoubleDouble { hi: bottom.hi, lo: bottom.lo + bottom_rest })
    }

    /// `1 − G(u)`
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn loss(&self) -> (DoubleDouble, DoubleDouble) {
        let Quotients { u, near, p, share, a, logarithm, bottom } = *self;
        let share_of_q = (1.0 + u) * p;
        let direct = fast_two_sum(0.5, share_of_q * a);
        // u (L − 1) + L: L itself may be below 1
        let far = logarithm.hi * p + (share * (logarithm.hi - 1.0) + share_of_q * logarithm.lo);
        let top =
            DoubleDouble { hi: select(near, direct.hi, far), lo: select(near, direct.lo, 0.0) };
        (top, bottom)
    }
}

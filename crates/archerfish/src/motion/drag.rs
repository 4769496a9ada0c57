//! The one special function of linear drag.
//!
//! Everything drag does to an apex is `φ(u) = (u − ln(1+u))/u²` at u = ε sin α. With
//! σ = u/(2 + u) in [0, 1), `ln(1+u) = 2 artanh σ` and `ρ(σ²) = (artanh σ/σ − 1)/σ²`,
//!
//! - `a = u G′(u) = σ(1 − σ) ρ`, never negative, with nothing cancelling as u → 0;
//! - `φ(u) = (1 − σ)/2 · (1 − a)`;
//! - `G(u) = (1 + u) φ(u) = (1 + σ)/2 · (1 − a)`.

use crate::real::Logarithm;
use crate::real::double_double::{DoubleDouble, fast_two_sum, two_sum};

/// Drag at one value of u = ε sin α.
pub(crate) struct Drag {
    /// `q = 1 + u`
    pub q: DoubleDouble,
    /// `σ = u/(2 + u)`
    pub sigma: DoubleDouble,
    /// `1 − σ = 2/(2 + u)`
    pub sigma_rest: DoubleDouble,
    /// `ρ(σ²)`
    pub rho: DoubleDouble,
    /// `a = u G′(u)`
    pub a: DoubleDouble,
}

const ONE: DoubleDouble = DoubleDouble { hi: 1.0, lo: 0.0 };

impl Drag {
    /// Of u ≥ 0.
    #[inline(always)]
    pub fn at(u: DoubleDouble) -> Self {
        let q = plus(1.0, u);
        let logarithm = Logarithm::of(q);
        let denominator = plus(2.0, u);
        let inverse = 1.0 / denominator.hi;
        let sigma = u.div_by(denominator, inverse);
        let sigma_rest = DoubleDouble::from(2.0).div_by(denominator, inverse);
        // up to u = √2 − 1 the logarithm's own s is σ; above, artanh σ − σ loses few bits
        let excess = logarithm.value().scale(0.5).sub(sigma);
        let above = excess.div(sigma.square().mul(sigma));
        let rho = DoubleDouble::select(logarithm.k == 0.0, logarithm.rho, above);
        let a = sigma.mul(sigma_rest).mul(rho);
        Drag { q, sigma, sigma_rest, rho, a }
    }

    /// `1 + σ`
    #[inline(always)]
    pub fn sigma_plus_one(&self) -> DoubleDouble {
        plus(1.0, self.sigma)
    }

    /// `φ(u)`
    #[inline(always)]
    pub fn phi(&self) -> DoubleDouble {
        self.sigma_rest.mul(ONE.sub(self.a)).scale(0.5)
    }

    /// `G(u) = (1 + u) φ(u)`, from 1/2 to 1
    #[inline(always)]
    pub fn gain(&self) -> DoubleDouble {
        self.sigma_plus_one().mul(ONE.sub(self.a)).scale(0.5)
    }

    /// `1 − G(u) = ((1 − σ) + (1 + σ) a)/2`, from 1/2 to 0
    #[inline(always)]
    pub fn gain_rest(&self) -> DoubleDouble {
        self.sigma_rest.add(self.sigma_plus_one().mul(self.a)).scale(0.5)
    }

    /// `ln(1 + u)/u = (1 − σ)(1 + σ² ρ)`
    #[inline(always)]
    pub fn mean_slowness(&self) -> DoubleDouble {
        self.sigma_rest.mul(self.sigma.square().mul(self.rho).add_double(1.0))
    }
}

/// `a + b`
#[inline(always)]
fn plus(a: f64, b: DoubleDouble) -> DoubleDouble {
    let sum = two_sum(a, b.hi);
    fast_two_sum(sum.hi, sum.lo + b.lo)
}

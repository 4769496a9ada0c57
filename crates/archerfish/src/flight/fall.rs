//! How far a projectile has fallen, by the distance it has gone.
//!
//! Without gravity drag would let it go p = t E₁(εt) in time t; meanwhile it falls by
//! `t² E₂(εt) = p² ψ(εp)`, `ψ(v) = (−v − ln(1 − v))/v²`, which is φ(−v): from 1/2 without drag to
//! ∞ at v = 1, where the way ends.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{Logarithm, Order};

/// `ψ(v)` for v in [0, 1), given 1 − v as well.
///
/// Method: with σ = v/(2 − v), `ln(1 − v) = −2 artanh σ`; ρ being `(artanh σ/σ − 1)/σ²`,
/// `ψ = (1 + σ(1 + σ) ρ)/(2 − v)`, a sum of positive terms.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub(super) fn fall(v: DoubleDouble, rest: DoubleDouble) -> DoubleDouble {
    let logarithm = Logarithm::of(rest);
    let denominator = rest.add_double(1.0);
    let inverse = 1.0 / denominator.hi;
    let sigma = v.div_by(denominator, inverse);
    // up to v = 1 − √½ the logarithm's own s is −σ; above, artanh σ − σ loses few bits
    let excess = logarithm.value().scale(-0.5).sub(sigma);
    let above = excess.div(sigma.squared().times(sigma));
    let rho = DoubleDouble::select(logarithm.k.equals(0.0), logarithm.rho, above);
    let one = DoubleDouble::from(1.0);
    let bracket = one.add(sigma.times(sigma.add_double(1.0)).times(rho));
    bracket.div_by(denominator, inverse)
}

//! The one special function of linear drag.
//!
//! Everything drag does to an apex is `φ(u) = (u − ln(1+u))/u²` at u = ε sin α, and
//! `G(u) = (1 + u) φ(u)`, from 1/2 to 1. With q = 1 + u its derivatives are rational in G:
//!
//! - `a = u G′(u) = 1 − G (1 + q)/q`, never negative;
//! - `e = u a′(u)`, and `q (a + e) = 2G − 1`.
//!
//! Method: from the excess `l = u − ln(1 + u)` (`real/log1pmx.rs`): `φ = l/u²` and `G = q l/u²`; or, small
//! where G is near 1, `1 − G = m/u` with `m = ln(1 + u) − l/u`.

use super::super::real::double_double::{
    DoubleDouble, fast_two_difference, fast_two_sum, two_square,
};
use super::super::real::{Number, Sign, greater, lesser, log_excess};

/// 2⁻⁶⁰
const LEAST: f64 = f64::from_bits((1023 - 60) << 52);
/// 2²⁰⁰ and 2¹⁰⁰⁰: beyond both G differs from 1 by nothing; u² is in range up to the one, 1/u up to the
/// other.
pub(super) const STRONG: f64 = f64::from_bits((1023 + 200) << 52);
pub(super) const STRONGEST: f64 = f64::from_bits((1023 + 1000) << 52);

/// Drag at one value of u = ε sin α.
pub(super) struct Drag {
    /// u, between the bounds that change nothing
    pub u: Number,
    /// `l = u − ln(1 + u)`; the words overlap
    excess: DoubleDouble,
}

impl Drag {
    /// Of u ≥ 0, with `most`, one of the two, in place of what is above it.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn at(u: Number, most: f64) -> Self {
        Drag::up_to_most(lesser(most, u))
    }

    /// Of u from 0 to the greater of the two.
    #[inline(always)]
    pub fn up_to_most(u: Number) -> Self {
        // G is 1/2 + u/6 below, to 2⁻⁶²
        let u = greater(LEAST, u);
        Drag { u, excess: log_excess(u, Sign::Positive).0 }
    }

    /// `G(u) = q l/u²`, given q = 1 + u: q l, whose words overlap, and u²
    #[inline(always)]
    pub fn gain_and_square(&self, q: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
        (q.times(self.excess), two_square(self.u))
    }

    /// `1 − G(u)`, from 1/2 to 0, given a double next to `1/u`.
    #[inline(always)]
    pub fn gain_rest(&self, inverse: Number) -> DoubleDouble {
        let excess = fast_two_sum(self.excess.hi, self.excess.lo);
        let logarithm = fast_two_difference(self.u, excess.hi);
        let logarithm = DoubleDouble { hi: logarithm.hi, lo: logarithm.lo - excess.lo };
        let share = excess.div_double_by(self.u, inverse);
        logarithm.sub_smaller(share).div_double_by(self.u, inverse)
    }
}

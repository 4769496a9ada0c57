//! Time of flight.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{Mask, Number, Order, select, sin_cos_upper};
use super::domain::{is_drag, is_rising};
use super::landing::{Landing, landing, start};

/// Below this, 2⁻⁴⁰, the first term in u = ε sin α says all that drag does.
const FREE: f64 = f64::from_bits((1023 - 40) << 52);

/// A shot over level ground.
pub(super) struct LevelShot {
    pub sin: DoubleDouble,
    pub cos: DoubleDouble,
    /// `u = ε sin α`
    pub u: Number,
    /// with w = εT; nothing where the shot is free
    pub landing: Landing,
}

impl LevelShot {
    /// At the angle α in [0, π].
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn at(alpha: Number, epsilon: Number) -> Self {
        let (sin, cos) = sin_cos_upper(alpha);
        let u = sin.times_double(epsilon);
        let h = start(u.hi);
        // here, while the division of the start is under way (bench/NOTES.md, "Order")
        let q = u.add_positive(1.0);
        LevelShot { sin, cos, u: u.hi, landing: landing(q, h) }
    }

    /// Whether the first term in u says all that drag does.
    #[inline(always)]
    pub fn is_free(&self) -> Mask {
        self.u.is_below(FREE)
    }

    /// `sin α (1 − k u)`, k being a few units.
    #[inline(always)]
    pub fn shortened(&self, k: f64) -> DoubleDouble {
        DoubleDouble { hi: self.sin.hi, lo: self.sin.lo - self.sin.hi * (k * self.u) }
    }
}

/// Time of flight over level ground, the T > 0 with y(T) = 0, in V₀/g.
///
/// α in [0, π]. Limits: `2 sin α` as ε → 0; `sin α + 1/ε` as ε → ∞.
#[inline(always)]
pub fn flight_time(alpha: Number, eps: Number) -> Number {
    let shot = LevelShot::at(alpha, eps);
    let slowed = shot.landing.time().div_double(eps);
    // 2 sin α (1 − u/3 + …)
    let free = shot.shortened(1.0 / 3.0).scale(2.0);
    let time = DoubleDouble::select(shot.is_free(), free, slowed).round();
    select(is_rising(alpha) & is_drag(eps), time, f64::NAN)
}

//! Time of flight.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{select, sin_cos_upper};
use super::domain::{LARGE, SMALL, is_drag, is_rising};
use super::half_time::half_time;

/// Below this, 2⁻⁶⁰, drag makes no difference: u = ε sin α.
const FREE: f64 = f64::from_bits((1023 - 60) << 52);

/// A shot over level ground.
pub(super) struct LevelShot {
    pub sin: DoubleDouble,
    pub cos: DoubleDouble,
    /// `1 + ε sin α`
    pub q: DoubleDouble,
    epsilon: f64,
    /// `εT/2`
    half_time: DoubleDouble,
    /// whether drag makes no difference to T
    free: bool,
}

impl LevelShot {
    /// At the angle α in [0, π].
    #[inline(always)]
    pub fn at(alpha: f64, epsilon: f64) -> Self {
        let (sin, cos) = sin_cos_upper(alpha);
        let u = sin.times_double(epsilon);
        let q = u.add_positive(1.0);
        LevelShot { sin, cos, q, epsilon, half_time: half_time(u, q), free: u.hi < FREE }
    }

    /// T, or 2²⁰⁰ T where `lifted`; hi alone is good to 2⁻¹⁴.
    #[inline(always)]
    pub fn time(&self, lifted: bool) -> DoubleDouble {
        let half = self.half_time.div_double(self.epsilon * select(lifted, SMALL, 1.0));
        let free = self.sin.scale(select(lifted, LARGE, 1.0));
        DoubleDouble::select(self.free, free, half).scale(2.0)
    }
}

/// Time of flight over level ground, the T > 0 with y(T) = 0, in V₀/g.
///
/// α in [0, π]. Limits: `2 sin α` as ε → 0; `sin α + 1/ε` as ε → ∞.
#[inline(always)]
pub fn flight_time(alpha: f64, eps: f64) -> f64 {
    let time = LevelShot::at(alpha, eps).time(false).round();
    select(is_rising(alpha) & is_drag(eps), time, f64::NAN)
}

//! Time of flight.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{select, sin_cos_upper};
use super::domain::{LARGE, SMALL, is_drag, is_rising};
use super::half_time::half_time;

/// A shot over level ground.
pub(super) struct LevelShot {
    /// `sin α`, or 2²⁰⁰ times that where it is tiny
    pub sin: DoubleDouble,
    /// what to multiply lengths and times with in the end
    pub back: f64,
    pub cos: DoubleDouble,
    /// `1 + ε sin α`
    pub q: DoubleDouble,
    /// `T/(2 sin α)`, from 1 without drag to 1/2
    pub eta: DoubleDouble,
}

impl LevelShot {
    /// At the angle α in [0, π].
    #[inline(always)]
    pub fn at(alpha: f64, epsilon: f64) -> Self {
        let (sin, cos) = sin_cos_upper(alpha);
        let u = sin.times_double(epsilon);
        let q = u.add_positive(1.0);
        let tiny = sin.hi < SMALL;
        LevelShot {
            sin: sin.scale(select(tiny, LARGE, 1.0)),
            back: select(tiny, SMALL, 1.0),
            cos,
            q,
            eta: half_time(u, q),
        }
    }
}

/// Time of flight over level ground, the T > 0 with y(T) = 0, in V₀/g.
///
/// α in [0, π]. Limits: `2 sin α` as ε → 0; `sin α + 1/ε` as ε → ∞.
#[inline(always)]
pub fn flight_time(alpha: f64, eps: f64) -> f64 {
    let shot = LevelShot::at(alpha, eps);
    let time = shot.sin.times(shot.eta).scale(2.0).round() * shot.back;
    select(is_rising(alpha) & is_drag(eps), time, f64::NAN)
}

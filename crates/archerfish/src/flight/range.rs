//! Range.

use super::super::real::double_double::DoubleDouble;
use super::super::real::{Number, select};
use super::domain::{is_drag, is_rising};
use super::time::LevelShot;

/// Range over level ground, x(T), in V₀²/g; negative for α > π/2.
///
/// α in [0, π]. Limits: `2 sin α cos α` as ε → 0; `cos α / ε` as ε → ∞.
#[inline(always)]
pub fn flight_range(alpha: Number, eps: Number) -> Number {
    // x(T) = cos α (1 − e^{−εT})/ε, which is cos α sin α (1 − 4u/3 + …)/½
    let shot = LevelShot::at(alpha, eps);
    let free = shot.is_free();
    let way = DoubleDouble::select(free, shot.shortened(4.0 / 3.0), shot.landing.gone());
    let range = way.times(shot.cos).div_double(select(free, 0.5, eps)).round();
    select(is_rising(alpha) & is_drag(eps), range, f64::NAN)
}

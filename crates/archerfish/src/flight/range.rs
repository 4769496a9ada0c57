//! Range.

use super::super::real::select;
use super::domain::{SMALL, is_drag, is_rising};
use super::time::LevelShot;

/// Range over level ground, x(T), in V₀²/g; negative for α > π/2.
///
/// α in [0, π]. Limits: `2 sin α cos α` as ε → 0; `cos α / ε` as ε → ∞.
#[inline(always)]
pub fn flight_range(alpha: f64, eps: f64) -> f64 {
    // x(T) = T cos α / q, for 1 − e^{−εT} = εT/q at the landing
    let shot = LevelShot::at(alpha, eps);
    // where sin α is tiny, products of T would have no error
    let tiny = shot.sin.hi < SMALL;
    let lifted = shot.time(tiny).times(shot.cos).quotient(shot.q);
    let range = lifted * select(tiny, SMALL, 1.0);
    select(is_rising(alpha) & is_drag(eps), range, f64::NAN)
}

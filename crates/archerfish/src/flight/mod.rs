//! A whole flight: how long, how far, through which points, and at which angle to a target.
//!
//! Lengths in V₀²/g, times in V₀/g, the drag parameter ε = b V₀ / g in [0, ∞); outside, NaN.
//! Quantities that end on level ground take launch angles in [0, π]; quantities on the way, which
//! may lead downwards, take every direction, [−2π, 2π]. Worst errors:
//! reference/accuracy.toml.
//!
//! Two functions of the time w = εt carry everything: `E₁(w) = (1 − e⁻ʷ)/w` and
//! `E₂(w) = (w − 1 + e⁻ʷ)/w²`. At time t all shots of one speed lie on a circle of radius t E₁ that
//! has fallen by t² E₂.

mod aim;
mod aim_start;
mod domain;
mod envelope;
mod fall;
mod height;
mod landing;
mod optimal_angle;
mod position;
mod range;
mod relaxation;
mod time;

pub use aim::{aim_high, aim_low};
#[allow(unused_imports, reason = "for dispatch alone, which not every build has")]
pub(crate) use aim::{aim_high_ordinary, aim_low_ordinary};
pub use envelope::envelope_height;
pub use height::trajectory_height;
pub use optimal_angle::optimal_angle;
pub use position::{flight_x, flight_y};
pub use range::flight_range;
pub use time::flight_time;

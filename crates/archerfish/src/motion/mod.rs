//! Motion under gravity and linear drag, in units of V₀²/g and V₀/g.
//!
//! Angles are radians in [0, π], the drag parameter ε = b V₀ / g is in [0, ∞); outside, NaN.
//! Angles above π/2 are the mirror image of those below. Worst errors: reference/accuracy.toml.
//!
//! Reference: H. Hernández-Saldaña, "On the locus formed by the maximum heights of projectile
//! motion with air resistance", Eur. J. Phys. (2010); its equation numbers stand in brackets.

mod apex;
mod curvature;
mod derivatives;
mod drag;
mod guess;
mod launch;
mod locus;

pub use apex::{apex, apex_distance, apex_elevation, apex_time, apex_x, apex_y};
#[allow(unused_imports, reason = "for dispatch alone, which not every build has")]
pub(crate) use apex::{apex_elevation_ordinary, apex_y_ordinary};
#[allow(unused_imports, reason = "for dispatch alone, which not every build has")]
pub(crate) use curvature::locus_curvature_ordinary;
pub use curvature::{apex_curvature, locus_curvature};
pub use derivatives::{
    locus_launch_angle_d1, locus_launch_angle_d2, locus_launch_angle_derivatives,
};
#[allow(unused_imports, reason = "for dispatch alone, which not every build has")]
pub(crate) use derivatives::{locus_launch_angle_d1_ordinary, locus_launch_angle_d2_ordinary};
pub use locus::{locus_launch_angle, locus_radius};
#[allow(unused_imports, reason = "for dispatch alone, which not every build has")]
pub(crate) use locus::{locus_launch_angle_ordinary, locus_radius_ordinary};

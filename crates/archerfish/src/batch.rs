//! Slices in, slices out: one line a function.
//!
//! Every function takes its arguments as slices at least as long as `out` and fills `out`.

#[cfg(not(target_arch = "wasm32"))]
use crate::dispatch::batch;
#[cfg(not(target_arch = "wasm32"))]
pub use crate::dispatch::{holds_nan, isa_name};
#[cfg(target_arch = "wasm32")]
use crate::pairs::batch;

/// A function of one number over slices.
#[cfg(not(target_arch = "wasm32"))]
pub type UnaryBatch = fn(&[f64], &mut [f64]);
/// A function of two numbers over slices.
#[cfg(not(target_arch = "wasm32"))]
pub type BinaryBatch = fn(&[f64], &[f64], &mut [f64]);
/// A function of three numbers over slices.
#[cfg(not(target_arch = "wasm32"))]
pub type TernaryBatch = fn(&[f64], &[f64], &[f64], &mut [f64]);

// In a browser all are of one type, for one loop.
#[cfg(target_arch = "wasm32")]
use crate::pairs::{Kernel as UnaryBatch, Kernel as BinaryBatch, Kernel as TernaryBatch};
#[cfg(target_arch = "wasm32")]
pub use crate::pairs::{Kernel, evaluate};

/// Defines the slice functions and the table of them that bindings register.
macro_rules! table {
    ($table:ident: $type:ty => $out:tt; $($name:ident($($x:ident),+) = $module:ident::$kernel:ident $(or $ordinary:ident)?;)+) => {
        $(batch! {
            #[doc = concat!("[`", stringify!($module), "::", stringify!($kernel), "`](crate::", stringify!($module), "::", stringify!($kernel), ") over slices.")]
            $name, $module::$kernel $(or $ordinary)?, $($x),+ => $out
        })+
        /// Every function of this shape, by its public name.
        pub const $table: &[(&str, $type)] = &[$((stringify!($name), $name as $type)),+];
    };
}

table! { UNARY: UnaryBatch => (out);
    lambertw0(z) = lambert::lambertw0;
    lambertwm1(z) = lambert::lambertwm1;
    lambertw0_offset(d) = lambert::lambertw0_offset;
    lambertwm1_offset(d) = lambert::lambertwm1_offset;
    tree(z) = lambert::tree;
    log1pmx(x) = real::log1pmx or log1pmx_ordinary;
    optimal_angle(eps) = flight::optimal_angle;
}

table! { BINARY: BinaryBatch => (out);
    apex_x(alpha, eps) = motion::apex_x;
    apex_y(alpha, eps) = motion::apex_y or apex_y_ordinary;
    apex_time(alpha, eps) = motion::apex_time;
    apex_distance(alpha, eps) = motion::apex_distance;
    apex_elevation(alpha, eps) = motion::apex_elevation or apex_elevation_ordinary;
    apex_curvature(alpha, eps) = motion::apex_curvature;
    locus_launch_angle(theta, eps) = motion::locus_launch_angle or locus_launch_angle_ordinary;
    locus_launch_angle_d1(theta, eps) = motion::locus_launch_angle_d1 or locus_launch_angle_d1_ordinary;
    locus_launch_angle_d2(theta, eps) = motion::locus_launch_angle_d2 or locus_launch_angle_d2_ordinary;
    locus_radius(theta, eps) = motion::locus_radius or locus_radius_ordinary;
    locus_curvature(theta, eps) = motion::locus_curvature or locus_curvature_ordinary;
    flight_time(alpha, eps) = flight::flight_time;
    flight_range(alpha, eps) = flight::flight_range;
    envelope_height(x, eps) = flight::envelope_height;
}

table! { TERNARY: TernaryBatch => (out);
    flight_x(t, alpha, eps) = flight::flight_x;
    flight_y(t, alpha, eps) = flight::flight_y;
    trajectory_height(x, alpha, eps) = flight::trajectory_height;
    aim_low(x, y, eps) = flight::aim_low or aim_low_ordinary;
    aim_high(x, y, eps) = flight::aim_high or aim_high_ordinary;
}

// A page draws them side by side, and what they share is most of the work.

#[cfg(target_arch = "wasm32")]
table! { BINARY_PAIR: Kernel => (d1, d2);
    locus_launch_angle_derivatives(theta, eps) = motion::locus_launch_angle_derivatives;
}

#[cfg(target_arch = "wasm32")]
table! { BINARY_FOUR: Kernel => (x, y, elevation, curvature);
    apex(alpha, eps) = motion::apex;
}

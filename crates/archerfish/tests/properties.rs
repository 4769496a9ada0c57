//! What must hold for every shot, whatever the digits: order, symmetry, bounds and round trips.

#[path = "common/shots.rs"]
mod shots;

use archerfish::{lambert, motion, real};
use core::f64::consts::{FRAC_PI_2, PI};
use proptest::prelude::*;
use shots::{ULPS, drag, rising_angle};

/// Whether two values agree to a few units in the last place.
fn close(a: f64, b: f64, ulps: f64) -> bool {
    (a - b).abs() <= ulps * f64::EPSILON * a.abs().max(b.abs()) + 1e-323
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn the_apex_is_seen_lower_than_the_launch(alpha in rising_angle(), eps in drag()) {
        let theta = motion::apex_elevation(alpha, eps);
        prop_assert!(theta <= alpha);
        prop_assert!(alpha <= real::atan(2.0 * real::tan(theta)) * (1.0 + ULPS) + 5e-324);
    }

    #[test]
    fn the_launch_angle_lies_within_its_bounds(theta in rising_angle(), eps in drag()) {
        let alpha = motion::locus_launch_angle(theta, eps);
        prop_assert!(theta <= alpha);
        prop_assert!(alpha <= real::atan(2.0 * real::tan(theta)) * (1.0 + ULPS));
    }

    #[test]
    fn elevation_and_launch_angle_are_inverse(theta in rising_angle(), eps in drag()) {
        let alpha = motion::locus_launch_angle(theta, eps);
        // dθ/dα · α / θ is at most 2, so a few ulp of α are a few ulp of θ.
        let back = motion::apex_elevation(alpha, eps);
        prop_assert!(close(back, theta, 8.0), "{theta:e} came back as {back:e}");
    }

    #[test]
    fn launch_angle_and_elevation_are_inverse(alpha in rising_angle(), eps in drag()) {
        prop_assume!(alpha > 1e-300); // below, θ is subnormal and has not kept the digits of α
        let theta = motion::apex_elevation(alpha, eps);
        let back = motion::locus_launch_angle(theta, eps);
        // Near π/2 the angles lose what is left of π/2 - α together, so the measure is absolute.
        let slope = motion::locus_launch_angle_d1(theta, eps);
        let allowed = (4.0 + 4.0 * slope * theta / alpha) * f64::EPSILON * alpha;
        prop_assert!((back - alpha).abs() <= allowed, "{alpha:e} came back as {back:e}");
    }

    #[test]
    fn elevation_rises_with_the_launch_angle(a in rising_angle(), b in rising_angle(), eps in drag()) {
        let (low, high) = (a.min(b), a.max(b));
        let (below, above) = (motion::apex_elevation(low, eps), motion::apex_elevation(high, eps));
        prop_assert!(below <= above * (1.0 + ULPS));
        let (below, above) = (motion::locus_launch_angle(low, eps), motion::locus_launch_angle(high, eps));
        prop_assert!(below <= above * (1.0 + ULPS));
    }

    #[test]
    fn drag_lowers_the_apex(alpha in rising_angle(), a in drag(), b in drag()) {
        let (less, more) = (a.min(b), a.max(b));
        for quantity in [motion::apex_x, motion::apex_y, motion::apex_time, motion::apex_distance] {
            prop_assert!(quantity(alpha, more) <= quantity(alpha, less) * (1.0 + ULPS) + 5e-324);
        }
        prop_assert!(motion::apex_elevation(alpha, less) <= motion::apex_elevation(alpha, more) * (1.0 + ULPS));
    }

    #[test]
    fn backward_shots_mirror_forward_ones(angle in 1e-3..FRAC_PI_2, eps in drag()) {
        // π - angle is exact in no double; subtract what its rounding adds.
        let mirrored = PI - angle;
        let angle = PI - mirrored; // both differences of nearby doubles: this one is exact
        let slip = 1.2246467991473532e-16; // π less its double
        let tolerance = |value: f64, slope: f64| 16.0 * f64::EPSILON * value.abs() + 2.0 * slip * slope.abs();
        let (x, y) = (motion::apex_x(angle, eps), motion::apex_y(angle, eps));
        prop_assert!((motion::apex_x(mirrored, eps) + x).abs() <= tolerance(x, 1.0));
        prop_assert!((motion::apex_y(mirrored, eps) - y).abs() <= tolerance(y, x));
        let (alpha, slope) = (motion::locus_launch_angle(angle, eps), motion::locus_launch_angle_d1(angle, eps));
        prop_assert!((motion::locus_launch_angle(mirrored, eps) - (PI - alpha)).abs() <= tolerance(PI, slope));
    }

    #[test]
    fn locus_and_apex_are_the_same_curve(theta in rising_angle(), eps in (-7.0..7.0f64).prop_map(f64::exp2)) {
        prop_assume!(theta > 1e-300 && theta < 1.57);
        let alpha = motion::locus_launch_angle(theta, eps);
        let radius = motion::locus_radius(theta, eps);
        // Both come from angles rounded to a double, which the tangent to the locus carries on.
        let along = f64::EPSILON * 4.0 * alpha;
        prop_assert!((radius - motion::apex_distance(alpha, eps)).abs() <= 8.0 * f64::EPSILON * radius + along);
    }

    #[test]
    fn lambert_w_solves_its_equation(w in -0.999..50.0f64) {
        // Backwards: choose w, form z = w e^w, demand w back; z is rounded, and W's slope carries that on.
        let z = w * w.exp();
        let slip = 4.0 * f64::EPSILON * (z / ((1.0 + w) * w.exp())).abs();
        prop_assert!((lambert::lambertw0(z) - w).abs() <= slip + 4.0 * f64::EPSILON * w.abs());
        prop_assert!(close(lambert::tree(-z), -lambert::lambertw0(z), 0.0));
    }

    #[test]
    fn lower_branch_solves_its_equation(w in -700.0..-1.001f64) {
        let z = w * w.exp();
        // The library exponential's own error in the argument counts |w| times at most.
        let slip = (4.0 + w.abs() / 100.0) * f64::EPSILON * (z / ((1.0 + w) * w.exp())).abs();
        prop_assert!((lambert::lambertwm1(z) - w).abs() <= slip + 4.0 * f64::EPSILON * w.abs());
    }

    #[test]
    fn branches_rise_and_fall(a in 0.0..0.36f64, b in 0.0..0.36f64) {
        let (near, far) = (a.min(b), a.max(b));
        prop_assert!(lambert::lambertw0_offset(near) <= lambert::lambertw0_offset(far) * (1.0 + ULPS));
        prop_assert!(lambert::lambertwm1_offset(near) * (1.0 + ULPS) >= lambert::lambertwm1_offset(far) * (1.0 + 2.0 * ULPS));
    }

    #[test]
    fn log1pmx_stays_on_its_side_of_the_parabola(x in -0.999..1e6f64) {
        let value = real::log1pmx(x);
        prop_assert!(value <= 0.0);
        // ln(1+x) - x is above -x²/2 for x > 0 and below it for x < 0.
        let parabola = -0.5 * x * x;
        let within = if x >= 0.0 {
            value >= parabola * (1.0 + ULPS)
        } else {
            value <= parabola * (1.0 - ULPS)
        };
        prop_assert!(within);
    }

    #[test]
    fn bad_input_has_no_value(angle in prop_oneof![-1e3..-1e-300f64, 3.1415926535897936..1e3], eps in drag()) {
        for function in ALL {
            prop_assert!(function(angle, eps).is_nan());
            prop_assert!(function(1.0, -eps - 5e-324).is_nan());
            prop_assert!(function(1.0, f64::INFINITY).is_nan());
            prop_assert!(function(f64::NAN, eps).is_nan());
            prop_assert!(function(1.0, f64::NAN).is_nan());
        }
    }
}

type Binary = fn(f64, f64) -> f64;

const ALL: [Binary; 11] = [
    motion::apex_x,
    motion::apex_y,
    motion::apex_time,
    motion::apex_distance,
    motion::apex_elevation,
    motion::apex_curvature,
    motion::locus_launch_angle,
    motion::locus_launch_angle_d1,
    motion::locus_launch_angle_d2,
    motion::locus_radius,
    motion::locus_curvature,
];

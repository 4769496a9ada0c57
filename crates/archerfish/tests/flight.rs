//! What must hold for every whole flight, whatever the digits.

#[path = "common/shots.rs"]
mod shots;

use archerfish::{flight, motion};
use core::f64::consts::{FRAC_PI_4, PI};
use proptest::prelude::*;
use shots::{ULPS, drag, rising_angle};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn the_fall_takes_longer_than_the_rise(alpha in rising_angle(), eps in drag()) {
        let (up, whole) = (motion::apex_time(alpha, eps), flight::flight_time(alpha, eps));
        prop_assert!(2.0 * up <= whole * (1.0 + ULPS) + 1e-323);
        let (near, far) = (motion::apex_x(alpha, eps), flight::flight_range(alpha, eps));
        prop_assert!(near <= far * (1.0 + ULPS) && far <= 2.0 * near * (1.0 + ULPS) + 1e-323);
    }

    #[test]
    fn drag_shortens_flights(alpha in rising_angle(), a in drag(), b in drag()) {
        let (less, more) = (a.min(b), a.max(b));
        for quantity in [flight::flight_time, flight::flight_range] {
            prop_assert!(quantity(alpha, more) <= quantity(alpha, less) * (1.0 + ULPS) + 5e-324);
        }
        prop_assert!(flight::optimal_angle(more) <= flight::optimal_angle(less) * (1.0 + ULPS));
        prop_assert!(flight::optimal_angle(less) <= FRAC_PI_4);
    }

    #[test]
    fn no_range_exceeds_that_of_the_best_angle(alpha in rising_angle(), eps in drag()) {
        let best = flight::flight_range(flight::optimal_angle(eps), eps);
        prop_assert!(flight::flight_range(alpha, eps) <= best * (1.0 + ULPS));
    }

    #[test]
    fn aim_flies_through_its_target(alpha in -1.4..1.4f64, share in 0.01..0.99f64, eps in (-7.0..5.0f64).prop_map(f64::exp2)) {
        let t = 3.0 * share;
        let (x, y) = (flight::flight_x(t, alpha, eps), flight::flight_y(t, alpha, eps));
        let (low, high) = (flight::aim_low(x, y, eps), flight::aim_high(x, y, eps));
        prop_assert!(low <= high);
        // one of the arcs is the shot the target was taken from, to the target's digits
        let miss = (low - alpha).abs().min((high - alpha).abs());
        let steepness = (eps * t).exp() * (1.0 + t) * (1.0 + t);
        let margin = (flight::envelope_height(x, eps) - y).max(1e-16).sqrt();
        prop_assert!(miss <= 1e-13 * steepness / margin / (1.0 - x * eps).max(1e-9), "{low} {high} {alpha}");
    }

    #[test]
    fn above_the_envelope_there_is_no_shot(x in -2.0..2.0f64, above in (-40.0..10.0f64).prop_map(f64::exp2), eps in drag()) {
        let top = flight::envelope_height(x, eps);
        let y = top + above * (1.0 + top.abs());
        prop_assert!(flight::aim_low(x, y, eps).is_nan() && flight::aim_high(x, y, eps).is_nan());
        if top > f64::NEG_INFINITY {
            let (low, high) = (flight::aim_low(x, top, eps), flight::aim_high(x, top, eps));
            prop_assert!(low == high && (0.0..=PI).contains(&low));
        }
    }

    #[test]
    fn bad_input_has_no_value(eps in drag(), bad in prop_oneof![Just(f64::NAN), Just(f64::INFINITY), -1e3..-1e-300f64]) {
        prop_assert!(flight::flight_time(1.0, bad).is_nan() && flight::flight_range(1.0, bad).is_nan());
        prop_assert!(flight::flight_time(bad, eps).is_nan() && flight::flight_range(bad, eps).is_nan());
        prop_assert!(flight::flight_x(bad, 1.0, eps).is_nan() && flight::flight_y(bad, 1.0, eps).is_nan());
        prop_assert!(flight::flight_x(1.0, 1.0, bad).is_nan() && flight::flight_y(1.0, 1.0, bad).is_nan());
        prop_assert!(flight::trajectory_height(bad, 1.0, eps).is_nan());
        prop_assert!(flight::envelope_height(0.0, bad).is_nan() && flight::optimal_angle(bad).is_nan());
        prop_assert!(flight::aim_low(0.1, -1.0, bad).is_nan() && flight::aim_high(0.1, -1.0, bad).is_nan());
    }
}

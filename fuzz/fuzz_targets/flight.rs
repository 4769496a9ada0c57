#![no_main]

use std::f64::consts::{FRAC_PI_4, PI};

use archerfish_fuzz::{binary, doubles, ternary, unary};
use libfuzzer_sys::fuzz_target;

/// The strongest drag for which the functions of flight promise a value.
const STRONGEST: f64 = 1e300;

fuzz_target!(|bytes: &[u8]| {
    let numbers = doubles(bytes);
    check(&numbers);
    // most doubles are neither times nor angles: the same bytes once more, brought into the domain
    let inside = |(i, x): (usize, &f64)| if i % 3 == 1 { x.abs() % PI } else { x.abs() };
    check(&numbers.iter().enumerate().map(inside).collect::<Vec<_>>());
});

/// Takes the numbers as (time or abscissa, launch angle, ε) in turn.
fn check(numbers: &[f64]) {
    let rows = numbers.chunks_exact(3);
    let column = |k: usize| rows.clone().map(|row| row[k]).collect::<Vec<f64>>();
    let [x, alpha, eps] = [column(0), column(1), column(2)];
    let best = unary("optimal_angle", &eps);
    let time = binary("flight_time", &alpha, &eps);
    let range = binary("flight_range", &alpha, &eps);
    let apex = binary("apex_time", &alpha, &eps);
    for name in ["flight_x", "flight_y", "trajectory_height"] {
        ternary(name, &x, &alpha, &eps);
    }
    let envelope = binary("envelope_height", &x, &eps);
    let low = ternary("aim_low", &x, &alpha, &eps);
    let high = ternary("aim_high", &x, &alpha, &eps);
    for i in 0..eps.len() {
        let (a, e) = (alpha[i], eps[i]);
        // here the second number is a height; far below the launcher both arcs fall straight down
        let near = a.abs() < 1e30;
        assert_eq!(
            near && low[i].is_nan(),
            near && high[i].is_nan(),
            "arcs at {:e}, {a:e}, {e:e}",
            x[i]
        );
        assert!(!(near && x[i] >= 0.0 && low[i] > high[i]), "arcs at {:e}, {a:e}, {e:e}", x[i]);
        // the last digits above the envelope count as on it
        let above = a > envelope[i] + 1e-13 * (envelope[i].abs() + x[i]) && x[i] >= 0.0;
        assert!(!above || low[i].is_nan(), "aim_low at {:e}, {a:e}, {e:e}", x[i]);
        if !((0.0..=STRONGEST).contains(&e)) {
            assert!(e > STRONGEST || best[i].is_nan(), "optimal_angle at {e:e}");
            continue;
        }
        assert!((0.0..=FRAC_PI_4).contains(&best[i]), "optimal_angle at {e:e} is {:e}", best[i]);
        let angle = (0.0..=PI).contains(&a);
        assert_eq!(angle, !time[i].is_nan(), "flight_time at {a:e}, {e:e} is {:e}", time[i]);
        assert_eq!(angle, !range[i].is_nan(), "flight_range at {a:e}, {e:e} is {:e}", range[i]);
        // the fall takes longer than the climb, both rounded
        let subnormal = apex[i] < 1e-300;
        assert!(subnormal || !(time[i] < apex[i] * (2.0 - 1e-15)), "flight_time at {a:e}, {e:e}");
        assert!(!angle || (range[i] >= 0.0) == (a <= PI / 2.0) || range[i] == 0.0);
    }
}

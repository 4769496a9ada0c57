#![no_main]

use std::f64::consts::{FRAC_PI_2, PI};

use archerfish::batch::BINARY;
use archerfish_fuzz::{assert_domain, binary, pairs};
use libfuzzer_sys::fuzz_target;

/// The strongest drag for which the functions of motion promise a value.
const STRONGEST: f64 = 1e300;

fuzz_target!(|bytes: &[u8]| {
    let (angle, eps) = pairs(bytes);
    check(&angle, &eps);
    // most doubles are no angles: the same bytes once more, brought into the domain
    let angle: Vec<f64> = angle.iter().map(|a| a.abs() % PI).collect();
    let eps: Vec<f64> = eps.iter().map(|e| e.abs()).collect();
    check(&angle, &eps);
});

fn check(angle: &[f64], eps: &[f64]) {
    for (name, _) in BINARY.iter().filter(|(n, _)| n.starts_with("apex") || n.starts_with("locus"))
    {
        let values = binary(name, angle, eps);
        for i in 0..angle.len() {
            let (a, e) = (angle[i], eps[i]);
            let inside = (0.0..=PI).contains(&a) && (0.0..=STRONGEST).contains(&e);
            let outside = !(0.0..=PI).contains(&a) || !(0.0..f64::INFINITY).contains(&e);
            if inside || outside {
                assert_domain(name, &[a, e], inside, values[i]);
            }
            let signed = matches!(*name, "apex_x" | "locus_launch_angle_d2");
            assert!(signed || !(values[i] < 0.0), "{name} at {a:e}, {e:e} is {:e}", values[i]);
        }
    }
    let theta = binary("apex_elevation", angle, eps);
    let back = binary("locus_launch_angle", &theta, eps);
    let slope = binary("locus_launch_angle_d1", &theta, eps);
    for i in 0..angle.len() {
        let (a, e, t) = (angle[i], eps[i], theta[i]);
        if t.is_nan() || e > STRONGEST {
            continue;
        }
        // θ lies between α and 0, or between α and π
        assert!(if a <= FRAC_PI_2 { t <= a } else { t >= a }, "θ at {a:e}, {e:e} is {t:e}");
        // θ is known to two ulp, and so is α(θ)
        let near = 2.0 * f64::EPSILON * (slope[i] * t + a) + 1e-307;
        assert!((back[i] - a).abs() <= near, "α(θ(α)) at {a:e}, {e:e} is {:e}", back[i]);
    }
}

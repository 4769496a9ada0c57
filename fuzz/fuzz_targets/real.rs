#![no_main]

use std::f64::consts::{FRAC_PI_2, PI};

use archerfish::real;
use archerfish_fuzz::{assert_domain, doubles, pairs, unary};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let x = doubles(bytes);
    let log1pmx = unary("log1pmx", &x);
    for i in 0..x.len() {
        let x = x[i];
        assert_domain("log1pmx", &[x], x >= -1.0, log1pmx[i]);
        assert!(!(log1pmx[i] > 0.0), "log1pmx at {x:e}");
        one(x);
    }
    let (y, x) = pairs(bytes);
    for (y, x) in y.into_iter().zip(x) {
        let angle = real::atan2(y, x);
        assert_domain("atan2", &[y, x], !y.is_nan() && !x.is_nan(), angle);
        assert!(!(angle.abs() > PI), "atan2 at {y:e}, {x:e}");
    }
});

fn one(x: f64) {
    let number = !x.is_nan();
    assert_domain("exp", &[x], number, real::exp(x));
    assert_domain("exp_m1", &[x], number, real::exp_m1(x));
    assert_domain("atan", &[x], number, real::atan(x));
    assert_domain("ln", &[x], x >= 0.0, real::ln(x));
    assert_domain("ln_1p", &[x], x >= -1.0, real::ln_1p(x));
    assert_domain("sqrt", &[x], x >= 0.0, real::sqrt(x));
    assert!(!(real::exp(x) < 0.0 || real::exp_m1(x) < -1.0), "exponentials at {x:e}");
    assert!(!(real::atan(x).abs() > FRAC_PI_2), "atan at {x:e}");
    let (sin, cos) = real::sin_cos(x);
    let inside = x.abs() <= 2.0 * PI;
    assert_domain("sin", &[x], inside, sin);
    assert_domain("cos", &[x], inside, cos);
    assert_domain("tan", &[x], inside, real::tan(x));
    assert!(!inside || (sin * sin + cos * cos - 1.0).abs() < 5e-16, "sin² + cos² at {x:e}");
    // an odd function is odd to the last bit
    assert!(!inside || real::tan(-x) == -real::tan(x), "tan at ±{x:e}");
    assert!(!number || real::atan(-x) == -real::atan(x), "atan at ±{x:e}");
    let back = real::exp(real::ln(x));
    let near = (back - x).abs() <= x * 1e-13;
    assert!(!(x > 1e-300 && x < 1e300) || near, "exp ln at {x:e} is {back:e}");
}

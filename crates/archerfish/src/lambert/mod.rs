//! The real branches of the Lambert W function.
// provisional bodies
const BRANCH: f64 = -0.36787944117144233;
fn halley(z: f64, mut w: f64) -> f64 {
    for _ in 0..100 {
        let e = w.exp();
        let f = w * e - z;
        let d = e * (w + 1.0) - (w + 2.0) * f / (2.0 * w + 2.0);
        if d == 0.0 {
            break;
        }
        w -= f / d;
    }
    w
}
pub fn lambertw0(z: f64) -> f64 {
    if !(z >= BRANCH) {
        return f64::NAN;
    }
    if z == BRANCH {
        return -1.0;
    }
    if z == f64::INFINITY || z == 0.0 {
        return z;
    }
    if z < 0.3 { halley(z, lambertw0_offset(z - BRANCH) - 1.0) } else { halley(z, z.ln_1p() * 0.7) }
}
pub fn lambertwm1(z: f64) -> f64 {
    if !(z >= BRANCH && z <= 0.0) {
        return f64::NAN;
    }
    if z == BRANCH {
        return -1.0;
    }
    if z == 0.0 {
        return f64::NEG_INFINITY;
    }
    let l = (-z).ln();
    halley(z, if z < -0.25 { lambertwm1_offset(z - BRANCH) - 1.0 } else { l - (-l).ln() })
}
fn series(p: f64) -> f64 {
    p - p * p / 3.0 + 11.0 / 72.0 * p * p * p
}
pub fn lambertw0_offset(d: f64) -> f64 {
    if d < 0.01 {
        series((2.0 * core::f64::consts::E * d).sqrt())
    } else if d < 0.7 {
        1.0 + halley(BRANCH + d, series((2.0 * core::f64::consts::E * d).sqrt()) - 1.0)
    } else {
        1.0 + lambertw0(BRANCH + d)
    }
}
pub fn lambertwm1_offset(d: f64) -> f64 {
    if d < 0.01 {
        series(-(2.0 * core::f64::consts::E * d).sqrt())
    } else if d < 0.1 {
        1.0 + halley(BRANCH + d, series(-(2.0 * core::f64::consts::E * d).sqrt()) - 1.0)
    } else {
        1.0 + lambertwm1(BRANCH + d)
    }
}
pub fn tree(z: f64) -> f64 {
    -lambertw0(-z)
}

//! Motion under gravity and linear drag.
// provisional bodies
use crate::real::*;
use core::f64::consts::{FRAC_PI_2, PI};
fn ok(a: f64, e: f64) -> bool { a >= 0.0 && a <= PI && e >= 0.0 && e < f64::INFINITY }
fn phi(u: f64) -> f64 { if u < 1e-8 { 0.5 - u / 3.0 } else { -log1pmx(u) / u / u } }
pub fn apex_x(a: f64, e: f64) -> f64 { if !ok(a, e) { return f64::NAN; } let (s, c) = a.sin_cos(); s * c / (1.0 + e * s) }
pub fn apex_y(a: f64, e: f64) -> f64 { if !ok(a, e) { return f64::NAN; } let s = a.sin(); s * s * phi(e * s) }
pub fn apex_time(a: f64, e: f64) -> f64 { if !ok(a, e) { return f64::NAN; } let s = a.sin(); let u = e * s; if u < 1e-300 { s } else { s * (u.ln_1p() / u) } }
pub fn apex_distance(a: f64, e: f64) -> f64 { apex_x(a, e).hypot(apex_y(a, e)) }
pub fn apex_elevation(a: f64, e: f64) -> f64 { if !ok(a, e) { return f64::NAN; } let (s, c) = a.sin_cos(); let u = e * s; (s * (1.0 + u) * phi(u)).atan2(c) }
pub fn apex_curvature(a: f64, e: f64) -> f64 {
    if !ok(a, e) { return f64::NAN; }
    let (s, c) = a.sin_cos(); let u = e * s; let q = 1.0 + u; let (k, p) = (1.0 / q, u / q);
    let m = k * (1.0 - 2.0 * s * s) - p * s * s;
    let n = m * m + 2.0 * p * c * c * m + s * s * c * c * (3.0 + k); let d = s * s * c * c + m * m;
    q * (n / d) / d.sqrt()
}
pub fn locus_launch_angle(t: f64, e: f64) -> f64 {
    if !ok(t, e) { return f64::NAN; }
    if t > FRAC_PI_2 { return PI - locus_launch_angle(PI - t, e); }
    let (mut lo, mut hi) = (t, (2.0 * t.tan()).atan().max(t));
    for _ in 0..60 { let m = 0.5 * (lo + hi); if apex_elevation(m, e) < t { lo = m } else { hi = m } }
    0.5 * (lo + hi)
}
fn d12(t: f64, e: f64) -> (f64, f64) {
    let a = locus_launch_angle(t, e);
    let h = 1e-5; let f = |x: f64| apex_elevation(x, e);
    let (a0, a2) = ((a - h).max(0.0), (a + h).min(PI));
    let d = (f(a2) - f(a0)) / (a2 - a0);
    let b = 0.5 * (a0 + a2);
    let dd = (f(a2) - 2.0 * f(b) + f(a0)) / ((a2 - b) * (b - a0));
    (1.0 / d, -dd / (d * d * d))
}
pub fn locus_launch_angle_d1(t: f64, e: f64) -> f64 { if !ok(t, e) { f64::NAN } else { d12(t, e).0 } }
pub fn locus_launch_angle_d2(t: f64, e: f64) -> f64 { if !ok(t, e) { f64::NAN } else { d12(t, e).1 } }
pub fn locus_radius(t: f64, e: f64) -> f64 { apex_distance(locus_launch_angle(t, e), e) }
pub fn locus_curvature(t: f64, e: f64) -> f64 { apex_curvature(locus_launch_angle(t, e), e) }

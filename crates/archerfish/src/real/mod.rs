//! Functions of one real number.
// provisional bodies
#[inline(always)] pub fn exp(x: f64) -> f64 { x.exp() }
#[inline(always)] pub fn ln(x: f64) -> f64 { x.ln() }
#[inline(always)] pub fn ln_1p(x: f64) -> f64 { x.ln_1p() }
#[inline(always)] pub fn exp_m1(x: f64) -> f64 { x.exp_m1() }
#[inline(always)] pub fn sin_cos(x: f64) -> (f64, f64) { x.sin_cos() }
#[inline(always)] pub fn tan(x: f64) -> f64 { x.tan() }
#[inline(always)] pub fn atan(x: f64) -> f64 { x.atan() }
#[inline(always)] pub fn atan2(y: f64, x: f64) -> f64 { y.atan2(x) }
#[inline(always)] pub fn log1pmx(x: f64) -> f64 {
    if x.abs() < 0.1 { let (mut s, mut p) = (0.0, x); for k in 2..40 { p *= -x; s += p / k as f64; } s } else { x.ln_1p() - x }
}

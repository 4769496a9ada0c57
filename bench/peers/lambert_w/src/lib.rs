//! The lambert_w crate over arrays, for bench/peers.py.

use std::slice;

/// # Safety
/// `z` has `count` readable, `out` as many writable doubles.
#[inline(always)]
unsafe fn each(function: impl Fn(f64) -> f64, z: *const f64, out: *mut f64, count: usize) {
    // SAFETY: the caller's promise.
    let (z, out) =
        unsafe { (slice::from_raw_parts(z, count), slice::from_raw_parts_mut(out, count)) };
    for (value, &z) in out.iter_mut().zip(z) {
        *value = function(z);
    }
}

/// # Safety
/// As [`each`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn lambertw0(z: *const f64, out: *mut f64, count: usize) {
    // SAFETY: the caller's promise.
    unsafe { each(lambert_w::lambert_w0, z, out, count) }
}

/// # Safety
/// As [`each`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn lambertwm1(z: *const f64, out: *mut f64, count: usize) {
    // SAFETY: the caller's promise.
    unsafe { each(lambert_w::lambert_wm1, z, out, count) }
}

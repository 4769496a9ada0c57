//! Projectile motion under gravity and linear drag, computed to the last digits.
#![cfg_attr(not(feature = "std"), no_std)]
// from f64 to f64, where a browser's kernels turn a double into a pair
#![allow(clippy::useless_conversion)]

/// The type of an argument that may be a literal. (Were it generic here as well, the compiler would
/// order what it compiles differently, and vectors would wait for other things.)
macro_rules! operand {
    () => {
        f64
    };
}

pub mod flight;
pub mod lambert;
pub mod motion;
pub mod real;

mod number;

#[cfg(feature = "std")]
pub mod batch;
#[cfg(all(feature = "std", not(target_arch = "wasm32")))]
mod dispatch;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
mod fused;
#[cfg(all(feature = "std", target_arch = "wasm32"))]
mod pair;
#[cfg(all(feature = "std", target_arch = "wasm32"))]
mod pairs;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
mod twin;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
mod twins;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
mod wide;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
mod wides;

/// What the kernels compute with: a double. (They are compiled for several doubles at once as well:
/// `pairs` in a browser, `twins` for AVX2, `wides` for AVX-512.)
pub type Number = f64;
/// The same in single precision.
type Single = f32;
/// What a comparison of numbers gives.
type Mask = bool;
/// The bits of a number.
type Integer = u64;

/// A constant among the numbers.
const fn constant(x: f64) -> Number {
    x
}

/// Whether errors of products come from a fused instruction; `fused` is these modules with it.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
const FUSED: bool = false;

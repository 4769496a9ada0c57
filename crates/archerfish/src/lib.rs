//! Projectile motion under gravity and linear drag, computed to the last digits.
#![cfg_attr(not(feature = "std"), no_std)]

pub mod flight;
pub mod lambert;
pub mod motion;
pub mod real;

#[cfg(feature = "std")]
pub mod batch;
#[cfg(all(feature = "std", not(target_arch = "wasm32")))]
mod dispatch;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
mod fused;
#[cfg(all(feature = "std", target_arch = "wasm32"))]
mod pairs;

/// Whether errors of products come from a fused instruction; `fused` is these modules with it.
const FUSED: bool = false;

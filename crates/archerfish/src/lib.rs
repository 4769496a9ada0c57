//! Projectile motion under gravity and linear drag, computed to the last digits.
#![cfg_attr(not(feature = "std"), no_std)]

pub mod flight;
pub mod lambert;
pub mod motion;
pub mod real;

#[cfg(feature = "std")]
pub mod batch;
#[cfg(feature = "std")]
mod dispatch;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
mod fused;

/// Whether errors of products come from a fused instruction; `fused` is these modules with it.
const FUSED: bool = false;

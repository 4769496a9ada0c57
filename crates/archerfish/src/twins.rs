//! All functions once more, from the same files, over two elements at a time, for AVX2.
//!
//! The compiler takes two vectors of elements at a time in each loop (`.cargo/config.toml`). One result
//! after the other is waited for, and four are faster. With two elements in one step, two vectors are
//! four.

// what no batch needs, and files of two modules, on purpose
#![allow(dead_code, unused_imports, clippy::duplicate_mod)]

use crate::twin::Twin;

pub(crate) type Number = Twin<f64>;
pub(crate) type Single = Twin<f32>;
pub(crate) type Mask = Twin<bool>;
pub(crate) type Integer = Twin<u64>;

pub(crate) const FUSED: bool = true;

/// A constant among the numbers.
pub(crate) const fn constant(x: f64) -> Number {
    Twin::of(x)
}

macro_rules! operand {
    () => {
        impl Into<$crate::twins::Number>
    };
}

#[path = "flight/mod.rs"]
pub mod flight;
#[path = "lambert/mod.rs"]
pub mod lambert;
#[path = "motion/mod.rs"]
pub mod motion;
#[path = "real/mod.rs"]
pub mod real;

/// Elements of a block: the first half of it goes in step with the second, each as two vectors of four.
pub(crate) const BLOCK: usize = 16;
/// Below this many elements all go the other way: too few are left in blocks.
pub(crate) const SHORT: usize = 256;

//! All functions once more, from the same files, over blocks of elements, for AVX-512.
//!
//! The compiler would make vectors of the plain loop as well. Written down, they can be looked up in
//! tables that registers hold, and four of them are in flight.

// what no batch needs, and files of two modules, on purpose
#![allow(dead_code, unused_imports, clippy::duplicate_mod)]

pub(crate) use crate::wide::{
    Wide as Number, WideBits as Integer, WideMask as Mask, WideSingle as Single,
};

pub(crate) const FUSED: bool = true;

/// A constant among the numbers.
pub(crate) const fn constant(x: f64) -> Number {
    Number::of(x)
}

macro_rules! operand {
    () => {
        impl Into<$crate::wides::Number>
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

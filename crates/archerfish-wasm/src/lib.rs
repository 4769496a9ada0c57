//! The WebAssembly door: every function of the core's tables, on linear memory. No arithmetic here.
//!
//! The host asks for room with [`allocate`], writes the arguments into it, calls [`evaluate`] with
//! the number of a function, and reads the values where it had them written: nothing is copied.
//! `js/kernels.js` does all that by name.
#![cfg(target_arch = "wasm32")]

use std::arch::wasm32;
use std::{ptr, slice};

use archerfish::batch::{
    BINARY, BINARY_FOUR, BINARY_PAIR, BinaryBatch, BinaryFourBatch, BinaryPairBatch, TERNARY,
    TernaryBatch, UNARY, UnaryBatch,
};

/// A function of the tables, whatever the number of its arguments and results.
#[derive(Clone, Copy)]
enum Kernel {
    Unary(UnaryBatch),
    Binary(BinaryBatch),
    Ternary(TernaryBatch),
    BinaryPair(BinaryPairBatch),
    BinaryFour(BinaryFourBatch),
}

/// Name and function of a number from 0 on: the tables, one after the other.
fn find(number: usize) -> Option<(&'static str, Kernel)> {
    let unary = UNARY.iter().map(|&(name, function)| (name, Kernel::Unary(function)));
    let binary = BINARY.iter().map(|&(name, function)| (name, Kernel::Binary(function)));
    let ternary = TERNARY.iter().map(|&(name, function)| (name, Kernel::Ternary(function)));
    let pair = BINARY_PAIR.iter().map(|&(name, function)| (name, Kernel::BinaryPair(function)));
    let four = BINARY_FOUR.iter().map(|&(name, function)| (name, Kernel::BinaryFour(function)));
    unary.chain(binary).chain(ternary).chain(pair).chain(four).nth(number)
}

/// Address of the name (ASCII) of a function; 0 past the last.
#[unsafe(no_mangle)]
pub extern "C" fn name(number: usize) -> *const u8 {
    find(number).map_or(ptr::null(), |(name, _)| name.as_ptr())
}

/// Length of that name.
#[unsafe(no_mangle)]
pub extern "C" fn name_length(number: usize) -> usize {
    find(number).map_or(0, |(name, _)| name.len())
}

/// How many arguments it takes.
#[unsafe(no_mangle)]
pub extern "C" fn inputs(number: usize) -> usize {
    match find(number) {
        Some((_, Kernel::Unary(_))) => 1,
        Some((_, Kernel::Binary(_) | Kernel::BinaryPair(_) | Kernel::BinaryFour(_))) => 2,
        Some((_, Kernel::Ternary(_))) => 3,
        None => 0,
    }
}

/// How many results it has; 0 past the last function.
#[unsafe(no_mangle)]
pub extern "C" fn outputs(number: usize) -> usize {
    match find(number) {
        Some((_, Kernel::BinaryPair(_))) => 2,
        Some((_, Kernel::BinaryFour(_))) => 4,
        Some(_) => 1,
        None => 0,
    }
}

/// Room for `count` doubles, all 0, for ever: what a page needs is allocated once. Null where there
/// is no more memory.
#[unsafe(no_mangle)]
pub extern "C" fn allocate(count: usize) -> *mut f64 {
    // Whole pages from the system: an allocator that takes room back would be a tenth of the file.
    const PAGE: usize = 65_536;
    let pages = (count * size_of::<f64>()).div_ceil(PAGE);
    match wasm32::memory_grow::<0>(pages) {
        usize::MAX => ptr::null_mut(),
        before => ptr::with_exposed_provenance_mut(before * PAGE),
    }
}

/// Fills the columns of results with the values of a function at the arguments; those beyond its
/// numbers of both are not looked at.
///
/// # Safety
/// Each address is one of [`allocate`]'s, with room for `count` doubles, and each of the results is
/// none of the others.
#[unsafe(no_mangle)]
// Addresses as numbers are all that JavaScript can hand over; an array of them would be a copy.
#[allow(clippy::too_many_arguments)]
pub unsafe extern "C" fn evaluate(
    number: usize,
    count: usize,
    x0: *const f64,
    x1: *const f64,
    x2: *const f64,
    out0: *mut f64,
    out1: *mut f64,
    out2: *mut f64,
    out3: *mut f64,
) {
    // SAFETY: the caller's promise.
    let of = |x| unsafe { slice::from_raw_parts(x, count) };
    // SAFETY: the caller's promise.
    let to = |out| unsafe { slice::from_raw_parts_mut(out, count) };
    match find(number) {
        Some((_, Kernel::Unary(function))) => function(of(x0), to(out0)),
        Some((_, Kernel::Binary(function))) => function(of(x0), of(x1), to(out0)),
        Some((_, Kernel::Ternary(function))) => function(of(x0), of(x1), of(x2), to(out0)),
        Some((_, Kernel::BinaryPair(function))) => {
            function(of(x0), of(x1), to(out0), to(out1));
        }
        Some((_, Kernel::BinaryFour(function))) => {
            function(of(x0), of(x1), to(out0), to(out1), to(out2), to(out3));
        }
        None => {}
    }
}

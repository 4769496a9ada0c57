//! The WebAssembly door: every function of the core's tables, on linear memory. No arithmetic here.
//!
//! The host asks for room with [`allocate`], writes the arguments into it, calls [`evaluate`] with
//! the number of a function, and reads the values where it had them written: nothing is copied.
//! `js/kernels.js` does all that by name.
#![cfg(target_arch = "wasm32")]

use std::arch::wasm32;
use std::{ptr, slice};

use archerfish::batch::{self, BINARY, BINARY_FOUR, BINARY_PAIR, Kernel, TERNARY, UNARY};

type Table = &'static [(&'static str, Kernel)];

/// The tables, with the numbers of arguments and of results of their functions.
const TABLES: [(Table, usize, usize); 5] =
    [(UNARY, 1, 1), (BINARY, 2, 1), (TERNARY, 3, 1), (BINARY_PAIR, 2, 2), (BINARY_FOUR, 2, 4)];

/// A function, with its name and the numbers of its arguments and of its results.
struct Function {
    name: &'static str,
    inputs: usize,
    outputs: usize,
    kernel: Kernel,
}

/// The function of a number from 0 on: the tables, one after the other.
#[inline(never)]
fn find(number: usize) -> Option<Function> {
    let mut before = 0;
    for (table, inputs, outputs) in TABLES {
        if let Some(&(name, kernel)) = table.get(number - before) {
            return Some(Function { name, inputs, outputs, kernel });
        }
        before += table.len();
    }
    None
}

/// Address of the name (ASCII) of a function; 0 past the last.
#[unsafe(no_mangle)]
pub extern "C" fn name(number: usize) -> *const u8 {
    find(number).map_or(ptr::null(), |function| function.name.as_ptr())
}

/// Length of that name.
#[unsafe(no_mangle)]
pub extern "C" fn name_length(number: usize) -> usize {
    find(number).map_or(0, |function| function.name.len())
}

/// How many arguments it takes.
#[unsafe(no_mangle)]
pub extern "C" fn inputs(number: usize) -> usize {
    find(number).map_or(0, |function| function.inputs)
}

/// How many results it has; 0 past the last function.
#[unsafe(no_mangle)]
pub extern "C" fn outputs(number: usize) -> usize {
    find(number).map_or(0, |function| function.outputs)
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

/// Fills the columns of results with the values of a function at the arguments; what is given beyond
/// its number of arguments makes no difference, and beyond its number of results is not looked at.
///
/// # Safety
/// Each address is one of [`allocate`]'s, with room for `count` doubles, and each of the results that
/// the function has is none of the others.
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
    if let Some(Function { kernel, outputs, .. }) = find(number) {
        // SAFETY: the caller's promise.
        let of = |x| unsafe { slice::from_raw_parts(x, count) };
        let to = |k, out| {
            let room = if k < outputs { count } else { 0 };
            // SAFETY: the caller's promise.
            unsafe { slice::from_raw_parts_mut(out, room) }
        };
        let results = [to(0, out0), to(1, out1), to(2, out2), to(3, out3)];
        batch::evaluate(kernel, [of(x0), of(x1), of(x2)], results);
    }
}

//! The NumPy ufunc boundary, and all the `unsafe` of this crate.
//!
//! A loop goes through its elements in blocks that fit the stack. An input is copied to a block
//! (which undoes strides, misalignment, float32 and an `out=` that is the input itself) unless it
//! already is a plain slice of `f64` apart from the output; the output likewise.
//!
//! NumPy releases the GIL around these loops by itself (it does for every loop without Python
//! objects), so nothing in them may touch Python; `python/tests/boundary/test_threads.py` watches
//! two of them run at once.

#[cfg(target_arch = "x86_64")]
use std::arch::asm;
use std::array;
use std::ffi::{CString, c_char, c_int, c_void};
use std::slice;

use numpy::npyffi::{NPY_TYPES, PY_UFUNC_API, PyUFuncGenericFunction, npy_intp};
use pyo3::ffi;
use pyo3::prelude::*;

use crate::kernel::{Kernel, MAX_INPUTS};

/// Elements in a block: three blocks of `f64` take 6 KiB, well inside the first-level cache.
const BLOCK: usize = 256;

/// Elements that a kernel is given at once where nothing is copied: the results are looked through
/// for NaN afterwards, and are still in the first-level cache.
const STRETCH: usize = 2048;

/// Elements in a block for operands no longer than that, for whom clearing 6 KiB would take longer
/// than everything else.
const SMALL: usize = 8;

/// The loops of every ufunc, float32 first: NumPy takes the first to which the inputs cast safely.
const LOOPS: [(NPY_TYPES, PyUFuncGenericFunction); 2] = [
    (NPY_TYPES::NPY_FLOAT, Some(inner_loop::<f32>)),
    (NPY_TYPES::NPY_DOUBLE, Some(inner_loop::<f64>)),
];

/// `PyUFunc_None`: no identity, so `reduce` over nothing is NumPy's ValueError.
const NO_IDENTITY: c_int = -1;

/// Adds the ufunc `name` to `module`. Its docstring comes from `archerfish/_ufunc_docs.py`.
pub fn register(module: &Bound<'_, PyModule>, name: &str, kernel: Kernel) -> PyResult<()> {
    let py = module.py();
    let inputs = kernel.inputs();
    let kernel: *mut Kernel = Box::leak(Box::new(kernel));
    // NumPy keeps every pointer it gets here for as long as the process lives: leak the arrays.
    let functions = LOOPS.map(|(_, function)| function).to_vec().leak();
    let data = LOOPS.map(|_| kernel.cast::<c_void>()).to_vec().leak();
    let types = LOOPS.map(|(of_loop, _)| vec![of_loop as c_char; inputs + 1]).concat().leak();
    // SAFETY: the GIL is held (`py`); the arrays hold one entry a loop, `types` one for each
    // operand of each loop; they and both strings live for ever.
    let ufunc = unsafe {
        let made = PY_UFUNC_API.PyUFunc_FromFuncAndData(
            py,
            functions.as_mut_ptr(),
            data.as_mut_ptr(),
            types.as_mut_ptr(),
            LOOPS.len() as c_int,
            inputs as c_int,
            1,
            NO_IDENTITY,
            CString::new(name)?.into_raw(),
            c"".as_ptr(),
            0,
        );
        Bound::from_owned_ptr_or_err(py, made)?
    };
    module.add(name, ufunc)
}

/// Whether this is the process's first interpreter, whose number is 0.
pub fn in_main_interpreter(_py: Python<'_>) -> bool {
    // SAFETY: the GIL is held, so there is a current interpreter.
    unsafe { ffi::PyInterpreterState_GetID(ffi::PyInterpreterState_Get()) == 0 }
}

/// The element types of the loops. Everything is computed in `f64`.
trait Element: Copy {
    const IS_F64: bool;
    fn widen(self) -> f64;
    fn narrow(value: f64) -> Self;
}

impl Element for f64 {
    const IS_F64: bool = true;
    #[inline(always)]
    fn widen(self) -> f64 {
        self
    }
    #[inline(always)]
    fn narrow(value: f64) -> f64 {
        value
    }
}

impl Element for f32 {
    const IS_F64: bool = false;
    #[inline(always)]
    fn widen(self) -> f64 {
        f64::from(self)
    }
    #[inline(always)]
    fn narrow(value: f64) -> f32 {
        value as f32
    }
}

/// One operand of a loop: elements of type `T`, `step` bytes apart, aligned or not.
#[derive(Clone, Copy)]
struct Operand {
    start: *mut c_char,
    step: npy_intp,
}

impl Operand {
    /// First address, and the one past the last, of `count` elements of `size` bytes.
    fn extent(self, count: usize, size: usize) -> (isize, isize) {
        let first = self.start as isize;
        let last = first + (count as isize - 1) * self.step;
        (first.min(last), first.max(last) + size as isize)
    }

    /// Whether no byte of `count` elements is shared with the other operand's.
    fn is_apart_from(self, other: Operand, count: usize, size: usize) -> bool {
        let (first, end) = self.extent(count, size);
        let (other_first, other_end) = other.extent(count, size);
        end <= other_first || other_end <= first
    }

    /// Whether element i lies exactly on the other operand's element i, and on no other.
    fn coincides_with(self, other: Operand, size: usize) -> bool {
        self.start == other.start && self.step == other.step && self.step.unsigned_abs() >= size
    }

    /// Whether the elements can be read as a `&[f64]`, given that they are `f64`.
    fn is_slice(self) -> bool {
        self.step == size_of::<f64>() as npy_intp && self.start.cast::<f64>().is_aligned()
    }

    /// Address of element `index`.
    ///
    /// # Safety
    /// The operand has more than `index` elements.
    unsafe fn element(self, index: usize) -> *mut c_char {
        // SAFETY: the caller's promise; NumPy's elements lie within one allocation.
        unsafe { self.start.offset(index as isize * self.step) }
    }

    /// Copies elements, from number `first` on, to `block`.
    ///
    /// # Safety
    /// The operand has `first + block.len()` readable elements of type `T`.
    unsafe fn gather<T: Element>(self, first: usize, block: &mut [f64]) {
        #[inline(always)]
        unsafe fn copy<T: Element>(from: *const c_char, step: isize, block: &mut [f64]) {
            for (i, value) in block.iter_mut().enumerate() {
                // SAFETY: the promise of `gather`; the read supposes no alignment.
                *value =
                    unsafe { from.offset(i as isize * step).cast::<T>().read_unaligned() }.widen();
            }
        }
        let whole = size_of::<T>() as isize;
        // SAFETY: the caller's promise. Side by side, the step is a constant and the loop a vector one.
        unsafe {
            let from = self.element(first);
            if self.step == whole {
                copy::<T>(from, whole, block)
            } else {
                copy::<T>(from, self.step, block)
            }
        }
    }

    /// Copies `block` to the elements from number `first` on.
    ///
    /// # Safety
    /// The operand has `first + block.len()` writable elements of type `T`.
    unsafe fn scatter<T: Element>(self, first: usize, block: &[f64]) {
        #[inline(always)]
        unsafe fn copy<T: Element>(block: &[f64], to: *mut c_char, step: isize) {
            for (i, &value) in block.iter().enumerate() {
                // SAFETY: the promise of `scatter`; the write supposes no alignment.
                unsafe {
                    to.offset(i as isize * step).cast::<T>().write_unaligned(T::narrow(value))
                };
            }
        }
        let whole = size_of::<T>() as isize;
        // SAFETY: the caller's promise.
        unsafe {
            let to = self.element(first);
            if self.step == whole {
                copy::<T>(block, to, whole)
            } else {
                copy::<T>(block, to, self.step)
            }
        }
    }
}

/// The inner loop NumPy calls, for elements of type `T`.
///
/// # Safety
/// As NumPy calls it: `data` is the kernel given to [`register`]; `args` and `steps` have one entry
/// for each operand, inputs first, with `*dimensions` elements of type `T` each.
unsafe extern "C" fn inner_loop<T: Element>(
    args: *mut *mut c_char,
    dimensions: *mut npy_intp,
    steps: *mut npy_intp,
    data: *mut c_void,
) {
    let flags = RaisedFlags::now();
    // SAFETY: the caller's promise.
    let (kernel, count) = unsafe { (*data.cast::<Kernel>(), *dimensions as usize) };
    // SAFETY: the caller's promise; `k` is at most the number of inputs, the output's index.
    let operand = |k: usize| unsafe { Operand { start: *args.add(k), step: *steps.add(k) } };
    let used = kernel.inputs();
    let inputs = array::from_fn(|k| operand(k.min(used - 1)));
    // SAFETY: the caller's promise.
    let nan_born = unsafe {
        if count <= SMALL {
            in_blocks::<T, SMALL>(kernel, count, inputs, operand(used))
        } else {
            in_blocks::<T, BLOCK>(kernel, count, inputs, operand(used))
        }
    };
    flags.restore(nan_born);
}

/// Goes through `count` elements in blocks of `SIZE`, and says whether a NaN was born.
///
/// # Safety
/// Each input has `count` readable, the output `count` writable elements of type `T`.
unsafe fn in_blocks<T: Element, const SIZE: usize>(
    kernel: Kernel,
    count: usize,
    inputs: [Operand; MAX_INPUTS],
    output: Operand,
) -> bool {
    let used = kernel.inputs();
    let size = size_of::<T>();
    let apart = inputs.map(|input| input.is_apart_from(output, count, size));
    // An output that runs into an input out of step (`accumulate` and `reduce` do this) means
    // element by element, each seeing what the one before it wrote.
    let in_step = (0..used).all(|k| apart[k] || inputs[k].coincides_with(output, size));
    let plain =
        T::IS_F64 && output.is_slice() && (0..used).all(|k| apart[k] && inputs[k].is_slice());
    let block = match (in_step, plain) {
        (false, _) => 1,
        (true, false) => SIZE,
        (true, true) => STRETCH,
    };

    let mut copies = [[0.0; SIZE]; MAX_INPUTS];
    let mut results = [0.0; SIZE];
    let mut nan_born = false;
    for first in (0..count).step_by(block) {
        let n = block.min(count - first);
        let mut x: [&[f64]; MAX_INPUTS] = [&[]; MAX_INPUTS];
        for (k, copy) in copies.iter_mut().enumerate().take(used) {
            x[k] = if T::IS_F64 && apart[k] && inputs[k].is_slice() {
                // SAFETY: `n` aligned `f64` side by side that nothing writes in this loop.
                unsafe { slice::from_raw_parts(inputs[k].element(first).cast(), n) }
            } else {
                // A broadcast number was copied for the first block and stays.
                if first == 0 || !apart[k] || inputs[k].step != 0 {
                    // SAFETY: elements `first .. first + n` are within `count`.
                    unsafe { inputs[k].gather::<T>(first, &mut copy[..n]) };
                }
                &copy[..n]
            };
        }
        if T::IS_F64 && output.is_slice() {
            // SAFETY: `n` aligned `f64` side by side; every slice of `x` that is not a copy of ours
            // is apart from them.
            let out = unsafe { slice::from_raw_parts_mut(output.element(first).cast(), n) };
            nan_born |= kernel.fill(x, out);
        } else {
            let out = &mut results[..n];
            nan_born |= kernel.fill(x, out);
            // SAFETY: elements `first .. first + n` are within `count`.
            unsafe { output.scatter::<T>(first, out) };
        }
    }
    nan_born
}

/// The floating-point flags as they stood before a loop.
///
/// Branch-free kernels compute both sides of every choice and leave flags that mean nothing; but
/// flags raised before this call are NumPy's (a cast, an earlier stretch of the same array).
#[cfg(target_arch = "x86_64")]
struct RaisedFlags(u32);

// The C library's functions (below) also go through the x87 unit, which Rust never uses, and that
// takes as long as NumPy needs for a whole call.
#[cfg(target_arch = "x86_64")]
impl RaisedFlags {
    fn now() -> Self {
        let mut status = 0_u32;
        // SAFETY: writes the control and status register to `status`, nothing else.
        unsafe { asm!("stmxcsr [{}]", in(reg) &mut status, options(nostack, preserves_flags)) };
        Self(status)
    }

    /// Puts the flags back, with `invalid` added where a NaN was born.
    fn restore(self, nan_born: bool) {
        const INVALID: u32 = 1;
        let status = if nan_born { self.0 | INVALID } else { self.0 };
        // SAFETY: reads `status` into the register, whose control bits stay as they were; its flags
        // are read by Rust code nowhere, and no trap is enabled in a Python process.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &status, options(nostack)) };
    }
}

#[cfg(not(target_arch = "x86_64"))]
struct RaisedFlags(c_int);

#[cfg(not(target_arch = "x86_64"))]
impl RaisedFlags {
    fn now() -> Self {
        // SAFETY: reads this thread's floating-point status, nothing else.
        Self(unsafe { fetestexcept(FE_ALL_EXCEPT) })
    }

    /// Puts the flags back, with `invalid` added where a NaN was born.
    fn restore(self, nan_born: bool) {
        let raised = if nan_born { self.0 | FE_INVALID } else { self.0 };
        // SAFETY: both calls only write this thread's floating-point status, which Rust code reads
        // nowhere; no trap is enabled in a Python process.
        unsafe {
            feclearexcept(FE_ALL_EXCEPT);
            if raised != 0 {
                feraiseexcept(raised);
            }
        }
    }
}

// C's <fenv.h>: the flags are macros, so their values are written out here.
#[cfg(all(not(target_arch = "x86_64"), not(windows)))]
const FE_INVALID: c_int = 0x01;
#[cfg(all(not(target_arch = "x86_64"), windows))]
const FE_INVALID: c_int = 0x10;
#[cfg(target_arch = "x86")]
const FE_ALL_EXCEPT: c_int = 0x3d;
#[cfg(not(any(target_arch = "x86_64", target_arch = "x86")))]
const FE_ALL_EXCEPT: c_int = 0x1f;

#[cfg(not(target_arch = "x86_64"))]
#[cfg_attr(unix, link(name = "m"))]
unsafe extern "C" {
    fn fetestexcept(flags: c_int) -> c_int;
    fn feclearexcept(flags: c_int) -> c_int;
    fn feraiseexcept(flags: c_int) -> c_int;
}

#[cfg(test)]
mod tests;

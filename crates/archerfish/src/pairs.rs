//! All functions once more, from the same files, for a browser: over two elements at a time.
//!
//! A page fetches the file, so that code is dear. Natively every kernel is one straight line for the
//! compiler to vectorise; here the vectors are written down (`pair.rs`), and the parts that kernels
//! have in common are functions, which they call.

// what no kernel needs, as `tan`, and files of two modules, on purpose
#![allow(dead_code, unused_imports, clippy::duplicate_mod)]

pub(crate) use crate::pair::{Pair as Number, PairBits as Integer, PairMask as Mask};

/// A constant among the numbers.
pub(crate) const fn constant(x: f64) -> Number {
    Number::of(x)
}

macro_rules! operand {
    () => {
        impl Into<$crate::pairs::Number>
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

/// A kernel at two elements: of three numbers, the last of which it need not look at, and with room
/// for four results, of which it may fill the first alone. (By C's rules vectors are handed over in
/// registers.)
#[allow(improper_ctypes_definitions)]
pub type Kernel = extern "C" fn(Number, Number, Number, &mut [Number; 4]);

/// Fills slices with the values of a kernel at others, two elements at a time; a last single element
/// goes as a pair with itself. All slices are of one length.
pub fn evaluate(kernel: Kernel, inputs: [&[f64]; 3], outputs: &mut [&mut [f64]]) {
    let mut values = [constant(0.0); 4];
    let [(x, x_rest), (y, y_rest), (z, z_rest)] = inputs.map(<[f64]>::as_chunks);
    for (i, ((x, y), z)) in x.iter().zip(y).zip(z).enumerate() {
        kernel((*x).into(), (*y).into(), (*z).into(), &mut values);
        for (out, value) in outputs.iter_mut().zip(values) {
            if let Some(out) = out.as_chunks_mut().0.get_mut(i) {
                *out = value.into();
            }
        }
    }
    if let ([x], [y], [z]) = (x_rest, y_rest, z_rest) {
        kernel((*x).into(), (*y).into(), (*z).into(), &mut values);
        for (out, value) in outputs.iter_mut().zip(values) {
            if let Some(out) = out.last_mut() {
                [*out, _] = value.into();
            }
        }
    }
}

/// Defines a [`Kernel`].
macro_rules! batch {
    ($(#[$doc:meta])* $name:ident, $module:ident::$kernel:ident, $x:ident => $out:tt $($in_twins:ident)?) => {
        $crate::pairs::batch! { $name(x, _y, _z) = $module::$kernel(x) => $out }
    };
    ($(#[$doc:meta])* $name:ident, $module:ident::$kernel:ident, $x:ident, $y:ident => $out:tt $($in_twins:ident)?) => {
        $crate::pairs::batch! { $name(x, y, _z) = $module::$kernel(x, y) => $out }
    };
    ($(#[$doc:meta])* $name:ident, $module:ident::$kernel:ident, $x:ident, $y:ident, $z:ident => $out:tt $($in_twins:ident)?) => {
        $crate::pairs::batch! { $name(x, y, z) = $module::$kernel(x, y, z) => $out }
    };
    ($name:ident($x:ident, $y:ident, $z:ident) = $module:ident::$kernel:ident $arguments:tt => ($($out:ident),+)) => {
        #[allow(improper_ctypes_definitions)]
        extern "C" fn $name(
            $x: $crate::pairs::Number,
            $y: $crate::pairs::Number,
            $z: $crate::pairs::Number,
            results: &mut [$crate::pairs::Number; 4],
        ) {
            let [$($out,)+ ..] = results;
            ($(*$out),+) = $crate::pairs::$module::$kernel $arguments;
        }
    };
}
pub(crate) use batch;

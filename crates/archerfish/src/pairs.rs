//! All functions once more, from the same files, for a browser: over two elements at a time.
//!
//! A page fetches the file, so that code is dear. Natively every kernel is one straight line for the
//! compiler to vectorise; here the vectors are written down (`pair.rs`), and the parts that kernels
//! have in common are functions, which they call.

// what no kernel needs, as `tan`, and files of two modules, on purpose
#![allow(dead_code, unused_imports, clippy::duplicate_mod)]

pub(crate) use crate::pair::{
    Pair as Number, PairBits as Integer, PairMask as Mask, PairSingle as Single,
};

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

/// Two elements of a slice.
pub type Two = [f64; 2];

/// A function over slices of up to three arguments and four results; it looks at no others.
pub type Kernel = fn(&[Two], &[Two], &[Two], [&mut [Two]; 4]);

/// Fills slices with the values of a kernel at others; a last single element goes as a pair with
/// itself. All slices are of one length, but for results that the kernel does not have: of none.
pub fn evaluate(kernel: Kernel, inputs: [&[f64]; 3], results: [&mut [f64]; 4]) {
    let [(x, last_x), (y, last_y), (z, last_z)] = inputs.map(<[f64]>::as_chunks);
    let [a, b, c, d] = results.map(<[f64]>::as_chunks_mut);
    kernel(x, y, z, [a.0, b.0, c.0, d.0]);
    if let ([x], [y], [z]) = (last_x, last_y, last_z) {
        let mut values = [[[0.0; 2]]; 4];
        let room = values.each_mut().map(|value| &mut value[..]);
        kernel(&[[*x; 2]], &[[*y; 2]], &[[*z; 2]], room);
        for (last, [[value, _]]) in [a.1, b.1, c.1, d.1].into_iter().zip(values) {
            if let [last] = last {
                *last = value;
            }
        }
    }
}

/// A loop over the elements of several slices at once.
macro_rules! for_each {
    (($pattern:pat) in ($rows:expr) $body:block) => {
        for $pattern in $rows $body
    };
    (($pattern:pat) in ($rows:expr), $slice:ident $(, $slices:ident)* $body:block) => {
        $crate::pairs::for_each! { (($pattern, $slice)) in ($rows.zip($slice)) $(, $slices)* $body }
    };
}
pub(crate) use for_each;

/// Defines a [`Kernel`].
macro_rules! batch {
    ($(#[$doc:meta])* $name:ident, $module:ident::$kernel:ident $(or $ordinary:ident)?, $x:ident => $out:tt) => {
        $crate::pairs::batch! { @ $name(x, _y, _z) = $module::$kernel(x) => $out }
    };
    ($(#[$doc:meta])* $name:ident, $module:ident::$kernel:ident $(or $ordinary:ident)?, $x:ident, $y:ident => $out:tt) => {
        $crate::pairs::batch! { @ $name(x, y, _z) = $module::$kernel(x, y) => $out }
    };
    ($(#[$doc:meta])* $name:ident, $module:ident::$kernel:ident $(or $ordinary:ident)?, $x:ident, $y:ident, $z:ident => $out:tt) => {
        $crate::pairs::batch! { @ $name(x, y, z) = $module::$kernel(x, y, z) => $out }
    };
    (@ $name:ident($x:ident, $y:ident, $z:ident) = $module:ident::$kernel:ident($first:ident $(, $argument:ident)*) => ($($out:ident),+)) => {
        fn $name(
            $x: &[$crate::pairs::Two],
            $y: &[$crate::pairs::Two],
            $z: &[$crate::pairs::Two],
            results: [&mut [$crate::pairs::Two]; 4],
        ) {
            let [$($out,)+ ..] = results;
            $crate::pairs::for_each! { ($first) in ($first.iter()) $(, $argument)* $(, $out)+ {
                let values = $crate::pairs::$module::$kernel((*$first).into() $(, (*$argument).into())*);
                $crate::pairs::hand_out!(values => $($out),+);
            } }
        }
    };
}
pub(crate) use batch;

/// Puts what a kernel gives where it belongs.
macro_rules! hand_out {
    ($values:ident => $out:ident) => {
        *$out = $values.into();
    };
    ($values:ident => $a:ident, $b:ident) => {
        (*$a, *$b) = ($values.0.into(), $values.1.into());
    };
    ($values:ident => $a:ident, $b:ident, $c:ident, $d:ident) => {
        (*$a, *$b) = ($values.0.into(), $values.1.into());
        (*$c, *$d) = ($values.2.into(), $values.3.into());
    };
}
pub(crate) use hand_out;

//! The block loop on operands laid out in every way, against one element after another.
//!
//! `make miri` runs these under Miri, which sees every read and write: outside an operand, of bytes
//! never written, misaligned, or through a slice that something else changes meanwhile.

use super::*;

/// A block short enough for Miri, which takes a microsecond for each step.
const SHORT: usize = 5;

/// Bytes of memory that the operands lie in.
const ROOM: usize = 320;

fn sum(x: &[f64], y: &[f64], out: &mut [f64]) {
    for i in 0..out.len() {
        out[i] = x[i] + 0.5 * y[i];
    }
}

fn next(x: &[f64], out: &mut [f64]) {
    for i in 0..out.len() {
        out[i] = x[i] + 1.0;
    }
}

fn blend(x: &[f64], y: &[f64], z: &[f64], out: &mut [f64]) {
    for i in 0..out.len() {
        out[i] = x[i] + 0.5 * y[i] - 0.25 * z[i];
    }
}

/// Where an operand lies: its first byte, counted from an aligned one, and its step.
#[derive(Clone, Copy, Debug)]
struct Place(usize, isize);

impl Place {
    fn operand(self, room: *mut c_char) -> Operand {
        Operand { start: room.wrapping_add(self.0), step: self.1 }
    }
}

/// Compares the whole memory after `in_blocks` with what one element at a time leaves there.
fn check<T: Element, const SIZE: usize>(kernel: Kernel, count: usize, x: [Place; 3], out: Place) {
    // Doubles make the room aligned; what each element holds at the start is an ordinary number.
    let mut rooms = [[0.0_f64; ROOM / 8]; 2];
    for (i, value) in rooms[0].iter_mut().enumerate() {
        *value = if T::IS_F64 { 1.0 + i as f64 } else { f64::from_bits(0x3f80_0000_3f80_0000) };
    }
    rooms[1] = rooms[0];
    let [mine, plain] = rooms.each_mut().map(|room| room.as_mut_ptr().cast::<c_char>());
    // SAFETY: every place of this file lies inside the room for every count of this file.
    unsafe {
        let inputs = x.map(|place| place.operand(mine));
        in_blocks::<T, SIZE>(kernel, count, inputs, out.operand(mine));
        let inputs = x.map(|place| place.operand(plain));
        for i in 0..count {
            let [mut a, mut b, mut c, mut value] = [[0.0]; 4];
            inputs[0].gather::<T>(i, &mut a);
            inputs[1].gather::<T>(i, &mut b);
            inputs[2].gather::<T>(i, &mut c);
            match kernel {
                Kernel::Unary(function) => function(&a, &mut value),
                Kernel::Binary(function) => function(&a, &b, &mut value),
                Kernel::Ternary(function) => function(&a, &b, &c, &mut value),
            }
            out.operand(plain).scatter::<T>(i, &value);
        }
    }
    let bits = rooms.map(|room| room.map(f64::to_bits));
    assert_eq!(bits[0], bits[1], "count {count}, inputs {x:?}, output {out:?}");
}

fn check_all<T: Element>(count: usize) {
    let size = size_of::<T>();
    let step = size as isize;
    let (low, middle) = (8, ROOM / 2 / 8 * 8);
    let last = (count.max(1) - 1) * size;
    let places = [
        Place(low, step),            // side by side
        Place(low + 1, step),        // misaligned
        Place(low + last, -step),    // backwards
        Place(low, 0),               // one number for all
        Place(low, step + 3),        // with gaps, mostly misaligned
        Place(low + size, step),     // one element on
        Place(low + 4 * size, step), // a few on
    ];
    let outputs = [
        Place(low, step),
        Place(low + size, step),
        Place(low + last, -step),
        Place(middle, step),
        Place(middle + 1, step + 5),
    ];
    for x in places {
        for out in outputs {
            let y = Place(low, step);
            let z = Place(low + 2 * size, step);
            check::<T, SHORT>(Kernel::Unary(next), count, [x; 3], out);
            check::<T, SHORT>(Kernel::Binary(sum), count, [x, y, y], out);
            check::<T, SHORT>(Kernel::Binary(sum), count, [y, x, x], out);
            for operands in [[x, y, z], [y, x, z], [y, z, x]] {
                check::<T, SHORT>(Kernel::Ternary(blend), count, operands, out);
            }
        }
    }
}

#[test]
fn doubles_in_every_layout() {
    for count in [0, 1, SHORT, SHORT + 1, 2 * SHORT + 1] {
        check_all::<f64>(count);
    }
}

#[test]
fn singles_in_every_layout() {
    for count in [0, 1, SHORT, SHORT + 1, 2 * SHORT + 1] {
        check_all::<f32>(count);
    }
}

#[test]
fn kernels_of_the_core_run_in_blocks() {
    let x = [0.5_f64; 3];
    let mut out = [0.0_f64; 3];
    let at = |start: *const f64| Operand { start: start.cast_mut().cast(), step: 8 };
    for (inputs, kernel) in archerfish::batch::UNARY
        .iter()
        .map(|&(_, f)| (1, Kernel::Unary(f)))
        .chain(archerfish::batch::BINARY.iter().map(|&(_, f)| (2, Kernel::Binary(f))))
        .chain(archerfish::batch::TERNARY.iter().map(|&(_, f)| (3, Kernel::Ternary(f))))
    {
        let operands = array::from_fn(|_| at(x.as_ptr()));
        // SAFETY: three doubles each.
        unsafe { in_blocks::<f64, SMALL>(kernel, 3, operands, at(out.as_mut_ptr())) };
        assert_eq!(kernel.inputs(), inputs);
        assert_eq!(out[0].to_bits(), out[2].to_bits());
    }
}

//! Two doubles side by side, in one of WebAssembly's vectors: a `Number` of the kernels.

use core::arch::wasm32::*;
use core::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, MulAssign, Neg, Not, Shl, Shr, Sub};

use crate::number::{Bits, LookUp, Narrow, Order, Table};

/// Two doubles.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(crate) struct Pair(v128);

/// The same in single precision, in the lower half of a vector.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(crate) struct PairSingle(v128);

/// Of each double whether something holds: all its bits, or none.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(crate) struct PairMask(v128);

/// The bits of each double.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(crate) struct PairBits(v128);

impl From<f64> for Pair {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Pair(f64x2_splat(x))
    }
}

impl From<[f64; 2]> for Pair {
    #[inline(always)]
    fn from(pair: [f64; 2]) -> Self {
        let [a, b] = pair;
        Pair(f64x2(a, b))
    }
}

impl From<Pair> for [f64; 2] {
    #[inline(always)]
    fn from(pair: Pair) -> Self {
        [f64x2_extract_lane::<0>(pair.0), f64x2_extract_lane::<1>(pair.0)]
    }
}

impl Pair {
    /// The same number twice.
    pub const fn of(x: f64) -> Self {
        Pair(f64x2(x, x))
    }

    #[inline(always)]
    pub fn to_bits(self) -> PairBits {
        PairBits(self.0)
    }

    #[inline(always)]
    pub fn from_bits(bits: PairBits) -> Self {
        Pair(bits.0)
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Pair(f64x2_sqrt(self.0))
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        Pair(f64x2_abs(self.0))
    }

    #[inline(always)]
    pub fn copysign(self, sign: Self) -> Self {
        Pair(v128_bitselect(sign.0, self.0, f64x2_splat(-0.0)))
    }

    #[inline(always)]
    pub fn is_nan(self) -> PairMask {
        PairMask(f64x2_ne(self.0, self.0))
    }
}

/// A comparison.
macro_rules! compare {
    ($($method:ident = $instruction:ident;)+) => {$(
        #[inline(always)]
        fn $method(self, other: impl Into<Self>) -> PairMask {
            PairMask($instruction(self.0, other.into().0))
        }
    )+};
}

impl Order for Pair {
    type Mask = PairMask;

    compare! {
        is_below = f64x2_lt;
        is_above = f64x2_gt;
        is_at_most = f64x2_le;
        is_at_least = f64x2_ge;
        equals = f64x2_eq;
    }

    #[inline(always)]
    fn select(condition: PairMask, a: Self, b: Self) -> Self {
        Pair(v128_bitselect(a.0, b.0, condition.0))
    }
}

impl Narrow for Pair {
    type Single = PairSingle;

    #[inline(always)]
    fn narrow(self) -> PairSingle {
        PairSingle(f32x4_demote_f64x2_zero(self.0))
    }

    #[inline(always)]
    fn widen(single: PairSingle) -> Self {
        Pair(f64x2_promote_low_f32x4(single.0))
    }
}

impl From<f32> for PairSingle {
    #[inline(always)]
    fn from(x: f32) -> Self {
        PairSingle(f32x4_splat(x))
    }
}

impl PairSingle {
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        PairSingle(f32x4_sqrt(self.0))
    }
}

impl LookUp for Pair {
    type Index = PairBits;

    #[inline(always)]
    fn look_up(table: &Table, index: PairBits) -> Self {
        let of = |index: u64| table[(index & 15) as usize];
        Pair(f64x2(of(u64x2_extract_lane::<0>(index.0)), of(u64x2_extract_lane::<1>(index.0))))
    }
}

/// An operation between pairs, and between a pair and one double.
macro_rules! arithmetic {
    ($($number:ident($of:ty): $trait:ident::$method:ident = $instruction:ident;)+) => {$(
        impl $trait for $number {
            type Output = Self;

            #[inline(always)]
            fn $method(self, b: Self) -> Self {
                $number($instruction(self.0, b.0))
            }
        }

        impl $trait<$of> for $number {
            type Output = Self;

            #[inline(always)]
            fn $method(self, b: $of) -> Self {
                self.$method($number::from(b))
            }
        }

        impl $trait<$number> for $of {
            type Output = $number;

            #[inline(always)]
            fn $method(self, b: $number) -> $number {
                $number::from(self).$method(b)
            }
        }
    )+};
}

arithmetic! {
    Pair(f64): Add::add = f64x2_add;
    Pair(f64): Sub::sub = f64x2_sub;
    Pair(f64): Mul::mul = f64x2_mul;
    Pair(f64): Div::div = f64x2_div;
    PairSingle(f32): Add::add = f32x4_add;
    PairSingle(f32): Sub::sub = f32x4_sub;
    PairSingle(f32): Mul::mul = f32x4_mul;
    PairSingle(f32): Div::div = f32x4_div;
}

impl Neg for Pair {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Pair(f64x2_neg(self.0))
    }
}

impl MulAssign for Pair {
    #[inline(always)]
    fn mul_assign(&mut self, b: Self) {
        *self = *self * b;
    }
}

impl core::ops::SubAssign for Pair {
    #[inline(always)]
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}

/// An operation between masks.
macro_rules! logic {
    ($($trait:ident::$method:ident = $instruction:ident;)+) => {$(
        impl $trait for PairMask {
            type Output = Self;

            #[inline(always)]
            fn $method(self, b: Self) -> Self {
                PairMask($instruction(self.0, b.0))
            }
        }
    )+};
}

logic! {
    BitAnd::bitand = v128_and;
    BitOr::bitor = v128_or;
    BitXor::bitxor = v128_xor;
}

impl Not for PairMask {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        PairMask(v128_not(self.0))
    }
}

impl From<bool> for PairMask {
    #[inline(always)]
    fn from(holds: bool) -> Self {
        PairMask(i64x2_splat(-i64::from(holds)))
    }
}

impl From<u64> for PairBits {
    #[inline(always)]
    fn from(bits: u64) -> Self {
        PairBits(u64x2_splat(bits))
    }
}

impl Bits for PairBits {
    type Mask = PairMask;

    #[inline(always)]
    fn has(self, bit: u64) -> PairMask {
        let bit = u64x2_splat(bit);
        PairMask(i64x2_eq(v128_and(self.0, bit), bit))
    }

    #[inline(always)]
    fn when(condition: PairMask, bits: u64) -> Self {
        PairBits(v128_and(condition.0, u64x2_splat(bits)))
    }
}

impl PairBits {
    #[inline(always)]
    pub fn wrapping_add(self, b: impl Into<Self>) -> Self {
        PairBits(i64x2_add(self.0, b.into().0))
    }

    #[inline(always)]
    pub fn wrapping_sub(self, b: impl Into<Self>) -> Self {
        PairBits(i64x2_sub(self.0, b.into().0))
    }
}

impl BitAnd<u64> for PairBits {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, b: u64) -> Self {
        PairBits(v128_and(self.0, u64x2_splat(b)))
    }
}

impl BitOr<u64> for PairBits {
    type Output = Self;

    #[inline(always)]
    fn bitor(self, b: u64) -> Self {
        PairBits(v128_or(self.0, u64x2_splat(b)))
    }
}

impl BitXor for PairBits {
    type Output = Self;

    #[inline(always)]
    fn bitxor(self, b: Self) -> Self {
        PairBits(v128_xor(self.0, b.0))
    }
}

impl Shl<u32> for PairBits {
    type Output = Self;

    #[inline(always)]
    fn shl(self, by: u32) -> Self {
        PairBits(i64x2_shl(self.0, by))
    }
}

impl Shr<u32> for PairBits {
    type Output = Self;

    #[inline(always)]
    fn shr(self, by: u32) -> Self {
        PairBits(u64x2_shr(self.0, by))
    }
}

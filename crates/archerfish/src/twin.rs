//! Two numbers that take every step together: a `Number` of the kernels.
//!
//! (An array, not two fields: those the compiler would hand about as one value, and then vectorise
//! nothing.)

use core::ops::{
    Add, BitAnd, BitOr, BitXor, Div, Mul, MulAssign, Neg, Not, Shl, Shr, Sub, SubAssign,
};

use crate::number::{Bits, LookUp, Narrow, Order, Table};

/// Two of a kind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Twin<T>(pub [T; 2]);

impl<T: Copy> From<T> for Twin<T> {
    #[inline(always)]
    fn from(x: T) -> Self {
        Twin([x; 2])
    }
}

/// A method without an argument, for both.
macro_rules! alone {
    ($($of:ty => $method:ident -> $to:ty;)+) => {$(
        impl Twin<$of> {
            #[inline(always)]
            pub fn $method(self) -> Twin<$to> {
                let Twin([a, b]) = self;
                Twin([a.$method(), b.$method()])
            }
        }
    )+};
}

alone! {
    f64 => to_bits -> u64;
    f64 => sqrt -> f64;
    f64 => abs -> f64;
    f64 => is_nan -> bool;
    f32 => sqrt -> f32;
}

impl Twin<f64> {
    /// The same number twice.
    pub const fn of(x: f64) -> Self {
        Twin([x; 2])
    }

    #[inline(always)]
    pub fn from_bits(bits: Twin<u64>) -> Self {
        let Twin([a, b]) = bits;
        Twin([f64::from_bits(a), f64::from_bits(b)])
    }

    #[inline(always)]
    pub fn copysign(self, sign: Self) -> Self {
        let (Twin([a, b]), Twin([sign_a, sign_b])) = (self, sign);
        Twin([a.copysign(sign_a), b.copysign(sign_b)])
    }

    #[inline(always)]
    pub fn mul_add(self, factor: Self, summand: Self) -> Self {
        let (Twin([a, b]), Twin([factor_a, factor_b])) = (self, factor);
        let Twin([summand_a, summand_b]) = summand;
        Twin([a.mul_add(factor_a, summand_a), b.mul_add(factor_b, summand_b)])
    }
}

/// A comparison.
macro_rules! compare {
    ($($method:ident: $operator:tt;)+) => {$(
        #[inline(always)]
        fn $method(self, other: impl Into<Self>) -> Twin<bool> {
            let (Twin([a, b]), Twin([other_a, other_b])) = (self, other.into());
            Twin([a $operator other_a, b $operator other_b])
        }
    )+};
}

impl Order for Twin<f64> {
    type Mask = Twin<bool>;

    compare! {
        is_below: <;
        is_above: >;
        is_at_most: <=;
        is_at_least: >=;
        equals: ==;
    }

    #[inline(always)]
    fn select(condition: Twin<bool>, a: Self, b: Self) -> Self {
        let Twin([first, second]) = condition;
        Twin([if first { a.0[0] } else { b.0[0] }, if second { a.0[1] } else { b.0[1] }])
    }
}

impl Narrow for Twin<f64> {
    type Single = Twin<f32>;

    #[inline(always)]
    fn narrow(self) -> Twin<f32> {
        let Twin([a, b]) = self;
        Twin([a.narrow(), b.narrow()])
    }

    #[inline(always)]
    fn widen(single: Twin<f32>) -> Self {
        let Twin([a, b]) = single;
        Twin([f64::widen(a), f64::widen(b)])
    }
}

impl LookUp for Twin<f64> {
    type Index = Twin<u64>;

    #[inline(always)]
    fn look_up(table: &Table, index: Twin<u64>) -> Self {
        let Twin([a, b]) = index;
        Twin([f64::look_up(table, a), f64::look_up(table, b)])
    }
}

/// An operation between two of a kind.
macro_rules! between {
    ($($of:ty: $trait:ident::$method:ident;)+) => {$(
        impl $trait for Twin<$of> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let (Twin([a, b]), Twin([other_a, other_b])) = (self, other);
                Twin([a.$method(other_a), b.$method(other_b)])
            }
        }
    )+};
}

/// An operation with the same on the right of both.
macro_rules! with_one {
    ($($of:ty: $trait:ident<$one:ty>::$method:ident;)+) => {$(
        impl $trait<$one> for Twin<$of> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, one: $one) -> Self {
                let Twin([a, b]) = self;
                Twin([a.$method(one), b.$method(one)])
            }
        }
    )+};
}

/// An operation with the same on the left of both.
macro_rules! of_one {
    ($($of:ty: $trait:ident::$method:ident;)+) => {$(
        impl $trait<Twin<$of>> for $of {
            type Output = Twin<$of>;

            #[inline(always)]
            fn $method(self, twin: Twin<$of>) -> Twin<$of> {
                let Twin([a, b]) = twin;
                Twin([self.$method(a), self.$method(b)])
            }
        }
    )+};
}

between! {
    f64: Add::add;
    f64: Sub::sub;
    f64: Mul::mul;
    f64: Div::div;
    f32: Add::add;
    f32: Sub::sub;
    f32: Mul::mul;
    f32: Div::div;
    bool: BitAnd::bitand;
    bool: BitOr::bitor;
    bool: BitXor::bitxor;
    u64: BitXor::bitxor;
}

with_one! {
    f64: Add<f64>::add;
    f64: Sub<f64>::sub;
    f64: Mul<f64>::mul;
    f64: Div<f64>::div;
    f32: Add<f32>::add;
    f32: Sub<f32>::sub;
    f32: Mul<f32>::mul;
    f32: Div<f32>::div;
    u64: BitAnd<u64>::bitand;
    u64: BitOr<u64>::bitor;
    u64: Shl<u32>::shl;
    u64: Shr<u32>::shr;
}

of_one! {
    f64: Add::add;
    f64: Sub::sub;
    f64: Mul::mul;
    f64: Div::div;
    f32: Add::add;
    f32: Sub::sub;
    f32: Mul::mul;
    f32: Div::div;
}

impl Bits for Twin<u64> {
    type Mask = Twin<bool>;

    #[inline(always)]
    fn has(self, bit: u64) -> Twin<bool> {
        let Twin([a, b]) = self;
        Twin([a.has(bit), b.has(bit)])
    }

    #[inline(always)]
    fn when(condition: Twin<bool>, bits: u64) -> Self {
        let Twin([a, b]) = condition;
        Twin([u64::when(a, bits), u64::when(b, bits)])
    }
}

impl Neg for Twin<f64> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        let Twin([a, b]) = self;
        Twin([-a, -b])
    }
}

impl Not for Twin<bool> {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        let Twin([a, b]) = self;
        Twin([!a, !b])
    }
}

impl MulAssign for Twin<f64> {
    #[inline(always)]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl SubAssign for Twin<f64> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Twin<u64> {
    #[inline(always)]
    pub fn wrapping_add(self, other: impl Into<Self>) -> Self {
        let (Twin([a, b]), Twin([other_a, other_b])) = (self, other.into());
        Twin([a.wrapping_add(other_a), b.wrapping_add(other_b)])
    }

    #[inline(always)]
    pub fn wrapping_sub(self, other: impl Into<Self>) -> Self {
        let (Twin([a, b]), Twin([other_a, other_b])) = (self, other.into());
        Twin([a.wrapping_sub(other_a), b.wrapping_sub(other_b)])
    }
}

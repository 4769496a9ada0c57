//! Thirty-two doubles in four of AVX-512's vectors, which take every step together: a `Number` of the
//! kernels.
//!
//! A kernel is a chain of results that wait for each other; four of them keep a processor busy.

use core::arch::x86_64::{__m512, __m512d, __m512i, __mmask8};
use core::ops::{
    Add, BitAnd, BitOr, BitXor, Div, Mul, MulAssign, Neg, Not, Shl, Shr, Sub, SubAssign,
};

use crate::dispatch::avx512;
use crate::number::{Bits, LookUp, Narrow, Order, Table};

/// Vectors in flight.
const VECTORS: usize = 4;
/// Doubles in one of them.
const LANES: usize = 8;
/// Elements of a block.
pub(crate) const BLOCK: usize = VECTORS * LANES;

/// The same for each vector. (Not `from_fn`, which the compiler may leave a loop of calls.)
macro_rules! each {
    ($i:ident => $value:expr) => {
        [
            {
                const $i: usize = 0;
                $value
            },
            {
                const $i: usize = 1;
                $value
            },
            {
                const $i: usize = 2;
                $value
            },
            {
                const $i: usize = 3;
                $value
            },
        ]
    };
}

/// Doubles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wide([__m512d; VECTORS]);

/// The same in single precision: two vectors' doubles in one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WideSingle([__m512; VECTORS / 2]);

/// Of each double whether something holds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WideMask([__mmask8; VECTORS]);

/// The bits of each double.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WideBits([__m512i; VECTORS]);

impl From<f64> for Wide {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Wide([avx512::spread(x); VECTORS])
    }
}

impl From<&[f64; BLOCK]> for Wide {
    #[inline(always)]
    fn from(block: &[f64; BLOCK]) -> Self {
        let (vectors, _) = block.as_chunks();
        Wide(each!(I => avx512::load(&vectors[I])))
    }
}

impl Wide {
    /// The same number everywhere.
    pub const fn of(x: f64) -> Self {
        Wide([avx512::spread_constant(x); VECTORS])
    }

    #[inline(always)]
    pub fn store(self, block: &mut [f64; BLOCK]) {
        let (vectors, _) = block.as_chunks_mut();
        each!(I => avx512::store(&mut vectors[I], self.0[I]));
    }

    #[inline(always)]
    pub fn to_bits(self) -> WideBits {
        WideBits(each!(I => avx512::to_bits(self.0[I])))
    }

    #[inline(always)]
    pub fn from_bits(bits: WideBits) -> Self {
        Wide(each!(I => avx512::from_bits(bits.0[I])))
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Wide(each!(I => avx512::sqrt(self.0[I])))
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        Wide(each!(I => avx512::abs(self.0[I])))
    }

    #[inline(always)]
    pub fn copysign(self, sign: Self) -> Self {
        Wide(each!(I => avx512::copysign(self.0[I], sign.0[I])))
    }

    #[inline(always)]
    pub fn is_nan(self) -> WideMask {
        WideMask(each!(I => avx512::is_nan(self.0[I])))
    }

    #[inline(always)]
    pub fn mul_add(self, factor: Self, summand: Self) -> Self {
        Wide(each!(I => avx512::mul_add(self.0[I], factor.0[I], summand.0[I])))
    }
}

/// A comparison.
macro_rules! compare {
    ($($method:ident;)+) => {$(
        #[inline(always)]
        fn $method(self, other: impl Into<Self>) -> WideMask {
            let other = other.into();
            WideMask(each!(I => avx512::$method(self.0[I], other.0[I])))
        }
    )+};
}

impl Order for Wide {
    type Mask = WideMask;

    compare! { is_below; is_above; is_at_most; is_at_least; equals; }

    /// By the bits, as unsigned integers.
    #[inline(always)]
    fn is_within(self, low: f64, high: f64) -> WideMask {
        let bits = self.to_bits();
        let above = if low > 0.0 { bits.wrapping_sub(low.to_bits()) } else { bits };
        let span = WideBits::from(high.to_bits() - low.to_bits());
        WideMask(each!(I => avx512::is_at_most_unsigned(above.0[I], span.0[I])))
    }

    #[inline(always)]
    fn select(condition: WideMask, a: Self, b: Self) -> Self {
        Wide(each!(I => avx512::select(condition.0[I], a.0[I], b.0[I])))
    }

    #[inline(always)]
    fn exponent(self) -> Option<Self> {
        Some(Wide(each!(I => avx512::exponent(self.0[I]))))
    }

    #[inline(always)]
    fn lesser(a: Self, b: Self) -> Self {
        Wide(each!(I => avx512::lesser(a.0[I], b.0[I])))
    }

    #[inline(always)]
    fn greater(a: Self, b: Self) -> Self {
        Wide(each!(I => avx512::greater(a.0[I], b.0[I])))
    }
}

impl Narrow for Wide {
    type Single = WideSingle;

    #[inline(always)]
    fn narrow(self) -> WideSingle {
        let Wide([a, b, c, d]) = self;
        WideSingle([avx512::narrow(a, b), avx512::narrow(c, d)])
    }

    #[inline(always)]
    fn widen(single: WideSingle) -> Self {
        let WideSingle([a, b]) = single;
        Wide([
            avx512::widen_low(a),
            avx512::widen_high(a),
            avx512::widen_low(b),
            avx512::widen_high(b),
        ])
    }
}

impl From<f32> for WideSingle {
    #[inline(always)]
    fn from(x: f32) -> Self {
        WideSingle([avx512::spread_single(x); VECTORS / 2])
    }
}

impl WideSingle {
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        let WideSingle([a, b]) = self;
        WideSingle([avx512::sqrt_single(a), avx512::sqrt_single(b)])
    }
}

/// An operation between numbers in single precision, and between them and one.
macro_rules! single_arithmetic {
    ($($trait:ident::$method:ident = $instruction:ident;)+) => {$(
        impl $trait for WideSingle {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let (WideSingle([a, b]), WideSingle([other_a, other_b])) = (self, other);
                WideSingle([avx512::$instruction(a, other_a), avx512::$instruction(b, other_b)])
            }
        }

        impl $trait<f32> for WideSingle {
            type Output = Self;

            #[inline(always)]
            fn $method(self, b: f32) -> Self {
                self.$method(WideSingle::from(b))
            }
        }

        impl $trait<WideSingle> for f32 {
            type Output = WideSingle;

            #[inline(always)]
            fn $method(self, b: WideSingle) -> WideSingle {
                WideSingle::from(self).$method(b)
            }
        }
    )+};
}

single_arithmetic! {
    Add::add = add_single;
    Sub::sub = sub_single;
    Mul::mul = mul_single;
    Div::div = div_single;
}

impl LookUp for Wide {
    type Index = WideBits;

    #[inline(always)]
    fn look_up(table: &Table, index: WideBits) -> Self {
        let (halves, _) = table.as_chunks();
        let (low, high) = (avx512::load(&halves[0]), avx512::load(&halves[1]));
        Wide(each!(I => avx512::look_up(low, index.0[I], high)))
    }
}

/// An operation between numbers, and between numbers and one double.
macro_rules! arithmetic {
    ($($trait:ident::$method:ident;)+) => {$(
        impl $trait for Wide {
            type Output = Self;

            #[inline(always)]
            fn $method(self, b: Self) -> Self {
                Wide(each!(I => avx512::$method(self.0[I], b.0[I])))
            }
        }

        impl $trait<f64> for Wide {
            type Output = Self;

            #[inline(always)]
            fn $method(self, b: f64) -> Self {
                self.$method(Wide::from(b))
            }
        }

        impl $trait<Wide> for f64 {
            type Output = Wide;

            #[inline(always)]
            fn $method(self, b: Wide) -> Wide {
                Wide::from(self).$method(b)
            }
        }
    )+};
}

arithmetic! {
    Add::add;
    Sub::sub;
    Mul::mul;
    Div::div;
}

impl Neg for Wide {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Wide(each!(I => avx512::neg(self.0[I])))
    }
}

impl MulAssign for Wide {
    #[inline(always)]
    fn mul_assign(&mut self, b: Self) {
        *self = *self * b;
    }
}

impl SubAssign for Wide {
    #[inline(always)]
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}

/// An operation between masks.
macro_rules! logic {
    ($($trait:ident::$method:ident: $operator:tt;)+) => {$(
        impl $trait for WideMask {
            type Output = Self;

            #[inline(always)]
            fn $method(self, b: Self) -> Self {
                WideMask(each!(I => self.0[I] $operator b.0[I]))
            }
        }
    )+};
}

logic! {
    BitAnd::bitand: &;
    BitOr::bitor: |;
    BitXor::bitxor: ^;
}

impl Not for WideMask {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        WideMask(each!(I => !self.0[I]))
    }
}

impl From<bool> for WideMask {
    #[inline(always)]
    fn from(holds: bool) -> Self {
        WideMask([if holds { !0 } else { 0 }; VECTORS])
    }
}

impl From<u64> for WideBits {
    #[inline(always)]
    fn from(bits: u64) -> Self {
        WideBits([avx512::spread_bits(bits); VECTORS])
    }
}

impl Bits for WideBits {
    type Mask = WideMask;

    #[inline(always)]
    fn has(self, bit: u64) -> WideMask {
        let bit = WideBits::from(bit);
        WideMask(each!(I => avx512::has(self.0[I], bit.0[I])))
    }

    #[inline(always)]
    fn when(condition: WideMask, bits: u64) -> Self {
        let bits = WideBits::from(bits);
        WideBits(each!(I => avx512::when(condition.0[I], bits.0[I])))
    }
}

/// An operation between bits, by a method.
macro_rules! between {
    ($($method:ident;)+) => {$(
        #[inline(always)]
        pub fn $method(self, b: impl Into<Self>) -> Self {
            let b = b.into();
            WideBits(each!(I => avx512::$method(self.0[I], b.0[I])))
        }
    )+};
}

impl WideBits {
    between! { wrapping_add; wrapping_sub; }
}

/// An operation between bits.
macro_rules! bitwise {
    ($($trait:ident<$of:ty>::$method:ident;)+) => {$(
        impl $trait<$of> for WideBits {
            type Output = Self;

            #[inline(always)]
            fn $method(self, b: $of) -> Self {
                let b = WideBits::from(b);
                WideBits(each!(I => avx512::$method(self.0[I], b.0[I])))
            }
        }
    )+};
}

bitwise! {
    BitAnd<u64>::bitand;
    BitOr<u64>::bitor;
    BitXor<WideBits>::bitxor;
}

impl Shl<u32> for WideBits {
    type Output = Self;

    #[inline(always)]
    fn shl(self, by: u32) -> Self {
        WideBits(each!(I => avx512::shift_left(self.0[I], by)))
    }
}

impl Shr<u32> for WideBits {
    type Output = Self;

    #[inline(always)]
    fn shr(self, by: u32) -> Self {
        WideBits(each!(I => avx512::shift_right(self.0[I], by)))
    }
}

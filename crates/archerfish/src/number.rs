//! What a number of the kernels can do besides + − × ÷.
//!
//! The kernels are written over `Number`, which is f64; they are compiled once more with several doubles
//! side by side in its place: in a browser (`pair.rs`), for AVX2 (`twin.rs`), for AVX-512 (`wide.rs`).

use core::ops::BitAnd;

/// Comparisons.
pub(crate) trait Order: Copy {
    /// What a comparison gives: `bool`, or one for each double.
    type Mask: BitAnd<Output = Self::Mask>;
    fn is_below(self, bound: impl Into<Self>) -> Self::Mask;
    fn is_above(self, bound: impl Into<Self>) -> Self::Mask;
    fn is_at_most(self, bound: impl Into<Self>) -> Self::Mask;
    fn is_at_least(self, bound: impl Into<Self>) -> Self::Mask;
    fn equals(self, other: impl Into<Self>) -> Self::Mask;
    /// Whether it is from one bound, which is not below 0, to the other. (−0 may count as below 0.)
    #[inline(always)]
    fn is_within(self, low: f64, high: f64) -> Self::Mask
    where
        Self: From<f64>,
    {
        self.is_at_least(low) & self.is_at_most(high)
    }
    /// `a` where the condition holds, else `b`.
    fn select(condition: Self::Mask, a: Self, b: Self) -> Self;
    /// The exponent of a positive normal number, where an instruction gives it.
    #[inline(always)]
    fn exponent(self) -> Option<Self> {
        None
    }
    /// `a` where it is below b, else `b`.
    #[inline(always)]
    fn lesser(a: Self, b: Self) -> Self {
        Self::select(a.is_below(b), a, b)
    }
    /// `a` where it is above b, else `b`.
    #[inline(always)]
    fn greater(a: Self, b: Self) -> Self {
        Self::select(a.is_above(b), a, b)
    }
}

impl Order for f64 {
    type Mask = bool;

    #[inline(always)]
    fn is_below(self, bound: impl Into<f64>) -> bool {
        self < bound.into()
    }

    #[inline(always)]
    fn is_above(self, bound: impl Into<f64>) -> bool {
        self > bound.into()
    }

    #[inline(always)]
    fn is_at_most(self, bound: impl Into<f64>) -> bool {
        self <= bound.into()
    }

    #[inline(always)]
    fn is_at_least(self, bound: impl Into<f64>) -> bool {
        self >= bound.into()
    }

    #[inline(always)]
    fn equals(self, other: impl Into<f64>) -> bool {
        self == other.into()
    }

    #[inline(always)]
    fn select(condition: bool, a: f64, b: f64) -> f64 {
        if condition { a } else { b }
    }
}

/// Numbers in single precision, for guesses: on vectors half the work, and divisions and roots a third.
pub(crate) trait Narrow {
    type Single;
    /// Rounded to 24 bits.
    fn narrow(self) -> Self::Single;
    fn widen(single: Self::Single) -> Self;
}

impl Narrow for f64 {
    type Single = f32;

    #[inline(always)]
    fn narrow(self) -> f32 {
        self as f32
    }

    #[inline(always)]
    fn widen(single: f32) -> f64 {
        f64::from(single)
    }
}

/// A table of as many numbers as two vectors of AVX-512 hold.
pub(crate) type Table = [f64; 16];

/// Numbers out of a table.
pub(crate) trait LookUp {
    type Index;
    /// Those at the last four bits of the index.
    fn look_up(table: &Table, index: Self::Index) -> Self;
}

impl LookUp for f64 {
    type Index = u64;

    #[inline(always)]
    fn look_up(table: &Table, index: u64) -> f64 {
        table[(index & 15) as usize]
    }
}

/// The bits of a number, as an integer.
pub(crate) trait Bits {
    type Mask;
    /// Whether this bit is set.
    fn has(self, bit: u64) -> Self::Mask;
    /// These bits where the condition holds, else none.
    fn when(condition: Self::Mask, bits: u64) -> Self;
}

impl Bits for u64 {
    type Mask = bool;

    #[inline(always)]
    fn has(self, bit: u64) -> bool {
        self & bit == bit
    }

    #[inline(always)]
    fn when(condition: bool, bits: u64) -> u64 {
        if condition { bits } else { 0 }
    }
}

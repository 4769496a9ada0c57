//! Unevaluated sums of two doubles, for the few places where one rounding is one too many.
//!
//! References: T. J. Dekker, Numer. Math. 18 (1971); D. E. Knuth, TAOCP 2, §4.2.2.
//! The rounding error of a product is itself a double. One fused instruction gives it, or Dekker's
//! seventeen operations: the very same number, short of the ends of the range.

#[cfg(all(feature = "std", target_arch = "x86_64"))]
use super::super::FUSED;
use super::{Mask, Number};

/// The sum `hi + lo`, with `|lo|` far below `|hi|`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DoubleDouble {
    pub hi: Number,
    pub lo: Number,
}

/// The nearest number of 26 bits, and the rest, of 26 bits too: products of such are exact.
#[inline(always)]
fn split(a: Number) -> (Number, Number) {
    const HALF: u64 = 1 << 26;
    const HEAD: u64 = !((1 << 27) - 1);
    let head = Number::from_bits(a.to_bits().wrapping_add(HALF) & HEAD);
    (head, a - head)
}

/// `a b − p`, p being `a * b` as rounded.
#[inline(always)]
fn product_error(a: Number, b: Number, p: Number) -> Number {
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    if FUSED {
        return a.mul_add(b, -p);
    }
    let (a_head, a_tail) = split(a);
    let (b_head, b_tail) = split(b);
    ((a_head * b_head - p) + a_head * b_tail + a_tail * b_head) + a_tail * b_tail
}

/// `a − x y`, rounded once, where a less the rounded product is a double: the rest of a quotient, or of
/// a sum. Both ways subtract exactly until the last rounding.
#[inline(always)]
pub(crate) fn rest_of_product(a: operand!(), x: Number, y: Number) -> Number {
    let a: Number = a.into();
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    if FUSED {
        return (-x).mul_add(y, a);
    }
    let product = two_product(x, y);
    (a - product.hi) - product.lo
}

/// `a + b` exactly, for any two numbers.
#[inline(always)]
pub(crate) fn two_sum(a: operand!(), b: operand!()) -> DoubleDouble {
    let (a, b): (Number, Number) = (a.into(), b.into());
    let hi = a + b;
    let b_part = hi - a;
    let lo = (a - (hi - b_part)) + (b - b_part);
    DoubleDouble { hi, lo }
}

/// `a + b` exactly, where `a` is zero or its exponent is at least that of `b`.
#[inline(always)]
pub(crate) fn fast_two_sum(a: operand!(), b: operand!()) -> DoubleDouble {
    let (a, b): (Number, Number) = (a.into(), b.into());
    let hi = a + b;
    DoubleDouble { hi, lo: b - (hi - a) }
}

/// `a - b` exactly, for any two numbers: `two_sum` without changing a sign, which is an instruction.
#[inline(always)]
pub(crate) fn two_difference(a: operand!(), b: operand!()) -> DoubleDouble {
    let (a, b): (Number, Number) = (a.into(), b.into());
    let hi = a - b;
    let b_part = hi - a;
    let lo = (a - (hi - b_part)) - (b + b_part);
    DoubleDouble { hi, lo }
}

/// `a - b` exactly, where `a` is zero or its exponent is at least that of `b`.
#[inline(always)]
pub(crate) fn fast_two_difference(a: operand!(), b: operand!()) -> DoubleDouble {
    let (a, b): (Number, Number) = (a.into(), b.into());
    let hi = a - b;
    DoubleDouble { hi, lo: (a - hi) - b }
}

/// `a + b` exactly, where neither is negative.
#[inline(always)]
pub(crate) fn two_sum_positive(a: operand!(), b: operand!()) -> DoubleDouble {
    let (a, b): (Number, Number) = (a.into(), b.into());
    fast_two_sum(super::greater(a, b), super::lesser(b, a))
}

/// `a * b` exactly.
#[inline(always)]
pub(crate) fn two_product(a: Number, b: Number) -> DoubleDouble {
    let hi = a * b;
    DoubleDouble { hi, lo: product_error(a, b, hi) }
}

/// `a²` exactly.
#[inline(always)]
pub(crate) fn two_square(a: Number) -> DoubleDouble {
    let hi = a * a;
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    if FUSED {
        return DoubleDouble { hi, lo: a.mul_add(a, -hi) };
    }
    let (head, tail) = split(a);
    DoubleDouble { hi, lo: ((head * head - hi) + 2.0 * head * tail) + tail * tail }
}

impl DoubleDouble {
    /// The same of every number there is.
    pub const fn constant(hi: f64, lo: f64) -> Self {
        DoubleDouble { hi: super::constant(hi), lo: super::constant(lo) }
    }

    /// A double as it is.
    #[inline(always)]
    pub fn from(a: operand!()) -> Self {
        DoubleDouble { hi: a.into(), lo: Number::from(0.0) }
    }

    /// The nearest double.
    #[inline(always)]
    pub fn round(self) -> Number {
        self.hi + self.lo
    }

    /// `self + b`, to 2⁻¹⁰⁴ of the greater of the two.
    #[inline(always)]
    pub fn add(self, b: Self) -> Self {
        let sum = two_sum(self.hi, b.hi);
        fast_two_sum(sum.hi, sum.lo + (self.lo + b.lo))
    }

    /// `self - b`, to 2⁻¹⁰⁴ of the greater of the two.
    #[inline(always)]
    pub fn sub(self, b: Self) -> Self {
        let difference = two_difference(self.hi, b.hi);
        fast_two_sum(difference.hi, difference.lo + (self.lo - b.lo))
    }

    /// `self + b` where `b` is one double.
    #[inline(always)]
    pub fn add_double(self, b: operand!()) -> Self {
        let sum = two_sum(self.hi, b);
        fast_two_sum(sum.hi, sum.lo + self.lo)
    }

    /// `self - b` where `b` is one double.
    #[inline(always)]
    pub fn sub_double(self, b: operand!()) -> Self {
        let difference = two_difference(self.hi, b);
        fast_two_sum(difference.hi, difference.lo + self.lo)
    }

    /// `self + b`, left as it falls, where self is zero or its exponent is at least that of b.
    #[inline(always)]
    pub fn add_smaller(self, b: Self) -> Self {
        let sum = fast_two_sum(self.hi, b.hi);
        DoubleDouble { hi: sum.hi, lo: sum.lo + (self.lo + b.lo) }
    }

    /// `self - b`, as `add_smaller`.
    #[inline(always)]
    pub fn sub_smaller(self, b: Self) -> Self {
        let difference = fast_two_difference(self.hi, b.hi);
        DoubleDouble { hi: difference.hi, lo: difference.lo + (self.lo - b.lo) }
    }

    /// `self + b` where neither is negative; left as it falls, the words nearly apart.
    #[inline(always)]
    pub fn add_positive(self, b: operand!()) -> Self {
        let sum = two_sum_positive(self.hi, b);
        DoubleDouble { hi: sum.hi, lo: sum.lo + self.lo }
    }

    /// `self + b` where neither is negative; left as it falls, the words nearly apart.
    #[inline(always)]
    pub fn add_positives(self, b: Self) -> Self {
        let sum = two_sum_positive(self.hi, b.hi);
        DoubleDouble { hi: sum.hi, lo: sum.lo + (self.lo + b.lo) }
    }

    /// `2 self`.
    #[inline(always)]
    pub fn twice(self) -> Self {
        DoubleDouble { hi: self.hi + self.hi, lo: self.lo + self.lo }
    }

    /// `1 - self`, where self is at most 2, and nothing below 0.
    #[inline(always)]
    pub fn complement(self) -> Self {
        let difference = fast_two_difference(1.0, self.hi);
        DoubleDouble { hi: difference.hi, lo: difference.lo - self.lo }
    }

    /// `-self`.
    #[inline(always)]
    pub fn neg(self) -> Self {
        DoubleDouble { hi: -self.hi, lo: -self.lo }
    }

    /// `self * b`, to 2⁻¹⁰⁰ of itself; hi is at most a few units in the last place from the nearest
    /// double. For what goes into further products and sums.
    #[inline(always)]
    pub fn times(self, b: Self) -> Self {
        let product = two_product(self.hi, b.hi);
        let across = self.hi * b.lo + self.lo * b.hi;
        DoubleDouble { hi: product.hi, lo: product.lo + across }
    }

    /// `self * b` where `b` is one double, as `times`.
    #[inline(always)]
    pub fn times_double(self, b: Number) -> Self {
        let product = two_product(self.hi, b);
        DoubleDouble { hi: product.hi, lo: product.lo + self.lo * b }
    }

    /// `self²`, as `times`.
    #[inline(always)]
    pub fn squared(self) -> Self {
        let square = two_square(self.hi);
        DoubleDouble { hi: square.hi, lo: square.lo + (self.hi + self.hi) * self.lo }
    }

    /// `self / b`, rounded.
    #[inline(always)]
    pub fn quotient(self, b: Self) -> Number {
        self.quotient_by(b, 1.0 / b.hi)
    }

    /// `self / b`, rounded, given a double next to `1 / b.hi`.
    #[inline(always)]
    pub fn quotient_by(self, b: Self, inverse: Number) -> Number {
        self.div_by(b, inverse).round()
    }

    /// `self * b` where `b` is a power of two.
    #[inline(always)]
    pub fn scale(self, b: operand!()) -> Self {
        let b: Number = b.into();
        DoubleDouble { hi: self.hi * b, lo: self.lo * b }
    }

    /// `self / b`, given `inverse`, a double next to `1 / b.hi`; to 2⁻¹⁰⁰ of itself, as `times`.
    #[inline(always)]
    pub fn div_by(self, b: Self, inverse: Number) -> Self {
        let quotient = self.hi * inverse;
        let rest = rest_of_product(self.hi, quotient, b.hi) + (self.lo - quotient * b.lo);
        DoubleDouble { hi: quotient, lo: rest * inverse }
    }

    /// `self / b`, as `div_by`.
    #[inline(always)]
    pub fn div(self, b: Self) -> Self {
        self.div_by(b, 1.0 / b.hi)
    }

    /// `self / b` where `b` is one double, as `div_by`.
    #[inline(always)]
    pub fn div_double(self, b: Number) -> Self {
        self.div_double_by(b, 1.0 / b)
    }

    /// `self / b` where `b` is one double, given a double next to `1 / b`, as `div_by`.
    #[inline(always)]
    pub fn div_double_by(self, b: Number, inverse: Number) -> Self {
        let quotient = self.hi * inverse;
        let rest = rest_of_product(self.hi, quotient, b) + self.lo;
        DoubleDouble { hi: quotient, lo: rest * inverse }
    }

    /// `self - a²`, which is nearly zero. (Not by `rest_of_product`: then the compiler no longer unites
    /// the roots of two cases, and the offset forms of Lambert's W take a sixth longer.)
    #[inline(always)]
    pub fn less_square(self, a: Number) -> Number {
        let square = two_square(a);
        ((self.hi - square.hi) - square.lo) + self.lo
    }

    /// `√self`, to 2⁻¹⁰⁰ of itself, as `times`; NaN at zero.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        let root = super::sqrt(self.hi);
        let rest = self.less_square(root);
        DoubleDouble { hi: root, lo: rest / (root + root) }
    }

    /// `a` where the condition holds, else `b`.
    #[inline(always)]
    pub fn select(condition: Mask, a: Self, b: Self) -> Self {
        DoubleDouble {
            hi: super::select(condition, a.hi, b.hi),
            lo: super::select(condition, a.lo, b.lo),
        }
    }
}

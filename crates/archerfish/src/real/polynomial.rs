//! Polynomials with the lowest coefficient first.

use core::ops::{Add, Mul};

/// Steps of Horner's below the one at the top. (A loop would be undone only after the compiler has moved
/// what stands before it behind it, one of several vectors after the other.)
macro_rules! steps {
    ($sum:ident, $square:ident, $coefficients:ident, $top:ident: $($k:literal)+) => {
        const { assert!(N <= 16) };
        $(if $k < $top {
            $sum = $sum * $square + X::from($coefficients[$k]);
        })+
    };
}

/// `Σ cₖ xᵏ`, as two interleaved Horner chains in x², half as long as one.
#[inline(always)]
pub(crate) fn polynomial<C, X, const N: usize>(x: X, coefficients: &[C; N]) -> X
where
    C: Copy,
    X: Copy + From<C> + Add<Output = X> + Mul<Output = X>,
{
    polynomial_by(x, x * x, coefficients)
}

/// `polynomial`, given x² as well.
#[inline(always)]
pub(crate) fn polynomial_by<C, X, const N: usize>(x: X, square: X, coefficients: &[C; N]) -> X
where
    C: Copy,
    X: Copy + From<C> + Add<Output = X> + Mul<Output = X>,
{
    let top_even = (N - 1) / 2 * 2;
    let top_odd = if N.is_multiple_of(2) { N - 1 } else { N - 2 };
    let mut even = X::from(coefficients[top_even]);
    let mut odd = X::from(coefficients[top_odd]);
    steps!(even, square, coefficients, top_even: 14 12 10 8 6 4 2 0);
    steps!(odd, square, coefficients, top_odd: 13 11 9 7 5 3 1);
    even + x * odd
}

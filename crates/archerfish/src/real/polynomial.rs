//! Polynomials with the lowest coefficient first.

use super::Number;

/// `Σ cₖ xᵏ`, as two interleaved Horner chains in x², half as long as one.
#[inline(always)]
pub(crate) fn polynomial<const N: usize>(x: Number, coefficients: &[f64; N]) -> Number {
    polynomial_by(x, x * x, coefficients)
}

/// `polynomial`, given x² as well.
#[inline(always)]
pub(crate) fn polynomial_by<const N: usize>(
    x: Number,
    square: Number,
    coefficients: &[f64; N],
) -> Number {
    let top_even = (N - 1) / 2 * 2;
    let top_odd = if N.is_multiple_of(2) { N - 1 } else { N - 2 };
    let mut even = coefficient(coefficients, top_even);
    let mut k = top_even;
    while k >= 2 {
        k -= 2;
        even = even * square + coefficient(coefficients, k);
    }
    let mut odd = coefficient(coefficients, top_odd);
    let mut k = top_odd;
    while k >= 3 {
        k -= 2;
        odd = odd * square + coefficient(coefficients, k);
    }
    even + x * odd
}

#[inline(always)]
fn coefficient<const N: usize>(coefficients: &[f64; N], k: usize) -> Number {
    Number::from(coefficients[k])
}

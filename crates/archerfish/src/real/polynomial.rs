//! Polynomials with the lowest coefficient first.

/// `Σ cₖ xᵏ`, as two interleaved Horner chains in x², half as long as one.
#[inline(always)]
pub(crate) fn polynomial<const N: usize>(x: f64, coefficients: &[f64; N]) -> f64 {
    let square = x * x;
    let top_even = (N - 1) / 2 * 2;
    let top_odd = if N.is_multiple_of(2) { N - 1 } else { N - 2 };
    let mut even = coefficients[top_even];
    let mut k = top_even;
    while k >= 2 {
        k -= 2;
        even = even * square + coefficients[k];
    }
    let mut odd = coefficients[top_odd];
    let mut k = top_odd;
    while k >= 3 {
        k -= 2;
        odd = odd * square + coefficients[k];
    }
    even + x * odd
}

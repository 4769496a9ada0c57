//! Square root: an instruction everywhere, correctly rounded by IEEE 754.

#[cfg(feature = "std")]
use super::Number;
use super::Single;

/// `√x`.
#[cfg(feature = "std")]
#[inline(always)]
pub fn sqrt(x: Number) -> Number {
    x.sqrt()
}

/// `√x` without the standard library: bit by bit in integers.
#[cfg(not(feature = "std"))]
#[inline(always)]
pub fn sqrt(x: f64) -> f64 {
    sqrt_by_bits(x)
}

/// `√x` in single precision.
#[cfg(feature = "std")]
#[inline(always)]
pub(crate) fn sqrt_single(x: Single) -> Single {
    x.sqrt()
}

/// `√x` in single precision: more than twice its digits, rounded, are the root rounded.
#[cfg(not(feature = "std"))]
#[inline(always)]
pub(crate) fn sqrt_single(x: Single) -> Single {
    sqrt_by_bits(f64::from(x)) as f32
}

/// Correctly rounded `√x` from integer operations alone.
#[cfg(any(not(feature = "std"), test))]
fn sqrt_by_bits(x: f64) -> f64 {
    if !(x > 0.0 && x < f64::INFINITY) {
        return if x < 0.0 { f64::NAN } else { x };
    }
    let scaled = if x < f64::MIN_POSITIVE { x * 18014398509481984.0 } else { x }; // 2⁵⁴
    let shift = if x < f64::MIN_POSITIVE { 27 } else { 0 };
    let bits = scaled.to_bits();
    let exponent = (bits >> 52) as i64 - 1023;
    let odd = exponent & 1;
    let significand = ((bits & 0x000f_ffff_ffff_ffff) | 0x0010_0000_0000_0000) as u128;
    // 54 bits of root: one more than the result keeps
    let radicand = significand << (54 + odd);
    let (mut root, mut bit) = (0u128, 1u128 << 53);
    while bit > 0 {
        if (root | bit) * (root | bit) <= radicand {
            root |= bit;
        }
        bit >>= 1;
    }
    // a root with a 54th bit is never exact, so half rounds up
    let rounded = ((root + 1) >> 1) as u64;
    let half = (exponent - odd) / 2 - shift + 1023;
    f64::from_bits((half as u64) << 52) * (rounded as f64 / 4503599627370496.0)
}

#[cfg(test)]
mod tests {
    #[test]
    fn integer_root_is_the_machine_root() {
        let mut bits = 1u64;
        let count = if cfg!(miri) { 50 } else { 20_000 };
        for _ in 0..count {
            bits = bits.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let x = f64::from_bits(bits >> 1);
            if x.is_finite() {
                assert_eq!(super::sqrt_by_bits(x).to_bits(), x.sqrt().to_bits(), "{x:e}");
            }
        }
        for x in [0.0, 1.0, 4.0, 2.0, 5e-324, f64::MAX, f64::MIN_POSITIVE, f64::INFINITY] {
            assert_eq!(super::sqrt_by_bits(x), x.sqrt());
        }
        assert!(super::sqrt_by_bits(-1.0).is_nan());
    }
}

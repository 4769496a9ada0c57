//! Inverse tangent, of a number and of a ratio.
//!
//! Method: of the ratio's two numbers the smaller is divided by the greater; a quotient above
//! tan(π/8) becomes (n − d)/(n + d), an eighth of a turn further on. There is one division.

use super::double_double::{DoubleDouble, fast_two_sum};
use super::{Bits, Integer, Mask, Number, Order, polynomial, power_of_two, select};

// atan_tail: minimax on [0.0, 0.17159], degree 11,
// weighted error 3.07e-18: reference/coefficients.py atan_tail
const ATAN_TAIL: [f64; 12] = [
    -0.33333333333333326,
    0.19999999999997692,
    -0.1428571428539078,
    0.11111111088351018,
    -0.09090908150796073,
    0.07692282900743969,
    -0.06666228860352462,
    0.05877042433517611,
    -0.052185374696342546,
    0.045040914795128874,
    -0.03348709642385551,
    0.015208009492690055,
];
// small_atan_tail: minimax on [0.0, 0.1251], degree 9,
// weighted error 4.63e-18: reference/coefficients.py small_atan_tail
const SMALL_ATAN_TAIL: [f64; 10] = [
    -0.33333333333333165,
    0.1999999999993487,
    -0.14285714276851577,
    0.11111110513149787,
    -0.09090885856095661,
    0.07691747138814369,
    -0.0665796483859827,
    0.05794792218598504,
    -0.04703752663544858,
    0.026216597317965593,
];
const TAN_EIGHTH_PI: f64 = 0.41421356237309503;

/// π/4 in two parts; the first has 50 bits, so that numbers up to 6 multiply it exactly.
const QUARTER_PI: DoubleDouble = DoubleDouble::constant(
    f64::from_bits(0x3fe9_21fb_5444_2d18),
    f64::from_bits(0x3c81_a626_3314_5c07),
);

const SIGN: u64 = 1 << 63;

/// The angle in [0, π] of the direction (x, y), y ≥ 0, not both zero, neither infinite and their
/// sum neither over- nor underflowing.
#[inline(always)]
pub(crate) fn angle(y: DoubleDouble, x: DoubleDouble) -> Number {
    let left = x.hi.is_below(0.0);
    turn(y, DoubleDouble::select(left, x.neg(), x), left, Integer::from(0u64))
}

/// The angle of the direction (±x, y), x ≥ 0 and leading to the left or not, that goes on below the
/// horizon from 0 and from π: in [−π/2, 3π/2].
#[inline(always)]
pub(crate) fn angle_all_round(y: DoubleDouble, x: Number, left: Mask) -> Number {
    let down = y.hi.to_bits() & SIGN;
    let up = DoubleDouble { hi: flipped(y.hi, down), lo: flipped(y.lo, down) };
    turn(up, DoubleDouble::from(x), left, down)
}

/// `a` with its sign changed where `sign` has the bit of one.
#[inline(always)]
fn flipped(a: Number, sign: Integer) -> Number {
    Number::from_bits(a.to_bits() ^ sign)
}

/// The angle of the direction (x, y), neither negative, mirrored at the horizontal where `down` has
/// the bit of a sign, and then at the upright if `left`.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
fn turn(y: DoubleDouble, x: DoubleDouble, left: Mask, down: Integer) -> Number {
    let steep = y.hi.is_above(x.hi);
    let less = DoubleDouble::select(steep, x, y);
    let more = DoubleDouble::select(steep, y, x);
    let diagonal = less.hi.is_above(TAN_EIGHTH_PI * more.hi);
    // less − more, exactly: what is left out of it is not of the sign of either
    let short = less.hi - more.hi;
    let short_lo = (less.hi - (short + more.hi)) + (less.lo - more.lo);
    let short = DoubleDouble { hi: short, lo: short_lo };
    let numerator = DoubleDouble::select(diagonal, short, less);
    let denominator = DoubleDouble::select(diagonal, more.add_smaller(less), more);
    let t = numerator.div(denominator);
    let z = t.hi * t.hi;
    let tail = t.hi * z * polynomial(z, &ATAN_TAIL);
    // eighths of a turn passed, and the sense in which the rest is added
    let eighths = select(diagonal, 1.0, 0.0);
    let eighths = flipped(select(steep, 2.0 - eighths, eighths), down);
    let eighths = select(left, 4.0 - eighths, eighths);
    let back = down ^ Integer::when(steep ^ left, SIGN);
    let sum = fast_two_sum(eighths * QUARTER_PI.hi, flipped(t.hi, back));
    sum.hi + (sum.lo + (eighths * QUARTER_PI.lo + flipped(t.lo * (1.0 - z) + tail, back)))
}

/// `arctan t − t` for t² up to 1/8.
#[inline(always)]
pub(crate) fn atan_bend(t: Number) -> Number {
    let z = t * t;
    t * z * polynomial(z, &SMALL_ATAN_TAIL)
}

/// `arctan x`.
#[inline(always)]
pub fn atan(x: Number) -> Number {
    // beyond 2¹⁰⁰ the result is π/2 to the last bit
    let size = select(x.abs().is_above(1e30), 1e30, x.abs());
    let regular = angle(DoubleDouble::from(size), DoubleDouble::from(1.0));
    let regular = select(x.abs().is_below(1e-300), x, regular.copysign(x));
    select(x.is_nan(), x, regular)
}

/// The angle in [−π, π] of the direction (x, y), with the signs of zeros and the infinities as in
/// C's `atan2`.
#[inline(always)]
pub fn atan2(y: Number, x: Number) -> Number {
    // infinities act as the directions (±1, 0), (0, ±1), (±1, ±1); (0, 0) as (±1, 0)
    let infinite = x.abs().equals(f64::INFINITY) | y.abs().equals(f64::INFINITY);
    let unit = |a: Number| select(a.abs().equals(f64::INFINITY), 1.0, 0.0);
    let across = select(infinite, unit(x), x.abs());
    let up = select(infinite, unit(y), y.abs());
    let across = select((across + up).equals(0.0), 1.0, across);
    // a power of two brings the greater near 1 (in two steps: the exponents differ by up to 2098)
    let greatest = select(across.is_above(up), across, up);
    let exponent = super::exponent_field(greatest);
    let half = super::nearest_integer(0.5 * exponent);
    let scale = |a: Number| a * power_of_two(-half) * power_of_two(half - exponent);
    let scaled =
        angle(DoubleDouble::from(scale(up)), DoubleDouble::from(scale(across).copysign(x)));
    // a direction this close to the positive x axis is its own angle, and may be subnormal
    let regular = select(x.is_above(0.0) & up.is_below(1e-280 * across), up / across, scaled);
    select(x.is_nan() | y.is_nan(), f64::NAN, regular.copysign(y))
}

//! Sine, cosine and tangent of angles in [−2π, 2π].
//!
//! Method: `x = k π/2 + r`, |r| ≤ π/4, with π/2 in three parts of which the first two multiply k
//! exactly; `sin r = r + r³ S(r²)`, `cos r = 1 − r²/2 + r⁴ C(r²)`.

use super::double_double::{
    DoubleDouble, fast_two_difference, fast_two_sum, two_difference, two_product, two_square,
};
use super::{Bits, MAGIC, Mask, Number, Order, lesser, polynomial, select};

// sin_tail: minimax on [0.0, 0.616912], degree 5,
// weighted error 5.38e-18: reference/coefficients.py sin_tail
const SIN_TAIL: [f64; 6] = [
    -0.16666666666666632,
    0.00833333333332242,
    -0.00019841269829811911,
    2.755731369330102e-06,
    -2.5050758331745135e-08,
    1.5896808365443716e-10,
];
// cos_tail: minimax on [0.0, 0.616912], degree 5,
// weighted error 8.99e-19: reference/coefficients.py cos_tail
const COS_TAIL: [f64; 6] = [
    0.0416666666666666,
    -0.0013888888888874133,
    2.4801587289488395e-05,
    -2.7557314354187497e-07,
    2.087572353345975e-09,
    -1.135966167320952e-11,
];

// long_sin_tail: minimax on [0.1, 2.46765], degree 6,
// weighted error 2.69e-19: reference/coefficients.py long_sin_tail
const LONG_SIN_TAIL: [f64; 7] = [
    0.008333333333333212,
    -0.00019841269841215268,
    2.7557319212129866e-06,
    -2.5052106960038454e-08,
    1.605894392480218e-10,
    -7.643097339520156e-13,
    2.7222514789077713e-15,
];

/// π/2 in three parts: 50 bits, 50 bits, the rest.
const HALF_PI: [f64; 3] = [
    f64::from_bits(0x3ff9_21fb_5444_2d18),
    f64::from_bits(0x3c91_a626_3314_5c00),
    f64::from_bits(0x397b_839a_2520_49c1),
];

/// What π/2 is more than the double next to it.
const FRAC_PI_2_LO: f64 = f64::from_bits(0x3c91_a626_3314_5c07);

/// How well a sine and a cosine are wanted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Digits {
    /// to 2⁻⁵⁶ of themselves
    More,
    /// to 2⁻⁵⁴, six instructions less
    Enough,
}

/// `sin r` and `cos r` for |r| ≤ π/4; the words of each overlap.
#[inline(always)]
fn sin_cos_reduced(r: DoubleDouble, digits: Digits) -> (DoubleDouble, DoubleDouble) {
    let DoubleDouble { hi: z, lo: z_low } = two_square(r.hi);
    // the leading term −r³/6 apart: it is a seventh of sin r, and its roundings are felt
    let cube = r.hi * z;
    const SIN_REST: [f64; 5] = {
        let [_, rest @ ..] = SIN_TAIL;
        rest
    };
    let sixth = SIN_TAIL[0];
    let small = cube * (z * polynomial(z, &SIN_REST));
    let cos_small = r.hi * r.lo;
    let (small, cos_small) = match digits {
        Digits::More => (small + r.hi * (sixth * z_low), 0.5 * z_low + cos_small),
        Digits::Enough => (small, cos_small),
    };
    let sin_rest = cube * sixth + (small + r.lo * (1.0 - 0.5 * z));
    let cos = fast_two_difference(1.0, 0.5 * z);
    let cos_tail = z * z * polynomial(z, &COS_TAIL) - cos_small;
    (DoubleDouble { hi: r.hi, lo: sin_rest }, DoubleDouble { hi: cos.hi, lo: cos.lo + cos_tail })
}

/// `sin x` and `cos x` for |x| ≤ 2π, each to 2⁻⁵⁶ of itself.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub(crate) fn sin_cos_extended(x: Number) -> (DoubleDouble, DoubleDouble) {
    let shifted = x * core::f64::consts::FRAC_2_PI + MAGIC;
    let k = shifted - MAGIC;
    let quadrant = shifted.to_bits();
    let r = two_difference(x - k * HALF_PI[0], k * HALF_PI[1]);
    let r = DoubleDouble { hi: r.hi, lo: r.lo - k * HALF_PI[2] };
    let (sin, cos) = sin_cos_reduced(r, Digits::More);
    let (sin, cos) = (fast_two_sum(sin.hi, sin.lo), fast_two_sum(cos.hi, cos.lo));
    let odd = quadrant.has(1);
    let sin_sign = select(quadrant.has(2), -1.0, 1.0);
    let cos_sign = select(quadrant.wrapping_add(1).has(2), -1.0, 1.0);
    (
        DoubleDouble::select(odd, cos, sin).scale(sin_sign),
        DoubleDouble::select(odd, sin, cos).scale(cos_sign),
    )
}

/// An angle in [0, π], or its mirror image: the left of the half-turn has the sines and cosines of the right.
#[derive(Clone, Copy)]
pub(crate) struct Mirrored {
    /// from 0 to π/2
    pub angle: DoubleDouble,
    /// whether it is itself
    pub right: Mask,
}

/// Sine and cosine of the distance from 0 or from π/2, of which the words overlap.
pub(crate) struct Quarter {
    sin: DoubleDouble,
    cos: DoubleDouble,
    /// whether it is from π/2
    steep: Mask,
}

impl Mirrored {
    #[inline(always)]
    pub fn of(x: Number) -> Self {
        use core::f64::consts::PI;
        let mirrored = PI - x;
        // the double next to π/2 lies below it, and is its own mirror image
        let right = x.is_at_most(mirrored);
        let lo = select(right, 0.0, 2.0 * FRAC_PI_2_LO);
        Mirrored { angle: DoubleDouble { hi: lesser(x, mirrored), lo }, right }
    }

    /// The differences to π and π/2 are exact where they are kept; their small parts stay apart, for
    /// nothing here is less than them but 0.
    #[inline(always)]
    pub fn quarter(self) -> Quarter {
        let DoubleDouble { hi: y, lo: y_lo } = self.angle;
        let across = core::f64::consts::FRAC_PI_2 - y;
        let steep = across.is_below(y);
        let lo = select(steep, FRAC_PI_2_LO - y_lo, y_lo);
        let r = DoubleDouble { hi: lesser(across, y), lo };
        let (sin, cos) = sin_cos_reduced(r, Digits::Enough);
        Quarter { sin, cos, steep }
    }
}

impl Quarter {
    /// Sine and cosine of the mirrored angle, each to 2⁻⁵⁴ of itself.
    #[inline(always)]
    pub fn sin_cos(self) -> (DoubleDouble, DoubleDouble) {
        let Quarter { sin, cos, steep } = self;
        let (sin, cos) = (fast_two_sum(sin.hi, sin.lo), fast_two_sum(cos.hi, cos.lo));
        (DoubleDouble::select(steep, cos, sin), DoubleDouble::select(steep, sin, cos))
    }
}

/// `sin x` for x in [0, π], and two numbers whose product is `sin x cos x`, each to 2⁻⁵⁴ of itself: the sine
/// and the cosine of the distance from the nearest quarter of a turn, whichever is which.
#[inline(always)]
pub(crate) fn sin_and_factors(x: Number) -> (Number, DoubleDouble, DoubleDouble) {
    use core::f64::consts::{FRAC_2_PI, FRAC_PI_2};
    let shifted = x * FRAC_2_PI + MAGIC;
    let k = shifted - MAGIC;
    let r = DoubleDouble { hi: x - k * FRAC_PI_2, lo: k * -FRAC_PI_2_LO };
    let (across, along) = sin_cos_reduced(r, Digits::Enough);
    let across = fast_two_sum(across.hi, across.lo);
    let along = fast_two_sum(along.hi, along.lo);
    let sin = select(k.equals(1.0), along.hi, across.hi.abs());
    // next to the upright the product has the other sign
    let turned = shifted.to_bits() << 63;
    let along = DoubleDouble {
        hi: Number::from_bits(along.hi.to_bits() ^ turned),
        lo: Number::from_bits(along.lo.to_bits() ^ turned),
    };
    (sin, across, along)
}

/// `sin x` and `cos x` for x in [0, π], each to 2⁻⁵⁴ of itself.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub(crate) fn sin_cos_upper(x: Number) -> (DoubleDouble, DoubleDouble) {
    let mirrored = Mirrored::of(x);
    let (sin, along) = mirrored.quarter().sin_cos();
    (sin, DoubleDouble::select(mirrored.right, along, along.neg()))
}

/// `sin x` for x in [0, π] where no cosine is asked for, to 2⁻⁵⁵ of itself: by one polynomial up to the
/// upright.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub(crate) fn sin_upper(x: Number) -> DoubleDouble {
    use core::f64::consts::PI;
    const PI_LO: f64 = f64::from_bits(0x3ca1_a626_3314_5c07);
    const SIXTH: f64 = 1.0 / 6.0;
    /// about (2/π)², so that what it multiplies vanishes at the upright as the cosine does
    const BEND: f64 = 0.4053;
    let mirrored = PI - x;
    let y = lesser(x, mirrored);
    let y_lo = select(x.is_below(mirrored), 0.0, PI_LO);
    let z = two_square(y);
    // sin y = y (1 − z/6 + z² S)
    let sixth = two_product(z.hi, Number::from(SIXTH));
    let tail = z.hi * z.hi * polynomial(z.hi, &LONG_SIN_TAIL);
    let ratio = fast_two_difference(1.0, sixth.hi);
    let small = ratio.lo + (tail - (sixth.lo + SIXTH * z.lo));
    let sin = two_product(y, ratio.hi);
    fast_two_sum(sin.hi, sin.lo + (y * small + y_lo * (1.0 - BEND * z.hi)))
}

/// Whether the functions of this file take `x`: |x| ≤ 2π.
#[inline(always)]
fn in_domain(x: Number) -> Mask {
    x.abs().is_at_most(core::f64::consts::TAU)
}

/// `(sin x, cos x)` for x in [−2π, 2π]; NaN outside.
#[inline(always)]
pub fn sin_cos(x: Number) -> (Number, Number) {
    let (sin, cos) = sin_cos_extended(x);
    let sin = select(x.abs().is_below(1e-300), x, sin.round());
    (select(in_domain(x), sin, f64::NAN), select(in_domain(x), cos.round(), f64::NAN))
}

/// `sin x` for x in [−2π, 2π]; NaN outside.
#[inline(always)]
pub fn sin(x: Number) -> Number {
    sin_cos(x).0
}

/// `cos x` for x in [−2π, 2π]; NaN outside.
#[inline(always)]
pub fn cos(x: Number) -> Number {
    sin_cos(x).1
}

/// `tan x` for x in [−2π, 2π]; NaN outside.
#[inline(always)]
pub fn tan(x: Number) -> Number {
    let (sin, cos) = sin_cos_extended(x);
    let regular = select(x.abs().is_below(1e-300), x, sin.div(cos).round());
    select(in_domain(x), regular, f64::NAN)
}

//! One launch: the direction, and the drag it meets.

use super::super::real::double_double::{
    DoubleDouble, fast_two_sum, rest_of_product, two_sum_positive,
};
use super::super::real::{Mask, Number, Order, lesser, select, sin_cos_upper};
use super::drag::{self, Drag};

/// How much of the domain a kernel is for (DESIGN.md, "ordinary part").
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    Whole,
    Ordinary,
}

/// A launch at angle α with drag parameter ε.
pub(crate) struct Launch {
    pub sin: DoubleDouble,
    pub cos: DoubleDouble,
    /// `u = ε sin α`, as it fell from the product
    pub u: DoubleDouble,
    epsilon: Number,
}

impl Launch {
    /// In the direction (cos α, sin α).
    #[inline(always)]
    pub fn new(sin: DoubleDouble, cos: DoubleDouble, epsilon: Number) -> Self {
        Launch { sin, cos, u: sin.times_double(epsilon), epsilon }
    }

    /// sin α, 2²⁰⁰ times as large: for lengths, which are proportional to it or to its square, and
    /// would be subnormal on the way.
    #[inline(always)]
    pub fn lifted(&self) -> DoubleDouble {
        self.sin.scale(LIFT)
    }

    /// At the angle α in [0, π].
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn at(alpha: Number, epsilon: Number) -> Self {
        let (sin, cos) = sin_cos_upper(alpha);
        Launch::new(sin, cos, epsilon)
    }

    /// `q = 1 + u`, of the product itself: `two_sum` with u as it is before it is rounded.
    #[inline(always)]
    pub fn q(&self) -> DoubleDouble {
        let hi = 1.0 + self.sin.hi * self.epsilon;
        let u = hi - 1.0;
        let one_rest = 1.0 - (hi - u);
        let u_rest = rest_of_product(u, self.sin.hi, self.epsilon);
        DoubleDouble { hi, lo: (self.sin.lo * self.epsilon + one_rest) - u_rest }
    }

    /// `q` of the rounded sine, as `q_without_one_rest`.
    #[inline(always)]
    pub fn q_of_rounded(&self) -> DoubleDouble {
        let hi = 1.0 + self.sin.hi * self.epsilon;
        DoubleDouble { hi, lo: -rest_of_product(hi - 1.0, self.sin.hi, self.epsilon) }
    }

    /// `G(u)`
    #[inline(always)]
    pub fn gain(&self) -> DoubleDouble {
        let drag = Drag::at(self.u.hi, drag::STRONG);
        let (share, square) = drag.gain_and_square(two_sum_positive(drag.u, 1.0));
        fast_two_sum(share.hi, share.lo).div(square)
    }
}

/// `q` without what the 1 leaves behind where it is less than a unit in the last place of u.
#[inline(always)]
pub(super) fn q_without_one_rest(sin: DoubleDouble, epsilon: Number) -> DoubleDouble {
    let hi = 1.0 + sin.hi * epsilon;
    let u_rest = rest_of_product(hi - 1.0, sin.hi, epsilon);
    DoubleDouble { hi, lo: sin.lo * epsilon - u_rest }
}

/// Whether neither is below what the functions of this module take, nor the angle above.
#[inline(always)]
pub(crate) fn is_within(angle: Number, epsilon: Number) -> Mask {
    // the mirrored angle is below 0 beyond π; and a NaN stays
    let mirrored = core::f64::consts::PI - angle;
    let least = lesser(angle, mirrored);
    lesser(epsilon, least).is_at_least(0.0)
}

/// Whether the functions of this module take the angle and the drag parameter.
#[inline(always)]
pub(crate) fn in_domain(angle: Number, epsilon: Number) -> Mask {
    // not `< INFINITY`: that comparison the compiler makes a test of bits, in five instructions
    is_within(angle, epsilon) & epsilon.is_at_most(f64::MAX)
}

/// `value` where the angle and the drag parameter are in the domain, else NaN.
#[inline(always)]
pub(crate) fn within_domain(angle: Number, epsilon: Number, value: Number) -> Number {
    select(in_domain(angle, epsilon), value, f64::NAN)
}

/// `value` where nothing on the way is subnormal, the angle is in the domain and the drag parameter in it
/// and at most `most`; else ∞. (One selection after the other: what a mask says of four vectors at once the
/// compiler would gather in an integer.)
#[inline(always)]
pub(crate) fn if_ordinary(angle: Number, epsilon: Number, most: f64, value: Number) -> Number {
    /// 2⁻³⁰⁰, and the last double before the one next to π
    const FIRST: f64 = f64::from_bits((1023 - 300) << 52);
    const LAST: f64 = f64::from_bits(core::f64::consts::PI.to_bits() - 1);
    let value = select(angle.is_within(FIRST, LAST), value, f64::INFINITY);
    select(epsilon.is_within(0.0, most), value, f64::INFINITY)
}

/// Below this, 2⁻⁵⁰⁰, a square is subnormal; times `LARGE`, 2⁴⁰⁰, it is not, and still tiny.
pub(crate) const TINY: f64 = f64::from_bits((1023 - 500) << 52);
pub(crate) const LARGE: f64 = f64::from_bits((1023 + 400) << 52);
/// 1/LARGE
pub(crate) const SMALL: f64 = f64::from_bits((1023 - 400) << 52);
/// 2²⁰⁰
pub(crate) const LIFT: f64 = f64::from_bits((1023 + 200) << 52);

/// An elevation so small that what is proportional to it would be subnormal on the way; a problem
/// alike to it, 2⁴⁰⁰ times as large, has none of that.
pub(crate) struct Scaled {
    pub angle: Number,
    pub epsilon: Number,
    /// what to multiply angles and lengths with in the end
    pub back: Number,
}

impl Scaled {
    /// With all angles below 2⁻⁵⁰⁰ multiplied by 2⁴⁰⁰, and ε sin α kept.
    #[inline(always)]
    pub fn new(angle: Number, epsilon: Number) -> Self {
        let tiny = angle.is_below(TINY);
        let back = select(tiny, SMALL, 1.0);
        Scaled { angle: angle * select(tiny, LARGE, 1.0), epsilon: epsilon * back, back }
    }
}

//! The launch angle that leads through a target.
//!
//! Method: at some time the target lies on the circle of all shots: with P = t E₁, β = t² E₂,
//! `H(β) = P² − X² − (Y + γβ)² = 0`. The unit of length is 1/μ, μ = 1/γ being the power of two below
//! the greater of 1 and ε, so that ε from 0 to 10³⁰⁰ is one case and X and Y have no error (w = λt,
//! λ = γε). P² is a concave function of β and the rest a parabola: its two zeros are the two arcs. The
//! touching point of the envelope lies between the two where they are close together, and begins both
//! (`aim_start.rs`). Two steps to the zero of (a + bθ + cθ²)/(1 + eθ), which has the first three
//! derivatives of H, lead on; the second has its residual in sums of two doubles. The angle is that
//! of (X, Y + γβ).

use super::super::real::double_double::{
    DoubleDouble, fast_two_difference, fast_two_sum, two_product, two_square,
};
use super::super::real::{
    Exponential, Mask, Number, Order, angle_all_round, nearest_integer, polynomial,
    power_and_inverse, power_of_two,
};
use super::super::real::{LN2_HI, LN2_LO, select, sqrt};
use super::aim_start::{Contact, start};
use super::domain::is_drag;
use super::relaxation::RELAXED;

// aim_exp: minimax on [-0.346608, 0.346608], degree 6,
// weighted error 1.16e-12: reference/coefficients.py aim_exp
const AIM_EXP: [f64; 7] = [
    0.49999999999528694,
    0.1666666678666288,
    0.04166666705243027,
    0.008333281263049488,
    0.0013888796471612822,
    0.000199092483011676,
    2.488764062293798e-05,
];

/// The sign of dH/dβ at the zero.
pub(super) const LOW: f64 = 1.0;
pub(super) const HIGH: f64 = -1.0;
/// w beyond which e⁻ʷ counts as 0.
const ENDED: f64 = 700.0;
/// 1/FAR, FAR being 2¹¹⁶: that far out the speed of the launch no longer counts, and a target at half of
/// x, a quarter of y and twice ε is hit by the same angle. Squares of squares would overflow.
const NEARER: f64 = f64::from_bits((1023 - 116) << 52);
/// Beyond this they would as well; so far down no shot changes its direction by what the last digit
/// does.
const DEEP: f64 = 1e70;
/// What enlarges tiny targets, 2¹⁰⁰⁰ and 2⁷⁰, and directions, 2⁴⁰⁰.
const MOST: f64 = f64::from_bits((1023 + 1000) << 52);
const MORE: f64 = f64::from_bits((1023 + 70) << 52);
const LARGE: f64 = f64::from_bits((1023 + 400) << 52);
/// μ beyond which a target a rounding off the envelope is meant to be on it: the model of H says nothing
/// of so small a thing, and squares of a far greater μ would overflow.
const STRONG: f64 = f64::from_bits((1023 + 50) << 52);
/// The greatest power of two with a normal inverse.
const GREATEST: f64 = f64::from_bits((1023 + 1022) << 52);

/// `a` and `b`, whichever is greater; `b` where `a` is NaN.
#[inline(always)]
pub(super) fn greater(a: Number, b: operand!()) -> Number {
    let b: Number = b.into();
    select(a.is_above(b), a, b)
}

/// `a` and `b`, whichever is less; `b` where `a` is NaN.
#[inline(always)]
pub(super) fn least(a: Number, b: operand!()) -> Number {
    let b: Number = b.into();
    select(a.is_below(b), a, b)
}

/// `a`, or the nearer of the two bounds.
#[inline(always)]
fn within(a: Number, bound: f64) -> Number {
    least(greater(a, -bound), bound)
}

/// A target and the drag, in the units of this file.
pub(super) struct Target {
    pub x: Number,
    pub y: Number,
    /// `1/γ`, a power of two
    pub mu: Number,
    pub lambda: Number,
    pub gamma: Number,
    /// `1/λ`
    pub end: Number,
    pub end_square: DoubleDouble,
    /// `λx` and `λy`
    pub share: DoubleDouble,
    pub rise: Number,
    /// `1 − (λx)²`
    pub beyond: Number,
}

impl Target {
    #[inline(always)]
    fn new(x: Number, y: Number, epsilon: Number) -> Self {
        let (_, (far, near)) = power_and_inverse(least(greater(x.abs() * NEARER, 1.0), GREATEST));
        let (x, y) = (x * near, y * near * near);
        // what is less makes no difference; its inverse would
        let epsilon = greater(epsilon * far, 1e-300);
        let (_, (mu, gamma)) = power_and_inverse(least(greater(epsilon, 1.0), GREATEST));
        let lambda = epsilon * gamma;
        let end = DoubleDouble::from(1.0).div_double(lambda);
        let share = two_product(lambda, mu * x);
        let (x, y) = (mu * x, within(mu * y, DEEP));
        Target {
            x,
            y,
            mu,
            lambda,
            gamma,
            end: end.hi,
            end_square: end.squared(),
            share,
            rise: lambda * y,
            beyond: ((1.0 - share.hi) - share.lo) * ((1.0 + share.hi) + share.lo),
        }
    }

    /// The time after a step from t towards the zero.
    #[inline(always)]
    fn step(&self, sense: f64, t: Number) -> Number {
        let (lambda, gamma) = (self.lambda, self.gamma);
        let w = least(lambda * t, ENDED);
        // e⁻ʷ = 2ⁿ (1 + r + r² q), and up to w = 0.35, where n = 0, q is E₂
        let n = nearest_integer(w * -core::f64::consts::LOG2_E);
        let r = (-w - n * LN2_HI) - n * LN2_LO;
        let q = polynomial(r, &AIM_EXP);
        let near = n.equals(0.0);
        let power = power_of_two(n);
        let rest = power + power * (r + r * r * q);
        let far = (w - (1.0 - rest)) * self.end_square.hi;
        let fall = select(near, t * t * q, far);
        let way = t - lambda * fall;

        let (x, y) = (self.x, self.y);
        let up = y + gamma * fall;
        let gone = rest * (1.0 + lambda * way);
        let excess_far = (self.beyond - gone) * self.end_square.hi - up * up;
        let excess_near = (way - x) * (way + x) - up * up;
        let excess = select(near, excess_near, excess_far);
        let model = Model::new(self, way, rest, rest - gamma * up, excess, 1.0);
        let root = sqrt(greater(model.discriminant(), 0.0));
        // on the other side of the greatest H the zero is the farther one
        let beyond = (sense * model.slope).is_below(0.0);
        let outer = model.slope.abs() + root;
        let numerator = sense * select(beyond, outer, -model.excess);
        let share = numerator / (select(beyond, model.bend, outer) * way); // θ/P
        let series = 0.5
            - share
                * ((1.0 / 6.0) + (1.0 / 3.0) * rest
                    - share * ((1.0 / 24.0) + rest * ((1.0 / 3.0) + 0.25 * rest)));
        t + share * way * (1.0 - rest * share * series)
    }

    /// `Y + γβ` at the zero, t being near, and X, by the same factor; whether they are on the
    /// envelope, and whether there is a zero.
    #[inline(always)]
    fn direction(
        &self,
        sense: f64,
        t: Number,
        contact: &Contact,
    ) -> (DoubleDouble, Number, Mask, Mask) {
        let (lambda, gamma) = (self.lambda, self.gamma);
        let w = two_product(lambda, t);
        let exponential = Exponential::of(-least(w.hi, ENDED));
        let power = power_of_two(exponential.n);
        let significand = exponential.loose_significand();
        let (high, low) =
            (power * significand.hi, power * (significand.lo - w.lo * significand.hi));
        let gone = fast_two_difference(1.0, high); // short of `low`
        let far = fast_two_difference(w.hi, gone.hi);
        let far = fast_two_sum(far.hi, far.lo + (w.lo - (gone.lo - low)));
        let far = far.times(self.end_square);
        let near = fast_two_sum(0.5, exponential.r * exponential.bend);
        let near = near.times(two_square(t));
        let fall = DoubleDouble::select(exponential.n.equals(0.0), near, far);
        let slowed = two_product(lambda, fall.hi);
        let way = fast_two_difference(t, slowed.hi);
        let way = DoubleDouble { hi: way.hi, lo: way.lo - (slowed.lo + lambda * fall.lo) };
        let rest = high + low;
        // where γ is tiny, so may the rise be
        let scaled_gamma = gamma * LARGE;
        let scaled_up = fall.scale(scaled_gamma).add_double(self.y * LARGE);
        let up = scaled_up.scale(1.0 / LARGE);

        // P² and X² + (Y + γβ)² are nearly equal: their difference has no error
        let (way_square, up_square, x_square) = (way.squared(), up.squared(), two_square(self.x));
        let ahead = fast_two_difference(way_square.hi, x_square.hi);
        let excess =
            (ahead.hi - up_square.hi) + (ahead.lo + ((way_square.lo - x_square.lo) - up_square.lo));
        // at the envelope e⁻ʷ is as small as γ, and products of four such would be 0
        let large = select(contact.close, self.mu, 1.0);
        let slope = large * (rest - gamma * up.hi);
        let model = Model::new(self, way.hi, rest, slope, large * excess, large);
        // H at its greatest, times `unit`, by what y is off the envelope
        let off = contact.up * (self.y.abs() + contact.up);
        let digits = model.unit * -model.bend * (large * off);
        // so strong is drag that no step along the envelope changes the direction: then H is the same
        let settled = contact.close & self.mu.is_above(STRONG);
        let discriminant = select(settled, excess, model.discriminant());
        let digits = select(settled, off, digits);
        let on = contact.close & discriminant.is_below(digits * (3.0 * f64::EPSILON));
        let there = !contact.close | discriminant.is_above(digits * (-5.0 * f64::EPSILON));
        // where no zero is in sight yet, a moderate step
        let least = model.slope * model.slope * 1e-18;
        let root = sqrt(select(on, 0.0, greater(discriminant, least)));

        // to the greatest H, and on; or to the nearer zero
        let close = contact.close;
        let numerator = select(close, sense * root - model.slope, -sense * model.excess);
        let denominator = select(close, model.bend, sense * model.slope + root);
        let theta = select(settled, 0.0, numerator / denominator);
        let scaled_up = fast_two_sum(scaled_up.hi, scaled_up.lo + scaled_gamma * (way.hi * theta));
        (scaled_up, self.x.abs() * LARGE, on, there)
    }
}

/// `unit H = excess + 2 slope θ + bend θ²`, over a linear function of θ, β having changed by Pθ.
pub(super) struct Model {
    pub excess: Number,
    pub slope: Number,
    pub bend: Number,
    unit: Number,
}

impl Model {
    /// At P, e⁻ʷ, half of dH/dβ and H, the last two `large` times as great.
    #[inline(always)]
    pub fn new(
        target: &Target,
        way: Number,
        rest: Number,
        slope: Number,
        excess: Number,
        large: operand!(),
    ) -> Self {
        let large: Number = large.into();
        let loss = large * target.lambda * rest;
        let curvature = loss + large * target.gamma * target.gamma * way;
        let second = way * curvature;
        let unit = 3.0 * second;
        let first = way * slope;
        Model {
            excess: unit * excess,
            slope: unit * first + 0.5 * (loss * excess),
            bend: 2.0 * (loss * first) - unit * second,
            unit,
        }
    }

    #[inline(always)]
    pub fn discriminant(&self) -> Number {
        self.slope * self.slope - self.bend * self.excess
    }
}

/// The launch angle of one arc to the target.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
fn aim(sense: f64, x: Number, y: Number, epsilon: Number) -> Number {
    let target = Target::new(x, y, epsilon);
    let contact = Contact::of(&target);
    let start = start(&target, &contact, sense);
    let t = select(contact.close, contact.t, target.step(sense, start.t));
    let (up, across, on, there) = target.direction(sense, t, &contact);

    // at the end of all motion the way is 1/λ
    let ended = start.end.is_above(RELAXED) & !on;
    let level = two_product(start.level, target.end * LARGE);
    let up = DoubleDouble::select(ended, level, up);
    // a target so near is hit after the way r, and a fall of r²/2; there the squares underflow
    let near = Mask::from(sense == LOW) & (target.x.abs() + target.y.abs()).is_below(1e-30);
    let enlarged = |a: Number| a * MOST * MORE;
    let (ahead, above) = (enlarged(x.abs()), enlarged(y));
    let fallen = 0.5 * (ahead * x.abs() + above * y);
    let up = DoubleDouble::select(near, DoubleDouble::from(above + fallen), up);
    // the launch point itself counts as straight ahead
    let across = select(near, greater(ahead, 1e-300), across);

    let turn = angle_all_round(up, across, x.is_below(0.0));
    let inside = there & contact.reached & y.is_above(f64::NEG_INFINITY) & is_drag(epsilon);
    // no angle turns further; a NaN does, and becomes the one that has the same bits everywhere
    select(inside & turn.abs().is_at_most(core::f64::consts::TAU), turn, f64::NAN)
}

/// Launch angle of the lower, faster arc through the target (x, y), in radians.
///
/// x and y in V₀²/g, ε ≥ 0. NaN where y is above `envelope_height(x, ε)`; on the envelope both
/// arcs are one. Two or three units in the last place above it count as on it: places computed in
/// doubles lie there. In [−π/2, π/2] for x ≥ 0, in (π/2, 3π/2] for x < 0. The launch point itself
/// counts as straight ahead.
#[inline(always)]
pub fn aim_low(x: Number, y: Number, eps: Number) -> Number {
    aim(LOW, x, y, eps)
}

/// Launch angle of the higher, slower arc through the target (x, y), in radians.
///
/// As [`aim_low`]. Both arcs are straight up for a target above the launcher, which the shot
/// meets on its way up and on its way down.
#[inline(always)]
pub fn aim_high(x: Number, y: Number, eps: Number) -> Number {
    aim(HIGH, x, y, eps)
}

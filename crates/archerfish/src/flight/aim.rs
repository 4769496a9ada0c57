//! The launch angle that leads through a target.
//!
//! Method: at some time the target lies on the circle of all shots: with P = t E₁, β = t² E₂,
//! `H(β) = P² − X² − (Y + γβ)² = 0`. The unit of length is 1/μ, μ = 1/γ being the power of two below
//! the greater of 1 and ε, so that ε from 0 to 10³⁰⁰ is one case and X and Y have no error (w = λt,
//! λ = γε). P² is a concave function of β and the rest a parabola: its two zeros are the two arcs. The
//! touching point of the envelope lies between the two where they are close together, and begins both
//! (`aim_start.rs`). Two steps to the zero of (a + bθ + cθ²)/(1 + eθ), which has the first three
//! derivatives of H, lead on; the second has its residual in sums of two doubles. The angle is that
//! of (X, Y + γβ), or far out, where that is a small difference, of (X, ±√(P² − X²)).

use super::super::real::double_double::{
    DoubleDouble, fast_two_difference, fast_two_sum, two_product, two_square,
};
use super::super::real::{
    Exponential, Mask, Number, Order, angle_all_round, nearest_integer, polynomial,
    power_and_inverse, power_of_two,
};
use super::super::real::{LN2_HI, LN2_LO, greater, lesser, select, sqrt};
use super::aim_start::{Contact, start};
use super::domain::is_drag;
use super::relaxation::RELAXED;

// aim_exp_tail: minimax on [-0.346608, 0.346608], degree 5,
// weighted error 1.18e-12: reference/coefficients.py aim_exp_tail
const AIM_EXP_TAIL: [f64; 6] = [
    0.1666666678489727,
    0.04166666690069884,
    0.008333281642553455,
    0.0013888812226054933,
    0.00019909052156106158,
    2.4882321646934263e-05,
];

/// How much of the kernel. The ordinary part leaves out what only extreme targets need, and those on the
/// envelope: it gives the same bits, or ∞ where it declines, and then the whole is asked
/// (`dispatch.rs`).
#[derive(Clone, Copy)]
enum Part {
    Whole,
    Ordinary,
}

/// The sign of dH/dβ at the zero.
pub(super) const LOW: f64 = 1.0;
pub(super) const HIGH: f64 = -1.0;
/// w beyond which e⁻ʷ counts as 0.
const ENDED: f64 = 700.0;
/// 2⁻¹¹⁶: as far out as 2¹¹⁶ the speed of the launch no longer counts, and a target at half of x, a quarter
/// of y and twice ε is hit by the same angle. Squares of squares would overflow.
const NEARER: f64 = f64::from_bits((1023 - 116) << 52);
/// Beyond this they would as well; so far down no shot changes its direction by what the last digit
/// does.
const DEEP: f64 = 1e70;
/// Distances between which a target is ordinary, and the greatest ordinary drag: nearer ones are hit after
/// a fall of r²/2, and nothing is scaled.
const TINY: f64 = 1e-30;
const FAR: f64 = 1e15;
/// What enlarges tiny targets, 2¹⁰⁰⁰ and 2⁷⁰, and directions, 2⁴⁰⁰.
const MOST: f64 = f64::from_bits((1023 + 1000) << 52);
const MORE: f64 = f64::from_bits((1023 + 70) << 52);
const LARGE: f64 = f64::from_bits((1023 + 400) << 52);
/// μ beyond which a target a rounding off the envelope is meant to be on it: the model of H says nothing
/// of so small a thing, and squares of a far greater μ would overflow.
const STRONG: f64 = f64::from_bits((1023 + 50) << 52);
/// The greatest power of two with a normal inverse.
const GREATEST: f64 = f64::from_bits((1023 + 1022) << 52);

/// `a`, or the nearer of the two bounds.
#[inline(always)]
fn within(a: Number, bound: f64) -> Number {
    lesser(greater(a, -bound), bound)
}

/// What directions are enlarged by.
#[inline(always)]
fn scale(part: Part) -> f64 {
    match part {
        Part::Whole => LARGE,
        Part::Ordinary => 1.0,
    }
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
    fn new(part: Part, x: Number, y: Number, epsilon: Number) -> Self {
        let (x, y, epsilon) = match part {
            Part::Whole => {
                let far = lesser(greater(x.abs() * NEARER, 1.0), GREATEST);
                let (_, (far, near)) = power_and_inverse(far);
                (x * near, y * near * near, epsilon * far)
            }
            Part::Ordinary => (x, y, epsilon),
        };
        // what is less makes no difference; its inverse would
        let epsilon = greater(epsilon, 1e-300);
        let most = match part {
            Part::Whole => lesser(epsilon, GREATEST),
            Part::Ordinary => epsilon,
        };
        let (_, (mu, gamma)) = power_and_inverse(greater(most, 1.0));
        let lambda = epsilon * gamma;
        let end = DoubleDouble::from(1.0).div_double(lambda);
        let share = two_product(lambda, mu * x);
        let (x, y) = (mu * x, mu * y);
        let y = match part {
            Part::Whole => within(y, DEEP),
            Part::Ordinary => y,
        };
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

    /// \|X\| + \|Y\|, as great as the distance or a little greater.
    #[inline(always)]
    fn distance(&self) -> Number {
        self.x.abs() + self.y.abs()
    }

    /// The time after a step from t towards the zero, and whether t was not past the greatest H: what is
    /// past it only the whole can bring back.
    #[inline(always)]
    fn step(&self, part: Part, sense: f64, t: Number) -> (Number, Mask) {
        let (lambda, gamma) = (self.lambda, self.gamma);
        let w = lesser(lambda * t, ENDED);
        // e⁻ʷ = 2ⁿ (1 + r + r² q), and up to w = 0.35, where n = 0, q is E₂
        let n = nearest_integer(w * -core::f64::consts::LOG2_E);
        let r = (-w - n * LN2_HI) - n * LN2_LO;
        let q = 0.5 + r * polynomial(r, &AIM_EXP_TAIL);
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
        let outer = sense * model.slope + root;
        let (numerator, denominator) = match part {
            Part::Whole => {
                let farther = root - sense * model.slope;
                (select(beyond, farther, -model.excess), select(beyond, model.bend, outer))
            }
            Part::Ordinary => (-model.excess, outer),
        };
        let share = sense * numerator / (denominator * way); // θ/P
        let series = 0.5
            - share
                * ((1.0 / 6.0) + (1.0 / 3.0) * rest
                    - share * ((1.0 / 24.0) + rest * ((1.0 / 3.0) + 0.25 * rest)));
        (t + share * way * (1.0 - rest * share * series), !beyond)
    }

    /// The direction to the zero, t being near.
    #[inline(always)]
    fn direction(&self, part: Part, sense: f64, t: Number, contact: &Contact) -> Direction {
        let (lambda, gamma) = (self.lambda, self.gamma);
        let w = two_product(lambda, t);
        let exponential = Exponential::of(-lesser(w.hi, ENDED));
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
        let scale = scale(part);
        let scaled_gamma = gamma * scale;
        let scaled_up = fall.scale(scaled_gamma).add_double(self.y * scale);
        let up = scaled_up.scale(1.0 / scale);

        // P² and X² + (Y + γβ)² are nearly equal: their difference has no error
        let (way_square, up_square, x_square) = (way.squared(), up.squared(), two_square(self.x));
        let ahead = fast_two_difference(way_square.hi, x_square.hi);
        let excess =
            (ahead.hi - up_square.hi) + (ahead.lo + ((way_square.lo - x_square.lo) - up_square.lo));
        let at = Instant { way: way.hi, rest, slope: rest - gamma * up.hi, excess };
        let (theta, on, there) = match part {
            Part::Whole => self.last_step(sense, at, contact),
            Part::Ordinary => {
                let (theta, near) = self.short_step(at);
                (theta, Mask::from(false), near)
            }
        };
        let up = fast_two_sum(scaled_up.hi, scaled_up.lo + scaled_gamma * (way.hi * theta));
        let up = match part {
            Part::Whole => {
                // far out Y + γβ is a small difference: the same is √(P² − X²), downwards on the low arc
                let longer = rest * way.hi * theta * (2.0 - lambda * theta);
                let small = ahead.lo + ((way_square.lo - x_square.lo) + longer);
                let rise = fast_two_sum(ahead.hi, small).sqrt().scale(-sense * LARGE);
                let far =
                    self.distance().is_above(FAR) & (gamma * rise.hi.abs()).is_above(rest * LARGE);
                DoubleDouble::select(far, rise, up)
            }
            Part::Ordinary => up,
        };
        Direction { up, across: self.x.abs() * scale, on, there }
    }

    /// θ to the zero next to which H was measured, and whether it is so near.
    #[inline(always)]
    fn short_step(&self, at: Instant) -> (Number, Mask) {
        Model::new(self, at.way, at.rest, at.slope, at.excess, 1.0).nearest_zero()
    }

    /// The same, or θ to the greatest H and on to the zero; whether the target counts as on the
    /// envelope, and whether there is a zero.
    #[inline(always)]
    fn last_step(&self, sense: f64, at: Instant, contact: &Contact) -> (Number, Mask, Mask) {
        // at the envelope e⁻ʷ is as small as γ, and products of four such would be 0
        let large = select(contact.close, self.mu, 1.0);
        let slope = large * at.slope;
        let model = Model::new(self, at.way, at.rest, slope, large * at.excess, large);
        // H at its greatest, times `unit`, by what y is off the envelope
        let off = contact.up * (self.y.abs() + contact.up);
        let digits = model.unit * -model.bend * (large * off);
        // so strong is drag that no step along the envelope changes the direction: then H is the same
        let settled = contact.close & self.mu.is_above(STRONG);
        let discriminant = select(settled, at.excess, model.discriminant());
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
        let (theta, near) = model.nearest_zero();
        let theta = select(near & !close, theta, numerator / denominator);
        (select(settled, 0.0, theta), on, there)
    }
}

/// The direction of the launch.
struct Direction {
    /// `Y + γβ`, enlarged
    up: DoubleDouble,
    /// `X`, as much enlarged
    across: Number,
    /// whether the target counts as on the envelope
    on: Mask,
    /// whether there is a zero; for the ordinary part, whether it was found
    there: Mask,
}

/// What is known of one time on the way.
struct Instant {
    way: Number,
    /// `e⁻ʷ`
    rest: Number,
    /// half of dH/dβ
    slope: Number,
    /// H
    excess: Number,
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

    /// θ of the nearer zero, and whether that is so near that four terms of the root are enough.
    #[inline(always)]
    fn nearest_zero(&self) -> (Number, Mask) {
        let inverse = 1.0 / self.slope;
        let newton = self.excess * inverse;
        let q = newton * (self.bend * inverse);
        let theta = -newton * polynomial(q, &[0.5, 0.125, 0.0625, 0.0390625]);
        (theta, q.abs().is_below(0.00048828125))
    }

    #[inline(always)]
    pub fn discriminant(&self) -> Number {
        self.slope * self.slope - self.bend * self.excess
    }
}

/// The launch angle of one arc to the target; of the ordinary part ∞ where that declines.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
fn aim(part: Part, sense: f64, x: Number, y: Number, epsilon: Number) -> Number {
    let target = Target::new(part, x, y, epsilon);
    let contact = Contact::of(&target);
    let start = start(sense, &target, &contact);
    let (stepped, inward) = target.step(part, sense, start.t);
    let t = match part {
        Part::Whole => select(contact.close, contact.t, stepped),
        Part::Ordinary => stepped,
    };
    let Direction { up, across, on, there } = target.direction(part, sense, t, &contact);

    // at the end of all motion the way is 1/λ
    let ended = start.end.is_above(RELAXED) & !on;
    let level = two_product(start.level, target.end * scale(part));
    let up = DoubleDouble::select(ended, level, up);
    let (up, across) = match part {
        Part::Whole => {
            let near = Mask::from(sense == LOW) & target.distance().is_below(TINY);
            next_to_launch(near, x, y, up, across)
        }
        Part::Ordinary => (up, across),
    };

    let turn = angle_all_round(up, across, x.is_below(0.0));
    match part {
        Part::Whole => {
            let inside = y.is_above(f64::NEG_INFINITY) & is_drag(epsilon);
            // no angle turns further; a NaN does, and becomes the one with the same bits everywhere
            let found = there & contact.reached & turn.abs().is_at_most(core::f64::consts::TAU);
            select(found & inside, turn, f64::NAN)
        }
        Part::Ordinary => {
            let distance = target.distance();
            let ordinary = distance.is_above(TINY)
                & (distance + epsilon).is_below(FAR)
                & epsilon.is_at_least(0.0);
            let declined = select(contact.reached, f64::INFINITY, f64::NAN);
            let declined = select(ordinary, declined, f64::INFINITY);
            let found = there & inward & contact.reached & !contact.close;
            select(found & ordinary, turn, declined)
        }
    }
}

/// The direction to a target that is near: hit after the way r and a fall of r²/2, when squares underflow;
/// else the one given.
#[inline(always)]
fn next_to_launch(
    near: Mask,
    x: Number,
    y: Number,
    up: DoubleDouble,
    across: Number,
) -> (DoubleDouble, Number) {
    let (ahead, above) = (x.abs() * MOST * MORE, y * MOST * MORE);
    let fallen = 0.5 * (ahead * x.abs() + above * y);
    let up = DoubleDouble::select(near, DoubleDouble::from(above + fallen), up);
    // the launch point itself counts as straight ahead
    (up, select(near, greater(ahead, 1e-300), across))
}

/// Launch angle of the lower, faster arc through the target (x, y), in radians.
///
/// x and y in V₀²/g, ε ≥ 0. NaN where y is above `envelope_height(x, ε)`; on the envelope both
/// arcs are one. Two or three units in the last place above it count as on it: places computed in
/// doubles lie there. In [−π/2, π/2] for x ≥ 0, in (π/2, 3π/2] for x < 0. The launch point itself
/// counts as straight ahead.
#[inline(always)]
pub fn aim_low(x: Number, y: Number, eps: Number) -> Number {
    aim(Part::Whole, LOW, x, y, eps)
}

/// Launch angle of the higher, slower arc through the target (x, y), in radians.
///
/// As [`aim_low`]. Both arcs are straight up for a target above the launcher, which the shot
/// meets on its way up and on its way down.
#[inline(always)]
pub fn aim_high(x: Number, y: Number, eps: Number) -> Number {
    aim(Part::Whole, HIGH, x, y, eps)
}

/// `aim_low` of ordinary targets, faster; ∞ for others.
#[allow(dead_code, reason = "for dispatch alone, which not every build has")]
#[inline(always)]
pub(crate) fn aim_low_ordinary(x: Number, y: Number, eps: Number) -> Number {
    aim(Part::Ordinary, LOW, x, y, eps)
}

/// `aim_high` of ordinary targets, faster; ∞ for others.
#[allow(dead_code, reason = "for dispatch alone, which not every build has")]
#[inline(always)]
pub(crate) fn aim_high_ordinary(x: Number, y: Number, eps: Number) -> Number {
    aim(Part::Ordinary, HIGH, x, y, eps)
}

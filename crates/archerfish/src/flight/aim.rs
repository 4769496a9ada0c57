//! The launch angle that leads through a target.
//!
//! Method: at some time the target lies on the circle of all shots: with P = t E₁, β = t² E₂,
//! `H(β) = P² − X² − (Y + γβ)² = 0`. Lengths are in units in which the greater of 1 and 1/ε is 1,
//! so that ε from 0 to 10³⁰⁰ is one case (γ = 1/ε or 1, w = λt with λ = 1 or ε). P² is a concave
//! function of β and the rest a parabola, so that H is concave: its two zeros are the two arcs, and
//! a tangent to P² in place of P² moves them outwards. The tangents at the launch, at the touching
//! point of the envelope and at the end of all motion bound the zero; steps that replace P² by its
//! parabola converge from there, for the low arc after one that solves `e⁻ʷ = 1 − ε√(X² + (Y + γβ)²)`
//! for w. The last step has its residual in sums of two doubles; the angle is that of (Y + γβ, X).

use super::super::real::double_double::{DoubleDouble, two_product};
use super::super::real::{Exponential, angle, ln, polynomial, power_of_two, select, sqrt};
use super::domain::is_drag;
use super::envelope::Touching;
use super::relaxation::{FALL_TAIL, RELAXED, Relaxation};

const LOW: f64 = -1.0;
const HIGH: f64 = 1.0;
const ONE: DoubleDouble = DoubleDouble { hi: 1.0, lo: 0.0 };
const PI: DoubleDouble =
    DoubleDouble { hi: core::f64::consts::PI, lo: f64::from_bits(0x3ca1_a626_3314_5c07) };
/// w beyond which e⁻ʷ, in the steps before the last, counts as 0.
const ENDED: f64 = 700.0;

/// `a` and `b`, whichever is greater; `b` where `a` is NaN.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    select(a > b, a, b)
}

/// A target in front of the launcher, in the units of this file.
struct Target {
    x: DoubleDouble,
    y: DoubleDouble,
    lambda: f64,
    gamma: DoubleDouble,
    /// `λx`, `λy` and `1 − (λx)² − (λy)²`
    share: DoubleDouble,
    rise: f64,
    before_wall: f64,
    /// `1 − (λx)²`
    beyond: DoubleDouble,
    touching: Touching,
}

/// The place of all shots at one time.
struct Front {
    t: f64,
    way: f64,
    fall: f64,
    /// `e⁻ʷ`
    rest: f64,
    /// `Y + γβ`
    up: f64,
    /// `H`
    excess: f64,
    /// half of dH/dβ
    slope: f64,
    /// minus half of d²H/dβ²
    bend: f64,
}

impl Target {
    #[inline(always)]
    fn new(x: f64, y: f64, epsilon: f64) -> Self {
        let strong = epsilon > 1.0;
        let mu = select(strong, epsilon, 1.0);
        // farther down no shot changes the direction by what the last digit of y does
        let bounded = |value: DoubleDouble, bound: f64| {
            DoubleDouble::select(
                value.hi.abs() > bound,
                DoubleDouble::from(bound.copysign(value.hi)),
                value,
            )
        };
        let across = bounded(two_product(mu, x.abs()), 1e70);
        let up = bounded(two_product(mu, y), 1e140);
        let share = bounded(two_product(epsilon, x.abs()), 1.0);
        let rise = bounded(two_product(epsilon, y), 1e140);
        let beyond = ONE.sub(share).mul(ONE.add(share));
        Target {
            x: across,
            y: up,
            lambda: select(strong, 1.0, epsilon),
            gamma: ONE.div(DoubleDouble::from(mu)),
            share,
            rise: rise.hi,
            before_wall: beyond.sub(rise.square()).round(),
            beyond,
            touching: Touching::at(x, epsilon),
        }
    }

    #[inline(always)]
    fn front(&self, t: f64) -> Front {
        let (lambda, gamma, y) = (self.lambda, self.gamma.hi, self.y.hi);
        let w = select(lambda * t > ENDED, ENDED, lambda * t);
        let exponential = Exponential::of(-w);
        let rest = exponential.significand().round() * power_of_two(exponential.n);
        let near = w < 0.7;
        let inverse = 1.0 / select(near, 1.0, w);
        let fall_near = 0.5 - w * (1.0 / 6.0 - w * polynomial(w, &FALL_TAIL));
        let speed_far = (1.0 - rest) * inverse;
        let fall_e2 = select(near, fall_near, (1.0 - speed_far) * inverse);
        let speed_e1 = select(near, 1.0 - w * fall_near, speed_far);
        let (way, fall) = (t * speed_e1, t * t * fall_e2);
        let dropped = gamma * fall;
        let up = y + dropped;
        // next to the wall before and after most of the fall, and in general
        let gone = rest * (1.0 + lambda * way);
        let inverse_square = 1.0 / (lambda * lambda);
        let by_wall = (self.before_wall - gone) * inverse_square - dropped * (2.0 * y + dropped);
        let far_down = (self.beyond.hi - gone) * inverse_square - up * up;
        let excess = (way - self.x.hi) * (way + self.x.hi) - up * up;
        let excess = select(near, excess, select(dropped < 0.5 * y.abs(), by_wall, far_down));
        Front {
            t,
            way,
            fall,
            rest,
            up,
            excess,
            slope: rest - gamma * up,
            bend: lambda * rest / way,
        }
    }

    /// Where the tangent to P² of slope 2k meets the parabola, `r2` being X² + Y² less the
    /// tangent's height at β = 0.
    #[inline(always)]
    fn bound(&self, arc: f64, k: f64, r2: f64) -> f64 {
        let (gamma, y) = (self.gamma.hi, self.y.hi);
        if arc == LOW {
            let h = k - gamma * y;
            r2 / (h + sqrt(greater(h * h - gamma * gamma * r2, 0.0)))
        } else {
            let h = k / gamma - y;
            (h + sqrt(greater(h * h - r2, 0.0))) / gamma
        }
    }

    /// λγβ when P has become 1/λ, the end of all motion but the fall; without cancellation.
    #[inline(always)]
    fn end(&self, arc: f64) -> f64 {
        let level = sqrt(greater(self.beyond.hi, 0.0));
        let sum = level + self.rise.abs();
        // ±level − rise
        let opposite = (self.rise < 0.0) == (arc == LOW);
        arc * select(opposite, self.before_wall / sum, sum)
    }

    /// A time to begin with.
    #[inline(always)]
    fn start(&self, arc: f64) -> f64 {
        let way = self.touching.way.hi / self.gamma.hi;
        let v = self.lambda * way;
        let psi = self.touching.psi.hi;
        let k = self.touching.way.hi * self.touching.sin.hi;
        let r2 = self.x.hi * self.x.hi + self.y.hi * self.y.hi;
        // the same twice, without loss where v is nearly 1
        let direct = r2 - way * way * (1.0 - 2.0 * k * psi);
        let by_wall = k * (1.0 + v) + 2.0 * k * psi * v * v - self.before_wall;
        let at_touch = select(v < 0.5, direct, by_wall / (self.lambda * self.lambda));
        let at_touch = self.bound(arc, k, at_touch);
        let at_launch = self.bound(arc, 1.0, r2);
        let end = self.end(arc) / (self.lambda * self.gamma.hi);
        let beta = if arc == LOW {
            greater(at_touch, greater(at_launch, end))
        } else {
            let first = select(at_touch < at_launch, at_touch, at_launch);
            let end = greater(end, 0.0);
            select(end < first, end, first)
        };
        // t of t² E₂(λt) = β, to a tenth
        let root = sqrt(2.0 * greater(beta, 1e-300));
        let w = greater(self.lambda * root, 0.0);
        let w = select(w > 1e100, 1e100, w);
        root * (0.5 * w + (1.0 + w * (2.0 / 3.0)) / (1.0 + w + w * w * (2.0 / 3.0)))
    }

    /// The step in β to the zero of the parabola.
    #[inline(always)]
    fn change(&self, arc: f64, excess: f64, slope: f64, bend: f64) -> f64 {
        let root = sqrt(greater(slope * slope + bend * excess, 0.0));
        let outer = slope + arc * root;
        let inner = slope - arc * root;
        select(arc * slope > 0.0, outer / bend, -excess / inner)
    }

    /// The time at which β has changed by `change`.
    #[inline(always)]
    fn later(&self, front: &Front, change: f64) -> f64 {
        let square = front.way * front.way;
        let root = sqrt(greater(square + 2.0 * front.rest * change, 0.01 * square));
        let t = front.t + 2.0 * change / (front.way + root);
        let end = ENDED / self.lambda;
        select(t > end, end, t)
    }

    #[inline(always)]
    fn step(&self, arc: f64, t: f64) -> f64 {
        let front = self.front(t);
        let gamma = self.gamma.hi;
        let bend = gamma * gamma + front.bend;
        self.later(&front, self.change(arc, front.excess, front.slope, bend))
    }

    /// The first step towards the low arc: the greater of two lower bounds.
    #[inline(always)]
    fn first_step(&self, t: f64) -> f64 {
        let front = self.front(t);
        let (gamma, lambda) = (self.gamma.hi, self.lambda);
        let by_tangent =
            self.later(&front, self.change(LOW, front.excess, front.slope, gamma * gamma));
        let dropped = gamma * front.fall;
        let rest_square =
            self.before_wall - lambda * lambda * dropped * (2.0 * self.y.hi + dropped);
        let share = sqrt(greater(1.0 - rest_square, 0.0));
        let rest = rest_square / (1.0 + share);
        let value = -ln(rest / front.rest);
        let slope = front.up * lambda * gamma * front.way / (share * rest) - 1.0;
        let by_logarithm = front.t + select(slope < -1e-3, -value / (slope * lambda), 0.0);
        greater(by_logarithm, by_tangent)
    }

    /// `Y + γβ` at the time when the arc leads through the target.
    #[inline(always)]
    fn up(&self, arc: f64, t: f64) -> DoubleDouble {
        let w = two_product(self.lambda, t);
        let relaxed = w.hi > RELAXED;
        let Relaxation { speed, fall, .. } =
            Relaxation::at(DoubleDouble::select(relaxed, DoubleDouble::from(RELAXED), w));
        let end = ONE.div(DoubleDouble::from(self.lambda));
        let way = DoubleDouble::select(relaxed, end, speed.mul_double(t));
        let fallen = DoubleDouble::select(
            relaxed,
            DoubleDouble::from(t).sub(end).mul(end),
            fall.mul_double(t).mul_double(t),
        );
        let up = self.y.add(self.gamma.mul(fallen));
        let excess = way.square().sub(up.square()).sub(self.x.square()).round();
        let rest = self.front(t).rest;
        let gamma = self.gamma.hi;
        let bend = gamma * gamma + self.lambda * rest / way.hi;
        let change = self.change(arc, excess, rest - gamma * up.hi, bend);
        up.add_double(gamma * change)
    }
}

/// The angle in [−π/2, π/2] of the direction (x, y), x ≥ 0.
#[inline(always)]
fn direction(x: DoubleDouble, y: DoubleDouble) -> DoubleDouble {
    const LARGE: f64 = f64::from_bits((1023 + 600) << 52);
    let down = y.hi < 0.0;
    let size = DoubleDouble::select(down, y.neg(), y);
    let factor = select((size.hi < 1e-150) & (x.hi < 1e-150), LARGE, 1.0);
    let turn = angle(size.scale(factor), x.scale(factor));
    // so small an angle is its tangent, whose powers would underflow
    let flat = size.hi < 1e-250 * x.hi;
    let turn = DoubleDouble::select(flat, size.div(x), turn);
    DoubleDouble::select(down, turn.neg(), turn)
}

/// The launch angle of one arc to the target.
#[inline(always)]
fn aim(arc: f64, x: f64, y: f64, epsilon: f64) -> f64 {
    // −0 is 0: its inverse would be −∞
    let epsilon = epsilon + 0.0;
    let target = Target::new(x, y, epsilon);
    let mut t = target.start(arc);
    if arc == LOW {
        t = target.first_step(t);
    }
    t = target.step(arc, t);
    t = target.step(arc, t);
    t = target.step(arc, t);
    t = target.step(arc, t);
    let up = target.up(arc, t);
    // a target so near is hit after the way r, and a fall of r²/2; there the squares underflow
    const FACTOR: f64 = f64::from_bits((1023 + 1000) << 52);
    const MORE: f64 = f64::from_bits((1023 + 70) << 52);
    let size = target.x.hi + target.y.hi.abs();
    let more = select(size < 1e-150, MORE, 1.0);
    let mu = select(epsilon > 1.0, epsilon, 1.0);
    let ahead = two_product(mu, x.abs() * FACTOR * more);
    let rise = two_product(mu, y * FACTOR * more);
    // γ undoes the unit of one factor of each square
    let fallen = ahead.mul_double(x.abs()).add(rise.mul_double(y)).scale(0.5);
    let near = (arc == LOW) & (size < 1e-30);
    let up = DoubleDouble::select(near, rise.add(fallen), up);
    let regular = direction(DoubleDouble::select(near, ahead, target.x), up);

    // at the end of all motion the way is 1/ε
    let level = target.beyond.sqrt();
    let ended = target.end(arc) * epsilon > RELAXED;
    let upright = direction(target.share, DoubleDouble::select(arc == LOW, level.neg(), level));
    let turn = DoubleDouble::select(ended, upright, regular);

    // a place computed in doubles may lie above the envelope by its last digits: it is on it
    let height = target.touching.height();
    let rise = target.touching.way.hi * target.touching.sin.hi;
    let highest = height + 2.0 * f64::EPSILON * (height.abs() + rise);
    let across = DoubleDouble::from(x.abs()).div(target.touching.way);
    let touching = direction(across, target.touching.sin);
    let turn = DoubleDouble::select(y >= height, touching, turn);
    let turn =
        DoubleDouble::select((x == 0.0) & (y == 0.0) & (arc == LOW), DoubleDouble::from(0.0), turn);
    let turn = DoubleDouble::select(x < 0.0, PI.sub(turn), turn).round();
    let inside = (y <= highest) & (y > f64::NEG_INFINITY) & is_drag(epsilon);
    // no angle turns further; a NaN does, and becomes the one that has the same bits everywhere
    select(inside & (turn.abs() <= core::f64::consts::TAU), turn, f64::NAN)
}

/// Launch angle of the lower, faster arc through the target (x, y), in radians.
///
/// x and y in V₀²/g, ε ≥ 0. NaN where y is above `envelope_height(x, ε)`; on the envelope both
/// arcs are one. Two or three units in the last place above it count as on it: places computed in
/// doubles lie there. In [−π/2, π/2] for x ≥ 0, in (π/2, 3π/2] for x < 0. The launch point itself
/// counts as straight ahead.
#[inline(always)]
pub fn aim_low(x: f64, y: f64, eps: f64) -> f64 {
    aim(LOW, x, y, eps)
}

/// Launch angle of the higher, slower arc through the target (x, y), in radians.
///
/// As [`aim_low`]. Both arcs are straight up for a target above the launcher, which the shot
/// meets on its way up and on its way down.
#[inline(always)]
pub fn aim_high(x: f64, y: f64, eps: f64) -> f64 {
    aim(HIGH, x, y, eps)
}

//! Where aiming begins: the touching point of the envelope, and a time near that of an arc.
//!
//! P² lies under its tangents, at the launch, at the touching point and at the end of all motion;
//! each in place of P² moves the two zeros of H outwards. At the touching point, d above the target,
//! e⁻ʷ = γU and P² = X² + U², so that H there is d (2U − d) and half its derivative γd: nothing
//! cancels in either. Before it P² lies under its parabola of there, too. For the high arc, where
//! the zeros are near, the approximation to H there gives them. For the low arc, which in strong
//! drag is nearly straight, the time of `e⁻ʷ = 1 − λ√(X² + (Y + γβ)²)` is nearer than that of β.

use super::super::real::{
    Logarithm, Mask, Number, Order, exponent_and_significand, greater, lesser, polynomial, select,
    sqrt,
};
use super::aim::{LOW, Model, Target};

// aim_log: minimax on [-0.293, 0.4143], degree 3,
// weighted error 0.000354: reference/coefficients.py aim_log
const AIM_LOG: [f64; 4] =
    [0.9996743312695143, -0.501591927514514, 0.3554190584986198, -0.23271145405795013];
// aim_way: 1.22 of the error that can be borne: reference/coefficients.py aim_way
const AIM_WAY_TOP: [f64; 4] = [0.9998747653, 1.104133531, -0.01452716116, 0.1165223651];
const AIM_WAY_BOTTOM: [f64; 4] = [1.0, 0.4311548783, 0.04313676296, 0.1048330231];

/// The shot that touches the envelope at the target's abscissa, at its touching point.
pub(super) struct Contact {
    pub t: Number,
    way: Number,
    fall: Number,
    /// `e⁻ʷ`
    rest: Number,
    /// its rise without gravity
    pub up: Number,
    /// how far the target is below
    below: Number,
    /// whether the target is so close under or over the envelope that both arcs begin here
    pub close: Mask,
    /// whether the target is not farther above than that
    pub reached: Mask,
}

impl Contact {
    #[inline(always)]
    pub fn of(target: &Target) -> Self {
        let Target { x, y, lambda, gamma, end, beyond, .. } = *target;
        // of the optimal shot sin α = (1 − λ²X²)/(λγX² + √(γ²X² + 1 − λ²X²)), P = 1/(λ + γ sin α)
        let across = gamma * x;
        let bottom = target.share.hi * across + sqrt(across * across + beyond);
        let inverse = 1.0 / (lambda * bottom + gamma * beyond);
        let (way, up) = (bottom * inverse, beyond * inverse);
        let (v, rest) = (lambda * way, gamma * up);

        let (k, m) = exponent_and_significand(rest);
        let near = k.equals(0.0);
        let f = select(near, -v, m - 1.0);
        let inverse = 1.0 / (2.0 + f);
        let s = f * inverse;
        let rho = Logarithm::artanh_excess(s * s);
        let artanh_ratio = 1.0 + s * s * rho;
        let w = -(k * core::f64::consts::LN_2 + 2.0 * (s * artanh_ratio));
        let psi = (1.0 - s * (1.0 - s) * rho) * inverse;
        let fall = select(near, way * way * psi, (w - v) * target.end_square.hi);

        let height = up - gamma * fall;
        let below = height - y;
        let noise = (8.0 * f64::EPSILON) * height.abs();
        let band = way * (lambda * rest + gamma * gamma * way) * 2e-9;
        let band = lesser(band, up * up * 0.0156) + noise * up;
        let above = below * up;
        Contact {
            t: w * end,
            way,
            fall,
            rest,
            up,
            below,
            close: above.is_below(band),
            reached: above.is_above(-band) & beyond.is_above(0.0),
        }
    }
}

/// A time near that of the arc.
pub(super) struct Start {
    pub t: Number,
    /// the rise when all motion has ended
    pub level: Number,
    /// λ²β of the arc that has ended
    pub end: Number,
}

#[inline(always)]
pub(super) fn start(sense: f64, target: &Target, contact: &Contact) -> Start {
    let Target { x, y, mu, lambda, gamma, end, rise, beyond, .. } = *target;
    let low = sense == LOW;
    let Contact { way, rest, up, below, .. } = *contact;

    // the zero where P² is as at the end of all motion
    let level = -sense * sqrt(greater(beyond, 0.0));
    let ended = level - rise;
    let ended_fall = ended * (end * mu);
    // H and half its derivative at the touching point, where e⁻ʷ = γ (Y + γβ) for the highest target
    // (a little more, so that rounding does not lead in from the other side)
    let twice = up * (2.0 * (1.0 + 8.0 * f64::EPSILON));
    let (excess, slope) = (below * (twice - below), gamma * below);
    let inside = excess.is_above(0.0);
    let fall = if low {
        // before it P² lies under its parabola of there, behind under its tangent
        let bend = gamma * gamma * way + select(inside, lambda * rest, 0.0);
        let first = way * slope;
        let root = sqrt(greater(first * first + way * bend * excess, 0.0));
        // less what the difference may have lost
        let touching = contact.fall * (1.0 - 8.0 * f64::EPSILON) - excess * way / (first + root);
        // with the tangent of the launch r²/2h, h = 1 − γY, and more
        let launch = (x * x + y * y) * (0.5 + 0.5 * gamma * y);
        greater(touching, greater(launch, ended_fall))
    } else {
        let touching = contact.fall + mu * (below + sqrt(greater(2.0 * up * below, 0.0)));
        let fall = lesser(greater(ended_fall, 0.0), touching);
        // by the approximation at the touching point, as far as three derivatives see
        let model = Model::new(target, way, rest, slope, excess, 1.0);
        let theta = model.excess / (sqrt(greater(model.discriminant(), 0.0)) - model.slope);
        let neighbouring = inside & theta.abs().is_below(1.25 * end);
        select(neighbouring, contact.fall + way * theta, fall)
    };

    let fall = greater(fall, 1e-290);
    let end = ended * lambda * mu;
    if !low {
        return Start { t: time_after(target, fall), level, end };
    }
    Start { t: greater(straight(target, fall), time_after(target, fall)), level, end }
}

/// A time near that of a fall: `λ²β = w − 1 + e⁻ʷ`.
#[inline(always)]
fn time_after(target: &Target, fall: Number) -> Number {
    let lambda = target.lambda;
    let root = sqrt(2.0 * fall);
    let q = lesser(lambda * root, 1e30);
    let way = root * polynomial(q, &AIM_WAY_TOP) / ((1.0 + q) * polynomial(q, &AIM_WAY_BOTTOM));
    lambda * fall + way
}

/// `w = −ln(1 − λR)` as a time, R being the distance of the target from where all shots have fallen to
/// by β. As β grows to that of the arc, R changes less than the way of a shot does, so that this is
/// nearer than the time of β itself; but where gravity decides, on steep ways down, it would be too great,
/// and is 0.
#[inline(always)]
fn straight(target: &Target, fall: Number) -> Number {
    let Target { x, y, lambda, gamma, end, beyond, .. } = *target;
    let up = y + gamma * fall;
    let share = lambda * sqrt(x * x + up * up);
    let rest_square = beyond - (lambda * up) * (lambda * up); // 1 − (λR)²
    let by_wall = rest_square * (0.5 + 0.125 * rest_square);
    let rest = select(rest_square.is_below(0.000244140625), by_wall, 1.0 - share);
    let (k, m) = exponent_and_significand(rest);
    let f = select(k.equals(0.0), -share, m - 1.0);
    let logarithm = k * core::f64::consts::LN_2 + f * polynomial(f, &AIM_LOG);
    select((gamma * up.abs() + 1e-300).is_below(4.0 * rest), -logarithm * end, 0.0)
}

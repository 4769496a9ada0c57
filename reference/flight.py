"""The whole flight, from the equation of motion alone.

In units of V₀²/g and V₀/g the projectile obeys v' = (0, -1) - ε v, r' = v, with r = 0 and v =
(cos α, sin α) at t = 0. `drift` and `fall` hold the solution in the textbooks' form, with
whatever bits its cancellation costs; the tests integrate the equation step by step beside it.
Everything else is a question put to that solution: when is y = 0 again, where is y as great as can
be, which angle leads through a point. Roots are proved by two signs.
"""

import math
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

from flint import arb, ctx

from reference.ball import OutsideDomainError, exact, exponent, precision

Value = arb | tuple[arb, arb]


def demand(condition: bool) -> None:
    if not condition:
        raise OutsideDomainError


def is_drag(eps: float) -> bool:
    return 0 <= eps < math.inf


def bits_lost(*sizes: arb) -> int:
    """Bits to add so that differences of second order in these sizes keep their digits."""
    return sum(2 * max(0, -exponent(size)) for size in sizes if size.mid() != 0)


# The equation of motion, solved --------------------------------------------------


def drift(t: arb, eps: arb) -> arb:
    """(1 - e^(-εt))/ε: how far a shot gets without gravity."""
    if eps == 0:
        return t
    w = eps * t
    return ((1 - (-w).exp()) if w > 1 else -(-w).expm1()) / eps


def fall(t: arb, eps: arb) -> arb:
    """(t - drift)/ε: how far gravity alone has pulled."""
    return (t - drift(t, eps)) / eps if eps != 0 else t * t / 2


def working_precision(t: float, eps: float) -> int:
    """What `fall` needs to be right to the precision in force."""
    w = arb(t) * arb(eps)
    return ctx.prec + 64 + (2 * max(0, -exponent(w)) if w != 0 else 0)


def flight_x(t: float, alpha: float, eps: float) -> arb:
    demand(0 <= t < math.inf and abs(alpha) <= 2 * math.pi and is_drag(eps))
    with precision(working_precision(t, eps)):
        return arb(alpha).cos() * drift(arb(t), arb(eps))


def flight_y(t: float, alpha: float, eps: float) -> Value:
    """And the greater of its two terms: what drag alone lets it rise, and what it falls."""
    demand(0 <= t < math.inf and abs(alpha) <= 2 * math.pi and is_drag(eps))
    with precision(working_precision(t, eps)):
        rise, drop = arb(alpha).sin() * drift(arb(t), arb(eps)), fall(arb(t), arb(eps))
        return rise - drop, abs(rise).max(drop)


# Roots --------------------------------------------------


def root(function: Callable[[arb], arb], low: arb, high: arb, bits: int) -> arb:
    """Where a function changes sign between two positive numbers, as a ball with proven signs.

    The exponent is bisected, then the number, then secants are taken that keep to the bracket.
    """
    rising = function(high) > 0

    def above(t: arb) -> bool:
        return (function(t) > 0) == rising

    bottom, top = exponent(low), exponent(high) + 1
    while top - bottom > 1:
        middle = (top + bottom) // 2
        if above(arb(2) ** middle):
            top = middle
        else:
            bottom = middle
    low, high = low.max(arb(2) ** bottom).mid(), high.min(arb(2) ** top).mid()
    for _ in range(8):
        middle = ((low + high) / 2).mid()
        low, high = (low, middle) if above(middle) else (middle, high)
    at_low, at_high = function(low).mid(), function(high).mid()
    before, f_before, t, f = low, at_low, high, at_high
    for _ in range(4000):
        if f == f_before:
            break
        step = (f * (t - before) / (f - f_before)).mid()
        before, f_before = t, f
        t = (t - step).mid()
        if not (low <= t and t <= high):
            t = ((low + high) / 2).mid()
        f = function(t).mid()
        low, high = (low, t) if (f > 0) == rising else (t, high)
        if step == 0 or exponent(step) < exponent(t) - bits - 4:
            break
    width = abs(t) * arb(2) ** -bits
    left, right = (t - width).mid(), (t + width).mid()
    at_left, at_right = function(left), function(right)
    if (at_left < 0 and at_right > 0) or (at_left > 0 and at_right < 0):
        return left.union(right)
    return arb.nan()  # not proven at this precision


# Landing --------------------------------------------------


def landing_time(alpha: float, eps: float) -> arb:
    """The T > 0 with y(T) = 0, by εT."""
    if eps == 0:
        return 2 * arb(alpha).sin()
    lost = max(0, -exponent(arb(eps) * arb(alpha).sin()))
    bits = ctx.prec + 16
    with precision(ctx.prec + 4 * lost + 128):
        u = arb(eps) * arb(alpha).sin()

        def height(tau: arb) -> arb:
            return -(1 + u) * (-tau).expm1() - tau

        return root(height, u, 2 * u + 1 / (1 / u + 1), bits) / arb(eps)


def flight_time(alpha: float, eps: float) -> arb:
    demand(0 <= alpha <= math.pi and is_drag(eps))
    return landing_time(alpha, eps) if alpha else arb(0)


def flight_range(alpha: float, eps: float) -> arb:
    demand(0 <= alpha <= math.pi and is_drag(eps))
    if alpha == 0:
        return arb(0)
    with precision(ctx.prec + 32):
        time = landing_time(alpha, eps)
        with precision(ctx.prec + 64 + bits_lost(time * arb(eps))):
            return arb(alpha).cos() * drift(time, arb(eps))


# The trajectory as a curve --------------------------------------------------


def fallen(way: arb, eps: arb) -> arb:
    """What has been fallen when the way `drift(t)` is `way`: t = -ln(1 - ε way)/ε."""
    return (-(1 - eps * way).log() / eps - way) / eps if eps != 0 else way * way / 2


def trajectory_height(x: float, alpha: float, eps: float) -> Value:
    demand(abs(x) < math.inf and abs(alpha) <= 2 * math.pi and is_drag(eps))
    way = arb(x) / arb(alpha).cos()
    demand(not way < 0)
    with precision(ctx.prec + 64 + bits_lost(way * arb(eps))):
        way, e = arb(x) / arb(alpha).cos(), arb(eps)
        demand(not e * way >= 1)
        rise, drop = arb(alpha).sin() * way, fallen(way, e)
        # x times the slope of the drop: next to the wall the last digit of x moves it that much
        steepest = way * way / (1 - e * way)
        return rise - drop, abs(rise).max(steepest)


# The best angle and the envelope --------------------------------------------------


def optimal_angle(eps: float) -> arb:
    """The range as a function of w = εT, at its greatest: that w lands has sin α = (w/(1 - e^-w) -
    1)/ε, and the range is cos α (1 - e^-w)/ε.
    """
    demand(is_drag(eps))
    if eps == 0:
        return arb.pi() / 4
    lost = abs(exponent(arb(eps)))
    bits = ctx.prec + 2 * lost + 16
    with precision(ctx.prec + 8 * lost + 128):
        e = arb(eps)

        def sine(w: arb) -> tuple[arb, arb]:
            """And its slope."""
            gone = -(-w).expm1()
            return (w / gone - 1) / e, (gone - w * (1 - gone)) / gone**2 / e

        def slope(w: arb) -> arb:
            s, s1 = sine(w)
            gone = -(-w).expm1()
            return (1 - s * s) * (1 - gone) - s * s1 * gone

        highest = e * 2  # cos α = 0 is before that
        w = root(slope, highest * arb(2) ** -1100, highest, bits)
        return sine(w)[0].asin()


def touching(x: float, eps: float) -> tuple[arb, arb]:
    """Rise and fall of the shot that is highest at x, at a precision the caller has raised.

    It has gone the way p = √(x² + z²) by then, has risen by z and fallen by `fallen(p)`; the
    height z - fallen has no slope where z = 1 - εp.
    """
    square, e = arb(x) ** 2, arb(eps)

    def excess(z: arb) -> arb:
        return z + e * (square + z * z).sqrt() - 1

    rise = root(excess, arb(2) ** -3000, arb(2), ctx.prec // 2)
    return rise, fallen((square + rise * rise).sqrt(), e)


def envelope_bits(x: float, eps: float) -> int:
    size = bits_lost(arb(x)) + bits_lost(arb(eps))
    return 2 * (ctx.prec + 64 + size)


def envelope_height(x: float, eps: float) -> Value | float:
    demand(abs(x) < math.inf and is_drag(eps))
    with precision(envelope_bits(x, eps)):
        rest = 1 - abs(arb(x)) * arb(eps)
        demand(not rest < 0)
        if rest == 0:
            return -math.inf
        rise, drop = touching(x, eps)
        return rise - drop, rise.max(drop)


# Aiming --------------------------------------------------


def direction(x: float, up: arb) -> arb:
    """The launch angle of a direction, measured on through the upright for backward ones."""
    turn = arb.atan2(up, abs(arb(x)))
    return arb.pi() - turn if x < 0 else turn


def sensitivity(x: float, y: float, eps: float, t: arb, up: arb) -> arb:
    """The greatest change of the angle for a relative change of x, y or ε by one, but no more than
    by what the last digits of x, y and ε do at the envelope, where the angle goes with a root.
    """
    way, drop = drift(t, arb(eps)), fall(t, arb(eps))
    k, s, c = (-arb(eps) * t).exp(), up / way, abs(arb(x)) / way
    margin = way * abs(k - s * way).max(k * arb(2) ** -26)
    by_x, by_y = abs(arb(x)) * abs(s * k - way), abs(arb(y)) * c * k
    return by_x.max(by_y).max(abs(way * way - 2 * drop * k) * c) / margin


class Prospect(NamedTuple):
    """What both arcs to a target share: a time between those of the two, and the precision at
    which it is known; or the one arc where there is one.
    """

    bits: int
    between: arb
    only: tuple[arb, arb] | None = None


def inside(t: arb, x: arb, y: arb, eps: arb) -> arb:
    """Positive where (x, y) is inside the circle of all shots at time t: it has the radius
    drift(t), and its centre has fallen by fall(t).
    """
    way, up = drift(t, eps), y + fall(t, eps)
    return way * way - x * x - up * up


def between(y: arb, eps: arb, bits: int) -> arb:
    """A time between those of the two arcs: a target that high is deepest inside when e^(-εt) is
    as great as what is left of its height above the centre.
    """
    return root(
        lambda t: (-eps * t).exp() - fall(t, eps) - y, arb(2) ** -2000, arb(2) ** 2000, bits
    ).mid()


@lru_cache(maxsize=4)
def prospect(x: float, y: float, eps: float, bits: int) -> Prospect:
    lost = bits_lost(arb(eps) * abs(arb(x)).max(abs(arb(y))).min(arb(1)))
    if y < 1:  # quickly, for all targets but those next to the envelope
        with precision(128 + lost):
            t = between(arb(y), arb(eps), 48)
            if inside(t, arb(x), arb(y), arb(eps)) > drift(t, arb(eps)) ** 2 * arb(2) ** -40:
                return Prospect(2 * (bits + 64) + lost, t)
    top = exact(envelope_height, x, eps)
    height = 0.0 if abs(top.hi) <= 1e-9 * top.ulp else top.hi
    demand(not math.isnan(height) and height > -math.inf)
    with precision(2 * (bits + 64) + lost):
        side, level, e = arb(x), arb(y), arb(eps)
        rise, _ = touching(x, eps)
        # by the crate's rule a target above the envelope by its last digits is on it
        demand(not level - height > (rise + abs(height)) * arb(2) ** -51)
        way = (side * side + rise * rise).sqrt()
        touched = -(1 - e * way).log() / e if eps else way
        if y >= height:
            return Prospect(ctx.prec, touched, (touched, rise))
        t = between(level, e, bits + 64)
        above = not inside(t, side, level, e) > 0
        return Prospect(ctx.prec, t, (t, level + fall(t, e)) if above else None)


def aim(x: float, y: float, eps: float, high: bool) -> Value:
    """The earlier or the later of the two times at which the circle passes through the target."""
    demand(abs(x) < math.inf and -math.inf < y < math.inf and is_drag(eps))
    bits = ctx.prec + 64
    common = prospect(x, y, eps, ctx.prec)
    if x == 0 and y <= 0 and not high:
        return -arb.pi() / 2 if y else arb(0)
    with precision(common.bits):
        if common.only is not None:
            t, up = common.only
            return direction(x, up), sensitivity(x, y, eps, t, up).max(1)
        side, level, e = arb(x), arb(y), arb(eps)
        ends = (common.between, arb(2) ** 2000) if high else (arb(2) ** -2000, common.between)
        t = root(lambda t: inside(t, side, level, e), *ends, bits)
        up = level + fall(t, e)
        return direction(x, up), sensitivity(x, y, eps, t, up)


def aim_low(x: float, y: float, eps: float) -> Value:
    return aim(x, y, eps, high=False)


def aim_high(x: float, y: float, eps: float) -> Value:
    return aim(x, y, eps, high=True)


FLIGHT = "v' = (0, -1) - epsilon v from speed 1 at the launch angle alpha"
OF_TERM = "ulp of the larger of it and the greater of"
OF_INPUT = "ulp of the larger of it and what a relative change of an argument by one makes of it"
DEFINITIONS = {
    "flight_time": f"the time T > 0 at which the height of {FLIGHT} is 0 again",
    "flight_range": f"the abscissa of {FLIGHT} where its height is 0 again",
    "flight_x": f"the abscissa at time t of {FLIGHT}",
    "flight_y": f"the height at time t of {FLIGHT}; {OF_TERM} its rise without gravity "
    "and its fall",
    "trajectory_height": f"the height at the abscissa x of {FLIGHT}; {OF_TERM} its rise without "
    "gravity and what a relative change of x makes of its fall",
    "optimal_angle": f"the launch angle of the greatest range of {FLIGHT}",
    "envelope_height": "the greatest height at the abscissa x, over all launch angles, of "
    f"{FLIGHT}; {OF_TERM} its rise without gravity and its fall",
    "aim_low": f"the launch angle of the earlier of the two arcs of {FLIGHT} through (x, y); "
    f"{OF_INPUT}",
    "aim_high": f"the launch angle of the later of the two arcs of {FLIGHT} through (x, y); "
    f"{OF_INPUT}",
}

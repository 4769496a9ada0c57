"""The apex and its locus, by two roads.

`slow` holds every quantity by its definition: the equation of motion is integrated and the zero of
ẏ found (flow.py), α(θ) is the shot whose apex is seen at θ, found by Newton's method kept inside a
shrinking bracket, and derivatives follow the shot through the integration. `fast` replaces the
integration by the paper's solution of it, equations (7), (8) and (10) exactly as printed -
logarithms and all, cancellation made good by as many bits as it costs - which is what runs of 10⁵
inputs can afford. Tests hold one against the other. Neither uses the crate's φ, G or any of its
rearrangements.
"""

import math
from collections.abc import Callable
from functools import lru_cache

from flint import arb, arb_series, ctx

from reference import flow, geometry
from reference.ball import OutsideDomainError, exponent, precision
from reference.geometry import TERMS, Locus


def inside(angle: float, eps: float) -> None:
    """Angles beyond [0, π], a negative ε or an infinite one: no value."""
    if not (0 <= angle <= math.pi and 0 <= eps < math.inf):
        raise OutsideDomainError


# The fast road --------------------------------------------------


def small_bits(size: arb) -> int:
    """How many bits a difference like u - ln(1+u) loses at u of this size, once."""
    return 0 if size.mid() == 0 else max(0, -exponent(size))


def by_paper(alpha: arb, eps: arb) -> Locus:
    """Equations (7) and (8); at ε = 0 the parabola."""
    ctx.cap = TERMS
    angle = arb_series([alpha, 1], prec=TERMS)
    s, c = angle.sin(), angle.cos()
    if eps == 0:
        return Locus(alpha, s, s * c, s * s / 2)
    u = eps * s
    logarithm = (1 + u).log()
    return Locus(alpha, logarithm / eps, s * c / (1 + u), (u - logarithm) / eps**2)


def tan_elevation(t: arb, eps: arb) -> arb:
    """Equation (10), t being tan α."""
    if eps == 0:
        return t / 2
    s = t / (1 + t * t).sqrt()
    u = eps * s
    return (u - (1 + u).log()) * (1 + u) * t / (u * u)


@lru_cache(maxsize=4)
def fast_apex(alpha: float, eps: float, bits: int) -> Locus:
    inside(alpha, eps)
    with precision(bits):
        lost = small_bits(arb(eps) * arb(alpha).sin())
    with precision(bits + 2 * lost):
        return by_paper(arb(alpha), arb(eps))


@lru_cache(maxsize=4)
def fast_locus(theta: float, eps: float, bits: int) -> Locus:
    inside(theta, eps)
    if theta == 0:
        with precision(bits):
            return by_paper(arb(0), arb(eps))
    with precision(bits):
        lost = small_bits(arb(eps) * arb(theta).sin())
    mirrored = theta > math.pi / 2
    with precision(bits + 4 * lost + 128):
        wanted = (arb.pi() - arb(theta) if mirrored else arb(theta)).tan()
        t = proven_root(
            lambda t: tan_elevation(t, arb(eps)) - wanted, guess(wanted, eps), bits + 2 * lost
        )
        alpha = arb.pi() - t.atan() if mirrored else t.atan()
        return by_paper(alpha, arb(eps))


def guess(tan_theta: arb, eps: float) -> arb:
    """tan α to nearly double precision: t ← t T / tan θ(t), which closes in for every ε."""
    ratio = 2.0  # tan α / tan θ; the tangent itself may be subnormal
    tangent = float(tan_theta.mid())
    for _ in range(60):
        t = ratio * tangent
        u = eps * (t / math.hypot(1.0, t))
        half = 0.5 + u / 6 - u * u / 12 if u < 1e-3 else (u - math.log1p(u)) / u * (1 + 1 / u)
        if abs(ratio * half - 1) < 1e-15:
            break
        ratio /= ratio * half
    return tan_theta.mid() * ratio


def proven_root(function: Callable[[arb], arb], start: arb, bits: int) -> arb:
    """The root of a rising function by secants, as a ball between two proven signs; else NaN."""
    width = arb(2) ** -bits
    before, t = start * (1 + arb(2) ** -40), start
    f_before, f = function(before).mid(), function(t).mid()
    for _ in range(60):
        if f == f_before:
            break
        step = (f * (t - before) / (f - f_before)).mid()
        before, f_before = t, f
        t = (t - step).mid()
        if step == 0 or exponent(step) < exponent(t) - bits - 4:
            break
        f = function(t).mid()
    low, high = (t * (1 - width)).mid(), (t * (1 + width)).mid()
    if function(low) < 0 and function(high) > 0:
        return low.union(high)
    return arb.nan()


# The slow road --------------------------------------------------


@lru_cache(maxsize=16)
def slow_apex(alpha: float, eps: float, bits: int) -> Locus:
    inside(alpha, eps)
    return slow_at(arb(alpha), eps, bits)


def slow_at(alpha: arb, eps: float, bits: int) -> Locus:
    return Locus(alpha, *flow.apex(alpha, arb(eps), bits))


@lru_cache(maxsize=16)
def slow_locus(theta: float, eps: float, bits: int) -> Locus:
    """Newton's method for "the apex is seen at θ", between bounds that every step tightens."""
    inside(theta, eps)
    if theta == 0:
        return slow_at(arb(0), eps, bits)
    with precision(bits + 96):
        low, high = arb(0), arb.pi()
        alpha = arb(theta)
        for _ in range(200):
            locus = slow_at(alpha, eps, bits)
            error = geometry.elevation(locus) - arb(theta)
            low, high = (alpha, high) if error < 0 else (low, alpha)
            step = (error / geometry.elevation_slope(locus)[0]).mid()
            if step == 0 or exponent(step) < exponent(alpha) - bits + 40:
                return locus
            alpha = (alpha - step).mid()
            if not (low < alpha and alpha < high):
                alpha = ((low + high) / 2).mid()
    raise ArithmeticError(f"no launch angle found for {theta}, {eps}")


# Quantities --------------------------------------------------

Road = Callable[[float, float, int], Locus]

BY_LAUNCH_ANGLE: dict[str, Callable[[Locus], arb]] = {
    "apex_x": lambda locus: locus.x[0],
    "apex_y": lambda locus: locus.y[0],
    "apex_time": lambda locus: locus.time[0],
    "apex_distance": geometry.distance,
    "apex_elevation": geometry.elevation,
    "apex_curvature": geometry.curvature,
}
BY_ELEVATION: dict[str, Callable[[Locus], arb]] = {
    "locus_launch_angle": lambda locus: locus.alpha,
    "locus_launch_angle_d1": geometry.launch_angle_d1,
    "locus_launch_angle_d2": geometry.launch_angle_d2,
    "locus_radius": geometry.distance,
    "locus_curvature": geometry.curvature,
}


FLIGHT = "v' = (0, -1) - epsilon v from speed 1 at the launch angle"
DEFINITIONS = {
    "apex_x": f"x where the vertical velocity of {FLIGHT} is zero",
    "apex_y": f"y where the vertical velocity of {FLIGHT} is zero",
    "apex_time": f"the time at which the vertical velocity of {FLIGHT} is zero",
    "apex_distance": f"the distance from the origin to the apex of {FLIGHT}",
    "apex_elevation": f"the polar angle of the apex of {FLIGHT}",
    "apex_curvature": "the curvature (x' y'' - y' x'')/(x'^2 + y'^2)^(3/2) of the locus of the "
    f"apexes of {FLIGHT}",
    "locus_launch_angle": f"the launch angle whose apex, by {FLIGHT}, has the polar angle theta",
    "locus_launch_angle_d1": "the derivative by theta of the launch angle whose apex, by "
    f"{FLIGHT}, has the polar angle theta",
    "locus_launch_angle_d2": "the second derivative by theta of the launch angle whose apex, by "
    f"{FLIGHT}, has the polar angle theta",
    "locus_radius": "the distance from the origin to that apex whose polar angle is theta, of "
    f"{FLIGHT}",
    "locus_curvature": f"the curvature of the locus of the apexes of {FLIGHT} at polar angle theta",
}


def along(road: Road, quantity: Callable[[Locus], arb]) -> Callable[[float, float], arb]:
    """The quantity as a function of the angle and ε at Arb's current precision."""

    def value(angle: float, eps: float) -> arb:
        bits = ctx.prec
        locus = road(angle, eps, bits)
        # The roads work with more bits than asked; read them with as many.
        with precision(bits + 4 * small_bits(arb(eps) * arb(angle).sin()) + 128):
            return quantity(locus)

    return value

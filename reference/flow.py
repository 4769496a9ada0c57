"""The slow road: the apex by integrating the equation of motion, with nothing solved on paper.

In units of V₀²/g and V₀/g the projectile obeys v' = (0, -1) - ε v, r' = v, with r = 0 and v = (cos
α, sin α) at t = 0. Each step of time expands r and v in a Taylor polynomial whose coefficients
follow from the equation by recurrence; steps are taken until the vertical velocity is negative, and
its zero in the last step is found by Newton's method. All numbers are power series in a small
change of α, so that the derivatives with respect to α come with the values.

No sum here cancels, so a precision a little above the wanted one is enough; `apex` compares two
precisions and insists that they agree.
"""

import math
from typing import NamedTuple

from flint import arb, arb_series, ctx

from reference.ball import precision
from reference.geometry import TERMS


def degree_for(bits: int) -> int:
    """The first k with 2^k / k! < 2^-bits: where an expansion over two time scales may be cut."""
    return next(k for k in range(10, 10 * bits) if math.lgamma(k + 1) / math.log(2) - k > bits)


class Apex(NamedTuple):
    time: arb_series
    x: arb_series
    y: arb_series


class State(NamedTuple):
    x: arb_series
    y: arb_series
    vx: arb_series
    vy: arb_series


def constant(value: arb) -> arb_series:
    return arb_series([value], prec=TERMS)


def expansion(state: State, eps: arb, degree: int) -> list[State]:
    """Taylor coefficients in time, from v' = (0, -1) - ε v and r' = v."""
    terms = [state]
    for k in range(degree):
        last = terms[-1]
        gravity = constant(arb(1 if k == 0 else 0))
        terms.append(
            State(
                last.vx / (k + 1),
                last.vy / (k + 1),
                -eps * last.vx / (k + 1),
                (-eps * last.vy - gravity) / (k + 1),
            )
        )
    return terms


def polynomial(coefficients: list[arb_series], t: arb_series) -> arb_series:
    total = constant(arb(0))
    for coefficient in reversed(coefficients):
        total = total * t + coefficient
    return total


def moved(terms: list[State], t: arb_series) -> State:
    return State(*(polynomial([term[i] for term in terms], t) for i in range(4)))


def integrate(alpha: arb, eps: arb, bits: int) -> Apex:
    """The apex to about `bits` bits."""
    with precision(bits + 64):
        ctx.cap = TERMS
        angle = arb_series([alpha, 1], prec=TERMS)
        state = State(constant(arb(0)), constant(arb(0)), angle.cos(), angle.sin())
        step = (2 / max(arb(1), eps)).mid()  # twice the time scale, at most
        degree = degree_for(bits + 64)
        elapsed = constant(arb(0))
        while True:
            terms = expansion(state, eps, degree)
            ahead = moved(terms, constant(step))
            if ahead.vy[0] < 0:
                break
            state = State(*(narrowed(part) for part in ahead))
            elapsed = elapsed + step
        t = vertical_rest(terms, bits)
        at = moved(terms, t)
        return Apex(elapsed + t, at.x, at.y)


def vertical_rest(terms: list[State], bits: int) -> arb_series:
    """The time within a step at which ẏ = 0: Newton from the left, as ẏ is convex and falls."""
    heights = [term.vy for term in terms]
    slopes = [k * heights[k] for k in range(1, len(heights))]
    t = constant(arb(0))
    previous = None
    for _ in range(bits + 64):
        change = polynomial(heights, t) / polynomial(slopes, t)
        t = narrowed(t - change)
        size = abs(change[0]).upper()
        if size == 0 or (previous is not None and size < t[0] * arb(2) ** -(bits + 8)):
            break
        previous = size
    for _ in range(3):  # each further step doubles the number of right terms in the change of α
        t = narrowed(t - polynomial(heights, t) / polynomial(slopes, t))
    return t


def narrowed(series: arb_series) -> arb_series:
    """Midpoints only: agreement of two precisions is the proof, not the widths on the way."""
    return arb_series(
        [c.mid() for c in series.coeffs()] + [arb(0)] * (TERMS - len(series.coeffs())), prec=TERMS
    )


def apex(alpha: arb, eps: arb, bits: int = 160) -> Apex:
    """The apex as series in the change of α, agreeing with the same at a higher precision."""
    rough = integrate(alpha, eps, bits)
    fine = integrate(alpha, eps, bits + 96)
    with precision(bits + 96):
        for name, first, second in zip(Apex._fields, rough, fine, strict=True):
            largest = max(abs(second[k]) for k in range(TERMS))
            if not all(
                abs(first[k] - second[k]) <= largest * arb(2) ** -(bits - 40) for k in range(TERMS)
            ):
                raise ArithmeticError(f"{name} at {alpha}, {eps} does not settle at {bits} bits")
    return fine

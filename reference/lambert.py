"""The real branches of Lambert W, from w e^w = z alone.

Everything is one equation in v = 1 + w, on one side of the branch point v = 0:

    (v - 1) e^(v-1) + 1/e = d,    d = z + 1/e >= 0,

whose left side falls for v < 0 and rises for v > 0. A root is guessed by Newton's method and then
proved: the left side minus d is shown to have opposite signs at the two ends of a narrow ball
(`bisected` in the tests finds the same roots by bisection alone). Next to the branch point d is
formed from an exact z and enough bits of 1/e, so nothing is lost there.

The double nearest -1/e lies below -1/e; by the crate's rule it counts as the branch point.
"""

import math

from flint import arb, ctx

from reference.ball import OutsideDomainError, exponent

#: The double nearest -1/e.
BRANCH_POINT = -0.36787944117144233
PRINCIPAL, LOWER = 1, -1


def excess(v: arb) -> arb:
    """(v-1) e^(v-1) + 1/e, which has the sign and size of v²/2e."""
    return (v - 1) * (v - 1).exp() + arb(-1).exp()


def guess(d: arb, side: int) -> arb:
    """A start from which Newton's method converges without leaving its side."""
    size = exponent(d)
    if size < -6:  # the first term at the branch point
        return side * (2 * arb(1).exp() * d).mid().sqrt()
    if side == PRINCIPAL:
        z = d - arb(-1).exp()
        if size > 4:
            log = math.log(2) * size
            return arb(1 + log - math.log(log))
        return arb(max(1 + 0.7 * math.log1p(float(z.mid())), 0.05))
    z = arb(-1).exp() - d  # -z, in (0, 1/e)
    log = float(z.log().mid())
    return arb(1 + log - math.log(-log) if log < -2 else -math.sqrt(2 * (-1 - log)))


def offset_root(d: arb, side: int) -> arb:
    """The v with excess(v) = d on one side of 0, as a proven ball; NaN asks for more precision."""
    if not d > 0 or (side == LOWER and not d < arb(-1).exp()):
        return arb.nan()
    v = guess(d, side)
    target = ctx.prec // 2
    for _ in range(200):
        v = v.mid()
        slope = v * (v - 1).exp()  # d/dv of excess
        step = ((excess(v) - d) / slope).mid()
        if side * (v - step) <= 0:  # thrown over the branch point: halve instead
            v = v / 2
            continue
        v = (v - step).mid()
        if step == 0 or exponent(step) < exponent(v) - target:
            break
    width = abs(v) * arb(2) ** -(ctx.prec // 2 + 8)
    inner, outer = (v - side * width).mid(), (v + side * width).mid()
    if excess(inner) - d < 0 and excess(outer) - d > 0:
        return inner.union(outer)
    return arb.nan()  # not proven at this precision


def lambertw(z: float, side: int) -> arb | float:
    if z == BRANCH_POINT:
        return arb(-1)
    d = arb(z) + arb(-1).exp()
    if z < BRANCH_POINT:
        raise OutsideDomainError
    return offset_root(d, side) - 1


def lambertw0(z: float) -> arb | float:
    if z == 0:
        return arb(0)
    if z == math.inf:
        return math.inf
    return lambertw(z, PRINCIPAL)


def lambertwm1(z: float) -> arb | float:
    if z == 0:
        return -math.inf
    if z > 0:
        raise OutsideDomainError
    return lambertw(z, LOWER)


def lambertw0_offset(d: float) -> arb | float:
    if d < 0:
        raise OutsideDomainError
    if d == 0:
        return arb(0)
    if d == math.inf:
        return math.inf
    return offset_root(arb(d), PRINCIPAL)


def lambertwm1_offset(d: float) -> arb | float:
    """1 + W₋₁(-1/e + d), for d up to 1/e."""
    if d < 0 or d > -BRANCH_POINT:
        raise OutsideDomainError
    if d == 0:
        return arb(0)
    if d == -BRANCH_POINT:  # the double nearest 1/e counts as 1/e, where the branch goes to -∞
        return -math.inf
    return offset_root(arb(d), LOWER)


def tree(z: float) -> arb | float:
    """T(z) = -W₀(-z)."""
    value = lambertw0(-z)
    return -value

"""Functions of one real number, straight from Arb's own; log1pmx is ln(1+x) - x."""

import math
from collections.abc import Callable

from flint import arb

from reference.ball import OutsideDomainError


def exp(x: float) -> arb | float:
    if (
        math.isinf(x) or abs(x) > 1e4
    ):  # beyond every double, and soon beyond what Arb's exponents hold
        return math.inf if x > 0 else arb(0)
    return arb(x).exp()


def exp_m1(x: float) -> arb | float:
    if math.isinf(x) or abs(x) > 1e4:
        return math.inf if x > 0 else arb(-1)
    return arb(x).expm1()


def ln(x: float) -> arb | float:
    if x < 0:
        raise OutsideDomainError
    if x == 0 or x == math.inf:
        return -math.inf if x == 0 else math.inf
    return arb(x).log()


def ln_1p(x: float) -> arb | float:
    if x < -1:
        raise OutsideDomainError
    if x == -1 or x == math.inf:
        return -math.inf if x == -1 else math.inf
    return arb(x).log1p()


def log1pmx(x: float) -> arb | float:
    if x < -1:
        raise OutsideDomainError
    if x == -1 or x == math.inf:
        return -math.inf
    return arb(x).log1p() - arb(x)


def periodic(function: Callable[[arb], arb]) -> Callable[[float], arb]:
    """sin, cos and tan on [-2π, 2π], the ends rounded to doubles; NaN outside."""

    def oracle(x: float) -> arb:
        if abs(x) > 2 * math.pi:
            raise OutsideDomainError
        return function(arb(x))

    return oracle


sin = periodic(arb.sin)
cos = periodic(arb.cos)
tan = periodic(arb.tan)


def atan(x: float) -> arb:
    if math.isinf(x):
        return arb.pi() * math.copysign(0.5, x)
    return arb(x).atan()


def atan2(y: float, x: float) -> arb:
    """The angle of the point (x, y); infinities as limits along the axes and diagonals."""
    if math.isinf(x) or math.isinf(y):
        x, y = (math.copysign(1.0 if math.isinf(v) else 0.0, v) for v in (x, y))
    if y == 0:
        return arb.pi() * math.copysign(1.0, y) if math.copysign(1.0, x) < 0 else arb(0)
    return arb.atan2(arb(y), arb(x))

"""Arb balls to doubles: raise the precision until a ball is narrow, then round it.

An exact value is kept as a `Rounded`: the nearest double `hi`, what is left of it `rest`, and the
`ulp` in which errors are counted, so that the error of a computed double is `abs((got - hi) / ulp -
rest)`, good to about 1e-9 ulp. (A second double for the remainder would be lost to underflow next
to 5e-324; a remainder counted in ulp is not.)
"""

import math
from collections.abc import Callable
from contextlib import contextmanager
from typing import NamedTuple

import numpy as np
from flint import arb, ctx

#: The width demanded of a ball before it is rounded, in bits relative to the value (or to the scale
#: of the error).
ACCURATE_BITS = 90
MOST_BITS = 1 << 17


class Rounded(NamedTuple):
    hi: float
    rest: float
    ulp: float


NAN = Rounded(math.nan, 0.0, 1.0)


class OutsideDomainError(Exception):
    """The exact function has no value there: the double wanted is NaN."""


@contextmanager
def precision(bits: int):
    saved = ctx.prec
    ctx.prec = bits
    try:
        yield
    finally:
        ctx.prec = saved


def exponent(ball: arb) -> int:
    """floor(log2 |midpoint|)."""
    mantissa, power = ball.mid().man_exp()
    return int(power) + int(mantissa).bit_length() - 1


def ulp_power(top: int) -> int:
    """The power of two that is one ulp in the binade [2^top, 2^(top+1))."""
    return max(top - 52, -1074)


def rounded(ball: arb, scale: arb | None = None) -> Rounded:
    """The nearest double to a narrow ball; the ulp is of the larger of the value and `scale`."""
    mantissa, power = (int(part) for part in ball.mid().man_exp())
    if mantissa == 0:
        top = -1074
        own = -1074
        whole, part = 0, 0.0
    else:
        top = power + mantissa.bit_length() - 1
        own = ulp_power(top)
        whole, part = split(mantissa, power - own)
        if (
            abs(whole) == 1 << 53 and abs(part) < 1e-9
        ):  # below a power of two by nothing that matters: the ulp of that power
            top, own, whole, part = top + 1, own + 1, whole // 2, part / 2
    unit = own
    if scale is not None and scale.mid() != 0:
        unit = max(own, ulp_power(exponent(scale)))
    if top > 1023 or (top == 1023 and abs(whole) >= 1 << 53):
        return Rounded(math.inf if mantissa > 0 else -math.inf, 0.0, 2.0**971)
    return Rounded(math.ldexp(whole, own), math.ldexp(part, own - unit), math.ldexp(1.0, unit))


def split(mantissa: int, shift: int) -> tuple[int, float]:
    """mantissa * 2^shift as the nearest integer (ties to even) and the remainder in [-1/2, 1/2]."""
    if shift >= 0:
        return mantissa << shift, 0.0
    guard = 60
    if -shift > guard:  # keep 60 bits below the point, enough for a remainder in double precision
        mantissa >>= -shift - guard
        shift = -guard
    whole = mantissa >> -shift
    below = mantissa - (whole << -shift)
    half = 1 << (-shift - 1)
    if below > half or (below == half and whole & 1):
        whole += 1
        below -= half << 1
    return whole, math.ldexp(below, shift)


def narrow(ball: arb, scale: arb | None = None) -> bool:
    if not ball.is_finite():
        return False
    if ball.is_exact():
        return True
    if ball.rel_accuracy_bits() >= ACCURATE_BITS:
        return True
    if scale is None or not scale.is_finite() or scale.mid() == 0:
        return False
    return exponent(ball.rad()) < exponent(scale) - ACCURATE_BITS


def exact(
    function: Callable[..., arb | tuple[arb, arb]], *arguments: float, bits: int = 192
) -> Rounded:
    """Round `function(*arguments)`, doubling the working precision until its ball is narrow.

    The function may answer a pair: the value, and the scale whose ulp the error is counted in.
    """
    if any(math.isnan(a) for a in arguments):
        return NAN
    while bits <= MOST_BITS:
        with precision(bits):
            try:
                answer = function(*arguments)
            except OutsideDomainError:
                return NAN
            if isinstance(answer, float):  # an infinite limit
                return Rounded(answer, 0.0, 1.0)
            value, scale = answer if isinstance(answer, tuple) else (answer, None)
            if narrow(value, scale):
                return rounded(value, scale)
        bits *= 2
    raise ArithmeticError(f"{function.__name__}{arguments} is not narrow at {MOST_BITS} bits")


def settled(
    function: Callable[..., arb | tuple[arb, arb]], *arguments: float, bits: int = 192
) -> Rounded:
    """As `exact`, for balls that are not proven: precision doubles until two answers agree."""
    before = exact(function, *arguments, bits=bits)
    while bits <= MOST_BITS:
        bits *= 2
        value = exact(function, *arguments, bits=bits)
        if agree(before, value):
            return value
        before = value
    raise ArithmeticError(f"{function.__name__}{arguments} does not settle at {MOST_BITS} bits")


def agree(a: Rounded, b: Rounded) -> bool:
    """The same exact value in the same ulp, to 1e-9 of it."""
    if math.isnan(a.hi) or math.isinf(a.hi):
        return a.hi == b.hi or (math.isnan(a.hi) and math.isnan(b.hi))
    return a.ulp == b.ulp and abs((a.hi - b.hi) / a.ulp + a.rest - b.rest) < 1e-9


def ulp_errors(got: np.ndarray, hi: np.ndarray, rest: np.ndarray, ulp: np.ndarray) -> np.ndarray:
    """Errors in ulp; infinite where one value is NaN or infinite and the other is not the same."""
    with np.errstate(all="ignore"):
        errors = np.abs((got - hi) / ulp - rest)
    special = ~np.isfinite(got) | ~np.isfinite(hi)
    same = (got == hi) | (np.isnan(got) & np.isnan(hi))
    return np.where(special, np.where(same, 0.0, np.inf), errors)

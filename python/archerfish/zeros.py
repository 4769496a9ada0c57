"""Zeros and least values of functions of one positive variable, a whole array at a time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
Function = Callable[[FloatArray], FloatArray]

_GOLDEN = (np.sqrt(5.0) - 1.0) / 2.0


def zero_between(function: Function, low: npt.ArrayLike, high: npt.ArrayLike) -> FloatArray:
    """Where `function`, positive at `low` and negative at `high`, changes sign: to the last bit.

    `low` and `high` are positive, of one shape, and `function` takes and returns that shape.

    Positive doubles are ordered as the integers with the same bits, so halving the interval of
    integers ends on two neighbouring doubles after at most 62 steps, whatever the function's
    slope or scale: no tolerance, no starting value, no failure to converge.
    """
    low_bits = np.array(low, dtype=np.float64).view(np.int64)
    high_bits = np.array(high, dtype=np.float64).view(np.int64)
    while np.any(high_bits - low_bits > 1):
        middle = low_bits + (high_bits - low_bits) // 2
        before = function(middle.view(np.float64)) > 0
        low_bits = np.where(before, middle, low_bits)
        high_bits = np.where(before, high_bits, middle)
    return low_bits.view(np.float64)


def least_value(function: Function, low: npt.ArrayLike, high: npt.ArrayLike) -> FloatArray:
    """The least value between `low` and `high` of a `function` that falls, then rises.

    The value has full precision; the place, known to half the digits, is not returned.
    Golden-section search in the logarithm of the variable. What an element gives does not depend
    on its neighbours: it rests while they go on.
    """
    left = np.log(np.asarray(low, dtype=np.float64))
    right = np.log(np.asarray(high, dtype=np.float64))
    while np.any(wide := right - left > 1e-9):
        width = _GOLDEN * (right - left)
        first, second = right - width, left + width
        falling = function(np.exp(first)) > function(np.exp(second))
        left, right = (
            np.where(wide & falling, first, left),
            np.where(wide & ~falling, second, right),
        )
    return function(np.exp(0.5 * (left + right)))

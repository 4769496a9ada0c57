"""Angles of the apex locus that deserve a name, each the zero of one exact condition.

Every function takes the drag parameter ε (`epsilon`, a number or an array, at least 0 and finite)
and returns a launch angle in radians, of the same shape, right to a few units of the last digit
from ε = 0 to 1e300. Symbols are those of the paper (H. Hernández-Saldaña, Eur. J. Phys. 2010):
s = sin α, u = ε s, q = 1 + u; lengths in V₀²/g, times in V₀/g.

The conditions are written so that nothing cancels, neither as ε → 0 nor as ε → ∞: sums of terms
that stay of the size of 1. DESIGN.md says what else is put together in Python, and why.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from archerfish import _core
from archerfish.kinematics import drift, fall
from archerfish.values import Quantity, not_negative
from archerfish.zeros import FloatArray, least_value, zero_between

_HALF_PI = np.pi / 2


def greatest_curvature_angle(epsilon: npt.ArrayLike) -> Quantity:
    """Launch angle α of the apex where the locus bends most, in radians.

    With k = 1/q, p = u/q, c² = 1 − s² and m = n/q, where n = 1 − 2s² − εs³, the curvature is
    ρK = q M / E^{3/2} with M = m² + 2pc²m + s²c²(3 + k) and E = s²c² + m². The condition is
    d ln(ρK)/d ln s = p + M′/M − (3/2) E′/E = 0, a dash being s d/ds:
    k′ = −kp, p′ = kp, m′ = −kpc² − 2s²(1 + k).

    >>> float(np.degrees(greatest_curvature_angle(0.0)).round(12))
    45.0
    """

    def condition(alpha: FloatArray, eps: FloatArray) -> FloatArray:
        s = np.sin(alpha)
        s2, k, p, m = _reduced(s, eps)
        c2 = 1 - s2
        m_d = -(k * p * c2 + 2 * s2 * (1 + k))
        big_m = m * m + 2 * p * c2 * m + s2 * c2 * (3 + k)
        big_e = s2 * c2 + m * m
        big_m_d = (
            2 * m * m_d
            + 2 * p * (c2 * (k * m + m_d) - 2 * s2 * m)
            + s2 * (2 * (1 - 2 * s2) * (3 + k) - c2 * k * p)
        )
        big_e_d = 2 * s2 * (1 - 2 * s2) + 2 * m * m_d
        return p + big_m_d / big_m - 1.5 * big_e_d / big_e

    return _solve(condition, epsilon)


def rightmost_angle(epsilon: npt.ArrayLike) -> Quantity:
    """Launch angle α of the apex farthest from the vertical axis, in radians.

    There dx/dα = 0, that is n = 0: s²(2 + u) = 1.

    >>> float(np.degrees(rightmost_angle(1.0)).round(9))
    38.172707627
    """

    def condition(alpha: FloatArray, eps: FloatArray) -> FloatArray:
        s = np.sin(alpha)
        return 1 - s * s * (2 + eps * s)

    return _solve(condition, epsilon)


def farthest_angle(epsilon: npt.ArrayLike) -> Quantity:
    """Launch angle α of the apex farthest from the launch point, in radians.

    There dx/dα = −y. With y = s² φ(u), t = s ln(1+u)/u and n the difference
    1 − 2s² − εs³, the large terms of n + q²y = 0 leave s(2 + u) t − y = 1.

    >>> float(np.degrees(farthest_angle(0.0)).round(10))
    54.7356103172
    """

    def condition(alpha: FloatArray, eps: FloatArray) -> FloatArray:
        s = np.sin(alpha)
        time = _core.apex_time(alpha, eps)
        height = _core.apex_y(alpha, eps)
        return np.asarray(1 + height - s * (2 + eps * s) * time)

    return _solve(condition, epsilon)


def greatest_range_angle(epsilon: npt.ArrayLike) -> Quantity:
    """Launch angle α of the longest shot over level ground, in radians: `optimal_angle`.

    >>> bool(np.isclose(np.sin(greatest_range_angle(1.0)), 1 / np.expm1(1.0), rtol=1e-15))
    True
    """
    return _number(_core.optimal_angle(not_negative("epsilon", epsilon)))


def receding_angle(epsilon: npt.ArrayLike) -> Quantity:
    """Launch angle α up to which the distance from the launcher never stops growing, in radians.

    Distance grows while x ẋ + y ẏ > 0. With the drift D and the fall F of the flight equations this
    says sin α < D (e^{−εt} + F)/(D² + F e^{−εt}): α is the angle of the least value over t.

    >>> bool(np.isclose(np.sin(receding_angle(0.0)), np.sqrt(8) / 3, rtol=1e-15))
    True
    """
    eps = np.asarray(not_negative("epsilon", epsilon))
    # Time in units of 1/(1 + ε), which keeps D and F of the size of 1.
    scale = 1 + eps
    drag = eps / scale

    def bound(time: FloatArray) -> FloatArray:
        moved, fallen, w = drift(time, drag), fall(time, drag), drag * time
        decay = np.exp(-w)
        # The decay times the scale, where the decay alone may underflow.
        soon = np.where(w < 700, scale * decay, np.exp(np.log(scale) - w))
        return np.asarray((soon + fallen / scale) / (moved + fallen / moved * decay))

    # The least value lies at t = √2 without drag, at 2 ln(ε)/ε for strong drag.
    sine = least_value(bound, np.ones_like(scale), 2 * (2 + np.log(scale)))
    return _number(np.arcsin(sine))


def apex_x_slope(alpha: npt.ArrayLike, epsilon: npt.ArrayLike) -> FloatArray:
    """dx/dα of the apex, in V₀²/g: n/q² with n = 1 − 2s² − εs³ and q = 1 + εs."""
    _, k, _, m = _reduced(np.sin(alpha), np.asarray(epsilon, dtype=np.float64))
    return k * m


def _reduced(s: FloatArray, eps: FloatArray) -> tuple[FloatArray, ...]:
    """s², k = 1/q, p = u/q and m = n/q, free of the overflow of q² and εs³."""
    u = eps * s
    k = 1 / (1 + u)
    p = u * k
    s2 = s * s
    return s2, k, p, k * (1 - 2 * s2) - p * s2


def _solve(
    condition: Callable[[FloatArray, FloatArray], FloatArray], epsilon: npt.ArrayLike
) -> Quantity:
    """The α where `condition` turns negative, between 1/(2 + ε), below every one, and π/2."""
    eps = np.asarray(not_negative("epsilon", epsilon))
    alpha = zero_between(
        lambda middle: condition(middle, eps), 1 / (2 + eps), np.full_like(eps, _HALF_PI)
    )
    return _number(alpha)


def _number(array: Any) -> Quantity:
    """A plain float for shape (), the array itself otherwise."""
    return float(array) if np.ndim(array) == 0 else np.asarray(array)

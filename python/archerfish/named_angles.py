"""Angles of the apex locus that deserve a name, each the zero of one exact condition.

Every function takes the drag parameter ε (`epsilon`, a number or an array, at least 0 and finite)
and returns a launch angle in radians, of the same shape, right to a few units of the last digit
from ε = 0 to 1e300. Symbols are those of the paper (H. Hernández-Saldaña, Eur. J. Phys. 2010):
s = sin α, u = ε s, q = 1 + u; lengths in V₀²/g, times in V₀/g.

The conditions are written so that nothing cancels, neither as ε → 0 nor as ε → ∞: sums of terms
that stay of the size of 1. They hold the only formulas of motion outside the Rust core.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from archerfish import _core
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

    Distance grows while x ẋ + y ẏ > 0. With w = εt and the E₁, E₂ of the flight equations, this
    says s < (E₁e^{−w} + t²E₁E₂) / (t(E₁² + E₂e^{−w})): α is the angle of the least value over t.

    >>> bool(np.isclose(np.sin(receding_angle(0.0)), np.sqrt(8) / 3, rtol=1e-15))
    True
    """
    eps = np.asarray(not_negative("epsilon", epsilon))

    def bound(time: FloatArray) -> FloatArray:
        w = eps * time
        decay = np.exp(-w)
        # E₁ = (1 − e^{−w})/w and E₂ = (w − 1 + e^{−w})/w², with their limits 1 and 1/2 at w = 0.
        lost = np.expm1(-w)
        with np.errstate(invalid="ignore"):
            e1 = np.where(w > 0, -lost / w, 1.0)
            # ln(1 + lost) is −w: log1pmx keeps the digits of a small w, plain w those of a large.
            shortfall = np.where(w > 1, w + lost, -_core.log1pmx(np.maximum(lost, -0.75)))
            e2 = np.where(w > 0, shortfall / w / w, 0.5)
        # e^{−w}/t, where e^{−w} alone may underflow.
        soon = np.where(w < 700, decay / time, np.exp(-w - np.log(time)))
        return np.asarray(e1 * (soon + time * e2) / (e1 * e1 + e2 * decay))

    # The least value lies at t = √2 without drag, at 2 ln(ε)/ε for strong drag.
    shortest = 1 / (1 + eps)
    sine = least_value(bound, shortest, 2 * (2 + np.log1p(eps)) * shortest)
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

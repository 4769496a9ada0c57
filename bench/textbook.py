"""The formulas as people type them into NumPy and SciPy: paper and textbook, nothing rearranged.

Angles in radians, lengths in V₀²/g. These are the contenders; none of them is used by archerfish.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import elementwise
from scipy.special import lambertw

Array = NDArray[np.float64]

GRID = 10_000
"""Points of the paper's tabulation of α(θ) and of its difference quotients."""


def height(alpha: Array, eps: float) -> Array:
    """Height of the apex, equation (8)."""
    u = eps * np.sin(alpha)
    return (u - np.log1p(u)) / eps**2


def abscissa(alpha: Array, eps: float) -> Array:
    """Horizontal distance of the apex, equation (7)."""
    return np.sin(alpha) * np.cos(alpha) / (1 + eps * np.sin(alpha))


def elevation(alpha: Array, eps: float) -> Array:
    """Polar angle of the apex, equation (10)."""
    return np.arctan2(height(alpha, eps), abscissa(alpha, eps))


def radius(theta: Array, alpha: Array, eps: float) -> Array:
    """Distance of the apex by equation (13) with (11), principal branch; α(θ) is given."""
    f = np.cos(alpha) * np.sin(alpha) * np.exp(-eps * np.sin(alpha))
    return -lambertw(-(eps**2) * np.tan(theta) * f).real / (eps**2 * np.sin(theta))


def flight_range(alpha: Array, eps: float) -> Array:
    """Range on level ground by Lambert W, as in the articles on linear drag."""
    q = 1 + eps * np.sin(alpha)
    tau = q + lambertw(-q * np.exp(-q)).real
    return np.cos(alpha) * (1 - np.exp(-tau)) / eps


def grid() -> Array:
    """The launch angles of the tabulation."""
    return np.linspace(0.0, np.pi / 2, GRID)


def launch_angle(theta: Array, eps: float) -> Array:
    """α(θ) by linear interpolation in the tabulated equation (10)."""
    alpha = grid()
    return np.interp(theta, elevation(alpha, eps), alpha)


def launch_angle_by_root(theta: Array, eps: float) -> Array:
    """α(θ) by SciPy's vectorised root finder on equation (10)."""
    found = elementwise.find_root(
        lambda alpha, theta: elevation(alpha, eps) - theta,
        (theta, np.arctan(2 * np.tan(theta))),
        args=(theta,),
    )
    return np.asarray(found.x)


def curvature(eps: float) -> Array:
    """ρK on the grid of launch angles, by difference quotients."""
    alpha = grid()
    x, y = abscissa(alpha, eps), height(alpha, eps)
    x1, y1 = np.gradient(x, alpha), np.gradient(y, alpha)
    x2, y2 = np.gradient(x1, alpha), np.gradient(y1, alpha)
    return (x1 * y2 - y1 * x2) / np.hypot(x1, y1) ** 3

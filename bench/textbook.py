"""The formulas as people type them into NumPy and SciPy: paper and textbook, nothing rearranged.

Angles in radians, lengths in V₀²/g. These are the contenders; none of them is used by archerfish.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import elementwise
from scipy.special import lambertw

Array = NDArray[np.float64]

BRANCH_POINT = -np.exp(-1.0)

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


def distance(alpha: Array, eps: float) -> Array:
    """Distance of the apex from the launch point."""
    return np.hypot(abscissa(alpha, eps), height(alpha, eps))


def principal_radius(theta: Array, alpha: Array, eps: float) -> Array:
    """Distance of the apex by equation (13) with (11), principal branch; α(θ) is given."""
    f = np.cos(alpha) * np.sin(alpha) * np.exp(-eps * np.sin(alpha))
    return -lambertw(-(eps**2) * np.tan(theta) * f).real / (eps**2 * np.sin(theta))


def radius(theta: Array, alpha: Array, eps: Array) -> Array:
    """The same with the branch that the argument belongs to."""
    u = eps * np.sin(alpha)
    z = -(eps**2) * np.tan(theta) * np.cos(alpha) * np.sin(alpha) * np.exp(-u)
    branch = np.where(u - np.log1p(u) <= 1, 0, -1)
    return -lambertw(z, branch).real / (eps**2 * np.sin(theta))


def radius_by_flight(alpha: Array, eps: Array, solve_ivp: Callable[..., Any]) -> Array:
    """The distance at which the solved equation of motion stops rising, shot by shot."""

    def motion(_: float, state: Array, drag: float) -> list[float]:
        return [state[2], state[3], -drag * state[2], -1 - drag * state[3]]

    def rising(_: float, state: Array, drag: float) -> float:  # noqa: ARG001 - solve_ivp passes it
        return float(state[3])

    rising.terminal = True  # type: ignore[attr-defined]  # read by solve_ivp
    found = []
    for angle, drag in zip(alpha, eps, strict=True):
        start = [0.0, 0.0, np.cos(angle), np.sin(angle)]
        flight = solve_ivp(
            motion, (0.0, 2.0), start, args=(drag,), events=rising, rtol=1e-10, atol=1e-12
        )
        found.append(np.hypot(*flight.y_events[0][0][:2]))
    return np.array(found)


def flight_time(alpha: Array, eps: float) -> Array:
    """Time of flight on level ground by Lambert W, as in the articles on linear drag."""
    q = 1 + eps * np.sin(alpha)
    return (q + lambertw(-q * np.exp(-q)).real) / eps


def flight_range(alpha: Array, eps: float) -> Array:
    """Range on level ground, from the time of flight."""
    return np.cos(alpha) * (1 - np.exp(-eps * flight_time(alpha, eps))) / eps


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
        lambda alpha, theta, eps: elevation(alpha, eps) - theta,
        (theta, np.arctan(2 * np.tan(theta))),
        args=(theta, eps),
    )
    return np.asarray(found.x)


def curvature(eps: float) -> Array:
    """ρK on the grid of launch angles, by difference quotients."""
    alpha = grid()
    x, y = abscissa(alpha, eps), height(alpha, eps)
    x1, y1 = np.gradient(x, alpha), np.gradient(y, alpha)
    x2, y2 = np.gradient(x1, alpha), np.gradient(y1, alpha)
    return (x1 * y2 - y1 * x2) / np.hypot(x1, y1) ** 3


def slope(eps: float) -> Array:
    """dα/dθ on the grid of launch angles, by difference quotients."""
    alpha = grid()
    return np.gradient(alpha, elevation(alpha, eps))


def bend(eps: float) -> Array:
    """d²α/dθ² on the same grid, by differences of differences."""
    return np.gradient(slope(eps), elevation(grid(), eps))

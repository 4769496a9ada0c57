r"""Whole trajectories, from launch to landing, for drawing.

One parameter σ makes linear drag look like no drag at all. With the time t = ln(1 + εσ)/ε (which is
σ without drag) the equation of motion has the solution, in units of V₀²/g and V₀,

    ẋ = cos α / (1 + εσ),        ẏ = (sin α − σ) / (1 + εσ),
    x = σ cos α / (1 + εσ),      y = σ (sin α − σ κ(εσ)) / (1 + εσ),

    κ(u) = ((1 + u) ln(1 + u) − u) / u²,    κ(0) = 1/2, decreasing.

So the velocity points along (cos α, sin α − σ), as in the drag-free problem; the apex is at
σ = sin α, the landing at σ κ(εσ) = sin α, and ε = 0 is an ordinary point.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from archerfish import apex_time, apex_y

Array = NDArray[np.float64]

BISECTIONS = 60
"""Halvings that bring an interval of order one down to the spacing of doubles."""

LATEST = np.arctan(1e8)
"""Greatest χ: that late, a shot is nearer to its wall than a double can tell."""


def fall(u: ArrayLike) -> Array:
    """Return κ(u), for u ≥ 0: the drag-free 1/2 of a falling body, changed by drag.

    Both forms come from a vertical shot at drag u, whose apex lies φ(u) high and is reached at
    ln(1 + u)/u. The first is exact at u = 0, the second does not cancel as u → ∞.
    """
    u = np.asarray(u, dtype=np.float64)
    vertical = np.pi / 2
    growth = 1.0 + u
    near = 1.0 - growth * apex_y(vertical, u)
    far = (growth * apex_time(vertical, u) - 1.0) / np.maximum(u, 1.0)
    return np.asarray(np.where(u < 1.0, near, far))


def trajectories(
    launch_angle: ArrayLike, epsilon: float, samples: int = 181
) -> tuple[Array, Array]:
    """Return x and y, in V₀²/g, of whole flights from launch to landing on level ground.

    ``launch_angle`` has shape (n,), in radians from 0 to π; x and y have shape (n, samples). The
    point halfway is not the apex: points are spread evenly in the angle χ of σ = (1 + tan χ) sin α.
    They solve the equation of motion that the paper starts from, in the form of this module's head.

    >>> x, y = trajectories([np.pi / 4], 0.0)
    >>> round(float(x[0, -1]), 12), round(float(y.max()), 4)
    (1.0, 0.25)
    """
    alpha = np.asarray(launch_angle, dtype=np.float64)[:, np.newaxis]
    sine, cosine = np.sin(alpha), np.cos(alpha)

    def above_ground(spread: Array) -> NDArray[np.bool_]:
        sigma = (1.0 + np.tan(spread)) * sine
        return np.asarray(sine > sigma * fall(epsilon * sigma))

    early, late = np.full_like(alpha, np.pi / 4), np.full_like(alpha, LATEST)
    for _ in range(BISECTIONS):
        middle = 0.5 * (early + late)
        above = above_ground(middle)
        early, late = np.where(above, middle, early), np.where(above, late, middle)

    start = -np.pi / 4
    spread = start + (early - start) * np.linspace(0.0, 1.0, samples)
    sigma = (1.0 + np.tan(spread)) * sine
    sigma[:, 0] = 0.0
    u = epsilon * sigma
    x = sigma * cosine / (1.0 + u)
    y = sigma * (sine - sigma * fall(u)) / (1.0 + u)
    # A shot that has not landed by then falls straight down its wall.
    y[:, -1] = 0.0
    return x, y

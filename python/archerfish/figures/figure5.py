"""Figure 5: the angles worth naming, against drag."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from archerfish import apex_elevation
from archerfish.named_angles import (
    farthest_angle,
    greatest_curvature_angle,
    greatest_range_angle,
    receding_angle,
    rightmost_angle,
)

from . import style
from .trajectory import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

EPSILONS = tuple(float(value) for value in np.logspace(-3, 3, 121))


STROKES: tuple[tuple[str, style.Dashes], ...] = (
    (style.BLACK, "-"),
    (style.BLUE, (0, (6, 1.5))),
    (style.VERMILLION, (0, (5, 1.5, 1, 1.5))),
    (style.GREEN, "-"),
    (style.BLACK, (0, (1, 1))),
    (style.GREEN, (0, (3, 1))),
)
"""One a curve: the two names of the point of greatest curvature share a colour."""

RING: dict[str, Any] = {"clip_on": False, "zorder": 3, "markersize": 4.5}


@dataclass(frozen=True)
class Figure5Data:
    """Curves of figure 5: the name of each angle, and its values in radians."""

    epsilon: Array  # (points,)
    angles: dict[str, Array]  # each (points,)
    drag_free: dict[str, float]  # the limit ε = 0 of each


def named_angles(epsilons: Sequence[float]) -> dict[str, Array]:
    """Return every named angle, in radians, for each ε ≥ 0, by the name drawn in the legend."""
    epsilon = np.asarray(epsilons, dtype=np.float64)
    bend = np.asarray(greatest_curvature_angle(epsilon))
    return {
        "distance stops growing": np.asarray(receding_angle(epsilon)),
        "farthest apex": np.asarray(farthest_angle(epsilon)),
        "rightmost apex": np.asarray(rightmost_angle(epsilon)),
        r"greatest curvature, $\alpha$": bend,
        "greatest range": np.asarray(greatest_range_angle(epsilon)),
        r"greatest curvature, $\theta$": np.asarray(apex_elevation(bend, epsilon)),
    }


def figure5_data(epsilons: Sequence[float] = EPSILONS) -> Figure5Data:
    """Return the named angles for each ε > 0, and their drag-free limits.

    ``epsilons`` come in any order, at least two of them; ValueError otherwise.

    >>> data = figure5_data([1.0, 10.0])
    >>> np.degrees(data.angles["greatest range"]).round(6).tolist()
    [35.589694, 15.828721]
    """
    epsilons = sorted(set(epsilons))
    if len(epsilons) < 2 or epsilons[0] <= 0.0:
        raise ValueError(
            f"figure 5 needs at least 2 values of epsilon, all above 0, got {list(epsilons)}"
        )
    return Figure5Data(
        epsilon=np.asarray(epsilons, dtype=np.float64),
        angles=named_angles(epsilons),
        drag_free={name: float(angle[0]) for name, angle in named_angles([0.0]).items()},
    )


def draw_figure5(ax: Axes, data: Figure5Data) -> None:
    """Draw figure 5: degrees against ε on a log axis, drag-free limits on the left edge."""
    for (name, angle), (color, dashes) in zip(data.angles.items(), STROKES, strict=True):
        ax.plot(data.epsilon, np.degrees(angle), color=color, linestyle=dashes, label=name)
    # Three of the limits are 45°: one ring for all three.
    for limit in sorted({round(float(np.degrees(value)), 2) for value in data.drag_free.values()}):
        ax.plot(data.epsilon[0], limit, "o", color=style.BLACK, mfc="white", **RING)
        ax.annotate(
            f"{limit:g}°",
            (data.epsilon[0], limit),
            xytext=(7.0, 3.0),
            textcoords="offset points",
            size="small",
        )
    ax.set_xscale("log")
    ax.set_xlim(data.epsilon[0], data.epsilon[-1])
    ax.set_ylim(0.0, 75.0)
    style.degree_axis(ax.yaxis, 15.0, highest=75.0)
    style.plain_log_ticks(ax.xaxis)
    ax.set_xlabel(r"drag parameter $\varepsilon = bV_0/g$")
    ax.set_ylabel("angle (°)")
    ax.legend(loc="upper right")


def caption5(data: Figure5Data) -> str:
    """Return the caption of figure 5."""
    return (
        "Figure 5. Launch angles worth naming, and the elevation θ of the point of greatest "
        f"curvature, against the drag parameter ε from {data.epsilon[0]:g} to "
        f"{data.epsilon[-1]:g}. Rings on the left edge: the limits ε → 0. "
        "A projectile launched above the solid black curve for a while comes nearer again."
    )

"""Figure 2: elevation of the apex against launch angle, and the inverse function."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from archerfish import apex_elevation, locus_launch_angle

from . import style
from .trajectory import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

EPSILONS = (0.1, 10.0)


@dataclass(frozen=True)
class Figure2Data:
    """Curves of figure 2, angles in radians; one ε a row."""

    epsilon: Array  # (n,)
    angle: Array  # (points,), the common abscissa
    elevation: Array  # (n, points): θ at launch angle ``angle``
    launch_angle: Array  # (n, points): α at elevation ``angle``


def figure2_data(epsilons: Sequence[float] = EPSILONS, *, points: int = 361) -> Figure2Data:
    """Return θ(α) (paper, equation 10) and its inverse α(θ), from 0 to π/2, for each ε ≥ 0.

    >>> figure2_data([0.0], points=5).launch_angle.shape
    (1, 5)
    """
    epsilon = np.asarray(epsilons, dtype=np.float64)
    angle = np.linspace(0.0, np.pi / 2, points)
    column = epsilon[:, np.newaxis]
    return Figure2Data(
        epsilon=epsilon,
        angle=angle,
        elevation=apex_elevation(angle, column),
        launch_angle=locus_launch_angle(angle, column),
    )


def draw_figure2(ax: Axes, data: Figure2Data) -> None:
    """Draw figure 2: equal axes in degrees, the inverse mirrored in the diagonal."""
    angle = np.degrees(data.angle)
    ax.plot([0.0, 90.0], [0.0, 90.0], color=style.GREY, linewidth=style.FAINT)
    for index, epsilon in enumerate(data.epsilon):
        line = style.stroke(index).line()
        label = style.epsilon_label(float(epsilon))
        ax.plot(angle, np.degrees(data.launch_angle[index]), **line, label=label)
        ax.plot(angle, np.degrees(data.elevation[index]), **line)
    ax.text(27.0, 66.0, r"$\alpha(\theta)$", ha="center", va="center")
    ax.text(66.0, 27.0, r"$\theta(\alpha)$", ha="center", va="center")
    ax.set_aspect("equal")
    ax.set_xlim(0.0, 90.0)
    ax.set_ylim(0.0, 90.0)
    style.degree_axis(ax.xaxis, 15.0)
    style.degree_axis(ax.yaxis, 15.0)
    ax.set_xlabel(r"launch angle $\alpha$, or elevation $\theta$ (°)")
    ax.set_ylabel(r"elevation $\theta$, or launch angle $\alpha$ (°)")
    ax.legend(loc="lower right")


def caption2(data: Figure2Data) -> str:
    """Return the caption of figure 2."""
    values = " and ".join(f"{epsilon:g}" for epsilon in data.epsilon)
    return (
        f"Figure 2. Elevation θ of the apex against launch angle α (below the diagonal), "
        f"equation (10), for ε = {values}, and the inverse functions α(θ) (above the diagonal)."
    )

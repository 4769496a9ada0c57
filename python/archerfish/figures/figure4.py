"""Figure 4: curvature of the locus by launch angle and by elevation, its maximum marked."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from archerfish import apex_curvature, apex_elevation, locus_curvature
from archerfish.named_angles import greatest_curvature_angle

from . import style
from .trajectory import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

EPSILONS = (0.0, 0.1, 1.0, 10.0)


@dataclass(frozen=True)
class Figure4Data:
    """Curves of figure 4, one ε a row; angles in radians, curvature as ρK (no unit)."""

    epsilon: Array  # (n,)
    angle: Array  # (points,): α in panel (a), θ in panel (b)
    by_launch_angle: Array  # (n, points)
    by_elevation: Array  # (n, points)
    greatest_launch_angle: Array  # (n,)
    greatest_elevation: Array  # (n,)
    greatest: Array  # (n,)


def figure4_data(epsilons: Sequence[float] = EPSILONS, *, points: int = 721) -> Figure4Data:
    """Return ρK against α and against θ (paper, equation 19) and its greatest, for each ε ≥ 0.

    >>> round(float(figure4_data([1.0]).greatest[0]), 9)
    12.298109766
    """
    epsilon = np.asarray(epsilons, dtype=np.float64)
    # Squared spacing: the stronger the drag, the nearer to 0 the curve bends.
    angle = np.pi / 2 * np.linspace(0.0, 1.0, points) ** 2
    column = epsilon[:, np.newaxis]
    bend = np.asarray(greatest_curvature_angle(epsilon))
    return Figure4Data(
        epsilon=epsilon,
        angle=angle,
        by_launch_angle=apex_curvature(angle, column),
        by_elevation=locus_curvature(angle, column),
        greatest_launch_angle=bend,
        greatest_elevation=apex_elevation(bend, epsilon),
        greatest=apex_curvature(bend, epsilon),
    )


def draw_figure4(axes: Sequence[Axes], data: Figure4Data) -> None:
    """Draw figure 4 on two axes: ρK (a) against α and (b) against θ, on a log scale."""
    angle = np.degrees(data.angle)
    panels = (
        ("a", r"launch angle $\alpha$ (°)", data.by_launch_angle, data.greatest_launch_angle),
        ("b", r"elevation of the apex $\theta$ (°)", data.by_elevation, data.greatest_elevation),
    )
    for ax, (panel, name, values, place) in zip(axes, panels, strict=True):
        for index, epsilon in enumerate(data.epsilon):
            stroke = style.stroke(index)
            ax.plot(angle, values[index], **stroke.line())
            ax.plot(
                np.degrees(place[index]),
                data.greatest[index],
                marker=stroke.marker,
                markeredgecolor="white",
                markeredgewidth=0.5,
                **stroke.line(),
                label=style.epsilon_label(float(epsilon)),
            )
        ax.set_yscale("log")
        ax.set_xlim(0.0, 90.0)
        style.degree_axis(ax.xaxis, 15.0)
        style.plain_log_ticks(ax.yaxis, (1.0, 2.0, 5.0))
        ax.set_xlabel(name)
        style.panel_label(ax, panel)
    axes[0].set_ylabel(r"curvature $\rho K$")
    axes[1].legend(loc="upper right")


def caption4(data: Figure4Data) -> str:
    """Return the caption of figure 4."""
    values = ", ".join(f"{epsilon:g}" for epsilon in data.epsilon)
    return (
        f"Figure 4. Curvature K of the locus times ρ = V₀²/g, for ε = {values}, (a) by launch "
        f"angle α and (b) by elevation θ of the apex, equation (19). Markers: the greatest value, "
        f"8 at α = 45° without drag. At 0° ρK is 1 for every drag, at 90° it is 1 + ε."
    )

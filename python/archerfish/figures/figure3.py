"""Figure 3: first and second derivative of the launch angle by the elevation of the apex."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from archerfish import locus_launch_angle_d1, locus_launch_angle_d2

from . import style
from .trajectory import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

EPSILONS = (0.0, 0.1, 1.0, 3.0, 10.0)

SECOND_RANGE = (-8.5, 0.5)
"""What panel (b) shows: d²α/dθ² starts at −8ε/3, which one strong drag would let rule the scale."""


@dataclass(frozen=True)
class Figure3Data:
    """Curves of figure 3, one ε a row; angles in radians, derivatives per radian."""

    epsilon: Array  # (n,)
    elevation: Array  # (points,)
    first: Array  # (n, points): dα/dθ
    second: Array  # (n, points): d²α/dθ²


def figure3_data(epsilons: Sequence[float] = EPSILONS, *, points: int = 721) -> Figure3Data:
    """Return dα/dθ (paper, equation 18) and d²α/dθ², θ from 0 to π/2, for each ε ≥ 0.

    >>> figure3_data([0.0, 1.0]).first[:, 0].tolist()
    [2.0, 2.0]
    """
    epsilon = np.asarray(epsilons, dtype=np.float64)
    # Squared spacing: with strong drag all that happens, happens near θ = 0.
    elevation = np.pi / 2 * np.linspace(0.0, 1.0, points) ** 2
    column = epsilon[:, np.newaxis]
    return Figure3Data(
        epsilon=epsilon,
        elevation=elevation,
        first=locus_launch_angle_d1(elevation, column),
        second=locus_launch_angle_d2(elevation, column),
    )


def draw_figure3(axes: Sequence[Axes], data: Figure3Data) -> None:
    """Draw figure 3 on two axes: (a) the first and (b) the second derivative."""
    elevation = np.degrees(data.elevation)
    names = (r"$\mathrm{d}\alpha/\mathrm{d}\theta$", r"$\mathrm{d}^2\alpha/\mathrm{d}\theta^2$")
    for ax, panel, name, values in zip(axes, "ab", names, (data.first, data.second), strict=True):
        for index, epsilon in enumerate(data.epsilon):
            ax.plot(
                elevation,
                values[index],
                **style.stroke(index).line(),
                label=style.epsilon_label(float(epsilon)),
            )
        unit = "" if panel == "a" else r" (rad$^{-1}$)"
        ax.set_xlim(0.0, 90.0)
        style.degree_axis(ax.xaxis, 15.0)
        ax.set_xlabel(r"elevation of the apex $\theta$ (°)")
        ax.set_ylabel(name + unit)
        style.panel_label(ax, panel)
    axes[1].set_ylim(SECOND_RANGE)
    axes[1].axhline(0.0, color=style.GREY, linewidth=style.FAINT, zorder=0)
    axes[0].legend(loc="upper right")


def caption3(data: Figure3Data) -> str:
    """Return the caption of figure 3."""
    values = ", ".join(f"{epsilon:g}" for epsilon in data.epsilon)
    return (
        f"Figure 3. (a) First and (b) second derivative of the launch angle α by the elevation θ "
        f"of the apex, equation (18), for ε = {values}. Both are exact, not difference quotients. "
        f"At θ = 0 they are 2 and −8ε/3; strong drag starts below panel (b)."
    )

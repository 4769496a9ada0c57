"""Figure 6: where the series for α(θ) converge, and where they do not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from archerfish.series import Of, convergence_data

from . import style
from .trajectory import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

EPSILONS = (0.1, 1.0, 3.0)
ORDERS = (6, 12, 18)
ARGUMENTS = (0.02, 2.0)
"""Least and greatest T = 2 tan θ shown."""
ERRORS = (3e-17, 100.0)
"""Least and greatest error shown, in radians; below it is rounding."""
MOST_PANELS = 4

NAMES: dict[Of, str] = {"paper": "(17)", "exact": "exact"}
COLORS: dict[Of, str] = {"paper": style.VERMILLION, "exact": style.BLACK}
DASHES: tuple[style.Dashes, ...] = ((0, (1, 1)), (0, (4, 1.5)), "-")


@dataclass(frozen=True)
class Figure6Data:
    """Curves of figure 6, in radians."""

    epsilon: Array  # (n,)
    argument: Array  # (points,): T = 2 tan θ
    orders: tuple[int, ...]
    error: dict[Of, Array]  # (n, orders, points): |series − α(θ)|
    radius: dict[Of, Array]  # (n,): each converges for T below it


def figure6_data(
    epsilons: Sequence[float] = EPSILONS,
    *,
    orders: Sequence[int] = ORDERS,
    points: int = 201,
) -> Figure6Data:
    """Return the errors of the paper's series (17) and of the reversion of (10) itself.

    One panel for each ε ≥ 0, up to 4, and at most 3 orders from 1 to 40; ValueError otherwise.

    >>> round(float(figure6_data([0.1]).radius["paper"][0]), 4)
    0.9263
    """
    if not 1 <= len(epsilons) <= MOST_PANELS:
        raise ValueError(
            f"figure 6 shows from 1 to {MOST_PANELS} values of epsilon, got {len(epsilons)}"
        )
    if len(orders) > len(DASHES):
        raise ValueError(f"figure 6 shows at most {len(DASHES)} orders, got {len(orders)}")
    argument = np.geomspace(*ARGUMENTS, points)
    data = convergence_data(epsilons, elevation=np.arctan(argument / 2.0), orders=orders)
    return Figure6Data(
        epsilon=data.epsilon,
        argument=argument,
        orders=data.orders,
        error={of: np.abs(error) for of, error in data.error.items()},
        radius=data.radius,
    )


def panels6(data: Figure6Data) -> int:
    """Return how many axes figure 6 needs."""
    return data.epsilon.size


def draw_figure6(axes: Sequence[Axes], data: Figure6Data) -> None:
    """Draw figure 6 on one axes a drag parameter; both scales logarithmic."""
    for index, (ax, letter) in enumerate(zip(axes, "abcd", strict=False)):
        for of, error in data.error.items():
            ax.axvline(data.radius[of][index], color=COLORS[of], linewidth=style.FAINT)
            for order, dashes, curve in zip(data.orders, DASHES, error[index], strict=False):
                name = f"{NAMES[of]}, order {order}"
                ax.plot(data.argument, curve, color=COLORS[of], linestyle=dashes, label=name)
        ax.set_xscale("log")
        ax.set_yscale("log")
        ax.set_xlim(ARGUMENTS)
        ax.set_ylim(ERRORS)
        style.plain_log_ticks(ax.xaxis, (1.0, 2.0, 5.0))
        ax.set_xlabel(r"$2\tan\theta$")
        style.panel_label(ax, letter, style.epsilon_label(float(data.epsilon[index])))
    axes[0].set_ylabel(r"error of $\alpha$ (rad)")
    # Half of the legend a panel: only so much room is free of curves.
    handles = axes[0].get_legend_handles_labels()[0]
    half = len(handles) // 2 if len(axes) > 1 else len(handles)
    for ax, part in zip(axes, (handles[:half], handles[half:]), strict=False):
        ax.legend(handles=part, loc="upper left", borderaxespad=0.3, labelspacing=0.3)


def caption6(data: Figure6Data) -> str:
    """Return the caption of figure 6."""
    values = ", ".join(f"{epsilon:g}" for epsilon in data.epsilon)
    return (
        f"Figure 6. Error of the series for α(θ), for ε = {values}: the paper’s series (17), which "
        f"reverts equation (16), and the exact one, which reverts (10). Thin verticals: the radii "
        f"of convergence, never above 1. Below them (17) keeps the error of (16) at every order."
    )

"""Figure 1: trajectories, the locus of their apexes, and the ellipse it is without drag."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from archerfish import apex_x, apex_y
from archerfish.launcher import Launcher

from . import style
from .trajectory import Array, trajectories

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LAUNCH_ANGLES_DEG = tuple(range(5, 95, 5))


@dataclass(frozen=True)
class Figure1Data:
    """Curves of figure 1. Lengths in metres, angles in radians."""

    speed: float
    epsilon: float
    launch_angle: Array  # (n,)
    x: Array  # (n, samples), one trajectory a row, launch to landing
    y: Array
    apex_x: Array  # (n,)
    apex_y: Array
    locus_x: Array  # (points,), launch angle from 0 to π/2
    locus_y: Array
    drag_free_x: Array
    drag_free_y: Array


def figure1_data(
    launcher: Launcher | None = None,
    *,
    launch_angles_deg: Sequence[float] = LAUNCH_ANGLES_DEG,
    points: int = 361,
) -> Figure1Data:
    """Return the curves of figure 1 (paper, equations 7 and 8).

    ``launcher`` holds plain numbers, no arrays; without one: V₀ = 10 m/s, ε = 0.1 and standard
    gravity, as in the paper. ``launch_angles_deg``, from 0 to 180, are those of the trajectories.

    >>> round(float(figure1_data().apex_y.max()), 6)  # metres
    4.782286
    """
    if launcher is None:
        launcher = Launcher(10.0, epsilon=0.1)
    epsilon, scale = float(launcher.epsilon), float(launcher.length_scale)
    shots = np.radians(np.asarray(launch_angles_deg, dtype=np.float64))
    x, y = trajectories(shots, epsilon)
    alpha = np.linspace(0.0, np.pi / 2, points)
    return Figure1Data(
        speed=float(launcher.speed),
        epsilon=epsilon,
        launch_angle=shots,
        x=scale * x,
        y=scale * y,
        apex_x=scale * apex_x(shots, epsilon),
        apex_y=scale * apex_y(shots, epsilon),
        locus_x=scale * apex_x(alpha, epsilon),
        locus_y=scale * apex_y(alpha, epsilon),
        drag_free_x=scale * apex_x(alpha, 0.0),
        drag_free_y=scale * apex_y(alpha, 0.0),
    )


def draw_figure1(ax: Axes, data: Figure1Data) -> None:
    """Draw figure 1: equal axes; metres, or the unit that suits the launcher."""
    # Strong drag makes the locus small beside the ellipse: then the frame crops the ellipse.
    top = 1.06 * min(data.drag_free_y.max(), 2.0 * data.locus_y.max())
    unit, metres = style.length_unit(top)
    for index, (x, y) in enumerate(zip(data.x, data.y, strict=True)):
        label = "trajectories" if index == 0 else None
        ax.plot(x / metres, y / metres, color=style.BLACK, linewidth=style.FAINT, label=label)
    ax.plot(
        data.drag_free_x / metres,
        data.drag_free_y / metres,
        color=style.RED,
        linestyle=(0, (5, 2)),
        label="locus without drag (ellipse)",
    )
    ax.plot(
        data.locus_x / metres,
        data.locus_y / metres,
        color=style.BLUE,
        linewidth=1.8,
        label="locus of apexes",
    )
    ax.plot(data.apex_x / metres, data.apex_y / metres, "o", color=style.BLUE, markersize=2.6)
    ax.set_aspect("equal")
    ax.set_ylim(0.0, top / metres)
    ax.set_xlim(0.0, max(1.03 * data.x.max(), 1.75 * top) / metres)
    style.plain_ticks(ax.xaxis)
    style.plain_ticks(ax.yaxis)
    ax.set_xlabel(f"horizontal distance $x$ ({unit})")
    ax.set_ylabel(f"height $y$ ({unit})")
    trajectory, drag_free, locus = ax.get_legend_handles_labels()[0]
    ax.legend(
        handles=[locus, drag_free, trajectory],
        loc="lower center",
        bbox_to_anchor=(0.5, 1.0),
        borderaxespad=0.2,
        ncols=3,
    )


def caption1(data: Figure1Data) -> str:
    """Return the caption of figure 1."""
    degrees = np.degrees(data.launch_angle).round(6)
    return (
        f"Figure 1. Locus of the apexes (blue, solid) of projectiles launched at "
        f"V₀ = {data.speed:g} m/s with drag parameter ε = bV₀/g = {data.epsilon:g}, "
        f"equations (7) and (8). Thin black: trajectories at {degrees.size} launch angles α from "
        f"{degrees.min():g}° to {degrees.max():g}°, a dot at each apex. "
        f"Dashed red: the drag-free locus, an ellipse of eccentricity √3/2."
    )

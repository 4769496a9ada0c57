"""Every figure by its number: where its data come from, how it is drawn and what its caption is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from . import figure1, figure2, figure3, figure4, figure5, figure6, shots, style


@dataclass(frozen=True)
class Figure:
    """One figure. ``draw`` takes one axes, or a sequence of them where ``panels`` is given."""

    data: Callable[..., Any]
    draw: Callable[[Any, Any], None]
    caption: Callable[[Any], str]
    size: tuple[float, float] | Callable[[Any], tuple[float, float]]
    """Width and height in inches, without the caption; or what tells them of the data."""
    panels: Callable[[Any], int] | None = None
    """How many axes the data need, side by side."""


def two(_: Any) -> int:
    """Return the number of panels of a figure with (a) and (b)."""
    return 2


FIGURES: dict[int, Figure] = {
    1: Figure(figure1.figure1_data, figure1.draw_figure1, figure1.caption1, (5.2, 3.4)),
    2: Figure(figure2.figure2_data, figure2.draw_figure2, figure2.caption2, (3.4, 3.4)),
    3: Figure(
        figure3.figure3_data, figure3.draw_figure3, figure3.caption3, (style.PAGE_WIDTH, 3.0), two
    ),
    4: Figure(
        figure4.figure4_data, figure4.draw_figure4, figure4.caption4, (style.PAGE_WIDTH, 3.0), two
    ),
    5: Figure(figure5.figure5_data, figure5.draw_figure5, figure5.caption5, (5.2, 3.6)),
    6: Figure(
        figure6.figure6_data,
        figure6.draw_figure6,
        figure6.caption6,
        (style.PAGE_WIDTH, 2.9),
        figure6.panels6,
    ),
}


SHOT_FIGURES: dict[str, Figure] = {
    "shot": Figure(shots.shot_data, shots.draw_shot, shots.caption_shot, shots.size),
    "aim": Figure(shots.aim_data, shots.draw_aim, shots.caption_aim, shots.size),
    "envelope": Figure(shots.envelope_data, shots.draw_fan, shots.caption_fan, shots.size),
    "angles": Figure(shots.angles_data, shots.draw_fan, shots.caption_fan, shots.size),
}
"""Figures of what the user asks for, by name; they take no number."""


def figure(number: int | str) -> Figure:
    """Return the figure of this number or name; ValueError where there is none."""
    if isinstance(number, str) and number in SHOT_FIGURES:
        return SHOT_FIGURES[number]
    if not isinstance(number, int) or number not in FIGURES:
        raise ValueError(f"figure must be from 1 to {max(FIGURES)}, got {number}")
    return FIGURES[number]

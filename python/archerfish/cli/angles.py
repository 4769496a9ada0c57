"""`archerfish angles`: the launch angles that deserve a name."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
import numpy as np

from archerfish.cli import case
from archerfish.cli.batch import Question
from archerfish.cli.errors import reported
from archerfish.cli.parameters import DRAGS, GRAVITY, SPEED, Values, flags
from archerfish.launcher import Launcher

NAMES = {
    "greatest_range": "greatest range",
    "greatest_curvature": "sharpest bend of the locus",
    "greatest_curvature_elevation": "  its elevation θ",
    "rightmost": "rightmost apex",
    "farthest": "farthest apex",
    "receding": "always receding, up to",
    "longest_path": "longest path",
    "largest_area": "largest area under the path",
}
SHAPE = {
    "greatest_rho_k": "greatest ρK",
    "locus_length_per_rho": "length of the locus (ρ)",
    "locus_area_per_rho2": "area inside it (ρ²)",
}
COLUMNS = (*(f"{name}_deg" for name in NAMES), *SHAPE)


def drag_of(values: Values) -> Launcher:
    """A launcher with this drag parameter; without a speed, one of V₀²/g = 1 m."""
    drags = {each.name: values[each.name] for each in DRAGS if each.name in values}
    if "speed" in values:
        return Launcher(values["speed"], gravity=values["gravity"], **drags)
    if set(drags) - {"epsilon"}:
        raise ValueError(f"give --speed with --{next(iter(drags)).replace('_', '-')}, or --epsilon")
    return Launcher(1.0, gravity=1.0, **drags)


def compute(values: Values) -> dict[str, Any]:
    """The columns of these drags."""
    epsilon = drag_of(values).epsilon
    locus = Launcher(1.0, gravity=1.0, epsilon=epsilon).locus
    angles = Launcher(1.0, gravity=1.0, epsilon=epsilon).named_angles()
    found = [np.degrees(getattr(angles, name)) for name in NAMES]
    found += [locus.max_curvature.curvature, locus.arc_length(), locus.area]
    return dict(zip(COLUMNS, found, strict=True))


QUESTION = Question(
    required=(), optional=(*DRAGS, SPEED, GRAVITY), columns=COLUMNS, compute=compute
)


@click.command(
    epilog="""\b
Examples:
  archerfish angles --epsilon 0.1
  archerfish angles --speed 10 --terminal-speed 20 --figure angles.svg
  archerfish angles --batch drags.csv --output angles.csv
      a column epsilon, or speed_m_per_s and drag_rate_per_s or terminal_speed_m_per_s
""",
)
@flags(*QUESTION.parameters)
@case.destinations
def angles(
    batch: str | None,
    chosen_format: str | None,
    output: Path | None,
    figure_paths: tuple[Path, ...],
    **flags: float | None,
) -> None:
    """The launch angles with a name: best range, longest path, sharpest bend and others.

    They depend on the drag parameter ε alone; give --epsilon, or --speed and another drag. Angles
    are in degrees; lengths and areas in units of ρ = V₀²/g.
    """
    values = case.given(flags)
    if batch is not None:
        case.run_batch(QUESTION, batch, values, output, chosen_format, figure_paths)
        return
    values = case.case_values(QUESTION, values)
    with reported():
        launcher = drag_of(values)
    case.show(
        table=lambda: _table(float(launcher.epsilon)),
        columns=lambda: case.answer(QUESTION, values),
        output=output,
        chosen_format=chosen_format,
        figure="angles",
        figure_paths=figure_paths,
        figure_options={"epsilon": launcher.epsilon},
    )


def _table(epsilon: float) -> str:
    from archerfish.cli.terminal import definitions, grid_table

    found = compute({"epsilon": np.array([epsilon, 0.0])})
    rows = [
        [label, *(f"{value:.10f}" for value in found[f"{name}_deg"])]
        for name, label in NAMES.items()
    ]
    rows += [[label, *(f"{value:.10g}" for value in found[name])] for name, label in SHAPE.items()]
    title = "Launch angles (°)"
    return definitions([("drag parameter ε", f"{epsilon:g}")]) + grid_table(
        title, ["", "with drag", "drag-free"], rows, named_rows=True
    )

"""`archerfish aim`: the shots that hit a target, or how far out of reach it is."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from archerfish.cli import case
from archerfish.cli.batch import Extra, Question
from archerfish.cli.errors import reported
from archerfish.cli.options import file_format
from archerfish.cli.parameters import (
    CEILING,
    DRAGS,
    GRAVITY,
    HEIGHT,
    OBSTACLE,
    SPEED,
    WIND,
    Values,
    X,
    Y,
    Z,
    flags,
    launcher_of,
    wind_of,
)

if TYPE_CHECKING:
    from archerfish.aim import Aim, Unreachable

OUT_OF_REACH = 3
"""Exit status where a single target is."""

ARC_COLUMNS = (
    "launch_angle_deg",
    "azimuth_deg",
    "time_s",
    "apex_x_m",
    "apex_y_m",
    "impact_speed_m_per_s",
    "impact_angle_deg",
)
COLUMNS = (
    *(f"low_{name}" for name in ARC_COLUMNS),
    *(f"high_{name}" for name in ARC_COLUMNS),
    "margin_m",
    "minimum_speed_m_per_s",
    "status",
)
OVER = ("low_over_obstacle_m", "high_over_obstacle_m")
UNDER = ("low_under_ceiling_m", "high_under_ceiling_m")
STATUS = np.array(["reachable", "unreachable", "undefined"])


def aim_of(values: Values) -> Aim | Unreachable:
    """The answer for these targets."""
    targets = {name: values[name] for name in ("x", "y", "z") if name in values}
    places = {f"target {name}": value for name, value in targets.items()} | {
        each.name.replace("_", " "): values[each.name]
        for each in (*OBSTACLE, CEILING)
        if each.name in values
    }
    for name, value in places.items():
        if not np.all(np.isfinite(value)):
            raise ValueError(f"{name} must be finite, got {value!s}")
    return launcher_of(values).aim(**targets, height=values["height"], wind=wind_of(values))


def compute(values: Values) -> dict[str, Any]:
    """The columns of these targets."""
    from archerfish.aim import Unreachable

    found = aim_of(values)
    if isinstance(found, Unreachable):  # Only one target, in plain numbers, gives that.
        return {}
    columns: dict[str, Any] = {}
    for side, arc in (("low", found.low), ("high", found.high)):
        apex = arc.apex
        quantities = (
            np.degrees(arc.angle),
            np.where(np.isnan(arc.time), np.nan, np.degrees(arc.azimuth)),
            arc.time,
            apex.x,
            apex.y,
            arc.impact_speed,
            np.degrees(arc.impact_angle),
        )
        columns |= dict(zip((f"{side}_{name}" for name in ARC_COLUMNS), quantities, strict=True))
    arcs = (found.low, found.high)
    if "obstacle_x" in values:
        place = values["obstacle_x"], values["obstacle_y"]
        columns |= dict(zip(OVER, (arc.clearance_over(*place) for arc in arcs), strict=True))
    if "ceiling" in values:
        below = (arc.clearance_under(values["ceiling"]) for arc in arcs)
        columns |= dict(zip(UNDER, below, strict=True))
    margins = np.atleast_1d(found.margin).tolist()
    status = STATUS[np.atleast_1d(found.status)].tolist()
    return columns | {
        "margin_m": found.margin,
        "minimum_speed_m_per_s": found.minimum_speed,
        "status": status,
        "reason": [
            "" if word == "reachable" else f"out of reach: {_beyond(margin)}"
            for word, margin in zip(status, margins, strict=True)
        ],
    }


QUESTION = Question(
    required=(SPEED, X, Y),
    optional=(GRAVITY, *DRAGS, Z, HEIGHT, *WIND),
    columns=COLUMNS,
    compute=compute,
    extras=(Extra(OBSTACLE, OVER), Extra((CEILING,), UNDER)),
)


@click.command(
    epilog="""\b
Examples:
  archerfish aim --speed 10 --epsilon 0.1 --x 6 --y 2
  archerfish aim --speed 10 --epsilon 0.1 --x 6 --y 2 --obstacle 3 2.5 --ceiling 4
  archerfish aim --speed 25 --drag-rate 0.3 --x 30 --y 0 --z 5 --wind-z -4 --figure aim.svg
  archerfish aim --batch targets.csv --speed 10 --epsilon 0.1 --output arcs.csv
      columns x_m, y_m and any other parameter that differs from row to row;
      obstacle_x_m and obstacle_y_m, ceiling_m: how far each arc clears them
""",
)
@flags(*QUESTION.required, *QUESTION.optional)
@click.option(
    "--obstacle",
    "obstacles",
    type=(float, float),
    multiple=True,
    metavar="X Y",
    help="A point to pass over, m. May be repeated for a table.",
)
@flags(CEILING)
@case.destinations
def aim(
    batch: str | None,
    chosen_format: str | None,
    output: Path | None,
    figure_paths: tuple[Path, ...],
    obstacles: tuple[tuple[float, float], ...],
    **flags: float | None,
) -> int:
    """Aim at a target: both arcs that hit it, or how far above the envelope it is.

    Exit status 3 where a single target is out of reach. With --z the target is aimed at in space,
    by elevation and azimuth. Angles are in degrees, everything else in SI units.
    """
    values = case.given(flags)
    if obstacles:
        values |= dict(zip((each.name for each in OBSTACLE), obstacles[0], strict=True))
    table = batch is None and file_format(chosen_format, output, case.FORMATS) == "table"
    if len(obstacles) > 1 and not table:
        count = len(obstacles)
        raise click.UsageError(f"only a table has room for several --obstacle, got {count}")
    if batch is not None:
        case.run_batch(QUESTION, batch, values, output, chosen_format, figure_paths)
        return 0
    values = case.case_values(QUESTION, values)
    with reported():
        answer = aim_of(values)
    case.show(
        table=lambda: _table(answer, obstacles, values.get("ceiling")),
        columns=lambda: case.answer(QUESTION, values),
        output=output,
        chosen_format=chosen_format,
        figure="aim",
        figure_paths=figure_paths,
        figure_options={
            "launcher": launcher_of(values),
            "answer": answer,
            "height": values["height"],
            "wind": wind_of(values),
        },
    )
    return 0 if answer.reachable else OUT_OF_REACH


def _table(
    answer: Aim | Unreachable, obstacles: tuple[tuple[float, float], ...], ceiling: float | None
) -> str:
    from archerfish.aim import Unreachable
    from archerfish.cli.terminal import definitions, grid_table

    target = answer.target
    place = f"x = {target.x:g} m, y = {target.y:g} m" + (
        f", z = {target.z:g} m" if target.z else ""
    )
    least = ("least speed that reaches it", f"{answer.minimum_speed:.6g} m/s")
    if isinstance(answer, Unreachable):
        return definitions([("target", place), ("unreachable", _beyond(answer.margin)), least])
    arcs = (answer.low, answer.high)
    rows = [
        ["launch angle (°)", *(case.degrees(arc.angle) for arc in arcs)],
        ["azimuth (°)", *(case.degrees(arc.azimuth) for arc in arcs)],
        ["time to the target (s)", *(case.number(arc.time) for arc in arcs)],
        ["apex x (m)", *(case.number(arc.apex.x) for arc in arcs)],
        ["apex height y (m)", *(case.number(arc.apex.y) for arc in arcs)],
        ["impact speed (m/s)", *(case.number(arc.impact_speed) for arc in arcs)],
        ["impact angle (°)", *(case.degrees(arc.impact_angle) for arc in arcs)],
    ]
    if not any(arc.azimuth for arc in arcs):
        del rows[1]
    for x, y in obstacles:
        name = f"above {x:g} m, {y:g} m (m)"
        rows.append([name, *(_clearance(arc.clearance_over(x, y)) for arc in arcs)])
    if ceiling is not None:
        name = f"below {ceiling:g} m (m)"
        rows.append([name, *(_clearance(arc.clearance_under(ceiling)) for arc in arcs)])
    below = ("below the envelope", f"{-answer.margin:.6g} m")
    return definitions([("target", place), below, least]) + grid_table(
        "The two arcs", ["", "low", "high"], rows, named_rows=True
    )


def _beyond(margin: Any) -> str:
    """How far out of reach a target is."""
    if np.isinf(margin):
        return "beyond the distance V₀/b that drag allows"
    return f"{float(margin):.6g} m above the envelope of all shots"


def _clearance(value: Any) -> str:
    value = float(value)
    return "–" if np.isnan(value) else f"{value:.6g} {'clear' if value >= 0 else 'hits'}"

"""`archerfish shot`: one shot, or every shot of a CSV."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from archerfish.cli import case
from archerfish.cli.batch import Question
from archerfish.cli.errors import reported
from archerfish.cli.parameters import (
    ANGLE,
    AZIMUTH,
    DRAGS,
    GRAVITY,
    GROUND,
    HEIGHT,
    SPEED,
    WIND,
    Values,
    angle_of,
    flags,
    launcher_of,
    wind_of,
)
from archerfish.launcher import Launcher

if TYPE_CHECKING:
    from archerfish.shot import Shot

COLUMNS = (
    "apex_x_m",
    "apex_y_m",
    "apex_z_m",
    "apex_time_s",
    "landing_x_m",
    "landing_z_m",
    "flight_time_s",
    "landing_speed_m_per_s",
    "landing_angle_deg",
)


def shot_of(values: Values, launcher: Launcher | None = None) -> Shot:
    """The shot that these values describe."""
    return (launcher or launcher_of(values)).shot(
        angle_of(values),
        azimuth=np.radians(values["azimuth"]),
        height=values["height"],
        ground=values["ground"],
        wind=wind_of(values),
    )


def compute(values: Values) -> dict[str, Any]:
    """The columns of these shots."""
    shot = shot_of(values)
    apex, landing = shot.apex, shot.landing
    reasons = np.where(np.isnan(apex.time), "aimed downward: no apex", "")
    reasons = np.where(np.isnan(landing.time), "never comes down to the ground", reasons)
    found = (
        apex.x,
        apex.y,
        apex.z,
        apex.time,
        landing.x,
        landing.z,
        landing.time,
        landing.speed,
        np.degrees(landing.angle),
    )
    return dict(zip(COLUMNS, found, strict=True)) | {"reason": np.atleast_1d(reasons).tolist()}


QUESTION = Question(
    required=(SPEED, ANGLE),
    optional=(GRAVITY, *DRAGS, AZIMUTH, HEIGHT, GROUND, *WIND),
    columns=COLUMNS,
    compute=compute,
)


@click.command(
    epilog="""\b
Examples:
  archerfish shot --speed 10 --epsilon 0.1 --angle 45
  archerfish shot --speed 30 --terminal-speed 40 --angle 50 --wind-x -5 --figure shot.svg
  archerfish shot --batch shots.csv --output flights.csv
      columns speed_m_per_s, launch_angle_deg, epsilon (or drag_rate_per_s, …)
  archerfish shot --batch - --speed 10 --drag-rate 0.5 < angles.csv > flights.csv
      a flag holds for every row
""",
)
@flags(*QUESTION.parameters)
@case.destinations
def shot(
    batch: str | None,
    chosen_format: str | None,
    output: Path | None,
    figure_paths: tuple[Path, ...],
    **flags: float | None,
) -> None:
    """Fly one shot: apex, landing, time, speed; or every shot of a CSV.

    Give the drag by exactly one of --epsilon, --drag-rate and --terminal-speed. Angles are in
    degrees, everything else in SI units.
    """
    values = case.given(flags)
    if batch is not None:
        case.run_batch(QUESTION, batch, values, output, chosen_format, figure_paths)
        return
    values = case.case_values(QUESTION, values)
    with reported():
        one = shot_of(values)
    case.show(
        table=lambda: _table(one, values),
        columns=lambda: case.answer(QUESTION, values),
        output=output,
        chosen_format=chosen_format,
        figure="shot",
        figure_paths=figure_paths,
        figure_options={"shot": one},
    )


def _table(one: Shot, values: Values) -> str:
    from archerfish.cli.terminal import definitions, grid_table

    launcher = one.launcher
    free = shot_of(values, Launcher(launcher.speed, gravity=launcher.gravity, epsilon=0.0))
    scales = [
        ("speed V₀", f"{launcher.speed:g} m/s"),
        ("launch angle α", f"{values['angle']:g}°"),
        ("drag parameter ε", f"{launcher.epsilon:g}"),
        ("terminal speed", f"{launcher.terminal_speed:g} m/s"),
    ]
    wind = wind_of(values)
    if any(wind):
        scales.append(("wind", f"{', '.join(f'{part:g}' for part in wind)} m/s"))
    if values["height"] or values["ground"]:
        scales.append(("from, to height", f"{values['height']:g} m, {values['ground']:g} m"))
    pair = (one, free)
    rows = [
        ["apex x (m)", *(case.number(each.apex.x) for each in pair)],
        ["apex height y (m)", *(case.number(each.apex.y) for each in pair)],
        ["time to the apex (s)", *(case.number(each.apex.time) for each in pair)],
        ["range x (m)", *(case.number(each.range) for each in pair)],
        ["sideways z (m)", *(case.number(each.landing.z) for each in pair)],
        ["flight time (s)", *(case.number(each.flight_time) for each in pair)],
        ["landing speed (m/s)", *(case.number(each.landing.speed) for each in pair)],
        ["landing angle (°)", *(case.degrees(each.landing.angle) for each in pair)],
        ["length of the path (m)", *(case.number(each.path_length()) for each in pair)],
    ]
    if one.landing.z == 0:
        del rows[4]
    text = definitions(scales) + grid_table(
        "The shot", ["", "with drag", "drag-free"], rows, named_rows=True
    )
    if np.isnan(one.flight_time):
        text += "It never comes down to the ground.\n"
    return text

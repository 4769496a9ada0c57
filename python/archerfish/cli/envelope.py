"""`archerfish envelope`: what a launcher can reach."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
import numpy as np

from archerfish.cli import case
from archerfish.cli.batch import Question
from archerfish.cli.errors import reported
from archerfish.cli.parameters import DRAGS, GRAVITY, SPEED, Values, X, Y, flags, launcher_of
from archerfish.launcher import Launcher

FILE_POINTS, TABLE_POINTS = 101, 11
COLUMNS = ("envelope_height_m", "margin_m", "status")


def compute(values: Values) -> dict[str, Any]:
    """The columns of these places."""
    for name in ("x", "y"):
        if name in values and not np.all(np.isfinite(values[name])):
            raise ValueError(f"{name} must be finite, got {values[name]!s}")
    x = np.asarray(values["x"])
    height = np.asarray(launcher_of(values).envelope.height(x))
    if "y" not in values:
        nothing = np.full(x.shape, np.nan)
        return dict(zip(COLUMNS, (height, nothing, [""] * x.size), strict=True))
    margin = np.subtract(values["y"], height)
    status = np.where(margin <= 0, "reachable", "unreachable")
    return dict(zip(COLUMNS, (height, margin, np.atleast_1d(status).tolist()), strict=True))


QUESTION = Question(
    required=(SPEED, X), optional=(Y, GRAVITY, *DRAGS), columns=COLUMNS, compute=compute
)


@click.command(
    epilog="""\b
Examples:
  archerfish envelope --speed 10 --epsilon 0.1
  archerfish envelope --speed 10 --drag-rate 0.5 --output envelope.csv --figure envelope.svg
  archerfish envelope --batch places.csv --speed 10 --epsilon 0.1 --output heights.csv
      column x_m, and y_m to be told whether it can be hit
""",
)
@flags(SPEED, GRAVITY, *DRAGS)
@click.option(
    "--points",
    type=click.IntRange(2, 10_000_000),
    help=f"How many places.  [default: {FILE_POINTS} in CSV and JSON, {TABLE_POINTS} in a table]",
)
@case.destinations
def envelope(
    batch: str | None,
    chosen_format: str | None,
    output: Path | None,
    figure_paths: tuple[Path, ...],
    points: int | None,
    **flags: float | None,
) -> None:
    """The envelope of all shots of one speed: everything on or under it can be hit.

    One line a place, from the launcher to the farthest point of level ground.
    """
    values = case.given(flags)
    if batch is not None:
        if points is not None:
            raise click.UsageError("--points goes with one envelope, not a --batch")
        case.run_batch(QUESTION, batch, values, output, chosen_format, figure_paths)
        return
    if "speed" not in values:
        raise click.UsageError("Missing option '--speed'")
    with reported():
        launcher = launcher_of({"gravity": GRAVITY.default} | values)
    case.show(
        table=lambda: _table(launcher, points or TABLE_POINTS),
        columns=lambda: _places(launcher, points or FILE_POINTS),
        output=output,
        chosen_format=chosen_format,
        figure="envelope",
        figure_paths=figure_paths,
        figure_options={"launcher": launcher},
    )


def _places(launcher: Launcher, count: int) -> dict[str, list[float]]:
    x = np.linspace(0.0, float(launcher.envelope.reach), count)
    height = np.maximum(launcher.envelope.height(x), 0.0)  # The last is 0 but for rounding.
    return {"x_m": x.tolist(), "envelope_height_m": height.tolist()}


def _table(launcher: Launcher, count: int) -> str:
    from archerfish.cli.terminal import definitions, grid_table

    envelope, free = (
        launcher.envelope,
        Launcher(launcher.speed, gravity=launcher.gravity, epsilon=0.0).envelope,
    )
    best = launcher.named_angles().greatest_range
    places = _places(launcher, count)
    rows = [[f"{x:.6g}", f"{y:.6g}"] for x, y in zip(*places.values(), strict=True)]
    return definitions(
        [
            ("speed V₀", f"{launcher.speed:g} m/s"),
            ("drag parameter ε", f"{launcher.epsilon:g}"),
            ("highest", f"{envelope.highest:.6g} m (drag-free {free.highest:.6g} m)"),
            ("greatest range", f"{envelope.reach:.6g} m (drag-free {free.reach:.6g} m)"),
            ("  at launch angle", f"{np.degrees(best):.4f}°"),
            ("no shot gets to x", f"{envelope.wall:.6g} m"),
        ]
    ) + grid_table("The envelope", ["x (m)", "height (m)"], rows)

"""`archerfish locus`: the locus of one launcher as a summary, a table, a file, a picture."""

from __future__ import annotations

from pathlib import Path

import click
import numpy as np

from archerfish.cli.columns import columns, to_csv, to_json
from archerfish.cli.errors import reported
from archerfish.cli.options import OUTPUT_PATH, file_format
from archerfish.files import write_whole
from archerfish.launcher import STANDARD_GRAVITY, Launcher

FORMATS = ("table", "csv", "json")
#: Points in a file, one a degree, and in the terminal, one every ten degrees.
FILE_POINTS, TABLE_POINTS = 91, 10
MOST_POINTS = 10_000_000
TITLES = {
    "launch-angle": "Apexes, evenly spaced in launch angle",
    "elevation": "Apexes, evenly spaced in elevation",
}


@click.command(
    epilog="""\b
Examples:
  archerfish locus --speed 10 --epsilon 0.1
      summary and a short table
  archerfish locus --speed 10 --drag-rate 0.5 --format csv > locus.csv
      one line a degree of launch angle, every digit
  archerfish locus --speed 10 --terminal-speed 20 --by elevation --points 19
      evenly spaced as seen from the launch point
  archerfish locus --speed 10 --epsilon 0.1 --output locus.csv --figure figure1.svg
      a file and a picture, and the summary
""",
)
@click.option("--speed", type=float, required=True, help="Launch speed V₀, m/s, above 0.")
@click.option(
    "--gravity", type=float, default=STANDARD_GRAVITY, show_default=True, help="g, m/s², above 0."
)
@click.option("--epsilon", type=float, help="Drag parameter ε = b V₀/g, at least 0.")
@click.option("--drag-rate", type=float, help="Drag rate b, 1/s, at least 0.")
@click.option("--terminal-speed", type=float, help="Terminal speed g/b, m/s, above 0 (inf: none).")
@click.option(
    "--points",
    type=click.IntRange(2, MOST_POINTS),
    help=f"How many apexes, from 0 to 90 degrees.  [default: {FILE_POINTS} in CSV and JSON, "
    f"{TABLE_POINTS} in a table]",
)
@click.option(
    "--by",
    type=click.Choice(["launch-angle", "elevation"]),
    default="launch-angle",
    show_default=True,
    help="Which angle is evenly spaced.",
)
@click.option(
    "--format",
    "chosen_format",
    type=click.Choice(FORMATS),
    help="What to write.  [default: what --output ends in, else table]",
)
@click.option("--output", type=OUTPUT_PATH, help="Write there, and the summary to the terminal.")
@click.option(
    "--figure",
    "figure_paths",
    type=OUTPUT_PATH,
    multiple=True,
    help="Draw Figure 1 for this launcher: .svg, .png or .pdf. May be repeated.",
)
def locus(
    speed: float,
    gravity: float,
    epsilon: float | None,
    drag_rate: float | None,
    terminal_speed: float | None,
    points: int | None,
    by: str,
    chosen_format: str | None,
    output: Path | None,
    figure_paths: tuple[Path, ...],
) -> None:
    """The curve formed by the apexes of all shots of one speed.

    Give the drag by exactly one of --epsilon, --drag-rate and --terminal-speed. Angles are in
    degrees, everything else in SI units, and every column says so. CSV and JSON carry every digit.
    """
    with reported():
        launcher = Launcher(
            speed,
            gravity=gravity,
            epsilon=epsilon,
            drag_rate=drag_rate,
            terminal_speed=terminal_speed,
        )
    chosen = file_format(chosen_format, output, FORMATS)

    if figure_paths:
        # Only now: a run without a figure does not pay for the plotting library.
        from archerfish.cli.figure import draw

        draw(1, figure_paths, launcher=launcher)

    if chosen != "table":
        table = _points(launcher, by, points or FILE_POINTS)
        text = to_csv(table) if chosen == "csv" else to_json(launcher, table)
        if output is None:
            click.echo(text, nl=False)
            return
        write_whole(output, text.encode())

    from archerfish.cli import terminal

    short = _points(launcher, by, TABLE_POINTS if chosen != "table" else points or TABLE_POINTS)
    text = terminal.summary(launcher) + terminal.points_table(TITLES[by], short)
    if chosen == "table" and output is not None:
        write_whole(output, text.encode())
    else:
        click.echo(text, nl=False)
    for path in (*([output] if output else []), *figure_paths):
        click.echo(f"wrote {path}")


def _points(launcher: Launcher, by: str, count: int) -> dict[str, list[float]]:
    """Columns of `count` apexes, evenly spaced from 0 to 90 degrees in the angle asked for."""
    degrees = np.linspace(0.0, 90.0, count)
    if by == "elevation":
        table = columns(launcher.locus.at_elevation(np.radians(degrees)))
        return table | {"elevation_deg": degrees.tolist()}
    table = columns(launcher.locus.at_launch_angle(np.radians(degrees)))
    return table | {"launch_angle_deg": degrees.tolist()}

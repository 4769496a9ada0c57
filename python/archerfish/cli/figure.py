"""`archerfish figure N`: one of the figures into files."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import click

from archerfish.cli.errors import reported
from archerfish.cli.options import OUTPUT_PATH


@click.command(
    epilog="""\b
Figures:
  1  trajectories, the locus of their apexes, and the ellipse it is without drag
  2  elevation θ of the apex against launch angle α, and the inverse
  3  first and second derivative of α by θ
  4  curvature of the locus against α and against θ, its maximum marked
  5  the named angles against the drag parameter
  6  where the series for α(θ) converge

\b
Examples:
  archerfish figure 1
  archerfish figure 4 --output curvature.svg --output curvature.png
  archerfish figure 2 --epsilon 0.5 --epsilon 2
""",
)
@click.argument("number", type=int, metavar="N")
@click.option(
    "--output",
    "outputs",
    type=OUTPUT_PATH,
    multiple=True,
    help="Write there: .svg, .png or .pdf. May be repeated.  [default: figureN.svg]",
)
@click.option(
    "--epsilon",
    "epsilons",
    type=float,
    multiple=True,
    help="Drag parameters to draw instead of the figure's own. May be repeated.",
)
@click.option("--caption/--no-caption", default=True, show_default=True, help="Caption below.")
@click.option(
    "--dpi", type=click.IntRange(50, 2400), default=300, show_default=True, help="PNG only."
)
def figure(
    number: int, outputs: tuple[Path, ...], epsilons: tuple[float, ...], caption: bool, dpi: int
) -> None:
    """Draw figure N into files.

    `archerfish locus --figure` draws figure 1 for a launcher of your own.
    """
    options: dict[str, Any] = {"show_caption": caption, "dpi": dpi}
    if epsilons:
        with reported():
            options |= _drags(number, epsilons)
    paths = outputs or (Path(f"figure{number}.svg"),)
    draw(number, paths, **options)
    for path in paths:
        click.echo(f"wrote {path}")


def draw(number: int | str, paths: Iterable[Path], **options: Any) -> None:
    """Draw one figure into each path; refuse all before writing any."""
    from archerfish import figures
    from archerfish.figures.registry import figure as registered
    from archerfish.figures.save import SUFFIXES

    with reported():
        registered(number)
        for path in paths:
            if path.suffix.lower() not in SUFFIXES:
                raise ValueError(f"a figure must end in {', '.join(SUFFIXES)}, got {path}")
        for path in paths:
            figures.save(number, path, **options)


def _drags(number: int, epsilons: tuple[float, ...]) -> dict[str, Any]:
    """The data function's own words for the drag parameters asked for."""
    from archerfish.launcher import Launcher
    from archerfish.values import not_negative

    if number == 1:
        if len(epsilons) > 1:
            raise ValueError(f"figure 1 shows one epsilon, got {len(epsilons)}")
        return {"launcher": Launcher(10.0, epsilon=epsilons[0])}
    return {"epsilons": [not_negative("epsilon", value) for value in epsilons]}

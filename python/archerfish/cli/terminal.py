"""What a person sees in the terminal: the summary of a locus and a table of its points."""

from __future__ import annotations

import io
import math
import sys

from rich import box
from rich.console import Console
from rich.table import Table

from archerfish.cli.columns import NAMED_APEXES, Columns, columns
from archerfish.launcher import Launcher

#: Column name to heading.
HEADINGS = {
    "launch_angle_deg": "α (°)",
    "elevation_deg": "θ (°)",
    "x_m": "x (m)",
    "y_m": "y (m)",
    "distance_m": "r (m)",
    "time_s": "t (s)",
    "curvature_per_m": "K (1/m)",
}
NAMES = {
    "highest": "highest",
    "rightmost": "rightmost",
    "farthest": "farthest",
    "max_curvature": "sharpest bend",
}
SYMBOLS = """\
α launch angle, θ elevation seen from the launch point, r distance from it,
t time of flight, K curvature of the locus (sharpest bend: greatest K)
"""
#: Wide enough for every table here: a narrow terminal breaks lines, it does not lose digits.
WIDTH = 120


def summary(launcher: Launcher) -> str:
    """ε, ρ, terminal speed; the named apexes, length and area, each beside its drag-free value."""
    locus, free = launcher.locus, launcher.locus.drag_free
    scales = _grid()
    scales.add_row("speed V₀", f"{launcher.speed:g} m/s")
    scales.add_row("drag parameter ε", f"{launcher.epsilon:g}")
    scales.add_row("length scale ρ = V₀²/g", f"{launcher.length_scale:g} m")
    scales.add_row("terminal speed", f"{launcher.terminal_speed:g} m/s")

    rows: Columns = {name: [] for name in HEADINGS}
    for name in NAMED_APEXES:
        for curve in (locus, free):
            for column, values in columns(getattr(curve, name)).items():
                rows[column] += values
    apexes = _table("Named apexes")
    apexes.add_column("", no_wrap=True)
    for heading in HEADINGS.values():
        apexes.add_column(heading, justify="right", no_wrap=True)
    for index, cells in enumerate(_rows(rows)):
        if index % 2 == 0:
            apexes.add_row(NAMES[NAMED_APEXES[index // 2]], *cells)
        else:
            apexes.add_row("  drag-free", *cells, style="dim")

    whole = _table("The locus, from the launch point to the highest apex")
    for heading in ("", "with drag", "drag-free", "ratio"):
        whole.add_column(heading, justify="right" if heading else "left", no_wrap=True)
    bend, free_bend = locus.max_curvature.curvature, free.max_curvature.curvature
    for label, mine, theirs in (
        ("greatest curvature K (1/m)", bend, free_bend),
        ("greatest ρK", bend * launcher.length_scale, free_bend * launcher.length_scale),
        ("length (m)", locus.arc_length(), free.arc_length()),
        ("area to the vertical axis (m²)", locus.area, free.area),
    ):
        ratio = f"{mine / theirs:.4g}" if theirs else ""
        whole.add_row(label, f"{mine:.6g}", f"{theirs:.6g}", ratio)
    return _render(scales, apexes) + SYMBOLS + "\n" + _render(whole)


def points_table(title: str, points: Columns) -> str:
    """The points as a table, six digits of the greatest value in each column."""
    table = _table(title)
    for heading in HEADINGS.values():
        table.add_column(heading, justify="right", no_wrap=True)
    for cells in _rows(points):
        table.add_row(*cells)
    return _render(table)


def definitions(rows: list[tuple[str, str]]) -> str:
    """Names and what they are, one a line."""
    grid = _grid()
    for row in rows:
        grid.add_row(*row)
    return _render(grid)


def grid_table(
    title: str, headings: list[str], rows: list[list[str]], *, named_rows: bool = False
) -> str:
    """A table of ready-made cells; with `named_rows` the first column is one of names."""
    table = _table(title)
    for index, heading in enumerate(headings):
        left = named_rows and index == 0
        table.add_column(heading, justify="left" if left else "right", no_wrap=True)
    for row in rows:
        table.add_row(*row)
    return _render(table)


def _rows(table: Columns) -> list[list[str]]:
    return [list(row) for row in zip(*(_cells(*item) for item in table.items()), strict=True)]


def _cells(name: str, values: list[float]) -> list[str]:
    """One column as text, on one scale, so that digits line up."""
    if name.endswith("_deg"):
        return [f"{value:.4f}" for value in values]
    greatest = max((abs(value) for value in values if math.isfinite(value)), default=0.0)
    # cos 90° is 6e-17 and not 0: on the scale of its column such a value is nothing.
    values = [0.0 if abs(value) < 1e-13 * greatest else value for value in values]
    if greatest == 0.0 or not 1e-3 <= greatest < 1e6:
        return [f"{value:.4e}" for value in values]
    decimals = max(0, 5 - math.floor(math.log10(greatest)))
    return [f"{value:.{decimals}f}" for value in values]


def _table(title: str) -> Table:
    return Table(
        title=title, title_justify="left", title_style="bold", box=box.SIMPLE_HEAD, show_edge=False
    )


def _grid() -> Table:
    grid = Table.grid(padding=(0, 2))
    grid.add_column(style="bold")
    grid.add_column(justify="left")
    return grid


def _render(*tables: Table) -> str:
    """The tables as text, with colours where standard output is a terminal that shows them."""
    console = Console(
        file=io.StringIO(),
        force_terminal=sys.stdout.isatty(),
        width=WIDTH,
        highlight=False,
        emoji=False,
    )
    with console.capture() as capture:
        for table in tables:
            console.print(table)
            console.print()
    return "\n".join(line.rstrip() for line in capture.get().splitlines()) + "\n"

"""What the commands about shots share: one case or a batch, and where the answer goes."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click
import numpy as np

from archerfish.cli.columns import to_csv
from archerfish.cli.errors import reported
from archerfish.cli.options import OUTPUT_PATH, file_format
from archerfish.cli.parameters import Values
from archerfish.files import write_whole

FORMATS = ("table", "csv", "json")
Function = TypeVar("Function", bound=Callable[..., Any])


def destinations(function: Function) -> Function:
    """A decorator: `--batch`, `--format`, `--output` and `--figure`."""
    for option in (
        click.option(
            "--figure",
            "figure_paths",
            type=OUTPUT_PATH,
            multiple=True,
            help="Draw it: .svg, .png or .pdf. May be repeated.",
        ),
        click.option(
            "--output", type=OUTPUT_PATH, help="Write there, and the table to the terminal."
        ),
        click.option(
            "--format",
            "chosen_format",
            type=click.Choice(FORMATS),
            help="What to write.  [default: what --output ends in, else table]",
        ),
        click.option(
            "--batch",
            metavar="FILE",
            help="Answer every row of this CSV ('-': standard input), into a CSV.",
        ),
    ):
        function = option(function)
    return function


def given(values: dict[str, float | None]) -> dict[str, float]:
    """The flags that were given."""
    return {name: value for name, value in values.items() if value is not None}


def run_batch(
    question: Any,
    source: str,
    values: Values,
    output: Path | None,
    chosen_format: str | None,
    figure_paths: tuple[Path, ...],
) -> None:
    """Answer a batch, which makes a CSV and nothing else."""
    from archerfish.cli import batch

    if figure_paths:
        raise click.UsageError("--figure draws one case, not a --batch")
    if chosen_format not in (None, "csv"):
        raise click.UsageError(f"--batch writes csv, got --format {chosen_format}")
    command = click.get_current_context().command_path
    batch.run_batch(question, source, values, output, command)


def case_values(question: Any, values: dict[str, float]) -> dict[str, float]:
    """The values of one case, defaults filled in; a usage error where one is missing."""
    for parameter in question.required:
        if parameter.name not in values:
            raise click.UsageError(f"Missing option '{parameter.flag}'")
    defaults = {
        parameter.name: parameter.default
        for parameter in question.parameters
        if parameter.default is not None
    }
    return defaults | values


def show(
    *,
    table: Callable[[], str],
    columns: Callable[[], dict[str, list[Any]]],
    output: Path | None,
    chosen_format: str | None,
    figure: str,
    figure_paths: tuple[Path, ...],
    figure_options: dict[str, Any],
) -> None:
    """Write one case: table, CSV or JSON, to the terminal or a file, and its pictures."""
    chosen = file_format(chosen_format, output, FORMATS)
    if figure_paths:
        from archerfish.cli.figure import draw

        draw(figure, figure_paths, **figure_options)
    text = ""
    if chosen != "table":
        found = columns()
        text = to_csv(found) if chosen == "csv" else _to_json(found)
        if output is None:
            click.echo(text, nl=False)
            return
        write_whole(output, text.encode())
        text = table()
        click.echo(text, nl=False)
    else:
        text = table()
        if output is not None:
            write_whole(output, text.encode())
        else:
            click.echo(text, nl=False)
    for path in (*([output] if output else []), *figure_paths):
        click.echo(f"wrote {path}")


def answer(question: Any, values: Values) -> dict[str, list[Any]]:
    """One row of the same columns that a batch has, the parameters first."""
    with reported():
        found = question.compute({name: np.array([value]) for name, value in values.items()})
    asked = {
        parameter.column: [values[parameter.name]]
        for parameter in question.parameters
        if parameter.name in values
    }
    answers = {
        name: column if isinstance(column, list) else np.asarray(column).tolist()
        for name, column in found.items()
    }
    ordered = {name: answers[name] for name in question.answered(values)}
    return asked | ordered | {"reason": answers.get("reason", [""])}


def _to_json(columns: dict[str, list[Any]]) -> str:
    """A list of objects, or one object where there is one row; null for what is not a number."""
    rows = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
    for row in rows:
        for name, value in row.items():
            if isinstance(value, float) and not math.isfinite(value):
                row[name] = None
    document = rows[0] if len(rows) == 1 else rows
    return json.dumps(document, indent=2, allow_nan=False, ensure_ascii=False) + "\n"


def number(value: Any, digits: int = 6) -> str:
    """A number for a table: six significant digits; nothing where there is none."""
    value = float(value)
    return "–" if math.isnan(value) else f"{value:.{digits}g}"


def degrees(value: Any) -> str:
    """An angle for a table, in degrees."""
    value = float(np.degrees(value))
    return "–" if math.isnan(value) else f"{value:.4f}"

"""Flags that several commands share."""

from __future__ import annotations

from pathlib import Path

import click

#: A path to write to; whether that works is found out by writing.
OUTPUT_PATH = click.Path(path_type=Path)


def file_format(chosen: str | None, output: Path | None, formats: tuple[str, ...]) -> str:
    """The format asked for; else the one `output` ends in; else the first."""
    if chosen is not None:
        return chosen
    suffix = output.suffix.lower().lstrip(".") if output is not None else ""
    return suffix if suffix in formats else formats[0]

"""Figures into files: the file appears whole or not at all."""

from __future__ import annotations

import io
import os
import textwrap
from pathlib import Path
from typing import TYPE_CHECKING, Any

from archerfish.files import write_whole

from . import style
from .registry import Figure, figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

SUFFIXES = (".png", ".svg", ".pdf")
MINIMUM_DPI = 50
CAPTION_SIZE = 8.0
"""Size of the caption's type, points."""
CHARACTER = 0.42
"""Mean width of a character of the caption, a little more than it is, in ems."""
CAPTION_MARGIN = 0.08
"""Space round the caption, inches."""


def caption(number: int, **options: Any) -> str:
    """Return the caption of a figure; ``options`` go to its data function.

    >>> caption(2, epsilons=[0.5]).startswith("Figure 2. Elevation θ of the apex against")
    True
    """
    chosen = figure(number)
    return chosen.caption(chosen.data(**options))


def save(
    number: int | str,
    path: str | os.PathLike[str],
    *,
    show_caption: bool = True,
    dpi: int = 300,
    **options: Any,
) -> Path:
    """Draw figure ``number`` into ``path`` and return the path.

    ``number`` may be the name ``shot``, ``aim``, ``envelope`` or ``angles`` of a figure of shots.
    The suffix of ``path`` chooses PNG, SVG or PDF; ``dpi`` is for PNG only. ``options`` go to the
    figure's data function (``launcher`` for figure 1, ``epsilons`` for the others). The same input
    gives the same bytes.
    ValueError: no such figure or suffix. OSError: the path cannot be written; then nothing is left
    behind, and a file that was there is untouched. ImportError: matplotlib is not installed.

    >>> from archerfish.figures import save
    >>> save(7, "figure7.png")
    Traceback (most recent call last):
    ...
    ValueError: figure must be from 1 to 6, got 7
    """
    target = Path(path)
    chosen = figure(number)
    suffix = target.suffix.lower()
    if suffix not in SUFFIXES:
        raise ValueError(f"a figure's file must end in {', '.join(SUFFIXES)}, got {target.name}")
    data = chosen.data(**options)
    content = render(chosen, data, suffix[1:], show_caption=show_caption, dpi=dpi)
    write_whole(target, content)
    return target


def render(
    chosen: Figure, data: Any, file_format: str, *, show_caption: bool = True, dpi: int = 300
) -> bytes:
    """Return the drawn figure as the bytes of a PNG, SVG or PDF file."""
    try:
        from matplotlib.figure import Figure as Canvas
    except ImportError as error:
        raise ImportError("figures need matplotlib: pip install 'archerfish[figures]'") from error
    text = chosen.caption(data)
    buffer = io.BytesIO()
    with style.context():
        canvas = Canvas(figsize=chosen.size(data) if callable(chosen.size) else chosen.size)
        chosen.draw(new_axes(canvas, chosen, data), data)
        if show_caption:
            add_caption(canvas, text)
        canvas.savefig(buffer, format=file_format, dpi=dpi, metadata=metadata(file_format, text))
    return buffer.getvalue()


def new_axes(canvas: Canvas, chosen: Figure, data: Any) -> Any:
    """Return what the drawing function takes: one axes, or a list of them side by side."""
    if chosen.panels is None:
        return canvas.subplots()
    return list(canvas.subplots(1, chosen.panels(data), squeeze=False)[0])


def add_caption(canvas: Canvas, text: str) -> None:
    """Make the figure taller and set the caption, wrapped, under it."""
    width, height = canvas.get_size_inches()
    em = CAPTION_SIZE / 72.0
    lines = textwrap.wrap(text, int((width - 2.0 * CAPTION_MARGIN) / (CHARACTER * em)))
    below = 1.25 * em * len(lines) + 2.0 * CAPTION_MARGIN
    whole = height + below
    canvas.set_size_inches(width, whole)
    engine = canvas.get_layout_engine()
    assert engine is not None
    engine.set(rect=(0.0, below / whole, 1.0, height / whole))  # type: ignore[call-arg]
    canvas.text(
        CAPTION_MARGIN / width,
        (below - CAPTION_MARGIN) / whole,
        style.typeset("\n".join(lines)),
        size=CAPTION_SIZE,
        va="top",
        linespacing=1.25,
    )


def metadata(file_format: str, text: str) -> dict[str, str | None]:
    """Return a title and description for readers of the file, and no date."""
    title = text.split(".", 1)[0]
    if file_format == "svg":
        return {"Title": title, "Description": text, "Date": None, "Creator": "archerfish"}
    if file_format == "pdf":
        return {"Title": title, "Subject": text, "CreationDate": None, "Creator": "archerfish"}
    return {"Title": title, "Description": text, "Software": "archerfish"}

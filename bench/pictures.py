"""The measurements as two pictures: bars beside each other, and cost against length."""

from __future__ import annotations

import io
from typing import Any

from archerfish.figures import style
from bench.speed import BARS, UNIT, Rows, kernel_and_name


def bars(rows: Rows, isa: str) -> bytes:
    """SVG of every contender's time on a logarithmic axis, kernel by kernel."""
    import matplotlib.pyplot as plt

    allowed = {"avx512": 1.0, "avx2": 2.0}.get(isa)
    shown = [
        (*kernel_and_name(name), row["logarithms"]) for name, row in rows.items() if name != UNIT
    ]
    with style.context():
        figure, axes = plt.subplots(figsize=(style.PAGE_WIDTH, 0.16 * len(shown) + 0.6))
        labels = []
        for y, (kernel, name, time) in enumerate(shown):
            ours = name == "archerfish"
            axes.barh(y, time, color=style.BLUE if ours else style.GREY, height=0.75)
            bar = BARS[kernel] * allowed if ours and allowed and kernel in BARS else 0.0
            axes.annotate(
                f"{time:.3g}",
                (max(time, bar), y),
                (3, 0),
                textcoords="offset points",
                va="center",
                fontsize=7,
            )
            labels.append(kernel if ours else name.replace("₀", "$_0$").replace("α", r"$\alpha$"))
            if bar:
                axes.plot([bar, bar], [y - 0.5, y + 0.5], color=style.VERMILLION)
        axes.set_xscale("log")
        axes.set_xlim(0.5, 6 * max(time for *_, time in shown))
        axes.set_ylim(len(shown) - 0.4, -0.6)
        axes.set_yticks(range(len(shown)), labels, fontsize=7)
        for tick, (_, name, _) in zip(axes.get_yticklabels(), shown, strict=True):
            tick.set_color(style.BLACK if name == "archerfish" else style.GREY)
        axes.tick_params(axis="y", length=0)
        axes.set_xlabel(
            "time an element, in units of np.log (blue: archerfish; red: what it may take)"
        )
        return svg(figure)


def lengths(tables: dict[str, dict[str, float]]) -> bytes:
    """SVG of nanoseconds an element against the length of the array."""
    import matplotlib.pyplot as plt

    with style.context():
        figure, axes = plt.subplots(figsize=(style.PAGE_WIDTH, 3.2))
        for index, (name, row) in enumerate(tables.items()):
            stroke = style.stroke(index)
            counts = [int(count) for count in row]
            axes.plot(counts, list(row.values()), label=name, marker=stroke.marker, **stroke.line())
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel("elements of the array")
        axes.set_ylabel("time an element (ns)")
        axes.legend()
        return svg(figure)


def svg(figure: Any) -> bytes:
    """The figure as a file that is the same for the same numbers."""
    import matplotlib.pyplot as plt

    room = io.BytesIO()
    figure.savefig(room, format="svg", metadata={"Date": None})
    plt.close(figure)
    return room.getvalue()

"""How every figure looks: sizes, fonts, colours and dashes, in one place.

Colours are Okabe and Ito's, chosen to stay apart for colour-blind readers. Two of them can still
print as one grey, so no curve is told from another by colour alone: each also has its own dashes,
and a label beside it or in a legend.
"""

from __future__ import annotations

from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any, TypeAlias

COLUMN_WIDTH = 3.4
"""Width of one journal column, inches."""

PAGE_WIDTH = 7.0
"""Width of a two-column figure, inches."""

BLACK = "#000000"
BLUE = "#0072B2"
VERMILLION = "#D55E00"
RED = "#C1121F"
GREEN = "#009E73"
PURPLE = "#CC79A7"
ORANGE = "#E69F00"
SKY = "#56B4E9"
GREY = "#7F7F7F"

FAINT = 0.4
"""Line width of trajectories and of guides, points."""


Dashes: TypeAlias = "str | tuple[float, tuple[float, ...]]"
"""A matplotlib line style: a name, or an offset and lengths on and off."""


@dataclass(frozen=True)
class Stroke:
    """Colour, dashes and marker of one curve."""

    color: str
    dashes: Dashes
    marker: str

    def line(self) -> dict[str, Any]:
        """Keyword arguments for a line."""
        return {"color": self.color, "linestyle": self.dashes}


SERIES = (
    Stroke(BLACK, "-", "o"),
    Stroke(BLUE, (0, (6, 1.5)), "s"),
    Stroke(VERMILLION, (0, (5, 1.5, 1, 1.5)), "^"),
    Stroke(GREEN, (0, (2.5, 1)), "D"),
    Stroke(PURPLE, (0, (1, 1)), "v"),
    Stroke(ORANGE, (0, (5, 1, 1, 1, 1, 1)), "P"),
)
"""Strokes for a family of curves, in order."""

LENGTH_UNITS = (("nm", 1e-9), ("µm", 1e-6), ("mm", 1e-3), ("m", 1.0), ("km", 1e3))
"""Units of length and their metres, rising."""

SYMBOLS = {
    "bV₀/g": r"$bV_0/g$",
    "V₀²/g": r"$V_0^2/g$",
    "V₀": r"$V_0$",
    "√3/2": r"$\sqrt{3}/2$",
    "ρK": r"$\rho K$",
    " K ": r" $K$ ",
    "d²α/dθ²": r"$\mathrm{d}^2\alpha/\mathrm{d}\theta^2$",
    "dα/dθ": r"$\mathrm{d}\alpha/\mathrm{d}\theta$",
    "α(θ)": r"$\alpha(\theta)$",
    " α": r" $\alpha$",
    " θ": r" $\theta$",
    " ε": r" $\varepsilon$",
    "8ε": r"$8\varepsilon$",
    " ρ ": r" $\rho$ ",
}
"""Symbols of the captions, longest first, as matplotlib typesets them."""

RC: dict[str, Any] = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 9.0,
    "axes.labelsize": 9.0,
    "axes.titlesize": 9.0,
    "legend.fontsize": 8.0,
    "xtick.labelsize": 8.0,
    "ytick.labelsize": 8.0,
    "axes.linewidth": 0.6,
    "lines.linewidth": 1.2,
    "lines.markersize": 4.0,
    "lines.dash_capstyle": "butt",
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.minor.width": 0.4,
    "ytick.minor.width": 0.4,
    "legend.frameon": False,
    "legend.handlelength": 2.8,
    "legend.borderaxespad": 0.6,
    "figure.constrained_layout.use": True,
    "axes.unicode_minus": True,
    # The same input gives the same file: glyphs as outlines, ids from a fixed salt.
    "svg.fonttype": "path",
    "svg.hashsalt": "archerfish",
    "pdf.fonttype": 42,
}
"""matplotlib settings under which figures are made and saved."""


def context() -> AbstractContextManager[None]:
    """Return a context in which matplotlib has this style and nothing of the user's."""
    import matplotlib.style

    return matplotlib.style.context(["default", RC])


def stroke(index: int) -> Stroke:
    """Return the stroke of the ``index``-th curve of a family, starting again after the last."""
    return SERIES[index % len(SERIES)]


def epsilon_label(epsilon: float) -> str:
    """Return ``ε = value`` for a legend, in matplotlib's mathematics."""
    mantissa, _, exponent = f"{epsilon:g}".partition("e")
    power = rf" \times 10^{{{int(exponent)}}}" if exponent else ""
    return rf"$\varepsilon = {mantissa}{power}$"


def degree_axis(axis: Any, step: float, lowest: float = 0.0, highest: float = 90.0) -> None:
    """Put ticks on a matplotlib axis every ``step`` degrees, ends included."""
    count = round((highest - lowest) / step)
    axis.set_ticks([lowest + step * index for index in range(count + 1)])


def plain_ticks(axis: Any) -> None:
    """Write short numbers at the ticks of a matplotlib axis, without a common factor beside it."""
    from matplotlib.ticker import FuncFormatter

    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def plain_log_ticks(axis: Any, steps: tuple[float, ...] = (1.0,)) -> None:
    """Write plain numbers at ``steps`` in every decade of a logarithmic matplotlib axis.

    Over more than three decades: at the powers of ten only.
    """
    from matplotlib.ticker import LogLocator, NullFormatter

    low, high = axis.get_view_interval()
    axis.set_major_locator(LogLocator(base=10.0, subs=steps if high < 1e3 * low else (1.0,)))
    plain_ticks(axis)
    axis.set_minor_formatter(NullFormatter())


def length_unit(length: float) -> tuple[str, float]:
    """Return the unit in which a length, in metres, is from 1 to 1000, and its metres.

    Metres for figure 1 of the paper; droplets and spores fly micrometres.
    """
    fitting = [unit for unit in LENGTH_UNITS if unit[1] <= length]
    return fitting[-1] if fitting else LENGTH_UNITS[0]


def panel_label(ax: Any, letter: str, what: str = "") -> None:
    """Write ``(a)``, ``(b)``, … and what the panel shows above its upper left corner."""
    ax.set_title(f"({letter}) {what}".rstrip(), loc="left", pad=4.0)


def typeset(text: str) -> str:
    """Return plain text with its symbols in matplotlib's mathematics, as in the axis labels."""
    for plain, symbol in SYMBOLS.items():
        text = text.replace(plain, symbol)
    return text

"""What the drawing functions put on their axes."""

import itertools

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure as Canvas

from archerfish import Launcher
from archerfish.figures import FIGURES, style
from archerfish.figures.save import new_axes


@pytest.fixture(params=sorted(FIGURES))
def drawn(request):
    """One figure drawn on plain axes: its number, the axes, the data."""
    figure = FIGURES[request.param]
    data = figure.data()
    axes = new_axes(Canvas(), figure, data)
    figure.draw(axes, data)
    return request.param, axes if isinstance(axes, list) else [axes], data


def test_axes_are_named_with_units(drawn):
    number, axes, _ = drawn
    labels = [ax.get_xlabel() for ax in axes] + [ax.get_ylabel() for ax in axes]
    unit = {1: "(m)", 2: "(°)", 3: "(°)", 4: "(°)"}.get(number, "")
    assert unit in axes[0].get_xlabel()
    assert any(labels[len(axes) :])


def test_no_two_curves_of_a_panel_look_alike_without_colour(drawn):
    """Curves that share both dashes and lightness must be one family (as the trajectories are)."""
    _, axes, _ = drawn
    for ax in axes:
        handles, labels = ax.get_legend_handles_labels()
        assert len(labels) == len(set(labels))
        for one, other in itertools.combinations(handles, 2):
            same_dashes = dashes(one) == dashes(other)
            contrast = abs(lightness(one.get_color()) - lightness(other.get_color()))
            thickness = one.get_linewidth() / other.get_linewidth()
            assert not same_dashes or contrast > 0.25 or not 0.4 < thickness < 2.5


def dashes(line):
    return line._unscaled_dash_pattern  # no public name for it


def lightness(color):
    """CIE L*, from 0 to 1: what is left of a colour in print without colour."""
    channel = np.array(to_rgb(color))
    linear = np.where(channel <= 0.04045, channel / 12.92, ((channel + 0.055) / 1.055) ** 2.4)
    luminance = linear @ [0.2126, 0.7152, 0.0722]
    return 1.16 * np.cbrt(luminance) - 0.16


def test_colours_stay_apart_from_the_page():
    assert all(lightness(stroke.color) < 0.75 for stroke in style.SERIES)


def test_series_have_dashes_and_markers_of_their_own():
    assert len({stroke.dashes for stroke in style.SERIES}) == len(style.SERIES)
    assert len({stroke.marker for stroke in style.SERIES}) == len(style.SERIES)


def test_figure_1_as_the_issue_asks():
    data = FIGURES[1].data()
    ax = Canvas().subplots()
    FIGURES[1].draw(ax, data)
    lines = {line.get_label(): line for line in ax.get_lines()}
    assert ax.get_aspect() == 1.0
    assert lines["trajectories"].get_color() == style.BLACK
    assert lines["trajectories"].get_linewidth() < 0.5
    assert lines["locus of apexes"].get_color() == style.BLUE
    ellipse = lines["locus without drag (ellipse)"]
    assert ellipse.get_color() == style.RED
    assert ellipse.is_dashed()
    assert ax.get_xlim()[1] > data.x.max()
    assert ax.get_ylim()[1] > data.drag_free_y.max()


def test_captions_are_complete():
    for number, figure in FIGURES.items():
        text = figure.caption(figure.data())
        assert text.startswith(f"Figure {number}. ")
        assert text.endswith(".")
        assert text.isprintable()
        assert "ε" in text


def test_every_symbol_of_the_captions_is_typeset():
    for figure in FIGURES.values():
        left = style.typeset(figure.caption(figure.data()))
        assert not set("αθερ₀√") & set(left)


def test_small_launchers_get_small_units():
    data = FIGURES[1].data(Launcher(0.01, epsilon=1.0))
    ax = Canvas().subplots()
    FIGURES[1].draw(ax, data)
    assert ax.get_xlabel() == "horizontal distance $x$ (µm)"
    lines = {line.get_label(): line for line in ax.get_lines()}
    np.testing.assert_allclose(lines["locus of apexes"].get_ydata(), 1e6 * data.locus_y)


@pytest.mark.parametrize(
    ("metres", "unit"),
    [(5.1, "m"), (1.0, "m"), (0.999, "mm"), (1e-9, "nm"), (1e-30, "nm"), (1e9, "km")],
)
def test_length_unit(metres, unit):
    assert style.length_unit(metres)[0] == unit


@pytest.mark.parametrize(
    ("epsilon", "text"),
    [(0.1, "0.1"), (1e8, r"1 \times 10^{8}"), (2.5e-7, r"2.5 \times 10^{-7}")],
)
def test_epsilon_label(epsilon, text):
    assert style.epsilon_label(epsilon) == rf"$\varepsilon = {text}$"


def test_wide_log_axes_keep_ticks():
    data = FIGURES[4].data([0.0, 1e8])
    axes = list(Canvas().subplots(1, 2))
    FIGURES[4].draw(axes, data)
    low, high = axes[0].get_ylim()
    ticks = axes[0].get_yticks()
    assert 3 <= np.count_nonzero((ticks >= low) & (ticks <= high)) <= 12

"""The figures of shots: data that are the library's, curves that are named."""

import numpy as np
import pytest
from matplotlib.figure import Figure as Canvas

from archerfish import Launcher
from archerfish.figures import save
from archerfish.figures.registry import SHOT_FIGURES
from archerfish.figures.shots import aim_data, angles_data, envelope_data, shot_data

LAUNCHER = Launcher(10.0, epsilon=0.1)


def drawn(name, *arguments, **options):
    figure = SHOT_FIGURES[name]
    data = figure.data(*arguments, **options)
    axes = Canvas().subplots()
    figure.draw(axes, data)
    return data, axes, figure.caption(data)


def labels(axes):
    return axes.get_legend_handles_labels()[1]


def test_the_apex_of_the_shot_is_on_the_locus():
    for shot in (LAUNCHER.shot(0.7), LAUNCHER.shot(2.2, height=2.0, wind=(-8.0, 1.0))):
        data, axes, caption = drawn("shot", shot)
        assert data.apex == (shot.apex.x, shot.apex.y)
        near = np.hypot(data.locus_x - shot.apex.x, data.locus_y - shot.apex.y).min()
        assert near < 0.1
        assert data.y[-1] == pytest.approx(0.0, abs=1e-12)
        assert labels(axes) == ["without drag", "locus of apexes", "shot"]
        assert f"α = {np.degrees(shot.angle):g}°" in caption
        assert axes.get_aspect() == 1.0


def test_captions_tell_of_the_wind_and_of_the_third_coordinate():
    _, _, calm = drawn("shot", LAUNCHER.shot(0.7))
    _, _, windy = drawn("shot", LAUNCHER.shot(0.7, wind=(-8.0, 1.0)))
    assert "wind" not in calm
    assert "in a wind of (-8, 1) m/s" in windy
    wind = (0.0, 0.0, -4.0)
    _, _, aside = drawn("aim", LAUNCHER, LAUNCHER.aim(4.0, 2.0, 1.0, wind=wind), 0.0, wind)
    assert "(4 m, 2 m, 1 m)" in aside
    assert "in a wind of (0, 0, -4) m/s" in aside
    assert "Seen from the side" in aside


def test_a_shot_that_never_lands_is_drawn_too():
    data = shot_data(LAUNCHER.shot(0.7, ground=9.0))
    assert np.isfinite(data.x).all()


def test_both_arcs_end_on_the_target_under_the_envelope():
    for wind in (None, (-6.0, 1.0)):
        data, axes, caption = drawn("aim", LAUNCHER, LAUNCHER.aim(5.0, 2.0, wind=wind), 0.0, wind)
        for x, y in data.arcs:
            assert (x[-1], y[-1]) == pytest.approx((5.0, 2.0), rel=1e-12)
            inside = (x > data.envelope_x.min()) & (x < data.envelope_x.max())
            order = np.argsort(data.envelope_x)
            envelope = np.interp(x[inside], data.envelope_x[order], data.envelope_y[order])
            assert np.all(y[inside] <= envelope + 1e-3)
        assert labels(axes) == ["envelope", "low arc", "high arc", "target"]
        assert caption.startswith("Both arcs")


def test_a_target_out_of_reach_is_above_the_envelope():
    data, axes, caption = drawn("aim", LAUNCHER, LAUNCHER.aim(9.0, 3.0))
    assert np.interp(9.0, data.envelope_x, data.envelope_y) == pytest.approx(
        3.0 - data.margin, abs=1e-3
    )
    assert labels(axes) == ["envelope", "target, out of reach"]
    assert "2.673 m above the envelope" in caption
    beyond = aim_data(LAUNCHER, LAUNCHER.aim(200.0, -3.0))
    assert np.isfinite(beyond.envelope_y).all()


def test_the_fan_is_under_the_envelope():
    for data in (envelope_data(LAUNCHER), angles_data(1.0)):
        envelope = np.interp(data.x, data.envelope_x, data.envelope_y)
        assert np.all(data.y <= envelope + 1e-4 * envelope.max())
    _, axes, caption = drawn("angles", 0.1)
    assert labels(axes)[0] == "greatest range, 43.71°"
    assert "named angles" in caption
    _, axes, caption = drawn("envelope", LAUNCHER)
    assert labels(axes) == ["shots", "envelope"]
    assert "10°, 20°" in caption


def test_the_page_suits_the_data():
    flat, steep = (SHOT_FIGURES["shot"].size(shot_data(LAUNCHER.shot(a))) for a in (0.7, 1.5))
    assert flat[0] == steep[0]
    assert flat[1] < steep[1]


def test_saved_under_their_names(tmp_path):
    path = save("aim", tmp_path / "a.svg", launcher=LAUNCHER, answer=LAUNCHER.aim(6.0, 2.0))
    assert "Both arcs" in path.read_text()
    with pytest.raises(ValueError, match="figure must be from 1 to 6, got shots"):
        save("shots", tmp_path / "b.svg")

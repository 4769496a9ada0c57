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


@pytest.mark.parametrize(
    ("angle", "height", "wind", "epsilon"),
    [
        (60, 0.0, (-8.0, 0.0), 1.0),  # blown to the other side of the launcher
        (120, 2.0, (30.0, 0.0), 0.1),
        (60, 0.0, (0.0, 0.0), 0.1),
    ],
)
def test_the_locus_is_one_curve_from_the_ground_to_its_top(angle, height, wind, epsilon):
    shot = Launcher(10.0, epsilon=epsilon).shot(np.radians(angle), height=height, wind=wind)
    data, axes, _ = drawn("shot", shot)
    [locus] = [line for line in axes.lines if line.get_label() == "locus of apexes"]
    x, y = locus.get_data()
    assert y[0] == pytest.approx(height, abs=1e-12)
    assert np.all(np.diff(y) >= 0)
    steps = np.hypot(np.diff(x), np.diff(y))
    assert steps.max() < 0.1 * steps.sum()  # no chord
    assert np.hypot(x - data.apex[0], y - data.apex[1]).min() < steps.max()


def test_where_there_is_no_apex_no_dot_is_spoken_of():
    _, axes, caption = drawn("shot", LAUNCHER.shot(np.radians(-30), height=2.0))
    assert "dot" not in caption
    assert "locus of apexes (blue)" in caption
    assert "locus of apexes" in labels(axes)


def test_a_shot_that_rising_air_carries_away():
    shot = Launcher(10.0, epsilon=1.0).shot(np.radians(45), wind=(0.0, 12.0))
    data, axes, caption = drawn("shot", shot)
    assert np.isfinite(SHOT_FIGURES["shot"].size(data)).all()
    assert labels(axes) == ["without drag", "shot"]
    assert "locus" not in caption


def test_a_shot_to_the_side_is_seen_along_its_bearing():
    straight, aside = (shot_data(LAUNCHER.shot(0.7, azimuth=a)) for a in (0.0, np.pi / 2))
    np.testing.assert_allclose(aside.x, straight.x, rtol=1e-14)
    np.testing.assert_allclose(aside.locus_x, straight.locus_x, rtol=1e-14)
    _, axes, caption = drawn("shot", LAUNCHER.shot(0.7, azimuth=np.pi / 2))
    assert axes.get_xlabel() == "horizontal distance along the bearing (m)"
    assert "azimuth 90°" in caption


def test_where_wind_carries_the_whole_weight_the_envelope_is_a_circle():
    launcher = Launcher(10.0, gravity=10.0, epsilon=1.0)
    wind = (0.0, 10.0)
    data, axes, _ = drawn("aim", launcher, launcher.aim(-3.0, 2.0, wind=wind), 0.0, wind)
    np.testing.assert_allclose(np.hypot(data.envelope_x, data.envelope_y), 10.0)
    assert labels(axes) == ["envelope", "low arc", "high arc", "target"]
    for x, y in data.arcs:
        np.testing.assert_allclose(y, x * (2.0 / -3.0), atol=1e-14)


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

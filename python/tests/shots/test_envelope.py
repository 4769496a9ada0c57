"""The envelope and the front, against the shots themselves."""

import numpy as np
import pytest

from archerfish import Launcher


@pytest.mark.parametrize("epsilon", [0.0, 0.1, 2.0, 30.0])
def test_no_shot_crosses_the_envelope_and_the_best_touches_it(epsilon):
    launcher = Launcher(1.0, gravity=1.0, epsilon=epsilon)
    x = np.linspace(0.02, 0.95, 40) * launcher.envelope.reach
    angles = np.linspace(0.01, 1.57, 4001)[:, np.newaxis]
    highest = np.nanmax(launcher.shot(angles).height_at(x), axis=0)
    envelope = launcher.envelope.height(x)
    assert np.all(highest <= envelope * (1 + 1e-13))
    np.testing.assert_allclose(highest, envelope, rtol=1e-3)  # Angles are 0.02° apart.
    assert np.array_equal(envelope, launcher.envelope.height(-x))


def test_highest_reach_and_wall():
    launcher = Launcher([10.0, 20.0], drag_rate=0.5)
    envelope = launcher.envelope
    np.testing.assert_allclose(envelope.highest, launcher.locus.highest.y, rtol=1e-15)
    np.testing.assert_allclose(envelope.height(envelope.reach), 0.0, atol=1e-13)
    np.testing.assert_array_equal(envelope.wall, [20.0, 40.0])
    assert envelope.height(50.0).tolist() == [-np.inf, -np.inf]
    assert Launcher(1.0, epsilon=0.0).envelope.wall == np.inf


def test_reachable():
    launcher = Launcher(10.0, epsilon=0.1)
    assert launcher.reachable(0.0, launcher.envelope.highest)
    assert not launcher.reachable(0.0, np.nextafter(launcher.envelope.highest, 10.0))
    assert launcher.reachable([3.0, np.nan], 1.0).tolist() == [True, False]
    assert launcher.reachable(9.5, 0.0, height=2.0)
    assert not launcher.reachable(9.5, 0.0)


@pytest.mark.parametrize("drag_rate", [0.0, 0.3, 10.0])
def test_all_shots_are_on_the_front(drag_rate):
    launcher = Launcher(10.0, drag_rate=drag_rate)
    angle = np.linspace(-3.0, 3.0, 25)
    for time in (0.01, 0.5, 3.0):
        front = launcher.front(time)
        place = launcher.shot(angle).position(time)
        distance = np.hypot(np.asarray(place.x) - front.x, np.asarray(place.y) - front.y)
        np.testing.assert_allclose(distance, front.radius, rtol=1e-13)
        np.testing.assert_allclose(front.point(angle).x, place.x, atol=1e-13)


def test_before_the_shots_there_is_no_front():
    front = Launcher(10.0, epsilon=0.1).front([-1.0, 0.0])
    assert np.isnan(front.radius).tolist() == np.isnan(front.y).tolist() == [True, False]

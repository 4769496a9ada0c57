"""The longest path and the largest area against integrals in 30 digits."""

import mpmath as mp
import numpy as np
import pytest

from archerfish import Launcher
from archerfish.flight_angles import largest_area_angle, longest_path_angle, named_angles

EPSILONS = ["0", "1e-9", "0.1", "0.36", "0.999", "1.001", "6", "20"]


def quantity(kind, angle, eps):
    """Length of the path, or area under it, over level ground."""
    s, c = mp.sin(angle), mp.cos(angle)

    def moved(t):
        return -mp.expm1(-eps * t) / eps if eps else t

    def height(t):
        fallen = (t - moved(t)) / eps if eps else t * t / 2
        return s * moved(t) - fallen

    top = mp.log1p(eps * s) / eps if eps else s
    end = mp.findroot(lambda t: height(t) / t, (top, 3 * s), solver="bisect", tol=1e-60)

    def speed(t):
        decay = mp.exp(-eps * t)
        return mp.hypot(c * decay, s * decay - moved(t))

    if kind == "path":
        return mp.quad(speed, [0, top / 2, top, (top + end) / 2, end])
    return mp.quad(lambda t: height(t) * c * mp.exp(-eps * t), [0, top, end])


@pytest.mark.parametrize("eps", EPSILONS)
@pytest.mark.parametrize(
    ("kind", "function"), [("path", longest_path_angle), ("area", largest_area_angle)]
)
def test_the_derivative_vanishes(kind, function, eps):
    angle = function(float(eps))
    with mp.workdps(50):
        step = mp.mpf(10) ** -12
        values = [quantity(kind, angle + k * step, mp.mpf(eps)) for k in (-1, 0, 1)]
        slope = (values[2] - values[0]) / (2 * step)
        bend = (values[2] - 2 * values[1] + values[0]) / step**2
        # One Newton step is how far the angle is from the true one: two units of the last digit.
        assert abs(slope / bend) < 4.5e-16
        assert bend < 0


def test_a_hundred_thousand_drags_at_once_are_each_alone():
    eps = np.concatenate([[0.0], np.logspace(-12, 6, 99_999)])
    angles = named_angles(eps)
    for index in (0, 1, 40_000, 66_670, 80_000, 99_999):
        alone = named_angles(eps[index])
        for name in alone.__dataclass_fields__:
            assert getattr(angles, name)[index] == getattr(alone, name), (name, index)


def test_without_drag():
    with mp.workdps(30):
        exact = mp.findroot(lambda a: mp.sin(a) * mp.atanh(mp.sin(a)) - 1, 0.98)
        assert longest_path_angle(0.0) == pytest.approx(float(exact), rel=4e-16)
    assert largest_area_angle(0.0) == pytest.approx(np.pi / 3, rel=4e-16)


def test_strong_drag_has_its_limits():
    eps = np.array([1e3, 1e100, 1e300])
    np.testing.assert_allclose(longest_path_angle(eps), np.pi / 2)
    np.testing.assert_allclose(largest_area_angle(eps[1:]), np.pi / 4, rtol=1e-15)


def test_all_of_them_at_once():
    angles = Launcher(10.0, epsilon=[0.0, 0.1, 1.0, 10.0]).named_angles()
    expected = {
        "greatest_range": [45, 43.7096921819, 35.5896941068, 15.8287214478],
        "greatest_curvature": [45, 43.7869703699, 35.9889139986, 16.8599371883],
        "greatest_curvature_elevation": [
            26.5650511771,
            26.1026334706,
            22.7180004668,
            12.2048522798,
        ],
        "rightmost": [45, 44.0375634638, 38.172707627, 23.9642438],
        "farthest": [54.7356103172, 54.0365143493, 49.7491455747, 39.1265680437],
        "receding": [70.5287793655, 69.2844661792, 60.039409929, 26.7041359196],
    }
    for name, degrees in expected.items():
        found = np.degrees(getattr(angles, name))
        np.testing.assert_allclose(found, degrees, atol=6e-8, err_msg=name)
    assert isinstance(named_angles(0.5).longest_path, float)


@pytest.mark.parametrize("epsilon", [0.0, 0.5, 4.0])
def test_neighbours_do_worse(epsilon):
    launcher = Launcher(10.0, epsilon=epsilon)
    angles = launcher.named_angles()
    near = np.array([-1e-4, 0.0, 1e-4])
    for angle, measure in (
        (angles.longest_path, lambda shot: shot.path_length()),
        (angles.greatest_range, lambda shot: shot.range),
    ):
        values = measure(launcher.shot(angle + near))
        assert values.argmax() == 1

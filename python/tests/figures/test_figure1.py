import numpy as np
import pytest

from archerfish import Launcher, apex_elevation, locus_radius
from archerfish.figures import figure1_data


@pytest.fixture(scope="module")
def data():
    return figure1_data()


def test_default_is_the_papers(data):
    assert (data.speed, data.epsilon) == (10.0, 0.1)
    rho = 10.0**2 / 9.80665
    assert data.drag_free_y[-1] == pytest.approx(rho / 2, rel=1e-15)


def test_apexes_are_the_highest_points(data):
    highest = data.y.argmax(axis=1)
    rows = np.arange(len(data.y))
    np.testing.assert_allclose(data.y[rows, highest], data.apex_y, rtol=1e-4)
    np.testing.assert_allclose(data.x[rows, highest], data.apex_x, rtol=2e-2, atol=1e-12)


def test_apexes_lie_on_the_locus(data):
    """Each apex, by its polar angle and the locus in polar form (equation 13)."""
    theta = np.arctan2(data.apex_y, data.apex_x)
    radius = np.hypot(data.apex_x, data.apex_y)
    rho = 10.0**2 / 9.80665
    np.testing.assert_allclose(radius, rho * locus_radius(theta, 0.1), rtol=1e-12)
    np.testing.assert_allclose(theta, apex_elevation(data.launch_angle, 0.1), rtol=1e-14)


def test_drawn_locus_goes_through_the_apexes(data):
    above = data.apex_y > 0.5 * data.locus_y.max()
    x = np.interp(data.apex_y[above], data.locus_y, data.locus_x)
    np.testing.assert_allclose(x, data.apex_x[above], atol=3e-3)


def test_drag_free_locus_is_the_ellipse(data):
    """Semi-axes ρ/2 and ρ/4, centre (0, ρ/4): eccentricity √3/2."""
    rho = 10.0**2 / 9.80665
    left = (data.drag_free_x / (rho / 2)) ** 2 + (data.drag_free_y / (rho / 4) - 1.0) ** 2
    np.testing.assert_allclose(left, 1.0, rtol=1e-14)


def test_scales_with_the_launcher():
    small = figure1_data(Launcher(1.0, epsilon=0.7))
    large = figure1_data(Launcher(2.0, gravity=2.0, epsilon=0.7))
    ratio = 4.0 / 2.0 * 9.80665
    np.testing.assert_allclose(large.locus_x, ratio * small.locus_x, rtol=1e-15)
    np.testing.assert_allclose(large.y, ratio * small.y, rtol=1e-14)


def test_launch_angles_are_the_callers():
    data = figure1_data(launch_angles_deg=[30.0, 60.0])
    np.testing.assert_allclose(np.degrees(data.launch_angle), [30.0, 60.0], rtol=1e-15)
    assert data.x.shape == data.y.shape == (2, 181)

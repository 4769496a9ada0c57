import numpy as np
import pytest
from scipy.integrate import trapezoid

from archerfish import apex_elevation, locus_launch_angle
from archerfish.figures import figure3_data


def test_drag_free_derivatives_are_elementary():
    data = figure3_data([0.0])
    sine, cosine = np.sin(data.elevation), np.cos(data.elevation)
    first = 2.0 / (1.0 + 3.0 * sine**2)
    np.testing.assert_allclose(data.first[0], first, rtol=1e-14)
    np.testing.assert_allclose(data.second[0], -3.0 * first**2 * sine * cosine, atol=1e-13)


@pytest.mark.parametrize("epsilon", [0.1, 1.0, 10.0, 100.0])
def test_first_derivative_adds_up_to_the_launch_angle(epsilon):
    data = figure3_data([epsilon], points=4001)
    assert trapezoid(data.first[0], data.elevation) == pytest.approx(np.pi / 2, abs=2e-5)
    middle = 2000
    part = trapezoid(data.first[0, : middle + 1], data.elevation[: middle + 1])
    assert part == pytest.approx(
        float(locus_launch_angle(data.elevation[middle], epsilon)), abs=2e-5
    )


@pytest.mark.parametrize("epsilon", [0.1, 1.0, 10.0])
def test_second_derivative_adds_up_to_the_first(epsilon):
    data = figure3_data([epsilon], points=4001)
    change = trapezoid(data.second[0], data.elevation)
    assert change == pytest.approx(data.first[0, -1] - data.first[0, 0], abs=2e-5)


def test_ends():
    """2 and −8ε/3 at θ = 0 (series 17), 1/θ′ = (1 + ε) φ(ε) at π/2."""
    data = figure3_data()
    np.testing.assert_allclose(data.first[:, 0], 2.0, rtol=1e-14)
    np.testing.assert_allclose(data.second[:, 0], -8.0 * data.epsilon / 3.0, rtol=1e-13)
    small = 1e-6
    slope = (np.pi / 2 - apex_elevation(np.pi / 2 - small, data.epsilon)) / small
    np.testing.assert_allclose(data.first[:, -1], 1.0 / slope, rtol=1e-5)

"""Whole trajectories against the equation of motion, integrated step by step."""

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from archerfish import apex_x, apex_y
from archerfish.figures.trajectory import fall, trajectories


@pytest.mark.parametrize("epsilon", [0.0, 1e-9, 0.1, 1.0, 10.0])
@pytest.mark.parametrize("degrees", [3.0, 45.0, 80.0])
def test_follows_the_equation_of_motion(degrees, epsilon):
    alpha = np.radians(degrees)
    x, y = (row[0] for row in trajectories([alpha], epsilon))
    # In V₀²/g and V₀/g the equation of motion is r″ = −ε r′ − (0, 1).
    flight = solve_ivp(
        lambda _, state: [state[2], state[3], -epsilon * state[2], -1.0 - epsilon * state[3]],
        (0.0, 2.0),
        [0.0, 0.0, np.cos(alpha), np.sin(alpha)],
        method="DOP853",
        rtol=1e-12,
        atol=1e-14,
        dense_output=True,
    )
    # The abscissa rises with time, so it tells the time of each point.
    low, high = np.zeros_like(x), np.full_like(x, 2.0)
    for _ in range(60):
        middle = 0.5 * (low + high)
        early = flight.sol(middle)[0] < x
        low, high = np.where(early, middle, low), np.where(early, high, middle)
    np.testing.assert_allclose(y, flight.sol(low)[1], atol=2e-9 * y.max(), rtol=1e-9)


@pytest.mark.parametrize("epsilon", [0.0, 5e-324, 0.1, 10.0, 1e3, 1e8, 1e300])
def test_rises_to_the_apex_and_lands(epsilon):
    alpha = np.radians([1.0, 20.0, 45.0, 70.0, 89.0])
    x, y = trajectories(alpha, epsilon, 2001)
    highest = np.argmax(y, axis=1)
    rows = np.arange(alpha.size)
    assert np.all(y[rows, highest] <= apex_y(alpha, epsilon) * (1.0 + 1e-12))
    np.testing.assert_allclose(y[rows, highest], apex_y(alpha, epsilon), rtol=1e-4)
    np.testing.assert_allclose(x[rows, highest], apex_x(alpha, epsilon), rtol=3e-2)
    assert np.all(y >= 0.0)
    assert np.all(np.diff(x, axis=1) >= -1e-15 * x[:, -1:])
    assert np.all(y[:, [0, -1]] == 0.0)


def test_range_without_drag_is_sin_2_alpha():
    alpha = np.radians([0.0, 15.0, 45.0, 75.0, 90.0])
    x, _ = trajectories(alpha, 0.0)
    np.testing.assert_allclose(x[:, -1], np.sin(2.0 * alpha), rtol=1e-14, atol=1e-15)


def test_vertical_and_horizontal_shots():
    x, y = trajectories([0.0, np.pi / 2, np.pi], 0.5)
    assert np.all(x[0] == 0.0)
    assert np.all(y[0] == 0.0)
    assert np.abs(x[1:]).max() < 1e-15
    assert y[1].max() == pytest.approx(float(apex_y(np.pi / 2, 0.5)), rel=1e-4)


def test_mirror_image_beyond_the_vertical():
    right, _ = trajectories(np.radians([30.0]), 2.0)
    left, _ = trajectories(np.radians([150.0]), 2.0)
    np.testing.assert_allclose(left, -right, rtol=1e-14)


@pytest.mark.parametrize("u", [0.0, 1e-300, 1e-9, 0.3, 0.999, 1.0, 7.0, 1e6, 1e300])
def test_fall_is_its_definition(u):
    with mpmath.workdps(700):
        v = mpmath.mpf(u)
        exact = ((1 + v) * mpmath.log1p(v) - v) / v**2 if v else mpmath.mpf("0.5")
        assert abs(float(fall(u)) / exact - 1) < 1e-14

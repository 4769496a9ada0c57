"""Independent roads to the same flight: solvers, identities, round trips, the named angles."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import archerfish

EPSILONS = (0.0, 0.1, 1.0, 10.0)
#: Launch angle of the greatest range, in degrees, by ε.
OPTIMAL = (45.0, 43.7096921819, 35.5896941068, 15.8287214478)


@pytest.mark.parametrize("i", range(4))
def test_named_angle_of_the_greatest_range(i):
    best = archerfish.optimal_angle(EPSILONS[i])
    assert math.isclose(math.degrees(best), OPTIMAL[i], rel_tol=1e-11)
    around = archerfish.flight_range(np.linspace(0, math.pi / 2, 2001), EPSILONS[i])
    assert around.max() <= archerfish.flight_range(best, EPSILONS[i]) * (1 + 1e-15)


def test_best_angle_at_unit_drag():
    assert math.isclose(math.sin(archerfish.optimal_angle(1.0)), 1 / (math.e - 1), rel_tol=4e-16)


@pytest.mark.parametrize("eps", [1e-8, 1e-3, 0.1, 1.0, 10.0, 1e3])
def test_launch_and_landing_are_perpendicular_at_the_best_angle(eps):
    alpha = archerfish.optimal_angle(eps)
    left = math.exp(-eps * archerfish.flight_time(alpha, eps))
    # v = v0 e^(-εt) - (0, 1)(1 - e^(-εt))/ε, and v0 is a unit vector
    gone = -math.expm1(-eps * archerfish.flight_time(alpha, eps)) / eps
    assert math.isclose(left, gone * math.sin(alpha), rel_tol=1e-12)


def test_without_drag_it_is_the_textbook_parabola():
    alpha = np.linspace(0, math.pi / 2, 301)[1:-1]
    s, c, t = np.sin(alpha), np.cos(alpha), np.linspace(0.01, 3, 299)
    close = {"rtol": 2e-15, "atol": 0}
    assert np.allclose(archerfish.flight_time(alpha, 0.0), 2 * s, **close)
    assert np.allclose(archerfish.flight_range(alpha, 0.0), 2 * s * c, **close)
    assert np.allclose(archerfish.flight_x(t, alpha, 0.0), c * t, **close)
    assert np.allclose(archerfish.flight_y(t, alpha, 0.0), s * t - t * t / 2, rtol=0, atol=4e-15)
    x = t * c
    height = archerfish.trajectory_height(x, alpha, 0.0)
    assert np.allclose(height, x * s / c - (x / c) ** 2 / 2, rtol=0, atol=4e-15)
    x = np.linspace(-3, 3, 301)
    assert np.allclose(archerfish.envelope_height(x, 0.0), (1 - x * x) / 2, rtol=0, atol=2e-15)


def test_without_drag_aiming_is_a_quadratic():
    x, y = np.meshgrid(np.linspace(0.05, 1.5, 40), np.linspace(-2, 0.5, 40))
    root = np.sqrt(np.maximum(1 - 2 * y - x * x, 0))
    inside = 1 - 2 * y - x * x > 1e-3
    for aim, sign in ((archerfish.aim_low, -1), (archerfish.aim_high, 1)):
        angle = aim(x[inside], y[inside], 0.0)
        assert np.allclose(angle, np.arctan((1 + sign * root[inside]) / x[inside]), atol=1e-13)
    assert archerfish.aim_low(1.0, 0.0, 0.0) == archerfish.aim_high(1.0, 0.0, 0.0) == math.pi / 4


@pytest.mark.parametrize("eps", [0.0, 1e-6, 0.1, 1.0, 30.0])
@pytest.mark.parametrize("alpha", [-0.7, 0.02, 0.6, 1.5, 2.5])
def test_an_ode_solver_flies_the_same_way(alpha, eps):
    def motion(_, state):
        _, _, vx, vy = state
        return [vx, vy, -eps * vx, -1 - eps * vy]

    times = np.linspace(0, 2, 9)
    start = [0, 0, math.cos(alpha), math.sin(alpha)]
    flight = solve_ivp(motion, (0, 2), start, "DOP853", times, rtol=1e-12, atol=1e-15)
    x, y = flight.y[:2]
    assert np.allclose(archerfish.flight_x(times, alpha, eps), x, rtol=1e-9, atol=1e-11)
    assert np.allclose(archerfish.flight_y(times, alpha, eps), y, rtol=1e-9, atol=1e-11)
    # x loses touch with time near the wall: before it
    early = eps * times < 5
    height = archerfish.trajectory_height(archerfish.flight_x(times[early], alpha, eps), alpha, eps)
    assert np.allclose(height, y[early], rtol=1e-9, atol=1e-9)


def test_the_shot_lands_where_and_when_it_should():
    random = np.random.default_rng(4)
    alpha, eps = random.uniform(0, math.pi, 20_000), 10 ** random.uniform(-9, 6, 20_000)
    time, reach = archerfish.flight_time(alpha, eps), archerfish.flight_range(alpha, eps)
    assert np.allclose(archerfish.flight_x(time, alpha, eps), reach, rtol=1e-14, atol=0)
    # relative to the fall, beside which the height at the landing is nothing
    fall = -archerfish.flight_y(time, 0.0, eps)
    assert (np.abs(archerfish.flight_y(time, alpha, eps)) <= 2e-15 * fall).all()


def test_the_apex_lies_on_the_flight():
    random = np.random.default_rng(5)
    alpha, eps = random.uniform(0, math.pi, 20_000), 10 ** random.uniform(-9, 6, 20_000)
    time = archerfish.apex_time(alpha, eps)
    x, y = archerfish.apex_x(alpha, eps), archerfish.apex_y(alpha, eps)
    assert np.allclose(archerfish.flight_x(time, alpha, eps), x, rtol=2e-14, atol=0)
    assert np.allclose(archerfish.flight_y(time, alpha, eps), y, rtol=2e-14, atol=0)


@pytest.mark.parametrize("eps", [0.0, 1e-3, 0.1, 1.0, 3.0, 10.0, 1e3])
def test_no_shot_rises_above_the_envelope_and_each_touches_it(eps):
    alpha = np.linspace(0.01, math.pi / 2 - 0.01, 400)
    s = np.sin(alpha)
    touch = np.cos(alpha) / (s + eps)
    top = archerfish.envelope_height(touch, eps)
    height = archerfish.trajectory_height(touch, alpha, eps)
    assert np.allclose(height, top, rtol=0, atol=1e-12 * s / (s + eps))
    x = np.linspace(0, 1, 200)[:, None] * np.cos(alpha) / max(eps, 0.1)
    with np.errstate(invalid="ignore"):
        heights = archerfish.trajectory_height(x, alpha, eps)
        above = heights - archerfish.envelope_height(x, eps)
    assert np.nanmax(above) <= 1e-13


def reachable(count, seed):
    """Targets well-conditioned and not: all of the plane within reach, by ε from 0 on."""
    random = np.random.default_rng(seed)
    eps = np.where(random.random(count) < 0.05, 0.0, 10 ** random.uniform(-6, 3, count))
    x = random.uniform(-1, 1, count) * np.minimum(3.0, 1 / np.maximum(eps, 1e-9))
    below = np.where(random.random(count) < 0.3, 2.0 ** random.uniform(-40, -5, count), 1.0)
    size = np.minimum(1.0, 1 / np.maximum(eps, 1e-9))
    y = archerfish.envelope_height(x, eps) - below * random.uniform(0, 2, count) * size
    return x, y, eps


def falling_through(y, alpha, eps):
    """The abscissa at which the shots come down through the heights y: by bisection in time."""
    low = np.zeros_like(y)
    high = 4 + 2 * np.sqrt(np.abs(y)) + 2 * eps * np.abs(y)
    up = np.sin(alpha) > 0
    low[up] = archerfish.apex_time(np.arcsin(np.sin(alpha[up])), eps[up])
    for _ in range(200):
        middle = (low + high) / 2
        above = archerfish.flight_y(middle, alpha, eps) > y
        low, high = np.where(above, middle, low), np.where(above, high, middle)
    return archerfish.flight_x(high, alpha, eps)


@pytest.mark.parametrize("aim", [archerfish.aim_low, archerfish.aim_high])
def test_aim_fly_arrive(aim):
    """The flight misses by less than 1e-13 of the distance, or by what the last digit of the
    angle moves it.
    """
    x, y, eps = reachable(200_000, 7)
    alpha = aim(x, y, eps)
    assert np.isfinite(alpha).all()
    with np.errstate(invalid="ignore"):
        height = archerfish.trajectory_height(x, alpha, eps)
    # the miss at right angles to the flight: the height's error times the cosine of its slope
    way = np.abs(x / np.cos(alpha))
    rest = np.maximum(1 - eps * way, 1e-300)
    slope = (np.sin(alpha) - way / rest) / np.cos(alpha)
    miss = np.abs(height - y) / np.hypot(1, slope)
    # next to the wall the angle's last digit decides whether it gets to x; there by height
    wall = np.isnan(miss) | (rest < 1e-6)
    assert wall.mean() < 0.25
    miss[wall] = np.abs(falling_through(y[wall], alpha[wall], eps[wall]) - x[wall])
    assert (miss <= 1e-13 * np.hypot(x, y) + 4e-16 * way).all()


@pytest.mark.parametrize(("weakest", "strongest"), [(-6, 3), (3, 299)])
def test_both_arcs_are_one_on_the_envelope_and_none_above_it(weakest, strongest):
    random = np.random.default_rng(8)
    eps = 10 ** random.uniform(weakest, strongest, 20_000)
    x = random.uniform(-1, 1, 20_000) * np.minimum(3.0, 1 / eps)
    top = archerfish.envelope_height(x, eps)
    low, high = archerfish.aim_low(x, top, eps), archerfish.aim_high(x, top, eps)
    assert np.array_equal(low, high)
    assert not np.isnan(low).any()
    size = np.abs(top) + np.minimum(1.0, 1 / eps)
    with np.errstate(invalid="ignore"):
        for aim in (archerfish.aim_low, archerfish.aim_high):
            assert np.isnan(aim(x, top + 1e-14 * size, eps)).all()
            assert not np.isnan(aim(x, top - 1e-14 * size, eps)).any()


def test_arcs_lie_on_either_side_of_the_touching_shot_and_mirror():
    x, y, eps = reachable(20_000, 9)
    low, high = archerfish.aim_low(x, y, eps), archerfish.aim_high(x, y, eps)
    right = x > 0
    assert (low[right] <= high[right]).all()
    assert (low[~right] >= high[~right]).all()
    for aim, angle in ((archerfish.aim_low, low), (archerfish.aim_high, high)):
        assert np.allclose(aim(-x, y, eps), math.pi - angle, rtol=0, atol=1e-15)


def test_textbook_range_has_no_digit_left_where_this_has_all():
    """R at ε = 1e-8 by the textbook's W₀ form is off by more than itself; by series it is exact."""
    alpha, eps = 0.7, 1e-8
    s, c = math.sin(alpha), math.cos(alpha)
    series = 2 * s * c * (1 - 4 * eps * s / 3)
    assert math.isclose(archerfish.flight_range(alpha, eps), series, rel_tol=4e-16)

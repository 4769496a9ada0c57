"""Independent roads to the same numbers: the paper's equations, an ODE solver, special values."""

import math

import numpy as np
import pytest
from numpy.polynomial import Chebyshev
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import archerfish

DEGREE = math.pi / 180
#: ε sin α where the right branch of W in (13) changes: u - ln(1+u) = 1.
BRANCH_CHANGE = 2.146193220620582585
EPSILONS = (0.0, 0.1, 1.0, 10.0)


def interpolated(function, eps, degree=64):
    """A polynomial through the function on [0, π/2], good to 1e-14; its slope is good to 1e-9."""
    return Chebyshev.interpolate(
        lambda angle: function(angle, eps), degree, domain=[0, math.pi / 2]
    )


@pytest.mark.parametrize("eps", [0.3, 1.0, 2.0, 2.5, 3.0, 10.0, 50.0])
def test_equation_13_with_the_right_branch(eps):
    alpha = np.linspace(0.05, 1.5, 60)
    theta = archerfish.apex_elevation(alpha, eps)
    f = np.cos(alpha) * np.sin(alpha) * np.exp(-eps * np.sin(alpha))
    z = np.maximum(-(eps**2) * np.tan(theta) * f, -math.exp(-1))
    principal = eps * np.sin(alpha) <= BRANCH_CHANGE
    with np.errstate(invalid="ignore"):
        w = np.where(principal, archerfish.lambertw0(z), archerfish.lambertwm1(z))
    radius = -w / (eps**2 * np.sin(theta))
    known = archerfish.apex_distance(alpha, eps)
    # z is rounded, and W hands that on divided by 1 + W.
    allowed = 2e-15 * (1 + eps) / np.maximum(np.abs(1 + w), 1e-8)
    assert np.all(np.abs(radius / known - 1) <= allowed)
    assert np.allclose(archerfish.locus_radius(theta, eps), known, rtol=2e-15)
    if principal.all():  # (14), the tree function
        assert np.allclose(archerfish.tree(-z) / (eps**2 * np.sin(theta)), radius, rtol=1e-15)


def test_the_principal_branch_is_wrong_beyond_its_reach():
    """At ε = 10, α = 1 the paper's branch gives 0.000165639, the right one 0.07837058."""
    alpha, eps = 1.0, 10.0
    u = eps * math.sin(alpha)
    sigma = u - math.log1p(u)
    z = -sigma * math.exp(-sigma)
    theta = archerfish.apex_elevation(alpha, eps)
    assert math.isclose(
        -archerfish.lambertwm1(z) / (eps**2 * math.sin(theta)), 0.0783705830542543418, rel_tol=1e-13
    )
    assert math.isclose(
        -archerfish.lambertw0(z) / (eps**2 * math.sin(theta)), 0.000165639, rel_tol=1e-5
    )
    assert math.isclose(archerfish.apex_distance(alpha, eps), 0.0783705830542543418, rel_tol=4e-16)


def test_equation_15_without_drag():
    theta = np.linspace(0, math.pi, 501)
    ellipse = 2 * np.sin(theta) / (1 + 3 * np.sin(theta) ** 2)
    assert np.allclose(archerfish.locus_radius(theta, 0.0), ellipse, rtol=2e-15, atol=0)
    rising = theta[theta < 1.57]
    assert np.allclose(
        archerfish.locus_launch_angle(rising, 0.0),
        np.arctan(2 * np.tan(rising)),
        rtol=4e-16,
        atol=0,
    )


@pytest.mark.parametrize("eps", [0.0, 0.1, 1.0, 3.0])
def test_equation_18_by_the_derivatives_of_an_interpolation(eps):
    angle = interpolated(archerfish.locus_launch_angle, eps)
    theta = np.linspace(0.05, 1.5, 40)
    assert np.allclose(
        angle.deriv()(theta), archerfish.locus_launch_angle_d1(theta, eps), rtol=1e-9
    )
    scale = np.abs(archerfish.locus_launch_angle_d2(theta, eps)).max()
    assert np.allclose(
        angle.deriv(2)(theta),
        archerfish.locus_launch_angle_d2(theta, eps),
        rtol=0,
        atol=1e-7 * scale,
    )


@pytest.mark.parametrize("eps", [0.0, 0.1, 1.0, 3.0])
def test_equation_19_by_polar_derivatives(eps):
    radius = interpolated(archerfish.locus_radius, eps)
    theta = np.linspace(0.05, 1.5, 40)
    r, r1, r2 = radius(theta), radius.deriv()(theta), radius.deriv(2)(theta)
    polar = (r**2 + 2 * r1**2 - r * r2) / (r**2 + r1**2) ** 1.5
    assert np.allclose(polar, archerfish.locus_curvature(theta, eps), rtol=1e-7)
    by_launch_angle = archerfish.apex_curvature(archerfish.locus_launch_angle(theta, eps), eps)
    # α(θ) is rounded to a double; the curvature's own slope carries that on.
    assert np.allclose(by_launch_angle, archerfish.locus_curvature(theta, eps), rtol=2e-14)


@pytest.mark.parametrize("eps", [0.0, 1e-6, 0.1, 1.0, 10.0, 300.0])
@pytest.mark.parametrize("alpha", [0.02, 0.6, 1.2, 1.55, 2.5])
def test_an_ode_solver_finds_the_apex(alpha, eps):
    """Integrate the equation of motion until the vertical velocity is zero."""

    def motion(_, state):
        _, _, vx, vy = state
        return [vx, vy, -eps * vx, -1 - eps * vy]

    def vertical_velocity(_, state):
        return state[3]

    vertical_velocity.terminal = True
    flight = solve_ivp(
        motion,
        (0, 2),
        [0, 0, math.cos(alpha), math.sin(alpha)],
        method="DOP853",
        rtol=1e-13,
        atol=1e-16,
        events=vertical_velocity,
    )
    (time,), ((x, y, _, _),) = flight.t_events[0], flight.y_events[0]
    assert math.isclose(archerfish.apex_time(alpha, eps), time, rel_tol=1e-10)
    assert math.isclose(archerfish.apex_x(alpha, eps), x, rel_tol=1e-10)
    assert math.isclose(archerfish.apex_y(alpha, eps), y, rel_tol=1e-10)
    assert math.isclose(archerfish.apex_elevation(alpha, eps), math.atan2(y, x), rel_tol=1e-10)


def test_curvature_at_the_ends_and_at_45_degrees():
    for eps in (0.0, 5e-324, 1e-8, 0.1, 1.0, 10.0, 1e8, 1e300):
        assert archerfish.apex_curvature(0.0, eps) == 1.0
        assert math.isclose(archerfish.apex_curvature(math.pi / 2, eps), 1 + eps, rel_tol=5e-16)
    assert math.isclose(archerfish.apex_curvature(math.pi / 4, 0.0), 8.0, rel_tol=5e-16)


def test_slopes_at_the_launch_point():
    """dα/dθ = 2 and d²α/dθ² = -8ε/3 at θ = 0, from the first terms of (17)."""
    for eps in (0.0, 1e-8, 0.1, 1.0, 10.0, 1e8, 1e300):
        assert archerfish.locus_launch_angle_d1(0.0, eps) == 2.0
        assert math.isclose(archerfish.locus_launch_angle_d2(0.0, eps), -8 * eps / 3, rel_tol=5e-16)


def test_second_slope_under_overwhelming_drag():
    """With G = 1, 1 - G = (ln u - 1)/u and α = θ: from θ' = P/Q up to the greatest double."""
    for eps in (1e40, 1e200, 1e300, 1e305, 1.7e308):
        for theta in (0.1, 0.5, 1.2, 1.5):
            sin, cos = math.sin(theta), math.cos(theta)
            logarithm = math.log(eps) + math.log(sin)
            expected = -(cos / sin) * (sin * (1 + logarithm) + 1 / sin) / eps
            computed = archerfish.locus_launch_angle_d2(theta, eps)
            assert math.isclose(computed, expected, rel_tol=2e-15), (theta, eps)


def test_time_under_overwhelming_drag():
    """ln(ε sin α)/ε, up to the greatest double, where 1 + u still has a low word."""
    for eps in (1e40, 1e300, 1e305, 1.7e308):
        for alpha in (0.1, 0.5, 1.2, 1.5):
            expected = (math.log(eps) + math.log(math.sin(alpha))) / eps
            computed = archerfish.apex_time(alpha, eps)
            assert math.isclose(computed, expected, rel_tol=2e-15), (alpha, eps)


@pytest.mark.parametrize("eps", EPSILONS)
def test_height_grows_by_the_abscissa(eps):
    """dy/dα = x."""
    alpha = np.linspace(0, math.pi / 2, 50)
    slope = interpolated(archerfish.apex_y, eps).deriv()(alpha)
    assert np.allclose(slope, archerfish.apex_x(alpha, eps), rtol=0, atol=1e-9)


# The named angles of the locus, in degrees, and its measures: ε = 0, 0.1, 1, 10.

CURVATURE_ALPHA = (45.0, 43.7869703699, 35.9889139986, 16.8599371883)
CURVATURE_THETA = (26.5650511771, 26.1026334706, 22.7180004668, 12.2048522798)
CURVATURE = (8.0, 8.4246013385226, 12.298109766078, 59.281577657409)
RIGHTMOST = (45.0, 44.0375634638, 38.172707627, 23.9642438)
FARTHEST = (54.7356103172, 54.0365143493, 49.7491455747, 39.1265680437)
LENGTH = (1.2110560275685, 1.1334374257361, 0.73465164710794, 0.18248054773867)
AREA = (0.19634954084936, 0.17235126113537, 0.073009183012758, 0.004456387500722)


def stationary(function, eps, near, reach):
    """Where the slope of a function vanishes, by eighth-order differences, in degrees."""
    weights = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])
    steps = np.arange(-4, 5) * 2e-3
    return (
        brentq(
            lambda angle: weights @ function(angle + steps, eps),
            near - reach,
            near + reach,
            xtol=1e-15,
        )
        / DEGREE
    )


@pytest.mark.parametrize("i", range(4))
def test_greatest_curvature(i):
    eps, alpha, theta = EPSILONS[i], CURVATURE_ALPHA[i] * DEGREE, CURVATURE_THETA[i] * DEGREE
    assert math.isclose(
        stationary(archerfish.apex_curvature, eps, alpha, 0.02), CURVATURE_ALPHA[i], abs_tol=1e-6
    )
    assert math.isclose(archerfish.apex_curvature(alpha, eps), CURVATURE[i], rel_tol=1e-13)
    assert math.isclose(archerfish.locus_curvature(theta, eps), CURVATURE[i], rel_tol=1e-13)
    assert math.isclose(archerfish.apex_elevation(alpha, eps), theta, rel_tol=1e-11)
    around = archerfish.apex_curvature(np.linspace(0, math.pi / 2, 2001), eps)
    assert around.max() <= CURVATURE[i] * (1 + 1e-13)


@pytest.mark.parametrize("i", range(4))
def test_rightmost_and_farthest_apex(i):
    eps = EPSILONS[i]
    assert math.isclose(
        stationary(archerfish.apex_x, eps, RIGHTMOST[i] * DEGREE, 0.05), RIGHTMOST[i], abs_tol=1e-7
    )
    assert math.isclose(
        stationary(archerfish.apex_distance, eps, FARTHEST[i] * DEGREE, 0.05),
        FARTHEST[i],
        abs_tol=1e-7,
    )


@pytest.mark.parametrize("i", range(4))
def test_length_and_area_of_the_locus(i):
    eps = EPSILONS[i]
    x, y = (interpolated(function, eps) for function in (archerfish.apex_x, archerfish.apex_y))
    nodes, weights = np.polynomial.legendre.leggauss(200)
    alpha, weights = (nodes + 1) * math.pi / 4, weights * math.pi / 4
    length = weights @ np.hypot(x.deriv()(alpha), y.deriv()(alpha))
    area = weights @ (archerfish.apex_x(alpha, eps) * y.deriv()(alpha))
    assert math.isclose(length, LENGTH[i], rel_tol=1e-11)
    assert math.isclose(area, AREA[i], rel_tol=1e-11)

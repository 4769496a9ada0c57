"""The locus in SI units: points, named points, length and area."""

import dataclasses
from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest

import archerfish
from archerfish import ApexLocus, Launcher

#: mathematics.md §8 of the project's notes: length and area at ε = 0, 0.1, 1, 10, in ρ and ρ².
LENGTHS = [1.2110560275685, 1.1334374257361, 0.73465164710794, 0.18248054773867]
AREAS = [0.19634954084936, 0.17235126113537, 0.073009183012758, 0.004456387500722]


def unit_locus(epsilon):
    return ApexLocus(epsilon, 1.0, 1.0)


def test_points_by_launch_angle_are_the_ufuncs_times_the_scales():
    launcher = Launcher(10.0, epsilon=0.3)
    alpha = np.linspace(0, np.pi, 11)
    points = launcher.locus.at_launch_angle(alpha)
    rho, unit = launcher.length_scale, launcher.time_scale
    assert np.array_equal(points.launch_angle, alpha)
    assert np.array_equal(points.elevation, archerfish.apex_elevation(alpha, 0.3))
    assert np.array_equal(points.x, archerfish.apex_x(alpha, 0.3) * rho)
    assert np.array_equal(points.y, archerfish.apex_y(alpha, 0.3) * rho)
    assert np.array_equal(points.distance, archerfish.apex_distance(alpha, 0.3) * rho)
    assert np.array_equal(points.time, archerfish.apex_time(alpha, 0.3) * unit)
    assert np.array_equal(points.curvature, archerfish.apex_curvature(alpha, 0.3) / rho)


def test_points_by_elevation_are_the_same_points():
    locus = Launcher(10.0, epsilon=[[0.0], [0.3], [20.0]]).locus
    theta = np.linspace(0.01, 1.5, 11)
    by_elevation = locus.at_elevation(theta)
    by_launch_angle = locus.at_launch_angle(by_elevation.launch_angle)
    for field in dataclasses.fields(by_elevation):
        mine, other = (getattr(each, field.name) for each in (by_elevation, by_launch_angle))
        assert mine.shape == (3, 11)
        np.testing.assert_allclose(mine, other, rtol=1e-13, err_msg=field.name)
    assert np.array_equal(by_elevation.elevation[1], theta)


def test_drag_free_elevation_is_equation_15():
    theta = np.linspace(0, np.pi / 2, 50)
    points = unit_locus(0.0).at_elevation(theta)
    sine = np.sin(theta)
    np.testing.assert_allclose(points.distance, 2 * sine / (1 + 3 * sine**2), rtol=1e-15)


@pytest.mark.parametrize("angle", [-0.1, 3.2, np.inf])
def test_angles_outside_the_half_turn_are_nan_with_a_warning(angle):
    locus = unit_locus(0.1)
    for ask in (locus.at_launch_angle, locus.at_elevation, locus.arc_length):
        with pytest.warns(RuntimeWarning, match="invalid value"):
            found = ask(angle)
        assert np.isnan(getattr(found, "distance", found))


def test_nan_passes_through_silently():
    assert np.isnan(unit_locus(0.1).at_launch_angle(np.nan).x)
    assert np.isnan(unit_locus(0.1).arc_length(np.nan))


def test_named_points_are_extremes_of_the_curve():
    locus = Launcher(10.0, epsilon=[0.0, 0.01, 1.0, 100.0]).locus
    points = locus.at_launch_angle(np.linspace(0, np.pi / 2, 20001)[:, np.newaxis])
    for named, field in (
        ("highest", "y"),
        ("rightmost", "x"),
        ("farthest", "distance"),
        ("max_curvature", "curvature"),
    ):
        sampled = getattr(points, field).max(axis=0)
        found = getattr(getattr(locus, named), field)
        assert np.all(found >= sampled * (1 - 2e-16 * 4)), named
        np.testing.assert_allclose(found, sampled, rtol=1e-4, err_msg=named)


def test_greatest_curvature_at_known_drags():
    locus = unit_locus([0.0, 0.1, 1.0, 10.0])
    np.testing.assert_allclose(
        locus.max_curvature.curvature,
        [8, 8.4246013385226, 12.298109766078, 59.281577657409],
        rtol=1e-13,
    )
    np.testing.assert_allclose(
        np.degrees(locus.max_curvature.elevation),
        [26.5650511771, 26.1026334706, 22.7180004668, 12.2048522798],
        rtol=2e-12,
    )


def test_length_and_area_at_known_drags():
    locus = unit_locus([0.0, 0.1, 1.0, 10.0])
    np.testing.assert_allclose(locus.arc_length(), LENGTHS, rtol=5e-14)
    np.testing.assert_allclose(locus.area, AREAS, rtol=5e-14)


@pytest.mark.parametrize("eps", [1e-300, 1e-8, 0.03, 2.0, 50.0, 1e4, 1e9])
def test_length_and_area_against_quadrature_in_40_digits(eps):
    with mp.workdps(40):
        e = mp.mpf(eps)

        def x(a):
            return mp.sin(a) * mp.cos(a) / (1 + e * mp.sin(a))

        def speed(a):
            s, q = mp.sin(a), 1 + e * mp.sin(a)
            return mp.hypot(x(a), (1 - 2 * s * s - e * s**3) / q**2)

        parts = int(mp.ceil(2 * mp.log1p(e * mp.pi / 2))) + 3
        edges = [mp.expm1(j * mp.log1p(e * mp.pi / 2) / parts) / e for j in range(parts + 1)]
        length = float(mp.quad(speed, edges, method="gauss-legendre"))
        area = float(mp.quad(lambda a: x(a) ** 2, edges, method="gauss-legendre"))
    assert unit_locus(eps).arc_length() == pytest.approx(length, rel=2e-15, abs=0)
    assert unit_locus(eps).area == pytest.approx(area, rel=2e-15, abs=0)


@pytest.mark.parametrize("eps", [1e30, 1e100, 1e300])
def test_length_at_overwhelming_drag(eps):
    # Out along the ground to 1/ε, then back up a quarter of a circle of this radius.
    assert unit_locus(eps).arc_length() * eps == pytest.approx(1 + np.pi / 2, rel=1e-13, abs=0)
    assert unit_locus(1e30).area * 1e60 == pytest.approx(np.pi / 4, rel=1e-13, abs=0)


def test_parts_of_the_length_add_up():
    locus = unit_locus([0.0, 0.2, 30.0])
    cuts = np.array([0.0, 1e-3, 0.4, 1.0, 1.7, np.pi])
    parts = sum(locus.arc_length(a, b) for a, b in pairwise(cuts))
    np.testing.assert_allclose(parts, 2 * locus.arc_length(), rtol=1e-14)
    np.testing.assert_allclose(locus.arc_length(1.0, 0.4), -locus.arc_length(0.4, 1.0))
    np.testing.assert_allclose(locus.arc_length(np.pi - 0.4, np.pi), locus.arc_length(0, 0.4))


def test_the_area_is_that_under_x_of_y():
    locus = Launcher(7.0, epsilon=0.8).locus
    points = locus.at_launch_angle(np.linspace(0, np.pi / 2, 20001))
    assert np.trapezoid(points.x, points.y) == pytest.approx(locus.area, rel=1e-7, abs=0)


def test_drag_free_ellipse():
    locus = Launcher(10.0, gravity=10.0, epsilon=0.7).locus
    ellipse = locus.drag_free
    assert ellipse is locus.drag_free
    assert (ellipse.epsilon, ellipse.length_scale, ellipse.time_scale) == (0.0, 10.0, 1.0)
    a, b = ellipse.semi_major_axis, ellipse.semi_minor_axis
    points = ellipse.at_launch_angle(np.linspace(0, np.pi, 101))
    np.testing.assert_allclose((points.x / a) ** 2 + ((points.y - b) / b) ** 2, 1.0, rtol=1e-14)
    assert ellipse.eccentricity == pytest.approx(np.sqrt(1 - (b / a) ** 2), rel=1e-15, abs=0)
    assert ellipse.area == pytest.approx(np.pi * a * b / 2, rel=1e-15, abs=0)
    assert ellipse.arc_length() == pytest.approx(
        2 * a * float(mp.ellipe(ellipse.eccentricity**2)), rel=1e-15, abs=0
    )


def test_fields_are_checked_and_frozen():
    with pytest.raises(ValueError, match=r"^epsilon must be at least 0 and finite, got -1\.0$"):
        ApexLocus(-1.0, 1.0, 1.0)
    with pytest.raises(ValueError, match=r"^length_scale must be above 0 and finite, got 0\.0$"):
        ApexLocus(0.1, 0.0, 1.0)
    locus = unit_locus(0.1)
    with pytest.raises(dataclasses.FrozenInstanceError):
        locus.epsilon = 0.2
    with pytest.raises(ValueError, match="read-only"):
        locus.at_launch_angle([0.1, 0.2]).x[0] = 3.0


def test_scalars_in_scalars_out():
    points = unit_locus(0.1).at_launch_angle(0.3)
    assert all(type(getattr(points, field.name)) is float for field in dataclasses.fields(points))
    assert type(unit_locus(0.1).arc_length()) is float


@pytest.mark.parametrize("ask", ["at_launch_angle", "at_elevation"])
def test_an_angle_outside_the_domain_warns_once(ask):
    locus = Launcher(10.0, epsilon=0.1).locus
    with pytest.warns(RuntimeWarning, match="invalid value") as warned:
        points = getattr(locus, ask)([-1.0, 0.5])
    assert len(warned) == 1
    assert np.isnan(points.x[0])
    assert np.isfinite(points.x[1])

"""What holds for every shot whatever the digits: order, bounds, symmetry, round trips."""

import math

from hypothesis import given
from hypothesis import strategies as st

import archerfish

EPSILON = 2.0**-52
SLACK = 1 + 8 * EPSILON
angles = st.floats(0.0, math.pi / 2)
drags = st.one_of(st.floats(0.0, 100.0), st.floats(0.0, 1e300))


@given(angles, drags)
def test_the_apex_is_seen_below_the_launch_angle_and_above_half_its_tangent(alpha, eps):
    theta = archerfish.apex_elevation(alpha, eps)
    assert theta <= alpha <= math.atan(2 * math.tan(theta)) * SLACK + 5e-324


@given(angles, drags)
def test_the_launch_angle_lies_between_its_bounds(theta, eps):
    alpha = archerfish.locus_launch_angle(theta, eps)
    assert theta <= alpha <= math.atan(2 * math.tan(theta)) * SLACK + 5e-324


@given(angles, drags)
def test_there_and_back_from_an_elevation(theta, eps):
    back = archerfish.apex_elevation(archerfish.locus_launch_angle(theta, eps), eps)
    assert math.isclose(back, theta, rel_tol=8 * EPSILON, abs_tol=5e-324)


@given(st.floats(1e-300, math.pi / 2), drags)
def test_there_and_back_from_a_launch_angle(alpha, eps):
    theta = archerfish.apex_elevation(alpha, eps)
    # θ is rounded, and dα/dθ carries that on.
    allowed = EPSILON * (4 * alpha + 4 * theta * archerfish.locus_launch_angle_d1(theta, eps))
    assert abs(archerfish.locus_launch_angle(theta, eps) - alpha) <= allowed


@given(angles, angles, drags)
def test_elevation_and_launch_angle_rise_together(a, b, eps):
    low, high = sorted((a, b))
    for function in (
        archerfish.apex_elevation,
        archerfish.locus_launch_angle,
        archerfish.apex_time,
        archerfish.apex_y,
    ):
        assert function(low, eps) <= function(high, eps) * SLACK


@given(angles, drags, drags)
def test_more_drag_brings_the_apex_closer_and_raises_its_elevation(alpha, a, b):
    less, more = sorted((a, b))
    for function in (
        archerfish.apex_x,
        archerfish.apex_y,
        archerfish.apex_time,
        archerfish.apex_distance,
    ):
        assert function(alpha, more) <= function(alpha, less) * SLACK + 5e-324
    assert archerfish.apex_elevation(alpha, less) <= archerfish.apex_elevation(alpha, more) * SLACK


@given(st.floats(1e-3, math.pi / 2), drags)
def test_shots_backward_mirror_shots_forward(angle, eps):
    mirrored = math.pi - angle
    angle = (
        math.pi - mirrored
    )  # exact: now the two add up to the double nearest π, 1.2e-16 short of π
    slip = 2.5e-16
    x, y = archerfish.apex_x(angle, eps), archerfish.apex_y(angle, eps)
    assert abs(archerfish.apex_x(mirrored, eps) + x) <= 4 * EPSILON * abs(x) + slip
    assert abs(archerfish.apex_y(mirrored, eps) - y) <= 4 * EPSILON * y + slip * x
    alpha = archerfish.locus_launch_angle(angle, eps)
    slope = archerfish.locus_launch_angle_d1(angle, eps)
    assert (
        abs(archerfish.locus_launch_angle(mirrored, eps) + alpha - math.pi)
        <= 4 * EPSILON * math.pi + slip * slope
    )


@given(angles, drags)
def test_distance_is_that_of_the_point(alpha, eps):
    point = math.hypot(archerfish.apex_x(alpha, eps), archerfish.apex_y(alpha, eps))
    assert math.isclose(
        archerfish.apex_distance(alpha, eps), point, rel_tol=4 * EPSILON, abs_tol=5e-324
    )


@given(angles, st.floats(0.0, 1e299))
def test_the_locus_bends_one_way_only(alpha, eps):
    assert archerfish.apex_curvature(alpha, eps) > 0
    assert archerfish.locus_curvature(alpha, eps) > 0

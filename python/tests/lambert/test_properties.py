"""What holds on the real branches whatever the digits."""

import math

from hypothesis import given
from hypothesis import strategies as st

import archerfish

EPSILON = 2.0**-52
offsets = st.floats(0.0, 0.367)


@given(offsets, offsets)
def test_one_branch_rises_and_the_other_falls(a, b):
    near, far = sorted((a, b))
    assert archerfish.lambertw0_offset(near) <= archerfish.lambertw0_offset(far) * (1 + 2 * EPSILON)
    assert archerfish.lambertwm1_offset(near) >= archerfish.lambertwm1_offset(far) * (
        1 + 2 * EPSILON
    )


@given(offsets)
def test_the_branches_lie_on_either_side_of_the_branch_point(d):
    assert archerfish.lambertwm1_offset(d) <= 0 <= archerfish.lambertw0_offset(d)


@given(st.floats(1e-3, 600.0))
def test_choose_w_and_demand_it_back(w):
    z = w * math.exp(w)
    slip = (4 + w) * EPSILON / (1 + w)  # of w, from the rounding of z
    assert math.isclose(archerfish.lambertw0(z), w, rel_tol=slip + 2 * EPSILON)


@given(st.floats(-600.0, -1.01))
def test_choose_w_below_minus_one_and_demand_it_back(w):
    z = w * math.exp(w)
    slip = (4 - w) * EPSILON / abs(1 + w)
    assert math.isclose(archerfish.lambertwm1(z), w, rel_tol=slip + 2 * EPSILON)


@given(st.floats(-0.367879, 0.9))
def test_tree_is_minus_the_principal_branch_of_minus_z(z):
    assert archerfish.tree(-z) == -archerfish.lambertw0(z)


@given(st.floats(1e-6, 0.3678))
def test_the_offset_form_is_the_ordinary_one_moved(d):
    """-1/e + d is rounded here; W's slope, 1/(e^w (1+w)), carries that on."""
    z = d - math.exp(-1)
    for ordinary, offset in (
        (archerfish.lambertw0, archerfish.lambertw0_offset),
        (archerfish.lambertwm1, archerfish.lambertwm1_offset),
    ):
        v = offset(d)
        slope = 1 / (abs(v) * math.exp(v - 1))
        assert abs(1 + ordinary(z) - v) <= EPSILON * (slope + 2 * abs(v) + 2)


@given(st.floats(-0.999, 1e300))
def test_log1pmx_lies_between_minus_x_and_zero_on_the_right(x):
    value = archerfish.log1pmx(x)
    assert value <= 0
    assert x < 0 or value >= -x

"""Rounding of exact values, against Python's own exact rational arithmetic."""

import math
from fractions import Fraction

import numpy as np
import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from reference.ball import NAN, agree, exact, precision, rounded, ulp_errors

finite = st.floats(allow_nan=False, allow_infinity=False)


@given(finite, finite)
def test_sum_of_two_doubles_is_rounded_as_rationals_are(a, b):
    total = Fraction(a) + Fraction(b)
    with precision(5000):
        value = rounded(arb(a) + arb(b))
    assert value.hi == a + b
    if math.isfinite(value.hi):
        assert abs(
            Fraction(value.hi) + Fraction(value.rest) * Fraction(value.ulp) - total
        ) <= Fraction(value.ulp) * Fraction(1, 10**9)
        assert abs(value.rest) <= 0.5


@given(st.floats(-1e308, 1e308).filter(lambda x: x != 0))
def test_ulp_is_the_spacing_of_doubles(x):
    assert rounded(arb(x)) == (x, 0.0, np.spacing(abs(x)))


def test_below_a_power_of_two_the_ulp_is_the_smaller_one():
    with precision(200):
        value = rounded(1 - arb(2) ** -55)
        assert value == (1.0, -0.25, 2.0**-53)
        assert rounded(1 - arb(2) ** -150).ulp == 2.0**-52


def test_beyond_the_largest_double_lies_infinity():
    largest = np.finfo(float).max
    with precision(200):
        assert rounded(arb(largest) + arb(2) ** 969).hi == largest
        assert rounded(arb(largest) + arb(2) ** 970).hi == math.inf
        assert rounded(-(arb(2) ** 1024)).hi == -math.inf


def test_half_of_the_smallest_double_keeps_its_remainder():
    with precision(200):
        assert rounded(arb(5e-324) * 3 / 8) == (0.0, 0.375, 5e-324)


def test_the_ulp_of_a_scale_counts_when_it_is_larger():
    with precision(200):
        value = rounded(arb(2) ** -60 * 3, arb(1))
    assert value == (3 * 2.0**-60, 0.0, 2.0**-52)


def test_precision_rises_until_the_ball_is_narrow():
    def cancelling(x):
        return (arb(x) + 1) - 1

    assert exact(cancelling, 1e-300).hi == 1e-300


def test_errors_are_counted_in_ulp_and_special_values_must_match():
    got = np.array([1.0 + 2.0**-52, math.nan, math.inf, 1.0, math.nan])
    hi = np.array([1.0, math.nan, math.inf, math.nan, 1.0])
    errors = ulp_errors(got, hi, np.array([0.25, 0, 0, 0, 0]), np.full(5, 2.0**-52))
    assert errors.tolist() == [0.75, 0.0, 0.0, math.inf, math.inf]


def test_agreement_means_the_same_value_in_the_same_ulp():
    assert agree(NAN, NAN)
    assert not agree(NAN, rounded(arb(1)))
    assert agree(rounded(arb(1)), rounded(arb(1)))
    assert not agree(rounded(arb(1)), rounded(arb(1), arb(2)))


@pytest.mark.parametrize("x", [math.nan, -math.nan])
def test_nan_goes_in_and_comes_out(x):
    assert math.isnan(exact(lambda x: arb(x), x).hi)

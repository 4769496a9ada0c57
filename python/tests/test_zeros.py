"""Zeros to the last bit, least values to full precision."""

import numpy as np

from archerfish.zeros import least_value, zero_between


def test_zero_is_the_last_double_before_the_change_of_sign():
    root = zero_between(lambda x: 2.0 - x * x, [1.0], [2.0])
    assert 2.0 - root * root > 0
    assert 2.0 - np.nextafter(root, 2.0) ** 2 <= 0


def test_zeros_of_many_scales_at_once():
    places = np.array([1e-300, 1e-10, 0.3, 1.0, 1e10, 1e300])
    low, high = np.full_like(places, 5e-324), np.full_like(places, 1.7e308)
    root = zero_between(lambda x: places - x, low, high)
    assert np.array_equal(np.nextafter(root, np.inf), places)


def test_least_value_has_full_precision_though_its_place_has_not():
    scale = np.array([1e-3, 1.0, 1e3])
    least = least_value(lambda x: x / scale + scale / x, scale / 50, scale * 20)
    np.testing.assert_array_max_ulp(least, np.full(3, 2.0), maxulp=2)

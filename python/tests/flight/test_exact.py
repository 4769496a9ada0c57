"""Every function of a whole flight against exact values."""

import math
import secrets

import numpy as np
import pytest

import archerfish
from reference import accuracy, compare, oracle, tables

NAMES = list(oracle.FLIGHT)
RECORD = accuracy.read_record()


@pytest.mark.parametrize("name", NAMES)
def test_table(name):
    compared = compare.with_table(name, getattr(archerfish, name))
    assert compared.errors.size == len(tables.rows(name))
    compared.assert_within(accuracy.demanded(name, RECORD))


@pytest.mark.parametrize("name", NAMES)
def test_fresh_inputs(name):
    compared = compare.with_oracle(name, getattr(archerfish, name), 1000, secrets.randbits(32))
    compared.assert_within(accuracy.demanded(name, RECORD))


@pytest.mark.parametrize("alpha", [0.0, 5e-324, 1e-300, 1.0, np.pi / 2, 2.0, np.pi])
@pytest.mark.parametrize("eps", [0.0, 5e-324, 1e-308, 1.0, 1e8, 1e300])
def test_the_ends_of_the_domain_are_ordinary(alpha, eps):
    assert math.isfinite(archerfish.flight_time(alpha, eps))
    assert math.isfinite(archerfish.flight_range(alpha, eps))
    assert math.isfinite(archerfish.optimal_angle(eps))
    assert math.isfinite(archerfish.envelope_height(0.0, eps))
    for t in (0.0, 5e-324, 1.0, 1e150):
        assert math.isfinite(archerfish.flight_x(t, alpha, eps))
        assert math.isfinite(archerfish.flight_y(t, alpha, eps))


@pytest.mark.parametrize("name", ["aim_low", "aim_high"])
@pytest.mark.parametrize("time", [1e8, 1e12, 1e16, 1e25, 1e30])
@pytest.mark.parametrize("w", [0.0, 0.001, 1.0, 3.0])
def test_targets_as_deep_as_numbers_go(name, time, w):
    """The rise of the launch is then a difference of far greater numbers."""
    rng = np.random.default_rng(2010)
    alpha = rng.uniform(-1.5, 1.5, 40)
    way, fallen = time, time**2 / 2
    if w > 0:
        way, fallen = -np.expm1(-w) / w * time, (w + np.expm1(-w)) / w**2 * time**2
    x, y, eps = way * np.cos(alpha), way * np.sin(alpha) - fallen, np.full(40, w / time)
    exact = oracle.values(name, x, y, eps)
    assert compare.ulp_errors(getattr(archerfish, name)(x, y, eps), *exact).max() <= 2


@pytest.mark.parametrize("name", ["aim_low", "aim_high"])
@pytest.mark.parametrize("weakest", [1e-8, 1e-3, 1e3, 1e14, 1e16, 1e30, 1e285])
def test_targets_whose_last_digits_decide_whether_they_are_on_the_envelope(name, weakest):
    """They count as on it, which moves them by some of those digits; all others keep to 2 ulp."""
    rng = np.random.default_rng(2026)
    eps = weakest * 10 ** rng.uniform(0, 14, 300)
    x = rng.uniform(-0.95, 0.95, 300) * np.minimum(3.0, 1 / eps)
    top = archerfish.envelope_height(x, eps)
    y = top + rng.integers(-16, 1, 300) * np.spacing(np.abs(top))
    got, exact = getattr(archerfish, name)(x, y, eps), oracle.values(name, x, y, eps)
    assert not np.isnan(got).any()
    known = ~np.isnan(exact[0])
    assert known.mean() > 0.98
    errors = compare.ulp_errors(*(values[known] for values in (got, *exact)))
    assert errors.max() <= 20

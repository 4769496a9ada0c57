"""Every function of α or θ and ε against exact values."""

import math
import secrets

import numpy as np
import pytest

import archerfish
from reference import accuracy, compare, oracle, tables

NAMES = list(oracle.BY_ANGLE)
RECORD = accuracy.read_record()


@pytest.mark.parametrize("name", NAMES)
def test_table(name):
    compared = compare.with_table(name, getattr(archerfish, name))
    assert compared.errors.size == len(tables.rows(name))
    compared.assert_within(accuracy.demanded(name, RECORD))


@pytest.mark.parametrize("name", NAMES)
def test_fresh_inputs(name):
    compared = compare.with_oracle(name, getattr(archerfish, name), 1500, secrets.randbits(32))
    compared.assert_within(accuracy.demanded(name, RECORD))


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize(
    ("angle", "eps"),
    [
        (-0.1, 1.0),
        (-5e-324, 1.0),
        (np.nextafter(np.pi, 4), 1.0),
        (np.inf, 1.0),
        (-np.inf, 1.0),
        (1.0, -5e-324),
        (1.0, -1.0),
        (1.0, np.inf),
        (1.0, -np.inf),
        (np.nan, 1.0),
        (1.0, np.nan),
    ],
)
def test_outside_the_domain_there_is_no_value(name, angle, eps):
    with np.errstate(invalid="ignore"):
        assert math.isnan(getattr(archerfish, name)(angle, eps))


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("angle", [0.0, 5e-324, 1e-300, 1.0, np.pi / 2, 2.0, np.pi])
@pytest.mark.parametrize("eps", [0.0, 5e-324, 1e-308, 1.0, 1e8, 1e300])
def test_the_ends_of_the_domain_are_ordinary(name, angle, eps):
    assert math.isfinite(getattr(archerfish, name)(angle, eps))

"""Lambert W, its offset forms, the tree function and log1pmx against exact values."""

import math
import secrets

import numpy as np
import pytest

import archerfish
from reference import compare, tables

NAMES = ["lambertw0", "lambertwm1", "lambertw0_offset", "lambertwm1_offset", "tree", "log1pmx"]
BRANCH_POINT = -0.36787944117144233


@pytest.mark.parametrize("name", NAMES)
def test_table(name):
    compared = compare.with_table(name, getattr(archerfish, name))
    assert compared.errors.size == len(tables.rows(name))
    compared.assert_within(1.0)


@pytest.mark.parametrize("name", NAMES)
def test_fresh_inputs(name):
    compare.with_oracle(name, getattr(archerfish, name), 1500, secrets.randbits(32)).assert_within(
        1.0
    )


@pytest.mark.parametrize("name", ["lambertw0", "lambertwm1"])
def test_the_double_nearest_the_branch_point_gives_minus_one(name):
    function = getattr(archerfish, name)
    assert function(BRANCH_POINT) == -1.0
    with np.errstate(invalid="ignore"):
        assert math.isnan(function(np.nextafter(BRANCH_POINT, -1)))


def test_limits():
    assert archerfish.lambertw0(0.0) == 0.0
    assert archerfish.lambertw0(np.inf) == np.inf
    assert archerfish.lambertwm1(0.0) == -np.inf
    assert archerfish.lambertw0_offset(0.0) == archerfish.lambertwm1_offset(0.0) == 0.0
    assert archerfish.tree(-BRANCH_POINT) == 1.0
    assert archerfish.log1pmx(-1.0) == -np.inf

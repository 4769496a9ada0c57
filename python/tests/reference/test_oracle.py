"""The exact values themselves, held against other ways to them."""

import math
import secrets

import numpy as np
import pytest
from flint import arb

from reference import inputs, lambert, motion, oracle
from reference.ball import agree, exact, precision, rounded, settled


def bisected(d, side, bits):
    """The root of (v-1) e^(v-1) + 1/e = d on one side of 0 by bisection and nothing else."""
    near, far = arb(0), arb(side)
    while lambert.excess(far) - d < 0:
        near, far = far, 2 * far
    for _ in range(bits):
        middle = ((near + far) / 2).mid()
        near, far = (middle, far) if lambert.excess(middle) - d < 0 else (near, middle)
    return far


@pytest.mark.parametrize("name", ["lambertw0_offset", "lambertwm1_offset"])
def test_offsets_by_bisection(name):
    side = lambert.PRINCIPAL if name == "lambertw0_offset" else lambert.LOWER
    for d in (
        1e-40,
        1e-17,
        1e-9,
        0.01,
        0.2,
        0.36,
        *inputs.log_uniform(1e-20, 0.3)(np.random.default_rng(1), 5),
    ):
        with precision(600):
            value = rounded(bisected(arb(float(d)), side, 400))
        assert agree(value, oracle.FUNCTIONS[name].exact(float(d))), (name, d)


@pytest.mark.parametrize(("name", "branch"), [("lambertw0", 0), ("lambertwm1", -1)])
def test_branches_by_arbs_own_lambert_w(name, branch):
    for z in oracle.sample(name, 300, secrets.randbits(32))[0].tolist():
        value = oracle.FUNCTIONS[name].exact(z)
        if math.isfinite(value.hi) and z not in (lambert.BRANCH_POINT, 0.0):
            assert agree(value, exact(lambda z: arb(z).lambertw(branch), z)), (name, z)


def test_the_double_nearest_the_branch_point_counts_as_it():
    below = math.nextafter(lambert.BRANCH_POINT, -1)
    above = math.nextafter(lambert.BRANCH_POINT, 0)
    with precision(200):
        assert arb(lambert.BRANCH_POINT) < -arb(-1).exp() < arb(above)
    for name in ("lambertw0", "lambertwm1"):
        assert oracle.FUNCTIONS[name].exact(lambert.BRANCH_POINT).hi == -1.0
        assert math.isnan(oracle.FUNCTIONS[name].exact(below).hi)
        assert oracle.FUNCTIONS[name].exact(above).hi != -1.0
    assert oracle.FUNCTIONS["tree"].exact(-lambert.BRANCH_POINT).hi == 1.0


@pytest.mark.parametrize("names", [list(motion.BY_LAUNCH_ANGLE), list(motion.BY_ELEVATION)])
def test_the_fast_road_is_the_slow_road(names):
    """Only the slow road integrates the equation of motion.

    It is spared the thousand steps that ε = 1e300 takes; the tables hold those.
    """
    angles, drags = oracle.sample(names[0], 20, secrets.randbits(32))
    corners = len(inputs.MOTION.corners)
    for i in (*range(0, corners, 29), *range(corners, angles.size)):
        angle, eps = float(angles[i]), float(drags[i])
        if math.isnan(eps) or eps < 1e10:
            for name in names:
                function = oracle.FUNCTIONS[name]
                assert agree(function.exact(angle, eps), function.defined(angle, eps)), (
                    name,
                    angle,
                    eps,
                )


def test_the_slow_road_knows_the_parabola():
    """Without drag everything is elementary."""
    for alpha in (0.3, 1.1, 1.5):
        apex = motion.slow_apex(alpha, 0.0, 192)
        with precision(192):
            s, c = arb(alpha).sin(), arb(alpha).cos()
            for found, known in ((apex.time, s), (apex.x, s * c), (apex.y, s * s / 2)):
                assert abs(found[0] - known) < arb(2) ** -180


def test_the_slow_road_rests_where_its_velocity_vanishes():
    """Going on beyond the apex for as long as it took to climb must descend."""
    for alpha, eps in ((0.7, 0.5), (1.2, 30.0)):
        low = settled(motion.along(motion.slow_apex, lambda locus: locus.y[0]), alpha, eps)
        near = settled(
            motion.along(motion.slow_apex, lambda locus: locus.y[0]), alpha * (1 + 1e-9), eps
        )
        assert near.hi > low.hi

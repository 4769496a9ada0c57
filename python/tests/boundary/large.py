"""More elements than 32 bits can address bytes of: ``make test-large``, about 5 GB of memory."""

import numpy as np
from numpy.testing import assert_array_equal

import archerfish

SIZE = 10**8
PIECE = 10**6


def pieces():
    return (slice(first, first + PIECE) for first in range(0, SIZE, PIECE))


def test_hundred_million_elements():
    z = np.linspace(-0.36, 100.0, SIZE)
    result = archerfish.lambertw0(z)
    for piece in pieces():
        assert_array_equal(result[piece], archerfish.lambertw0(z[piece]))


def test_hundred_million_elements_in_place_and_far_apart():
    given = np.linspace(0.0, np.pi, SIZE)
    room = np.zeros((SIZE, 3))
    alpha = room[:, 1]
    alpha[...] = given
    archerfish.apex_x(alpha, 0.1, out=alpha)
    for piece in pieces():
        assert_array_equal(alpha[piece], archerfish.apex_x(given[piece], 0.1))
    assert not room[:, ::2].any()


def test_hundred_million_float32():
    x = np.linspace(-0.5, 1.0, SIZE, dtype=np.float32)
    result = archerfish.log1pmx(x)
    assert result.dtype == np.float32
    for piece in pieces():
        assert_array_equal(result[piece], archerfish.log1pmx(x[piece]))

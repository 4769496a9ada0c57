"""The two functions of time and their inverses, against 40 digits."""

import mpmath as mp
import numpy as np
import pytest

from archerfish.kinematics import drift, fall, time_of_descent, time_of_drift, time_of_fall

RATES = [0.0, 1e-300, 1e-12, 1e-3, 0.5, 4.0, 300.0]
TIMES = [1e-9, 1e-3, 0.7, 5.0]


def exact(time, rate):
    with mp.workdps(400):
        t, b = mp.mpf(time), mp.mpf(rate)
        moved = t if b == 0 else -mp.expm1(-b * t) / b
        return moved, (t * t / 2 if b == 0 else (t - moved) / b)


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize("time", TIMES)
def test_drift_and_fall(time, rate):
    moved, fallen = (float(value) for value in exact(time, rate))
    np.testing.assert_allclose(drift(time, rate), moved, rtol=5e-16)
    np.testing.assert_allclose(fall(time, rate), fallen, rtol=5e-16)


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize("time", TIMES)
def test_inverses(time, rate):
    moved, fallen = (float(value) for value in exact(time, rate))
    np.testing.assert_allclose(time_of_fall(fallen, rate), time, rtol=1e-15)
    descent = time_of_descent(3.0 * moved + fallen, 3.0, rate)
    np.testing.assert_allclose(drift(descent, rate) * 3 + fall(descent, rate), 3 * moved + fallen)
    if rate * time < 3:  # Later, the drift has all but stopped and says little of the time.
        np.testing.assert_allclose(time_of_drift(moved, rate), time, rtol=1e-14)


def test_what_is_never_reached_is_nan():
    assert np.isnan(time_of_drift([2.0, 3.0, -1.0], 0.5)).tolist() == [True, True, True]
    assert np.isnan(time_of_fall(-1.0, 0.5))
    assert np.isnan(time_of_descent(-1.0, 1.0, 0.5))
    assert time_of_drift(0.0, 0.5) == time_of_fall(0.0, 0.5) == time_of_descent(0.0, 1.0, 0.5) == 0

"""Spheres: Stokes's drag, and a warning where it is a fiction."""

import warnings

import numpy as np
import pytest

from archerfish import Launcher
from archerfish.sphere import LinearDragWarning


def test_stokes_drag():
    mist = Launcher.from_sphere(20e-6, 1000.0, 1.81e-5, 1.2, 0.5)
    mass = 1000.0 * np.pi * 20e-6**3 / 6
    assert mist.drag_rate == pytest.approx(3 * np.pi * 1.81e-5 * 20e-6 / mass, rel=1e-14)
    assert mist.reynolds_number == pytest.approx(1.2 * 0.5 * 20e-6 / 1.81e-5, rel=1e-14)
    assert isinstance(mist, Launcher)
    assert mist.shot(0.5).range > 0


def test_the_same_sphere_faster():
    mist = Launcher.from_sphere(20e-6, 1000.0, 1.81e-5, 1.2, 0.5, gravity=9.0)
    faster = mist.replace(speed=0.6)
    assert faster == Launcher.from_sphere(20e-6, 1000.0, 1.81e-5, 1.2, 0.6, gravity=9.0)
    assert faster.reynolds_number == pytest.approx(1.2 * mist.reynolds_number, rel=1e-15)


def test_above_a_reynolds_number_of_one_it_warns():
    with pytest.warns(LinearDragWarning, match="must be well below 1 for linear drag, got 66.2983"):
        drop = Launcher.from_sphere(1e-3, 1000.0, 1.81e-5, 1.2, 1.0)
    assert drop.reynolds_number == pytest.approx(66.2983, rel=1e-5)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        Launcher.from_sphere([1e-6, 2e-6], 1000.0, 1.81e-5, 1.2, 1.0)


def test_refused():
    with pytest.raises(ValueError, match=r"fluid viscosity must be above 0 and finite, got 0\.0"):
        Launcher.from_sphere(1e-6, 1000.0, 0.0, 1.2, 1.0)

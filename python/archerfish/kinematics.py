"""A flight under a constant pull in a resting medium: two functions of time, and their inverses.

With drag rate b, launch velocity V and constant acceleration a, the place at time t is

    r(t) = V D(t) + a F(t),    D = t E₁(bt),    F = t² E₂(bt),    D′ = e^{−bt},  F′ = D.

D is the drift of a shot without gravity, F the fall from rest under unit gravity; both are flight
ufuncs of the horizontal shot. A steady wind w changes nothing but a: in the medium's frame the
launch velocity is V − w, and (V − w) D + w t = V D + b w F, because t = D + bF. So wind is a tilt
of gravity, a = b w − g, and every question about a windy shot is one about a shot without wind.

Source: the equation of motion before (7) of H. Hernández-Saldaña, Eur. J. Phys. 2010. Any
consistent units.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from archerfish import _core
from archerfish.values import without_unit
from archerfish.zeros import FloatArray, zero_between

#: In place of no drag where a formula divides by it: it changes a result by less than 1e-19.
_LEAST_DRAG = 1e-20
_UPRIGHT = np.pi / 2


def array(value: npt.ArrayLike) -> FloatArray:
    """`value` as an array of doubles; TypeError where it has a unit."""
    return np.asarray(without_unit(value), dtype=np.float64)


def drift(time: npt.ArrayLike, drag_rate: npt.ArrayLike) -> FloatArray:
    """D(t) = (1 − e^{−bt})/b, which is t without drag.

    >>> float(drift(2.0, 0.0))
    2.0
    """
    return array(_core.flight_x(array(time), 0.0, drag_rate))


def fall(time: npt.ArrayLike, drag_rate: npt.ArrayLike) -> FloatArray:
    """F(t) = (bt − 1 + e^{−bt})/b², which is t²/2 without drag.

    >>> float(fall(2.0, 0.0))
    2.0
    """
    return array(-_core.flight_y(array(time), 0.0, drag_rate))


def time_of_drift(distance: npt.ArrayLike, drag_rate: npt.ArrayLike) -> FloatArray:
    """The t at which D(t) is `distance`: −ln(1 − bD)/b. NaN where D never gets there.

    That is the time to the apex of an upright shot whose drag parameter is bD/(1 − bD).

    >>> float(time_of_drift(drift(2.0, 0.5), 0.5).round(12))
    2.0
    """
    distance, drag_rate = array(distance), array(drag_rate)
    share = distance * drag_rate
    left = 1 - share
    with np.errstate(invalid="ignore", divide="ignore"):
        time = distance / left * climb_time(share / left)
    return np.where((distance >= 0) & (share < 1), time, np.nan)


def climb_time(drag_parameter: npt.ArrayLike) -> FloatArray:
    """ln(1 + ε)/ε, the time to the apex of an upright shot, in units of the drag-free time.

    >>> float(climb_time(0.0))
    1.0
    """
    return array(_core.apex_time(_UPRIGHT, drag_parameter))


def time_of_fall(depth: npt.ArrayLike, drag_rate: npt.ArrayLike) -> FloatArray:
    """The t at which F(t) is `depth`. NaN below 0.

    With σ = b²F, the time in units of 1/b is σ + 1 + W₀(−e^{−1−σ}). Its last two terms are the
    Lambert function counted from its branch point, which keeps the digits of small σ.

    >>> float(time_of_fall(fall(2.0, 0.5), 0.5).round(12))
    2.0
    """
    depth, drag_rate = array(depth), array(drag_rate)
    with np.errstate(invalid="ignore", over="ignore"):
        root = np.sqrt(depth)
        share = np.maximum(root * drag_rate, _LEAST_DRAG)
        sigma = share * share
        offset = -np.expm1(-sigma) / np.e
        # For σ = 1e-40 the offset form is √(2σ), and the time √(2F).
        unit = (sigma + _core.lambertw0_offset(offset)) / share
    # A σ that overflows is all of its sum, and terminal speed all of the fall.
    return np.asarray(root * np.where(np.isinf(sigma), share, unit))


def time_of_descent(
    depth: npt.ArrayLike, speed: npt.ArrayLike, drag_rate: npt.ArrayLike
) -> FloatArray:
    """The t at which `speed` D(t) + F(t) is `depth`: thrown down, under unit gravity.

    Elementwise NaN where `depth` is below 0. Found by bisection, as its closed form loses digits.

    >>> float(time_of_descent(4.0, 1.0, 0.0))
    2.0
    """
    depth, speed, drag_rate = np.broadcast_arrays(array(depth), array(speed), array(drag_rate))

    def missing(time: FloatArray) -> FloatArray:
        with np.errstate(over="ignore", invalid="ignore"):
            return np.asarray(depth - (speed * drift(time, drag_rate) + fall(time, drag_rate)))

    low = np.full(depth.shape, 5e-324)
    time = zero_between(missing, low, np.full(depth.shape, 1e300))
    time = np.nextafter(time, np.inf)  # so that a root at a double is that double
    return np.where(depth > 0, time, np.where(depth == 0, 0.0, np.nan))

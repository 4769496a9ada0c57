"""Integrals along a flight: the length of the path, and what its greatest value needs.

With constant pull a, the velocity is V e^{−bt} + a D(t). Along −a it is (a/b)(q e^{−bt} − 1) with
q = 1 + bVₐ/a, across it Vₚ e^{−bt}; so the speed has its nearest complex zeros, where it is not
smooth, at bt = ln(q ± iλ), λ = bVₚ/a. A steep shot's lie next to the apex. Panels that grow from
there by a factor 3 keep them a panel away, and Gauss-Legendre quadrature gives all digits.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from archerfish.kinematics import array, drift
from archerfish.quadrature import over_panels
from archerfish.zeros import FloatArray

Triple: TypeAlias = "tuple[FloatArray, FloatArray, FloatArray]"

_GROWTH = 3.0
#: Before the apex the speed falls like e^{−bt}: panels no longer than this many 1/b.
_LONGEST_DECAY = 16.0
#: Least first panel, in units of the flight time: what is narrower is lost in rounding.
_NARROWEST = 1e-17
_LEAST_DRAG = 1e-20


def path_length(
    until: npt.ArrayLike, launch: Triple, pull: Triple, drag_rate: npt.ArrayLike
) -> FloatArray:
    """Length of the path from time 0 to `until`; NaN for a time below 0 or not finite."""

    def speed(time: FloatArray, at: Callable[[FloatArray], FloatArray]) -> FloatArray:
        return speed_at(time, _columns(at, launch), _columns(at, pull), at(drag))

    drag = array(drag_rate)
    return flight_integral(speed, until, launch, pull, drag)


def speed_at(time: FloatArray, launch: Triple, pull: Triple, drag: FloatArray) -> FloatArray:
    """The speed at `time`."""
    decay, moved = np.exp(-drag * time), drift(time, drag)
    x, y, z = (v * decay + a * moved for v, a in zip(launch, pull, strict=True))
    return np.asarray(np.hypot(np.hypot(x, z), y))


def flight_integral(
    integrand: Callable[[FloatArray, Callable[[FloatArray], FloatArray]], FloatArray],
    until: npt.ArrayLike,
    launch: Triple,
    pull: Triple,
    drag_rate: npt.ArrayLike,
) -> FloatArray:
    """∫ integrand dt from 0 to `until`.

    The integrand takes times, with a last axis for the nodes, and a function that gives an array of
    the shots the shape to go with them.
    """
    stop, drag, *parts = np.broadcast_arrays(array(until), array(drag_rate), *launch, *pull)
    with np.errstate(all="ignore"):
        good = (stop >= 0) & np.isfinite(stop)
        stop = np.where(good, stop, 0.0)
        edges = _edges(stop, parts[:3], parts[3:], drag)

        def with_nodes(value: FloatArray) -> FloatArray:
            return np.broadcast_to(value, stop.shape)[..., np.newaxis]

        total = over_panels(lambda time: integrand(time, with_nodes), edges)
    return np.where(good, total, np.nan)


def _edges(
    stop: FloatArray, launch: list[FloatArray], pull: list[FloatArray], drag: FloatArray
) -> list[FloatArray]:
    """Ends of the panels, from 0 to `stop`, graded around the time where the speed bends most."""
    strength = np.sqrt(sum(a * a for a in pull))
    speed = np.sqrt(sum(v * v for v in launch))
    along = -sum(v * a for v, a in zip(launch, pull, strict=True)) / strength
    across = np.sqrt(
        sum((launch[i] * pull[j] - launch[j] * pull[i]) ** 2 for i, j in ((0, 1), (1, 2), (2, 0)))
    )
    across = across / strength
    rate = np.maximum(drag, _LEAST_DRAG * strength / speed)
    share = rate / strength
    centre = 0.5 * np.log1p(share * (2 * along + share * speed * speed)) / rate
    scale = np.arctan2(share * across, 1 + share * along) / rate
    centre = np.clip(np.where(np.isfinite(centre), centre, 0.0), 0.0, stop)
    scale = np.maximum(np.where(np.isfinite(scale), scale, stop), _NARROWEST * stop)

    before, width = [centre], scale
    while np.any(before[-1] > 0):
        step = np.minimum(width, _LONGEST_DECAY / rate)
        before.append(np.maximum(before[-1] - step, 0.0))
        width = width * (_GROWTH - 1) if len(before) == 2 else width * _GROWTH
    after, width = [centre], scale
    while np.any(after[-1] < stop):
        after.append(np.minimum(after[-1] + width, stop))
        width = width * (_GROWTH - 1) if len(after) == 2 else width * _GROWTH
    return [*reversed(before), *after[1:]]


def _columns(at: Callable[[FloatArray], FloatArray], vector: Triple) -> Triple:
    x, y, z = vector
    return at(x), at(y), at(z)

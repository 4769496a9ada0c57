"""The length of a path: an integral along the flight.

With constant pull a, the velocity is V e^{−bt} + a D(t). Along −a it is (a/b)(q e^{−bt} − 1) with
q = 1 + bVₐ/a, across it Vₚ e^{−bt}; so the speed has its nearest complex zeros, where it is not
smooth, at bt = ln(q ± iλ), λ = bVₚ/a. A steep shot's lie next to the apex. Panels that grow from
there by a factor 3 keep them a panel away, and Gauss-Legendre quadrature gives all digits.
"""

from __future__ import annotations

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
    stop, drag, *parts = np.broadcast_arrays(array(until), array(drag_rate), *launch, *pull)
    good = (stop >= 0) & np.isfinite(stop)
    stop = np.where(good, stop, 0.0)
    columns = [part[..., np.newaxis] for part in (drag, *parts)]

    def speed(time: FloatArray) -> FloatArray:
        decay, moved = np.exp(-columns[0] * time), drift(time, columns[0])
        x, y, z = (columns[k] * decay + columns[k + 3] * moved for k in (1, 2, 3))
        return np.asarray(np.hypot(np.hypot(x, z), y))

    with np.errstate(all="ignore"):
        total = over_panels(speed, _edges(stop, parts[:3], parts[3:], drag))
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
    # Where wind carries the whole weight nothing bends; the speed falls like e^{−bt}.
    still = np.minimum(stop, 1 / rate)
    scale = np.where(np.isfinite(scale), np.maximum(scale, _NARROWEST * stop), still)

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

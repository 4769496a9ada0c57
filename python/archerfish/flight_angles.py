"""The launch angles that deserve a name, those of whole flights among them.

Functions take the drag parameter ε (a number or an array, at least 0 and finite) and return launch
angles in radians. The two of this module are zeros of the derivative of an integral along the
flight, in units of V₀²/g and V₀/g; T is the flight time over level ground, D(t) the drift.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from archerfish import _core
from archerfish import named_angles as named
from archerfish.kinematics import drift
from archerfish.path import flight_integral, speed_at
from archerfish.values import Quantity, Value, frozen
from archerfish.zeros import FloatArray


@dataclass(frozen=True, eq=False)
class NamedAngles(Value):
    """Launch angles (radians) of the shots with something to their name.

    `greatest_range` over level ground; `greatest_curvature`, where the locus of apexes bends most,
    and `greatest_curvature_elevation`, the elevation of that apex; `rightmost` and `farthest` apex;
    `receding`, up to which the distance to the projectile never shrinks; `longest_path` and
    `largest_area` under the path, over level ground.
    """

    greatest_range: Quantity
    greatest_curvature: Quantity
    greatest_curvature_elevation: Quantity
    rightmost: Quantity
    farthest: Quantity
    receding: Quantity
    longest_path: Quantity
    largest_area: Quantity


def named_angles(epsilon: npt.ArrayLike) -> NamedAngles:
    """All of them for each ε.

    >>> angles = named_angles([0.0, 1.0])
    >>> np.degrees(angles.largest_area).round(6).tolist()
    [60.0, 55.178454]
    """
    bend = named.greatest_curvature_angle(epsilon)
    angles = (
        named.greatest_range_angle(epsilon),
        bend,
        _core.apex_elevation(bend, epsilon),
        named.rightmost_angle(epsilon),
        named.farthest_angle(epsilon),
        named.receding_angle(epsilon),
        longest_path_angle(epsilon),
        largest_area_angle(epsilon),
    )
    return NamedAngles(*(frozen(np.array(angle, dtype=np.float64)) for angle in angles))


def longest_path_angle(epsilon: npt.ArrayLike) -> Quantity:
    """Launch angle α of the longest path from launch to level ground, in radians.

    With v the speed, the length L = ∫ v dt has
    (dL/dα)/cos α = v D/|ẏ| at T − ∫₀ᵀ e^{−εt} D/v dt. Without drag sin α artanh(sin α) = 1.

    >>> float(np.degrees(longest_path_angle(0.0)).round(10))
    56.4658351275
    """

    def condition(alpha: FloatArray, eps: FloatArray) -> FloatArray:
        launch, pull = _flight(alpha)
        time = np.asarray(_core.flight_time(alpha, eps))
        end = drift(time, eps)
        falling = np.abs(launch[1] * np.exp(-eps * time) - end)

        def lost(t: FloatArray, at: Callable[[FloatArray], FloatArray]) -> FloatArray:
            sine, cosine = at(launch[1]), at(launch[0])
            zero = np.zeros(np.shape(sine))
            speed = speed_at(t, (cosine, sine, zero), (zero, zero - 1, zero), at(eps))
            return np.asarray(np.exp(-at(eps) * t) * (drift(t, at(eps)) / at(end)) / speed)

        last = speed_at(time, launch, pull, eps) / falling
        return np.asarray(last - flight_integral(lost, time, launch, pull, eps))

    return named._solve(condition, epsilon)


def largest_area_angle(epsilon: npt.ArrayLike) -> Quantity:
    """Launch angle α of the largest area between the path and level ground, in radians.

    For A = ∫ y dx, dA/dα = ∫₀ᵀ D (e^{−εt} − D sin α) dt, that is D(T)²/2 − sin α ∫₀ᵀ D² dt. Without
    drag 60 degrees.

    >>> float(np.degrees(largest_area_angle(0.0)).round(10))
    60.0
    """

    def condition(alpha: FloatArray, eps: FloatArray) -> FloatArray:
        launch, pull = _flight(alpha)
        time = np.asarray(_core.flight_time(alpha, eps))
        end = drift(time, eps)

        def square(t: FloatArray, at: Callable[[FloatArray], FloatArray]) -> FloatArray:
            ratio = drift(t, at(eps)) / at(end)
            return np.asarray(ratio * ratio)

        return np.asarray(0.5 - launch[1] * flight_integral(square, time, launch, pull, eps))

    return named._solve(condition, epsilon)


def _flight(
    alpha: FloatArray,
) -> tuple[tuple[FloatArray, FloatArray, FloatArray], tuple[FloatArray, FloatArray, FloatArray]]:
    """Launch velocity and gravity, each of length 1."""
    sine, cosine = np.asarray(np.sin(alpha)), np.asarray(np.cos(alpha))
    zero = np.zeros(np.shape(sine))
    return (cosine, sine, zero), (zero, zero - 1, zero)

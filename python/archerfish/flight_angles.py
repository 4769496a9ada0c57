"""The launch angles that deserve a name, those of whole flights among them.

Functions take the drag parameter ε (a number or an array, at least 0 and finite) and return launch
angles in radians. The two of this module are zeros of the derivative of an integral along the
flight, in units of V₀²/g and V₀/g; T is the flight time over level ground, D(t) the drift.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from archerfish import _core
from archerfish import named_angles as named
from archerfish.kinematics import drift
from archerfish.quadrature import gauss_legendre, weighted_sum
from archerfish.values import Quantity, Value, frozen
from archerfish.zeros import FloatArray

#: What a logarithm's argument may be, where more would overflow and changes nothing.
_FAR = 1e300


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
    (dL/dα)/cos α = v D/|ẏ| at T − ∫₀ᵀ e^{−εt} D/v dt. In terms of D the speed is v² = 1 − 2mD + AD²
    with m = s + ε and A = q² + ε²c², so that the integral is elementary: with h = A D(T) − m it is
    (v(T) − 1 + (m/√A) (arsinh(h/c) + arsinh(m/c)))/A. Without drag sin α artanh(sin α) = 1.

    >>> float(np.degrees(longest_path_angle(0.0)).round(10))
    56.4658351275
    """

    def condition(alpha: FloatArray, eps: FloatArray) -> FloatArray:
        s, c = np.sin(alpha), np.cos(alpha)
        time = np.asarray(_core.flight_time(alpha, eps))
        end, decay = drift(time, eps), np.exp(-eps * time)
        q, m = 1 + eps * s, s + eps
        root = np.hypot(q, eps * c)
        # Falling speed and h at the end: where drag is strong, D(T) = (1 − e^{−εT})/ε has no digits
        # left of what they are made of.
        strong, rate = eps > 1, np.maximum(eps, 1.0)
        falling = np.where(strong, (1 - decay * q) / rate, q * end - s)
        with np.errstate(over="ignore"):
            h = np.where(strong, (q - decay * root * root) / rate, root * root * end - m)
            turn = np.arcsinh(h / c) + np.arcsinh(np.minimum(m / c, _FAR))
        speed = np.hypot(c * decay, falling)
        return np.asarray(speed * (h + m) / falling - (speed - 1) - m / root * turn)

    return named._solve(condition, epsilon)


def largest_area_angle(epsilon: npt.ArrayLike) -> Quantity:
    """Launch angle α of the largest area between the path and level ground, in radians.

    For A = ∫ y dx, dA/dα = ∫₀ᵀ D (e^{−εt} − D sin α) dt, that is D(T)²/2 − sin α ∫₀ᵀ D² dt. Without
    drag 60 degrees. With δ = εD(T) the integral is D(T)³ ∫₀¹ x²/(1 − δx) dx; and as y(T) = 0, it
    is also D (2 sin α − D)/(2ε) at T, which is the one to take where drag is strong.

    >>> float(np.degrees(largest_area_angle(0.0)).round(10))
    60.0
    """

    def condition(alpha: FloatArray, eps: FloatArray) -> FloatArray:
        s = np.sin(alpha)
        end = drift(_core.flight_time(alpha, eps), eps)
        lost = eps * end
        strong = lost > 0.5
        weak_drag = 0.5 - s * end * _third_moment(np.where(strong, 0.0, lost))
        strong_drag = lost + s * (end - 2 * s)
        return np.where(strong, strong_drag, weak_drag)

    return named._solve(condition, epsilon)


def _third_moment(delta: FloatArray) -> FloatArray:
    """∫₀¹ x²/(1 − δx) dx for δ up to 1/2, where 16 Gauss nodes are exact."""
    nodes, weights = gauss_legendre()
    x, weight = 0.5 * (1 + nodes), 0.5 * weights
    return weighted_sum(x * x / (1 - delta[..., np.newaxis] * x), weight)

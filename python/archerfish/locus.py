"""The locus of apexes, in SI units."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from archerfish import _core, named_angles
from archerfish.quadrature import FloatArray, integral
from archerfish.values import (
    Quantity,
    Value,
    frozen,
    not_negative,
    positive,
    product,
    quotient,
    without_unit,
)

_HALF_PI = np.pi / 2


@dataclass(frozen=True, eq=False)
class ApexPoints(Value):
    """Apexes of some shots: one number or one array a field, all of one shape.

    `launch_angle` and `elevation` (polar angle seen from the launch point) are in radians; `x`,
    `y` and `distance` (from the launch point) in metres; `time` (of flight to the apex) in
    seconds; `curvature` (of the locus at this point) in 1/m.
    """

    launch_angle: Quantity
    elevation: Quantity
    x: Quantity
    y: Quantity
    distance: Quantity
    time: Quantity
    curvature: Quantity


@dataclass(frozen=True, eq=False)
class ApexLocus(Value):
    """The curve formed by the apexes of all shots of one speed: the paper's C_m(ε).

    `epsilon` is the drag parameter (at least 0), `length_scale` = V₀²/g (m) and `time_scale` =
    V₀/g (s); arrays broadcast, also against the angles asked for. Usually made by
    `Launcher.locus`. Angles are in radians from 0 to π; outside, the results are NaN with NumPy's
    `invalid` warning.

    Source: H. Hernández-Saldaña, Eur. J. Phys. 2010, equations (7)-(15) and (19).

    >>> from archerfish import Launcher
    >>> locus = Launcher(10.0, epsilon=0.1).locus
    >>> bool(locus.area < locus.drag_free.area)
    True
    """

    epsilon: Quantity
    length_scale: Quantity
    time_scale: Quantity

    def __post_init__(self) -> None:
        object.__setattr__(self, "epsilon", not_negative("epsilon", self.epsilon))
        for name in ("length_scale", "time_scale"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))

    def at_launch_angle(self, alpha: npt.ArrayLike) -> ApexPoints:
        """The apexes of the shots at launch angle `alpha` (radians, 0 to π).

        Equations (7) and (8), and (10) for the elevation.

        >>> from archerfish import Launcher
        >>> points = Launcher(10.0, gravity=10.0, epsilon=0.0).locus.at_launch_angle([0.0, 0.5])
        >>> points.y.round(6).tolist()
        [0.0, 1.149244]
        """
        eps = self.epsilon
        elevation = _core.apex_elevation(without_unit(alpha, "alpha"), eps)
        with np.errstate(invalid="ignore"):  # one warning of one bad angle, not six
            return self._points(
                launch_angle=alpha,
                elevation=elevation,
                distance=_core.apex_distance(alpha, eps),
                curvature=_core.apex_curvature(alpha, eps),
            )

    def at_elevation(self, theta: npt.ArrayLike) -> ApexPoints:
        """The apexes seen from the launch point at elevation `theta` (radians, 0 to π).

        The inverse of equation (10) for the launch angle, (13) for the distance and (19) for the
        curvature.

        >>> from archerfish import Launcher
        >>> point = Launcher(10.0, epsilon=0.0).locus.at_elevation(0.4636476090008061)
        >>> round(float(point.launch_angle), 12)  # tan θ = 1/2 without drag: 45 degrees
        0.785398163397
        """
        eps = self.epsilon
        launch_angle = _core.locus_launch_angle(without_unit(theta, "theta"), eps)
        with np.errstate(invalid="ignore"):  # one warning of one bad angle, not six
            return self._points(
                launch_angle=launch_angle,
                elevation=theta,
                distance=_core.locus_radius(theta, eps),
                curvature=_core.locus_curvature(theta, eps),
            )

    @cached_property
    def highest(self) -> ApexPoints:
        """The highest apex, that of the vertical shot.

        >>> from archerfish import Launcher
        >>> round(float(Launcher(10.0, gravity=10.0, epsilon=0.0).locus.highest.y), 12)
        5.0
        """
        return self.at_launch_angle(_HALF_PI)

    @cached_property
    def rightmost(self) -> ApexPoints:
        """The apex farthest from the vertical axis: dx/dα = 0.

        >>> from archerfish import Launcher
        >>> round(float(Launcher(10.0, gravity=10.0, epsilon=0.0).locus.rightmost.x), 12)
        5.0
        """
        return self.at_launch_angle(named_angles.rightmost_angle(self.epsilon))

    @cached_property
    def farthest(self) -> ApexPoints:
        """The apex farthest from the launch point.

        >>> from archerfish import Launcher
        >>> alpha = Launcher(10.0, epsilon=0.1).locus.farthest.launch_angle
        >>> round(float(np.degrees(alpha)), 10)
        54.0365143493
        """
        return self.at_launch_angle(named_angles.farthest_angle(self.epsilon))

    @cached_property
    def max_curvature(self) -> ApexPoints:
        """The apex where the locus bends most.

        >>> from archerfish import Launcher
        >>> locus = Launcher(10.0, epsilon=0.1).locus
        >>> round(float(locus.max_curvature.curvature * locus.length_scale), 12)
        8.424601338523
        """
        return self.at_launch_angle(named_angles.greatest_curvature_angle(self.epsilon))

    def arc_length(self, start: npt.ArrayLike = 0.0, stop: npt.ArrayLike = _HALF_PI) -> Quantity:
        """Length of the locus (m) between launch angles `start` and `stop` (radians, 0 to π).

        Unless given, from the launch point to the highest apex. Negative where `stop` is less
        than `start`, as an integral is.

        >>> from archerfish import Launcher
        >>> locus = Launcher(10.0, epsilon=0.1).locus
        >>> round(locus.arc_length() / locus.length_scale, 12)
        1.133437425736
        """

        def speed(alpha: FloatArray, eps: FloatArray) -> FloatArray:
            x = _core.apex_x(alpha, eps)
            return np.hypot(x, named_angles.apex_x_slope(alpha, eps))  # dy/dα = x

        return product(frozen(integral(speed, start, stop, self.epsilon)), self.length_scale)

    @cached_property
    def area(self) -> Quantity:
        """Area between the locus and the vertical axis (m²).

        >>> from archerfish import Launcher
        >>> locus = Launcher(10.0, epsilon=0.0).locus
        >>> round(locus.area / locus.length_scale**2 / np.pi, 12)  # half an ellipse
        0.0625
        """

        def strip(alpha: FloatArray, eps: FloatArray) -> FloatArray:
            x = np.asarray(_core.apex_x(alpha, eps))
            return x * x  # x dy, with dy/dα = x

        half = frozen(integral(strip, 0.0, _HALF_PI, self.epsilon))
        return product(product(half, self.length_scale), self.length_scale)

    @cached_property
    def drag_free(self) -> DragFreeEllipse:
        """The locus of the same shots without drag: an ellipse, equation (15).

        >>> from archerfish import Launcher
        >>> round(Launcher(10.0, gravity=10.0, epsilon=0.1).locus.drag_free.semi_major_axis, 12)
        5.0
        """
        return DragFreeEllipse(
            epsilon=0.0, length_scale=self.length_scale, time_scale=self.time_scale
        )

    def _points(
        self,
        *,
        launch_angle: npt.ArrayLike,
        elevation: npt.ArrayLike,
        distance: npt.ArrayLike,
        curvature: npt.ArrayLike,
    ) -> ApexPoints:
        """The record of these apexes; lengths, times and curvature come in units of the scales."""
        alpha = np.asarray(launch_angle, dtype=np.float64)
        eps, length, time = self.epsilon, self.length_scale, self.time_scale
        fields = np.broadcast_arrays(
            alpha,
            np.asarray(elevation, dtype=np.float64),
            np.multiply(_core.apex_x(alpha, eps), length),
            np.multiply(_core.apex_y(alpha, eps), length),
            np.multiply(distance, length),
            np.multiply(_core.apex_time(alpha, eps), time),
            np.divide(curvature, length),
        )
        return ApexPoints(*(frozen(field.copy()) for field in fields))


@dataclass(frozen=True, eq=False)
class DragFreeEllipse(ApexLocus):
    """The locus without drag: an ellipse through the launch point, centred ρ/4 above it.

    Equation (15): r = 2ρ sin θ / (1 + 3 sin²θ), of eccentricity √3/2. All of `ApexLocus` applies.

    >>> from archerfish import Launcher
    >>> ellipse = Launcher(10.0, gravity=10.0, epsilon=0.1).locus.drag_free
    >>> ellipse.semi_major_axis, ellipse.semi_minor_axis, round(ellipse.eccentricity, 6)
    (5.0, 2.5, 0.866025)
    """

    @property
    def semi_major_axis(self) -> Quantity:
        """Horizontal semi-axis ρ/2 (m)."""
        return quotient(self.length_scale, 2.0)

    @property
    def semi_minor_axis(self) -> Quantity:
        """Vertical semi-axis ρ/4 (m), also the height of the centre."""
        return quotient(self.length_scale, 4.0)

    @property
    def eccentricity(self) -> float:
        """√3/2, for every speed and gravity."""
        return float(np.sqrt(3.0) / 2.0)

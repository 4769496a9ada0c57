"""Aiming: both arcs through a target, or the proof that there is none.

The medium's wind only tilts and changes gravity (`archerfish.kinematics`), and a shot stays in the
plane of its launch velocity and that pull. So aiming in space, in any steady wind, is aiming in one
plane without wind: turn the target into the plane's axes, ask the ufuncs `aim_low` and `aim_high`,
and turn the direction back.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from archerfish import _core
from archerfish.kinematics import (
    array,
    drift,
    fall,
    time_of_descent,
    time_of_drift,
    time_of_fall,
)
from archerfish.shot import Apex, Shot, Vector, record, wind_vector
from archerfish.values import Quantity, Value, finite, frozen, not_negative, positive, real
from archerfish.zeros import FloatArray, zero_between

if TYPE_CHECKING:
    from archerfish.gradients import AngleGradient
    from archerfish.launcher import Launcher

#: What `Aim.status` says of a target.
REACHABLE, UNREACHABLE, UNDEFINED = 0, 1, 2

#: Cosine of a launch angle below which the time of a rise is found from height, not distance.
_STEEP = 1e-3
#: What gravity counts as, of itself, where wind cancels it: no digit of the low arc depends on it.
_LEAST_PULL = 1e-30
#: Newton steps that make a good time of arrival exact.
_STEPS = 3


@dataclass(frozen=True, eq=False)
class Arc(Value):
    """One way to hit a target: `shot` is there after `time` (s). Both NaN where there is none."""

    shot: Shot
    target: Vector
    time: Quantity

    @property
    def angle(self) -> Quantity:
        """Elevation of the launch velocity (radians)."""
        return self.shot.angle

    @property
    def azimuth(self) -> Quantity:
        """Bearing of the launch velocity, from x towards z (radians)."""
        return self.shot.azimuth

    @property
    def apex(self) -> Apex:
        """Highest point of the shot, whether before the target or after it."""
        return self.shot.apex

    @cached_property
    def impact_velocity(self) -> Vector:
        """Velocity at the target (m/s)."""
        return self.shot.velocity(self.time)

    @cached_property
    def impact_speed(self) -> Quantity:
        """Speed at the target (m/s)."""
        v = self.impact_velocity
        return frozen(np.asarray(np.hypot(np.hypot(v.x, v.z), v.y)))

    @cached_property
    def impact_angle(self) -> Quantity:
        """Angle of the velocity at the target above the horizontal (radians)."""
        v = self.impact_velocity
        return frozen(np.asarray(np.arctan2(v.y, np.hypot(v.x, v.z))))

    @cached_property
    def highest(self) -> Quantity:
        """Greatest height y on the way to the target (m)."""
        rising = np.asarray(self.apex.time) < self.time
        ends = np.maximum(self.shot.height, self.target.y)
        with np.errstate(invalid="ignore"):
            height = np.where(rising, self.apex.y, ends)
        return frozen(np.where(np.isnan(self.time), np.nan, height))

    def clearance_over(self, x: npt.ArrayLike, y: npt.ArrayLike) -> Quantity:
        """How far above an obstacle at `x`, `y` (m) the arc passes: negative if it hits it.

        `x` and `y` broadcast with the targets. NaN where the arc ends before it gets there; the
        lower pass where a headwind brings the projectile by twice.

        >>> from archerfish import Launcher
        >>> arcs = Launcher(10.0, epsilon=0.1).aim(6.0, 2.0)
        >>> arcs.low.clearance_over(4.0, 2.5) > 0, arcs.high.clearance_over(4.0, 2.5) > 0
        (False, True)
        """
        passes = [
            np.where(time <= np.asarray(self.time), self.shot.position(time).y - array(y), np.nan)
            for time in (self.shot.time_at(x), self.shot.time_again_at(x))
        ]
        # The arc ends on its target, whatever the last digit of the time at its x.
        end = (array(x) == self.target.x) & ~np.isnan(self.time)
        passes.append(np.where(end, self.target.y - array(y), np.nan))
        return frozen(np.fmin.reduce(np.broadcast_arrays(*passes)))

    def clearance_under(self, ceiling: npt.ArrayLike) -> Quantity:
        """How far below a `ceiling` (m) the arc stays on its way to the target; negative if not.

        >>> from archerfish import Launcher
        >>> arcs = Launcher(10.0, epsilon=0.1).aim(6.0, 2.0)
        >>> arcs.low.clearance_under(3.0) > 0, arcs.high.clearance_under(3.0) > 0
        (True, False)
        """
        return frozen(np.asarray(array(ceiling) - self.highest))

    @cached_property
    def angle_gradient(self) -> AngleGradient:
        """Derivatives of `angle` by speed, drag rate, gravity and target, which stays hit.

        >>> from archerfish import Launcher
        >>> low = Launcher(10.0, epsilon=0.1).aim(6.0, 2.0).low
        >>> low.angle_gradient.speed < 0  # more speed, flatter shot
        True
        """
        from archerfish.gradients import angle_gradient

        return angle_gradient(self.shot, self.target, self.time)


@dataclass(frozen=True, eq=False)
class Unreachable(Value):
    """The proof that no shot of this speed hits the target.

    The target is `margin` (m) above the envelope of all shots, measured against gravity (tilted by
    wind), infinite where it is beyond the wall that drag puts up; `minimum_speed` (m/s) is the
    least launch speed that reaches it.

    >>> from archerfish import Launcher
    >>> answer = Launcher(10.0, epsilon=0.1).aim(9.0, 3.0)
    >>> answer.reachable, round(answer.margin, 6), round(answer.minimum_speed, 6)
    (False, 2.67285, 11.578631)
    """

    target: Vector
    margin: Quantity
    minimum_speed: Quantity

    reachable = False


@dataclass(frozen=True, eq=False)
class Aim(Value):
    """Both arcs to a target, or to each of many; NaN where a target is out of reach.

    `low` is the flat and fast one, `high` the steep and slow; on the envelope they are one, and
    where wind carries the whole weight. `status` is `REACHABLE`, `UNREACHABLE`, or `UNDEFINED`
    where a coordinate is not finite. `margin` (m) is the target's height above the envelope,
    negative below it.

    >>> from archerfish import Launcher
    >>> arcs = Launcher(10.0, epsilon=0.1).aim([4.0, 9.0, np.nan], 3.0)
    >>> arcs.status
    array([0, 1, 2], dtype=int8)
    """

    target: Vector
    low: Arc
    high: Arc
    margin: Quantity
    minimum_speed: Quantity

    @cached_property
    def reachable(self) -> bool | npt.NDArray[np.bool_]:
        """Whether the target is on or under the envelope."""
        hit = ~np.isnan(np.asarray(self.low.angle))
        return bool(hit) if hit.ndim == 0 else hit

    @cached_property
    def status(self) -> npt.NDArray[np.int8]:
        """`REACHABLE`, `UNREACHABLE` or `UNDEFINED`, for each target."""
        place = self.target
        known = np.isfinite(place.x) & np.isfinite(place.y) & np.isfinite(place.z)
        hit = np.asarray(self.reachable)
        return np.where(hit, REACHABLE, np.where(known, UNREACHABLE, UNDEFINED)).astype(np.int8)


class _Plane(NamedTuple):
    """A target in the plane of the shots that can hit it."""

    forward: FloatArray  # unit vector across the pull, towards the target; components first
    up: FloatArray  # unit vector against the pull
    distance: FloatArray  # of the target along `forward`, at least 0
    rise: FloatArray  # of the target along `up`
    strength: FloatArray  # of the pull
    weightless: FloatArray  # whether wind carries the whole weight


def aim(
    launcher: Launcher,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike | None = None,
    *,
    height: npt.ArrayLike = 0.0,
    wind: Any = None,
) -> Aim | Unreachable:
    """What `Launcher.aim` does."""
    in_space = z is not None or (
        wind is not None and not isinstance(wind, Vector) and len(wind) > 2
    )
    target = _target(x, y, z)
    height, air = finite("height", height), wind_vector(wind)
    speed, gravity, drag = np.broadcast_arrays(
        array(launcher.speed), array(launcher.gravity), array(launcher.drag_rate)
    )
    with np.errstate(all="ignore"):
        plane = _plane(target, height, air, gravity, drag)
        time_unit = speed / plane.strength
        length = speed * time_unit
        still = plane.strength == gravity
        eps = np.where(still, launcher.epsilon, drag * time_unit)
        distance, rise = plane.distance / length, plane.rise / length
        margin = (rise - _envelope(distance, eps)) * length
        least = _minimum_speed(plane, drag)
        ways: list[tuple[FloatArray, FloatArray]] = []
        for high, kernel in ((False, _core.aim_low), (True, _core.aim_high)):
            angle = array(kernel(distance, rise, eps))
            ways.append((angle, _arrival(distance, rise, angle, eps, high) * time_unit))
        arcs = []
        for way in ways:
            # Without weight nothing comes down from a high arc: the straight way is the only one.
            angle, time = map(np.where, (plane.weightless,) * 2, ways[0], way)
            elevation, azimuth = _direction(plane, angle, in_space)
            hit = ~np.isnan(elevation)
            shot = Shot(
                launcher,
                frozen(elevation),
                frozen(np.where(hit, azimuth, 0.0)),
                height,
                target.y if np.all(hit) else frozen(np.where(hit, target.y, 0.0)),
                air,
            )
            arcs.append(Arc(shot, target, frozen(np.asarray(time))))
    low, high_arc = arcs
    if np.ndim(low.angle) == 0 and np.isnan(low.angle):
        known = not np.isnan(np.asarray(margin)) or np.isinf(np.asarray(margin))
        if known:
            return Unreachable(target, frozen(np.asarray(margin)), frozen(least))
    return Aim(target, low, high_arc, frozen(np.asarray(margin)), frozen(least))


def minimum_speed(
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike | None = None,
    *,
    gravity: npt.ArrayLike,
    drag_rate: npt.ArrayLike,
    height: npt.ArrayLike = 0.0,
    wind: Any = None,
) -> Quantity:
    """The least launch speed (m/s) whose envelope reaches the target `x`, `y`, `z` (m).

    `gravity` (m/s²), `drag_rate` (1/s), the launch `height` (m) and `wind` (m/s) broadcast with the
    target. 0 for a target straight below; NaN for a target that is not finite.

    >>> round(minimum_speed(3.0, 4.0, gravity=10.0, drag_rate=0.0) ** 2, 12)  # g (y + r)
    90.0
    """
    target = _target(x, y, z)
    drag = array(not_negative("drag rate", drag_rate))
    pull = array(positive("gravity", gravity))
    with np.errstate(all="ignore"):
        plane = _plane(target, finite("height", height), wind_vector(wind), pull, drag)
        return frozen(_minimum_speed(plane, drag))


def _target(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None) -> Vector:
    """Targets as vectors; NaN and infinity are welcome, what is no number is not."""
    places = {"x": x, "y": y, "z": 0.0 if z is None else z}
    numbers = {name: real(f"target {name}", place) for name, place in places.items()}
    try:
        return record(Vector, **numbers)
    except ValueError:
        shapes = ", ".join(f"{name} {np.shape(place)}" for name, place in numbers.items())
        raise ValueError(f"targets must broadcast, got {shapes}") from None


def _plane(
    target: Vector, height: Quantity, wind: Vector, gravity: FloatArray, drag: FloatArray
) -> _Plane:
    shape = np.broadcast_shapes(
        *map(np.shape, (target.x, height, wind.x, wind.y, wind.z, gravity, drag))
    )

    def vector(*components: npt.ArrayLike) -> FloatArray:
        return np.stack([np.broadcast_to(array(each), shape) for each in components])

    upward = vector(-drag * wind.x, gravity - drag * wind.y, -drag * wind.z)
    strength = _length(upward)
    # Wind that carries the whole weight leaves a straight way; a least pull tells which is upward.
    weightless = strength == 0
    strength = np.where(weightless, _LEAST_PULL * gravity, strength)
    up = np.where(weightless, vector(0.0, 1.0, 0.0), upward / strength)
    place = vector(target.x, np.subtract(target.y, height), target.z)
    place = np.where(np.all(np.isfinite(place), axis=0), place, np.nan)  # no place at infinity
    rise = np.sum(place * up, axis=0)
    across = place - rise * up
    distance = _length(across)
    # A target straight along the pull: any direction across it will do; this is one in x, y.
    beside = np.stack([up[1], -up[0], np.zeros(shape)]) / np.hypot(up[0], up[1])
    forward = np.where(distance > 0, across / distance, beside)
    return _Plane(forward, up, distance, rise, strength, weightless)


def _length(vector: FloatArray) -> FloatArray:
    return np.asarray(np.hypot(np.hypot(vector[0], vector[2]), vector[1]))


def _direction(plane: _Plane, angle: FloatArray, in_space: bool) -> tuple[FloatArray, FloatArray]:
    """Elevation and azimuth of a launch at `angle` in the plane; azimuth 0 unless in space."""
    cosine, sine = np.cos(angle), np.sin(angle)
    x, y, z = cosine * plane.forward + sine * plane.up
    if in_space:
        return np.arctan2(y, np.hypot(x, z)), np.arctan2(z, x)
    elevation = np.arctan2(y, x)
    # A tilt below 1e-8 leaves the cosine at 1: the sine must say that there is none.
    upright = (plane.up[0] == 0) & (plane.up[1] == 1) & (plane.forward[0] == 1)
    return np.where(upright, angle, elevation), np.zeros(np.shape(elevation))


def _arrival(
    x: FloatArray, y: FloatArray, angle: FloatArray, eps: FloatArray, high: bool
) -> FloatArray:
    """Time at which the shot at `angle` is at x, y, in V/g and V²/g.

    A shot that comes down on its target takes the time to the apex and that of the fall from there;
    one that rises to it, or is aimed downward, the time to drift that far. Where the drift says
    little (almost vertical, or almost at the wall), the height is asked. The last digits come from
    Newton's method on the distance along the path, well conditioned everywhere.
    """
    x, y, angle, eps = np.broadcast_arrays(x, y, angle, eps)
    sine, cosine = np.sin(angle), np.cos(angle)
    upward = np.abs(angle)
    top, summit = array(_core.apex_time(upward, eps)), array(_core.apex_y(upward, eps))
    time = top + time_of_fall(np.maximum(summit - y, 0.0), eps)
    if not high:
        reach = x / cosine
        drifted = time_of_drift(reach, eps)
        rising = (sine > 0) & (x <= array(_core.apex_x(upward, eps)))
        time = np.where(rising | (sine <= 0), drifted, time)
        steep = rising & (cosine < _STEEP)
        if np.any(steep):
            time = np.where(steep, _rise(y, sine, top, eps), time)
        late = (sine <= 0) & ((cosine < _STEEP) | (eps * reach > 0.5))
        if np.any(late):
            time = np.where(late, time_of_descent(-y, -sine, eps), time)
    for _ in range(_STEPS):
        decay, moved = np.exp(-eps * time), drift(time, eps)
        vx, vy = cosine * decay, sine * decay - moved
        along = (x - cosine * moved) * vx + (y - (sine * moved - fall(time, eps))) * vy
        square = vx * vx + vy * vy
        step = along / square
        # A step in which gravity would turn the velocity round leads anywhere: at the top of a
        # vertical shot the time is already right.
        time = np.maximum(np.where(step * step < square, time + step, time), 0.0)
    return np.asarray(time)


def _rise(y: FloatArray, sine: FloatArray, top: FloatArray, eps: FloatArray) -> FloatArray:
    """Time, before the apex at `top`, at which a shot has risen to y."""

    def missing(time: FloatArray) -> FloatArray:
        return y - (sine * drift(time, eps) - fall(time, eps))

    return zero_between(missing, np.full(y.shape, 5e-324), np.maximum(top, 1e-323))


def _envelope(distance: FloatArray, eps: FloatArray) -> FloatArray:
    """Height of the envelope; minus infinity beyond the wall at 1/ε, where no shot ever gets."""
    height = array(_core.envelope_height(distance, eps))
    return np.where(distance * eps >= 1, -np.inf, height)


def _minimum_speed(plane: _Plane, drag: FloatArray) -> FloatArray:
    strength, distance, rise, drag = np.broadcast_arrays(
        plane.strength, plane.distance, plane.rise, drag
    )
    away = np.hypot(distance, rise)
    # Without drag V² = g (y + r), written so that it keeps its digits for a target below.
    sinking = distance / np.sqrt(away - rise)
    still = np.sqrt(strength) * np.where(rise >= 0, np.sqrt(rise + away), sinking)
    # With it, this speed or twice as much: V = (r + g F)/D at the time t when g F is as long as r,
    # the way to the target. A greater one could have an ε that overflows.
    time = np.minimum(time_of_fall(away / strength, drag), 1e300)
    lifted = np.where(rise >= 0, rise + away, sinking * sinking)
    enough = 2 * np.hypot(distance, lifted) / drift(time, drag)

    def missing(speed: FloatArray) -> FloatArray:
        unit = strength / speed
        height = _envelope(distance / speed * unit, drag / unit)
        return np.asarray(rise / speed * unit - height)

    low = np.where(still > 0, 0.5 * still, 1.0)
    high = np.where(still > 0, enough, 1.0)
    speed = np.nextafter(zero_between(missing, low, high), np.inf)
    speed = np.where(still > 0, speed, 0.0)
    return np.where(np.isnan(distance + rise), np.nan, speed)

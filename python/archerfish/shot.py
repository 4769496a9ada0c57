"""One shot, or an array of them: where it is, how fast, where it lands; in SI units."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
import numpy.typing as npt

from archerfish import _core
from archerfish.kinematics import (
    array,
    climb_time,
    drift,
    fall,
    time_of_descent,
    time_of_drift,
    time_of_fall,
)
from archerfish.values import Quantity, Value, finite, frozen, real, without_unit
from archerfish.zeros import FloatArray, zero_between

if TYPE_CHECKING:
    from archerfish.gradients import ShotGradients, Uncertainty
    from archerfish.launcher import Launcher

Record = TypeVar("Record", bound=Value)


def record(kind: type[Record], **fields: npt.ArrayLike) -> Record:
    """A record of these fields, broadcast to one shape: floats, or read-only arrays."""
    shaped = np.broadcast_arrays(*(array(field) for field in fields.values()))
    return kind(*(frozen(field.copy()) for field in shaped))


@dataclass(frozen=True, eq=False)
class Vector(Value):
    """Components of a place (m) or a velocity (m/s).

    `x` along azimuth 0, `y` up, `z` to the right of someone who looks along x.
    """

    x: Quantity
    y: Quantity
    z: Quantity


@dataclass(frozen=True, eq=False)
class Apex(Value):
    """Highest point of a shot: place (m) and time of flight to it (s)."""

    x: Quantity
    y: Quantity
    z: Quantity
    time: Quantity


@dataclass(frozen=True, eq=False)
class Landing(Value):
    """Where and how a shot comes down.

    `time` of flight (s), place `x`, `y`, `z` (m), velocity `vx`, `vy`, `vz` and `speed` (m/s), and
    `angle` (radians) above the horizontal: negative, as the projectile is falling.
    """

    time: Quantity
    x: Quantity
    y: Quantity
    z: Quantity
    vx: Quantity
    vy: Quantity
    vz: Quantity
    speed: Quantity
    angle: Quantity

    @property
    def velocity(self) -> Vector:
        """The velocity as a vector (m/s)."""
        return Vector(self.vx, self.vy, self.vz)


@dataclass(frozen=True, eq=False)
class Energy(Value):
    """Energy per unit mass (J/kg): of motion, of height above y = 0, and their sum."""

    kinetic: Quantity
    potential: Quantity
    total: Quantity


@dataclass(frozen=True, eq=False)
class Samples(Value):
    """A flight at evenly spaced times (s): places (m), velocities (m/s). Time is the last axis."""

    time: Quantity
    x: Quantity
    y: Quantity
    z: Quantity
    vx: Quantity
    vy: Quantity
    vz: Quantity


@dataclass(frozen=True, eq=False)
class Shot(Value):
    """One shot of a launcher, or an array of them; usually made by `Launcher.shot`.

    `angle` is the elevation of the launch velocity and `azimuth` its bearing from x towards z
    (radians); `height` and `ground` are the heights y of the launch point and of the ground (m),
    `wind` the velocity of the medium (m/s). All broadcast with the launcher's fields.

    What does not exist is NaN, without a warning: the apex of a shot aimed downward, the landing of
    one that never reaches the ground, everything where `angle` is outside [−π, π].

    Source: equation of motion before (7) of H. Hernández-Saldaña, Eur. J. Phys. 2010.

    >>> from archerfish import Launcher
    >>> shot = Launcher(10.0, epsilon=0.1).shot(0.75)
    >>> round(shot.range, 6), round(shot.flight_time, 6), round(shot.apex.y, 6)
    (9.315527, 1.359937, 2.266529)
    """

    launcher: Launcher
    angle: Quantity
    azimuth: Quantity
    height: Quantity
    ground: Quantity
    wind: Vector

    def __post_init__(self) -> None:
        # The locus wants ε alone, which may be so great that the drag rate overflows; a shot, both.
        finite("drag rate of the launcher", self.launcher.drag_rate)
        object.__setattr__(self, "angle", real("angle", self.angle))
        for name in ("azimuth", "height", "ground"):
            object.__setattr__(self, name, finite(name, getattr(self, name)))
        shapes = {
            "launcher": np.shape(self.launcher.epsilon),
            "wind": np.shape(np.add(np.add(self.wind.x, self.wind.y), self.wind.z)),
        } | {
            name: np.shape(getattr(self, name)) for name in ("angle", "azimuth", "height", "ground")
        }
        try:
            np.broadcast_shapes(*shapes.values())
        except ValueError:
            listed = ", ".join(f"{name} {shape}" for name, shape in shapes.items())
            raise ValueError(f"shapes must broadcast, got {listed}") from None

    # What the motion is made of.

    @cached_property
    def _drag(self) -> FloatArray:
        return array(self.launcher.drag_rate)

    @cached_property
    def _launch(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Launch velocity (m/s)."""
        angle, azimuth = array(self.angle), array(self.azimuth)
        angle = np.where(np.abs(angle) <= np.pi, angle, np.nan)
        speed, level = array(self.launcher.speed), np.cos(angle)
        return (
            speed * level * np.cos(azimuth),
            speed * np.sin(angle),
            speed * level * np.sin(azimuth),
        )

    @cached_property
    def _pull(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Constant acceleration b w − g (m/s²)."""
        drag, wind = self._drag, self.wind
        return (
            drag * wind.x,
            drag * wind.y - array(self.launcher.gravity),
            drag * wind.z,
        )

    @cached_property
    def _vertical(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """ε, unit of length and unit of time of the vertical motion; no wind: the launcher's."""
        gravity = array(self.launcher.gravity)
        weight = -self._pull[1]
        with np.errstate(all="ignore"):
            lighter = np.where(weight > 0, gravity / weight, np.nan)
        return (
            self.launcher.epsilon * lighter,
            self.launcher.length_scale * lighter,
            self.launcher.time_scale * lighter,
        )

    def _place(self, time: npt.ArrayLike) -> tuple[FloatArray, FloatArray, FloatArray]:
        with np.errstate(all="ignore"):
            moved, fallen = drift(time, self._drag), fall(time, self._drag)
            x, y, z = (
                v * moved + a * fallen for v, a in zip(self._launch, self._pull, strict=True)
            )
        return x, y + self.height, z

    def _motion(self, time: npt.ArrayLike) -> tuple[FloatArray, FloatArray, FloatArray]:
        with np.errstate(all="ignore"):
            decay, moved = np.exp(-self._drag * array(time)), drift(time, self._drag)
            x, y, z = (v * decay + a * moved for v, a in zip(self._launch, self._pull, strict=True))
        return x, y, z

    # The flight.

    def position(self, time: npt.ArrayLike) -> Vector:
        """Where the projectile is at `time` (s, at least 0), as if there were no ground.

        >>> from archerfish import Launcher
        >>> place = Launcher(10.0, gravity=10.0, epsilon=0.0).shot(np.pi / 2).position(0.5)
        >>> round(place.y, 12)
        3.75
        """
        x, y, z = self._place(time)
        return record(Vector, x=x, y=y, z=z)

    def velocity(self, time: npt.ArrayLike) -> Vector:
        """The velocity (m/s) at `time` (s, at least 0).

        >>> from archerfish import Launcher
        >>> Launcher(10.0, gravity=10.0, epsilon=0.0).shot(np.pi / 2).velocity(0.5).y
        5.0
        """
        x, y, z = self._motion(time)
        return record(Vector, x=x, y=y, z=z)

    def energy(self, time: npt.ArrayLike) -> Energy:
        """Energy per unit mass (J/kg) at `time` (s, at least 0); height counts from y = 0.

        >>> from archerfish import Launcher
        >>> shot = Launcher(10.0, drag_rate=0.2).shot(0.8)
        >>> bool(shot.energy(1.0).total < shot.energy(0.0).total)
        True
        """
        _, y, _ = self._place(time)
        kinetic = 0.5 * sum(part * part for part in self._motion(time))
        potential = self.launcher.gravity * y
        return record(Energy, kinetic=kinetic, potential=potential, total=kinetic + potential)

    @cached_property
    def apex(self) -> Apex:
        """The highest point, equations (7) and (8), shifted by wind and launch height.

        >>> from archerfish import Launcher
        >>> apex = Launcher(10.0, gravity=10.0, epsilon=0.0).shot(np.pi / 2, height=1.5).apex
        >>> round(apex.y, 12), round(apex.time, 12)
        (6.5, 1.0)
        """
        eps, length, unit = self._vertical
        with np.errstate(all="ignore"):
            time = _core.apex_time(self.angle, eps) * unit
            x, _, z = self._place(time)
            y = self.height + _core.apex_y(self.angle, eps) * length
        return record(Apex, x=x, y=y, z=z, time=time)

    @cached_property
    def flight_time(self) -> Quantity:
        """Time from launch until the shot comes down to the ground (s).

        Over level ground the ufunc `flight_time`; else the time to the apex and that of the fall
        from there.

        >>> from archerfish import Launcher
        >>> shot = Launcher(10.0, gravity=10.0, epsilon=0.0).shot(0.0, height=5.0)
        >>> round(shot.flight_time, 12)
        1.0
        """
        eps, length, unit = self._vertical
        angle, weight = array(self.angle), -self._pull[1]
        drop = array(self.height) - array(self.ground)
        with np.errstate(all="ignore"):
            level = _core.flight_time(angle, eps) * unit
            depth = _core.apex_y(angle, eps) * length + drop
            high = _core.apex_time(angle, eps) * unit + time_of_fall(depth / weight, self._drag)
            time = np.where(drop == 0, level, high)
            downward = (angle < 0) & (drop >= 0) & (weight > 0)
            if np.any(downward):
                low = time_of_descent(drop / weight, -self._launch[1] / weight, self._drag)
                time = np.where(downward, low, time)
            # In air that rises as fast as the projectile would fall, or faster, it may yet be
            # fast enough to get down: the vertical motion is one against a headwind.
            lifted = (angle < 0) & (drop >= 0) & (weight <= 0)
            if np.any(lifted):
                rise = self._launch[1]
                still = time_of_drift(-drop / rise, self._drag)
                first, _ = _times_in_wind(-drop, rise, -weight, self._drag)
                time = np.where(lifted, np.where(weight == 0, still, first), time)
        return frozen(time)

    @cached_property
    def landing(self) -> Landing:
        """Where the shot comes down to the ground, and how fast.

        >>> from archerfish import Launcher
        >>> landing = Launcher(10.0, epsilon=0.1).shot(0.75).landing
        >>> round(landing.speed, 6), round(float(np.degrees(landing.angle)), 6)
        (9.138589, -45.517348)
        """
        time = self.flight_time
        x, _, z = self._place(time)
        vx, vy, vz = self._motion(time)
        eps, length, _ = self._vertical
        with np.errstate(all="ignore"):
            # Over level ground and without wind the ufunc has the last digits, too.
            plain = (array(self.height) == self.ground) & (self.wind == _CALM_VECTOR)
            plain = plain & (array(self.angle) >= 0)
            if np.any(plain):
                reach = _core.flight_range(self.angle, eps) * length
                x = np.where(plain, reach * np.cos(self.azimuth), x)
                z = np.where(plain, reach * np.sin(self.azimuth), z)
        level = np.hypot(vx, vz)
        return record(
            Landing,
            time=time,
            x=x,
            y=np.where(np.isnan(time), np.nan, self.ground),
            z=z,
            vx=vx,
            vy=vy,
            vz=vz,
            speed=np.hypot(level, vy),
            angle=np.arctan2(vy, level),
        )

    @property
    def range(self) -> Quantity:
        """x where the shot comes down (m); negative for a shot to the other side.

        >>> from archerfish import Launcher
        >>> round(Launcher(10.0, gravity=10.0, epsilon=0.0).shot(np.pi / 4).range, 12)
        10.0
        """
        return self.landing.x

    def time_at(self, x: npt.ArrayLike) -> Quantity:
        """The first time (s) at which the shot is at horizontal coordinate `x` (m).

        NaN where it never is. Without wind along x the inverse of D; with it, found by bisection.

        >>> from archerfish import Launcher
        >>> round(Launcher(10.0, gravity=10.0, epsilon=0.0).shot(np.pi / 3).time_at(5.0), 12)
        1.0
        """
        speed, pull = self._launch[0], self._pull[0]
        with np.errstate(all="ignore"):
            time = time_of_drift(array(x) / speed, self._drag)
            time = np.where((array(x) == 0) & ~np.isnan(speed), 0.0, time)
            if np.any(pull != 0):
                windy, _ = _times_in_wind(array(x), speed, pull, self._drag)
                time = np.where(pull == 0, time, windy)
        return frozen(time)

    def time_again_at(self, x: npt.ArrayLike) -> Quantity:
        """The second time (s) at which the shot is at `x` (m): a headwind can blow it back there.

        NaN where it is there once or never.

        >>> from archerfish import Launcher
        >>> shot = Launcher(10.0, drag_rate=0.5).shot(1.0, wind=(-4.0, 0.0))
        >>> shot.time_at(1.0) < shot.time_again_at(1.0)
        True
        """
        places = np.broadcast_arrays(array(x), self._launch[0], self._pull[0], self._drag)
        if not np.any(places[2]):
            return frozen(np.full(places[0].shape, np.nan))
        with np.errstate(all="ignore"):
            return frozen(_times_in_wind(*places)[1])

    def height_at(self, x: npt.ArrayLike) -> Quantity:
        """y (m) where the shot first is at horizontal coordinate `x` (m), NaN where it never is.

        As if there were no ground.

        >>> from archerfish import Launcher
        >>> round(Launcher(10.0, gravity=10.0, epsilon=0.0).shot(np.pi / 4).height_at(5.0), 12)
        2.5
        """
        return frozen(self._place(self.time_at(x))[1])

    def path_length(self, time: npt.ArrayLike | None = None) -> Quantity:
        """Length of the path (m) flown by `time` (s, at least 0), or until landing.

        >>> from archerfish import Launcher
        >>> shot = Launcher(10.0, gravity=10.0, epsilon=0.0).shot(np.pi / 2)
        >>> round(shot.path_length(), 12)  # 5 m up, 5 m down
        10.0
        """
        from archerfish.path import path_length

        until = self.flight_time if time is None else time
        return frozen(path_length(until, self._launch, self._pull, self._drag))

    def sample(self, count: int) -> Samples:
        """The flight at `count` evenly spaced times from launch to landing, at least 2.

        Arrays of shape (..., count).

        >>> from archerfish import Launcher
        >>> Launcher(10.0, epsilon=0.1).shot([0.5, 0.75]).sample(5).x.shape
        (2, 5)
        """
        if without_unit(count, "count") < 2:
            raise ValueError(f"count must be at least 2, got {count}")
        share = np.linspace(0.0, 1.0, count)
        # Times go first, where arrays of any shape broadcast, and are then moved to the end.
        landing = array(self.landing.time)
        time = np.multiply.outer(share, landing)
        x, y, z = self._place(time)
        y[-1] = self.landing.y
        vx, vy, vz = self._motion(time)
        fields = {"time": time, "x": x, "y": y, "z": z, "vx": vx, "vy": vy, "vz": vz}
        return record(Samples, **{name: np.moveaxis(f, 0, -1) for name, f in fields.items()})

    @cached_property
    def gradients(self) -> ShotGradients:
        """Partial derivatives of range, flight time and apex by what the shot is made of.

        >>> from archerfish import Launcher
        >>> shot = Launcher(10.0, gravity=10.0, epsilon=0.0).shot(0.5)
        >>> round(shot.gradients.range.speed, 12) == round(2 * shot.range / 10.0, 12)
        True
        """
        from archerfish.gradients import shot_gradients

        return shot_gradients(self)

    def propagate(self, **uncertainties: npt.ArrayLike) -> Uncertainty:
        """Standard deviations of landing and apex; see `archerfish.gradients.propagate`.

        >>> from archerfish import Launcher
        >>> spread = Launcher(10.0, epsilon=0.1).shot(0.75).propagate(speed=0.1)
        >>> round(spread.range, 6)
        0.178385
        """
        from archerfish.gradients import propagate

        return propagate(self, **uncertainties)


#: No wind.
CALM = (0.0, 0.0, 0.0)
_CALM_VECTOR = Vector(*CALM)


def wind_vector(wind: Any) -> Vector:
    """`wind` as a vector: nothing, two components (x, y) or three (x, y, z), in m/s."""
    if isinstance(wind, Vector):
        return wind
    try:
        parts = CALM if wind is None else tuple(wind)
    except TypeError:
        raise TypeError(f"wind must be (x, y) or (x, y, z) in m/s, got {wind!r}") from None
    if len(parts) not in (2, 3):
        raise ValueError(f"wind must have 2 or 3 components, got {len(parts)}")
    names = ("wind x", "wind y", "wind z")
    x, y, z = (finite(name, part) for name, part in zip(names, (*parts, 0.0)[:3], strict=True))
    return Vector(x, y, z)


def _times_in_wind(
    x: FloatArray, speed: FloatArray, pull: FloatArray, drag: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """The first and second t with `speed` D(t) + `pull` F(t) = `x`, for a pull that is not 0."""
    x, speed, pull, drag = np.broadcast_arrays(x, speed, pull, drag)
    forward = np.where(speed != 0, np.sign(speed), np.sign(pull))
    x, speed, pull = x * forward, speed * forward, pull * forward
    # A headwind turns the projectile round where its velocity along x is 0.
    headwind = pull < 0
    ratio = np.where(headwind, speed / -pull, np.inf)
    turn = np.where(headwind, ratio * climb_time(drag * ratio), 1e150)

    def gone(time: FloatArray) -> FloatArray:
        return speed * drift(time, drag) + pull * fall(time, drag)

    forth = zero_between(lambda time: x - gone(time), np.full(x.shape, 5e-324), turn)
    back = zero_between(lambda time: gone(time) - x, turn, np.full(x.shape, 1e150))
    known = ~np.isnan(x * speed)
    reached, headwind = known & (x <= gone(turn)), known & headwind
    forth = np.where(x == 0, 0.0, forth)
    # What lies behind the launch point is passed on the way back alone.
    first = np.where(x >= 0, np.where(reached, forth, np.nan), np.where(headwind, back, np.nan))
    second = np.where((x >= 0) & reached & headwind, back, np.nan)
    return first, second

"""Partial derivatives of a shot, and how uncertain inputs make its landing point and apex.

The place r(t) = V D(t) + a F(t) has the partial derivatives, at fixed time,

    ∂D/∂b = −∫₀ᵗ τ e^{−bτ} dτ,    ∂F/∂b = −∫₀ᵗ (t − τ) τ e^{−bτ} dτ,    ∂a/∂b = w,

and those of anything that happens when a condition holds (landing: y = ground; apex: ẏ = 0; a hit:
r = target) follow by implicit differentiation. Nothing is differenced. Speed, angle, drag rate and
gravity are the independent variables, however the launcher's drag was given.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import numpy.typing as npt

from archerfish.kinematics import array, drift, fall
from archerfish.shot import record
from archerfish.values import Quantity, Value, frozen
from archerfish.zeros import FloatArray

if TYPE_CHECKING:
    from archerfish.shot import Shot

INPUTS = ("speed", "angle", "drag_rate", "gravity")
OUTPUTS = ("range", "flight_time", "apex_x", "apex_y", "apex_time")

#: In place of the launch angle 0 over level ground, where the flight is over as it begins: the
#: derivatives are the limits, and the quotients that give them stay defined.
_FLATTEST = 1e-150
_NODES = 16


@dataclass(frozen=True, eq=False)
class Partials(Value):
    """Derivatives of one quantity, in its unit over that of the input.

    By `speed` (m/s), launch `angle` (radian), `drag_rate` (1/s) and `gravity` (m/s²).
    """

    speed: Quantity
    angle: Quantity
    drag_rate: Quantity
    gravity: Quantity


@dataclass(frozen=True, eq=False)
class AngleGradient(Value):
    """Derivatives of the launch angle that hits a target: by speed, drag rate and gravity."""

    speed: Quantity
    drag_rate: Quantity
    gravity: Quantity


@dataclass(frozen=True, eq=False)
class ShotGradients(Value):
    """Derivatives of what a shot does: `range` and `apex_x`, `apex_y` (m), the times (s)."""

    range: Partials
    flight_time: Partials
    apex_x: Partials
    apex_y: Partials
    apex_time: Partials


@dataclass(frozen=True, eq=False)
class Uncertainty(Value):
    """Standard deviations of range and apex (m), flight time and apex time (s).

    `covariance`, of shape (..., 5, 5), is that of all five in the order of the other fields.
    """

    range: Quantity
    flight_time: Quantity
    apex_x: Quantity
    apex_y: Quantity
    apex_time: Quantity
    covariance: Quantity


class _Change(NamedTuple):
    """What one input does at a fixed time: to the place, and to the vertical velocity."""

    x: FloatArray
    y: FloatArray
    z: FloatArray
    vy: FloatArray


def shot_gradients(shot: Shot) -> ShotGradients:
    """Derivatives of range, flight time and apex of `shot`, NaN where these are."""
    from dataclasses import replace

    level = array(shot.height) == array(shot.ground)
    flat = level & (np.abs(shot.angle) < _FLATTEST)
    if np.any(flat):
        shot = replace(shot, angle=np.where(flat, _FLATTEST, shot.angle))
    with np.errstate(all="ignore"):
        pull = shot._pull[1]
        time = array(shot.flight_time)
        vx, vy, _ = shot._motion(time)
        at_landing = _changes(shot, time)
        landing_time = {name: -at.y / vy for name, at in at_landing.items()}
        landing_x = {name: at.x + vx * landing_time[name] for name, at in at_landing.items()}

        time = array(shot.apex.time)
        vx, _, _ = shot._motion(time)
        at_apex = _changes(shot, time)
        apex_time = {name: -at.vy / pull for name, at in at_apex.items()}
        apex_x = {name: at.x + vx * apex_time[name] for name, at in at_apex.items()}
        apex_y = {name: at.y for name, at in at_apex.items()}
    # A shot that never lands, or is aimed downward, has derivatives of nothing.
    return ShotGradients(
        *(
            record(Partials, **quantity)
            for quantity in (landing_x, landing_time, apex_x, apex_y, apex_time)
        )
    )


def angle_gradient(shot: Shot, time: npt.ArrayLike) -> AngleGradient:
    """Derivatives of the launch angle of `shot`, which must go on hitting where it is at `time`.

    The azimuth adjusts itself. Infinite on the envelope, where the two arcs meet.
    """
    with np.errstate(all="ignore"):
        vx, vy, vz = shot._motion(time)
        right = (-np.sin(shot.azimuth), np.cos(shot.azimuth))

        def turned(at: _Change) -> FloatArray:
            """det(v, change, right), where right is the direction of a change of azimuth."""
            along, forward = at.x * right[1] - at.z * right[0], vx * right[1] - vz * right[0]
            return np.asarray(vy * along - forward * at.y)

        changes = _changes(shot, array(time))
        by_angle = turned(changes.pop("angle"))
        slopes = {name: -turned(at) / by_angle for name, at in changes.items()}
    return record(AngleGradient, **slopes)


def propagate(
    shot: Shot,
    *,
    speed: npt.ArrayLike = 0.0,
    angle: npt.ArrayLike = 0.0,
    drag_rate: npt.ArrayLike = 0.0,
    gravity: npt.ArrayLike = 0.0,
    covariance: npt.ArrayLike | None = None,
) -> Uncertainty:
    """How uncertain range, flight time and apex are, to first order.

    Either standard deviations of independent inputs, in m/s, radians, 1/s and m/s², or their
    `covariance`, of shape (..., 4, 4) in this order.

    >>> from archerfish import Launcher
    >>> shot = Launcher(10.0, gravity=10.0, epsilon=0.0).shot(np.pi / 2)
    >>> round(propagate(shot, speed=0.1).apex_y, 12)  # y = V²/2g
    0.1
    """
    deviations = (speed, angle, drag_rate, gravity)
    given = covariance is not None
    if given and any(np.any(array(deviation) != 0) for deviation in deviations):
        raise TypeError("give standard deviations or a covariance, got both")
    if given:
        inputs = array(covariance)  # type: ignore[arg-type]  # `given`: not None
        if inputs.shape[-2:] != (4, 4):
            raise ValueError(f"covariance must have the shape (..., 4, 4), got {inputs.shape}")
    else:
        for name, deviation in zip(INPUTS, deviations, strict=True):
            if not np.all(array(deviation) >= 0):
                raise ValueError(
                    f"standard deviation of {name} must be at least 0, got {deviation}"
                )
        spread = np.stack(np.broadcast_arrays(*map(array, deviations)), axis=-1)
        inputs = spread[..., np.newaxis] ** 2 * np.eye(4)
    partials = [getattr(shot.gradients, output) for output in OUTPUTS]
    slopes = [array(getattr(each, name)) for each in partials for name in INPUTS]
    jacobian = np.stack(np.broadcast_arrays(*slopes), axis=-1)
    jacobian = jacobian.reshape(*jacobian.shape[:-1], len(OUTPUTS), len(INPUTS))
    outputs = jacobian @ inputs @ np.swapaxes(jacobian, -1, -2)
    deviation = np.sqrt(np.diagonal(outputs, axis1=-2, axis2=-1))
    spreads = (frozen(deviation[..., index].copy()) for index in range(len(OUTPUTS)))
    return Uncertainty(**dict(zip(OUTPUTS, spreads, strict=True)), covariance=frozen(outputs))


def _changes(shot: Shot, time: FloatArray) -> dict[str, _Change]:
    drag, speed = shot._drag, array(shot.launcher.speed)
    launch, pull, wind = shot._launch, shot._pull, shot.wind
    sine, cosine = np.sin(shot.angle), np.cos(shot.angle)
    bearing = np.cos(shot.azimuth), np.sin(shot.azimuth)
    decay, moved, fallen = np.exp(-drag * time), drift(time, drag), fall(time, drag)
    first, second = _moments(time, drag)
    zero = np.zeros(np.shape(moved))

    def along(wind: Quantity, v: FloatArray, a: FloatArray) -> FloatArray:
        return np.asarray(wind * fallen - v * first - a * second)

    return {
        "speed": _Change(
            cosine * bearing[0] * moved, sine * moved, cosine * bearing[1] * moved, sine * decay
        ),
        "angle": _Change(
            -speed * sine * bearing[0] * moved,
            speed * cosine * moved,
            -speed * sine * bearing[1] * moved,
            speed * cosine * decay,
        ),
        "drag_rate": _Change(
            along(wind.x, launch[0], pull[0]),
            along(wind.y, launch[1], pull[1]),
            along(wind.z, launch[2], pull[2]),
            wind.y * moved - launch[1] * time * decay - pull[1] * first,
        ),
        "gravity": _Change(zero, -fallen, zero, -moved),
    }


def _moments(time: FloatArray, drag: FloatArray) -> tuple[FloatArray, FloatArray]:
    """∫₀ᵗ τ e^{−bτ} dτ and ∫₀ᵗ (t − τ) τ e^{−bτ} dτ.

    In closed form both lose the digits of small bt; there 16 Gauss nodes are exact.
    """
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    share, weight = 0.5 * (1 + nodes), 0.5 * weights
    w = drag * time
    near = np.minimum(w, 3.0)[..., np.newaxis]
    decays = np.exp(-near * share)
    first = decays @ (weight * share)
    second = decays @ (weight * share * (1 - share))
    far, decay = w > 3, np.exp(-w)
    # Where w is huge, its powers overflow before the quotient does not matter.
    first = np.where(far, (1 - (1 + w) * decay) / w / w, first)
    second = np.where(far, (w - 2 + (w + 2) * decay) / w / w / w, second)
    return first * time * time, second * time * time * time

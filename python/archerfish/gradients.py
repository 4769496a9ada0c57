"""Partial derivatives of a shot, and how uncertain inputs make its landing point and apex.

The place r(t) = V D(t) + a F(t) has the partial derivatives, at fixed time,

    ∂D/∂b = −∫₀ᵗ τ e^{−bτ} dτ,    ∂F/∂b = −∫₀ᵗ (t − τ) τ e^{−bτ} dτ,    ∂a/∂b = w,

and those of anything that happens when a condition holds (landing: y = ground; apex: ẏ = 0; a hit:
r = target) follow by implicit differentiation. Nothing is differenced. Speed, angle, drag rate and
gravity are the independent variables, however the launcher's drag was given.

Accuracy: a few units of the last digit, times the condition of the derivative, which is how many
units it changes for one in each input. That is large next to where a derivative vanishes (the
range's by angle at the best angle) and where the arcs to a target meet, on the envelope.
In wind an aim's angle is right to a rounding of 1, not of itself, and so are its derivatives.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from archerfish.kinematics import array, drift, fall
from archerfish.quadrature import gauss_legendre, weighted_sum
from archerfish.shot import record
from archerfish.values import Quantity, Value, finite, frozen, not_negative
from archerfish.zeros import FloatArray

if TYPE_CHECKING:
    from archerfish.shot import Shot, Vector

INPUTS = ("speed", "angle", "drag_rate", "gravity")
OUTPUTS = ("range", "flight_time", "apex_x", "apex_y", "apex_time", "landing_z", "apex_z")

#: In place of the launch angle 0 over level ground, where the flight is over as it begins: the
#: derivatives are the limits, and the quotients that give them stay defined.
_FLATTEST = 1e-150
#: Cosine of a launch angle below which the target says how fast the shot is across.
_STEEP = 0.1
#: How far from symmetric and semidefinite rounding may leave the correlations of the inputs.
_ROUNDED = 1e-9
#: The bt from which on closed forms keep their digits.
_FAR = 3.0


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
    """Derivatives of the launch angle that hits a target, in radians over the input's unit.

    By `speed` (m/s), `drag_rate` (1/s), `gravity` (m/s²) and the target's `x`, `y`, `z` (m).
    """

    speed: Quantity
    drag_rate: Quantity
    gravity: Quantity
    x: Quantity
    y: Quantity
    z: Quantity


@dataclass(frozen=True, eq=False)
class ShotGradients(Value):
    """Derivatives of what a shot does: landing at `range`, `landing_z` (m), apex, times (s)."""

    range: Partials
    flight_time: Partials
    apex_x: Partials
    apex_y: Partials
    apex_time: Partials
    landing_z: Partials
    apex_z: Partials


@dataclass(frozen=True, eq=False)
class Uncertainty(Value):
    """Standard deviations of landing point and apex (m), flight time and apex time (s).

    `covariance`, of shape (..., 7, 7), is that of all seven in the order of the other fields.
    """

    range: Quantity
    flight_time: Quantity
    apex_x: Quantity
    apex_y: Quantity
    apex_time: Quantity
    landing_z: Quantity
    apex_z: Quantity
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
        _, vy, _ = shot._motion(time)
        landing_time = {name: -at.y / vy for name, at in _changes(shot, time).items()}
        landing_time["drag_rate"] = -_sag(shot, time) / vy
        landing_x, landing_z = (
            {name: -turned / vy for name, turned in _turned(shot, time, axis).items()}
            for axis in ((1.0, 0.0), (0.0, 1.0))
        )

        time = array(shot.apex.time)
        vx, _, vz = shot._motion(time)
        at_apex = _changes(shot, time)
        apex_time = {name: -at.vy / pull for name, at in at_apex.items()}
        apex_x = {name: at.x + vx * apex_time[name] for name, at in at_apex.items()}
        apex_y = {name: at.y for name, at in at_apex.items()}
        apex_z = {name: at.z + vz * apex_time[name] for name, at in at_apex.items()}
    # A shot that never lands, or is aimed downward, has derivatives of nothing.
    return ShotGradients(
        *(
            record(Partials, **quantity)
            for quantity in (
                landing_x,
                landing_time,
                apex_x,
                apex_y,
                apex_time,
                landing_z,
                apex_z,
            )
        )
    )


def angle_gradient(shot: Shot, target: Vector, time: npt.ArrayLike) -> AngleGradient:
    """Derivatives of the launch angle of `shot`, which must go on hitting `target`, at `time`.

    The azimuth adjusts itself. Infinite on the envelope, where the two arcs meet.
    """
    time = array(time)
    bearing = np.cos(shot.azimuth), np.sin(shot.azimuth)
    with np.errstate(all="ignore"):
        # Next to the vertical the angle is rounded in digits that its cosine needs: there the
        # target says how fast the shot is across.
        across = _along(bearing, array(target.x), array(target.z))
        moved, fallen = drift(time, shot._drag), fall(time, shot._drag)
        level = (across - _along(bearing, shot._pull[0], shot._pull[2]) * fallen) / moved
        cosine = np.cos(shot.angle)
        level = np.where(np.abs(cosine) < _STEEP, level, array(shot.launcher.speed) * cosine)
        turned = _turned(shot, time, bearing, level)
        by_angle = turned.pop("angle")
        decay = np.exp(-shot._drag * time)
        forward = level * decay + _along(bearing, shot._pull[0], shot._pull[2]) * moved
        rising = shot._motion(time)[1]
        turned |= {"x": rising * bearing[0], "y": -forward, "z": rising * bearing[1]}
        slopes = {name: -each / by_angle for name, each in turned.items()}
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
    """How uncertain landing point, flight time and apex are, to first order.

    Either standard deviations of independent inputs, in m/s, radians, 1/s and m/s², or their
    `covariance`, of shape (..., 4, 4) in this order.

    >>> from archerfish import Launcher
    >>> shot = Launcher(10.0, gravity=10.0, epsilon=0.0).shot(np.pi / 2)
    >>> round(propagate(shot, speed=0.1).apex_y, 12)  # y = V²/2g
    0.1
    """
    deviations = [
        array(not_negative(f"standard deviation of {name}", deviation))
        for name, deviation in zip(INPUTS, (speed, angle, drag_rate, gravity), strict=True)
    ]
    if covariance is not None:
        if np.any(np.concatenate(list(map(np.ravel, deviations)))):
            raise TypeError("give standard deviations or a covariance, got both")
        inputs = _covariance(covariance)
    else:
        spread = np.stack(np.broadcast_arrays(*deviations), axis=-1)
        inputs = spread[..., np.newaxis] ** 2 * np.eye(4)
    partials = [getattr(shot.gradients, output) for output in OUTPUTS]
    slopes = [array(getattr(each, name)) for each in partials for name in INPUTS]
    jacobian = np.stack(np.broadcast_arrays(*slopes), axis=-1)
    jacobian = jacobian.reshape(*jacobian.shape[:-1], len(OUTPUTS), len(INPUTS))
    outputs = jacobian @ inputs @ np.swapaxes(jacobian, -1, -2)
    # What is certain may come out a rounding below 0.
    deviation = np.sqrt(np.maximum(np.diagonal(outputs, axis1=-2, axis2=-1), 0.0))
    spreads = (frozen(deviation[..., index].copy()) for index in range(len(OUTPUTS)))
    return Uncertainty(**dict(zip(OUTPUTS, spreads, strict=True)), covariance=frozen(outputs))


def _covariance(given: npt.ArrayLike) -> FloatArray:
    """The covariance of the inputs; ValueError where no random numbers have it."""
    inputs = array(finite("covariance", given))
    if inputs.shape[-2:] != (4, 4):
        raise ValueError(f"covariance must have the shape (..., 4, 4), got {inputs.shape}")
    # Inputs have units of their own: correlations are compared, which have none.
    variances = np.diagonal(inputs, axis1=-2, axis2=-1)
    scale = np.sqrt(np.where(variances > 0, variances, 1.0))
    correlation = inputs / scale[..., np.newaxis] / scale[..., np.newaxis, :]
    skew = np.max(np.abs(correlation - np.swapaxes(correlation, -1, -2)), initial=0.0)
    if skew > _ROUNDED:
        raise ValueError(f"covariance must be symmetric, got correlations {skew:.3g} apart")
    least = np.min(np.linalg.eigvalsh(correlation), initial=0.0)
    if least < -_ROUNDED:
        raise ValueError(
            "covariance must be positive semidefinite, got the eigenvalue "
            f"{least:.3g} of its correlations"
        )
    return inputs


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


def _sag(shot: Shot, time: FloatArray) -> FloatArray:
    """∂y/∂b at the time of landing, where V D + a F is the ground's height over the launch.

    That takes the launch velocity out of −V ∫τe − a ∫(t − τ)τe, whose two terms agree to many
    digits for strong drag. What is left of them, F ∫τe − D ∫(t − τ)τe, is ((1 − e)² − (bt)²e)/b⁴.
    """
    drag = shot._drag
    drop, (first, _) = array(shot.height) - array(shot.ground), _moments(time, drag)
    w, decay, moved = drag * time, np.exp(-drag * time), drift(time, drag)
    tail = _tail(w / 2)
    near = decay * tail * (2 + w * w / 4 * tail) / 4 * time**4
    far = ((moved * drag) ** 2 - w * w * decay) / drag / drag / drag / drag
    left = np.where(w > _FAR, far, near)
    sag = (drop * first + shot._pull[1] * left) / moved
    return np.asarray(sag + shot.wind.y * fall(time, drag))


def _along(direction: tuple[Any, Any], x: FloatArray, z: FloatArray) -> FloatArray:
    """The component of a vector along a horizontal direction."""
    return np.asarray(x * direction[0] + z * direction[1])


def _turned(
    shot: Shot, time: FloatArray, direction: tuple[Any, Any], level: FloatArray | None = None
) -> dict[str, FloatArray]:
    """v × ∂r by each input, in the vertical plane of `direction`: how far ∂r leads off the path.

    `level` is the launch velocity along `direction`. With v = V e^{−bt} + a D and ∂r made of V and
    a as well, all is V × a times a sum of positive terms; what cancels is left out by hand, as it
    would leave nothing of a fast shot.
    """
    drag, speed = shot._drag, array(shot.launcher.speed)
    sine, cosine = np.sin(shot.angle), np.cos(shot.angle)
    share = _along(direction, np.cos(shot.azimuth), np.sin(shot.azimuth))
    rise = shot._launch[1]
    level = speed * cosine * share if level is None else level
    pull, lift = _along(direction, shot._pull[0], shot._pull[2]), shot._pull[1]
    wind, updraft = _along(direction, array(shot.wind.x), array(shot.wind.z)), array(shot.wind.y)
    w, decay = drag * time, np.exp(-drag * time)
    moved, fallen = drift(time, drag), fall(time, drag)
    forward, rising = level * decay + pull * moved, rise * decay + lift * moved
    bent = level * lift - rise * pull
    # D ∫τe − e ∫(t − τ)τe is (1 − 2bt e − e²)/b³.
    near = 2 * decay * _tail(w) * time**3
    far = (1 - 2 * w * decay - decay * decay) / drag / drag / drag
    return {
        "speed": -bent * moved * moved / speed,
        "angle": speed
        * moved
        * (speed * decay * share + moved * (pull * cosine + lift * sine * share)),
        "drag_rate": bent * np.where(w > _FAR, far, near)
        + fallen * (forward * updraft - rising * wind),
        "gravity": -fallen * forward,
    }


def _tail(w: FloatArray) -> FloatArray:
    """(sinh w − w)/w³ = ½ ∫₀¹ (1 − x)² cosh(wx) dx for w up to `_FAR`, where 16 nodes are exact."""
    nodes, weights = gauss_legendre()
    share, weight = 0.5 * (1 + nodes), 0.25 * weights
    near = np.minimum(w, _FAR)[..., np.newaxis]
    return weighted_sum(np.cosh(near * share), weight * (1 - share) ** 2)


def _moments(time: FloatArray, drag: FloatArray) -> tuple[FloatArray, FloatArray]:
    """∫₀ᵗ τ e^{−bτ} dτ and ∫₀ᵗ (t − τ) τ e^{−bτ} dτ.

    In closed form both lose the digits of small bt; there 16 Gauss nodes are exact.
    """
    nodes, weights = gauss_legendre()
    share, weight = 0.5 * (1 + nodes), 0.5 * weights
    w = drag * time
    near = np.minimum(w, _FAR)[..., np.newaxis]
    decays = np.exp(-near * share)
    first = weighted_sum(decays, weight * share)
    second = weighted_sum(decays, weight * share * (1 - share))
    far, decay = w > _FAR, np.exp(-w)
    # Where w is huge, its powers overflow before the quotient does not matter.
    first = np.where(far, (1 - (1 + w) * decay) / w / w, first)
    second = np.where(far, (w - 2 + (w + 2) * decay) / w / w / w, second)
    return first * time * time, second * time * time * time

"""Figures of shots: one with its apex on the locus, both arcs to a target, an envelope, angles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from archerfish.aim import Aim, Unreachable
from archerfish.launcher import Launcher
from archerfish.shot import Apex, Shot, Vector, wind_vector

from . import style
from .trajectory import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SAMPLES = 201
WIDTH, LEAST_HEIGHT, GREATEST_HEIGHT = 5.2, 1.0, 4.5
"""Inches; the heights are those of the axes."""
FAN_DEG = tuple(range(10, 90, 10))
THIN = 0.8
"""Line width of a shot among several, points."""


@dataclass(frozen=True)
class ShotData:
    """A shot, the apexes of all shots like it, and the same shot without drag; metres.

    `x` is along the shot's bearing.
    """

    speed: float
    angle: float
    azimuth: float
    epsilon: float
    x: Array  # (samples,), launch to landing
    y: Array
    drag_free_x: Array
    drag_free_y: Array
    locus_x: Array  # (samples,), of the shots to the same side; NaN where none has an apex
    locus_y: Array
    apex: tuple[float, float]  # NaN where there is none
    ground: float
    wind: Vector


def shot_data(shot: Shot) -> ShotData:
    """Return the curves of the figure of one shot, plain numbers in its fields.

    The locus is that of shots at every angle to the same side, with the same launch height and
    wind. A shot that never lands is drawn until three times its apex time, or three units V₀/g.

    >>> from archerfish import Launcher
    >>> data = shot_data(Launcher(10.0, epsilon=0.1).shot(0.75))
    >>> round(float(data.y.max()), 3), round(data.apex[1], 3)
    (2.267, 2.267)
    """
    launcher = shot.launcher
    free = Launcher(launcher.speed, gravity=launcher.gravity, epsilon=0.0)
    others: dict[str, Any] = {"height": shot.height, "wind": shot.wind, "azimuth": shot.azimuth}
    # The other half of the locus says nothing of the shot.
    side = np.pi if np.cos(shot.angle) < 0 else 0.0
    fan = launcher.shot(np.linspace(side, np.pi / 2, SAMPLES), **others).apex
    path, free_path = _path(shot), _path(free.shot(shot.angle, ground=shot.ground, **others))
    return ShotData(
        speed=float(launcher.speed),
        angle=float(shot.angle),
        azimuth=float(shot.azimuth),
        epsilon=float(launcher.epsilon),
        x=_along(shot, path),
        y=np.asarray(path.y),
        drag_free_x=_along(shot, free_path),
        drag_free_y=np.asarray(free_path.y),
        locus_x=_along(shot, fan),
        locus_y=np.asarray(fan.y),
        apex=(float(_along(shot, shot.apex)), float(shot.apex.y)),
        ground=float(shot.ground),
        wind=shot.wind,
    )


def draw_shot(ax: Axes, data: ShotData) -> None:
    """Draw the figure of one shot on equal axes."""
    top = _finite(data.y, data.drag_free_y, data.locus_y).max()
    unit, metres = style.length_unit(float(max(top, np.ptp(data.x))))
    ax.plot(
        data.drag_free_x / metres,
        data.drag_free_y / metres,
        color=style.VERMILLION,
        linestyle=(0, (5, 2)),
        linewidth=THIN,
        label="without drag",
    )
    if _finite(data.locus_y).size:
        ax.plot(
            data.locus_x / metres,
            data.locus_y / metres,
            color=style.BLUE,
            linewidth=1.8,
            label="locus of apexes",
        )
    ax.plot(data.x / metres, data.y / metres, color=style.BLACK, label="shot")
    ax.plot(*(np.array(data.apex)[:, np.newaxis] / metres), "o", color=style.BLUE, zorder=3)
    _ground(ax, data.ground / metres)
    _finish(ax, unit, x="along the bearing" if data.azimuth else "$x$")


def caption_shot(data: ShotData) -> str:
    """Return the caption of the figure of one shot."""
    bearing = f", azimuth {np.degrees(data.azimuth):g}°," if data.azimuth else ""
    locus = ""
    if np.isfinite(data.apex[1]):
        locus = ", its apex (dot) on the locus of apexes (blue)"
    elif _finite(data.locus_y).size:
        locus = ", the locus of apexes (blue) of shots aimed upward"
    return (
        f"Shot at V₀ = {data.speed:g} m/s and launch angle α = {np.degrees(data.angle):g}°"
        f"{bearing} with drag parameter ε = bV₀/g = {data.epsilon:.4g}{_in_wind(data.wind)} "
        f"(black){locus}, and the same shot without drag (dashed red)."
    )


def _in_wind(wind: Vector) -> str:
    parts = (wind.x, wind.y, wind.z)
    if not any(parts):
        return ""
    shown = ", ".join(f"{part:g}" for part in (parts if wind.z else parts[:2]))
    return f" in a wind of ({shown}) m/s"


@dataclass(frozen=True)
class AimData:
    """The arcs to a target, and the envelope above it; metres."""

    speed: float
    epsilon: float
    target: tuple[float, float]
    z: float
    wind: Vector
    reachable: bool
    margin: float
    arcs: tuple[tuple[Array, Array], ...]  # low and high, or none
    apexes: tuple[tuple[float, float], ...]
    envelope_x: Array
    envelope_y: Array


def aim_data(
    launcher: Launcher, answer: Aim | Unreachable, height: float = 0.0, wind: Any = None
) -> AimData:
    """Return the curves of the figure of one target, seen from the side (x and y).

    >>> launcher = Launcher(10.0, epsilon=0.1)
    >>> data = aim_data(launcher, launcher.aim(6.0, 2.0))
    >>> [round(float(x[-1]), 9) for x, y in data.arcs]
    [6.0, 6.0]
    """
    target = (float(answer.target.x), float(answer.target.y))
    arcs = (answer.low, answer.high) if isinstance(answer, Aim) else ()
    paths = [_path(arc.shot, float(arc.time)) for arc in arcs]
    air = wind_vector(wind)
    envelope = _envelope(launcher, air, target, height)
    return AimData(
        speed=float(launcher.speed),
        epsilon=float(launcher.epsilon),
        target=target,
        z=float(answer.target.z),
        wind=air,
        reachable=bool(arcs),
        margin=float(answer.margin),
        arcs=tuple((np.asarray(path.x), np.asarray(path.y)) for path in paths),
        apexes=tuple((float(arc.apex.x), float(arc.apex.y)) for arc in arcs),
        envelope_x=envelope[0],
        envelope_y=envelope[1] + height,
    )


def draw_aim(ax: Axes, data: AimData) -> None:
    """Draw the figure of one target on equal axes."""
    unit, metres = style.length_unit(float(np.ptp(data.envelope_x)))
    ax.plot(
        data.envelope_x / metres,
        data.envelope_y / metres,
        color=style.VERMILLION,
        linestyle=(0, (5, 2)),
        label="envelope",
    )
    for (x, y), name, dashes in zip(
        data.arcs, ("low arc", "high arc"), ("-", (0, (6, 1.5))), strict=False
    ):
        color = style.BLACK if name == "low arc" else style.BLUE
        ax.plot(x / metres, y / metres, color=color, linestyle=dashes, label=name)
    for apex in data.apexes:
        # Only what is on the way to the target is drawn.
        if min(0.0, data.target[0]) <= apex[0] <= max(0.0, data.target[0]):
            ax.plot(apex[0] / metres, apex[1] / metres, "o", color=style.GREY, markersize=3)
    marker = "D" if data.reachable else "X"
    ax.plot(
        data.target[0] / metres,
        data.target[1] / metres,
        marker,
        color=style.GREEN if data.reachable else style.VERMILLION,
        markersize=6,
        label="target" if data.reachable else "target, out of reach",
        zorder=3,
    )
    _finish(ax, unit)


def caption_aim(data: AimData) -> str:
    """Return the caption of the figure of one target."""
    launcher = f"V₀ = {data.speed:g} m/s and drag parameter ε = bV₀/g = {data.epsilon:.4g}"
    launcher += _in_wind(data.wind)
    place = f"({data.target[0]:g} m, {data.target[1]:g} m)"
    side = ""
    if data.z or data.wind.z:
        place = f"({data.target[0]:g} m, {data.target[1]:g} m, {data.z:g} m)"
        side = " Seen from the side; the envelope is that of z = 0 without wind across."
    if data.reachable:
        return (
            f"Both arcs through the target at {place} for {launcher}, under the envelope of all "
            f"shots (dashed red).{side}"
        )
    above = f"{data.margin:.4g} m above" if np.isfinite(data.margin) else "beyond"
    return (
        f"The target at {place} lies {above} the envelope (dashed red) of all shots with "
        f"{launcher}: none reaches it.{side}"
    )


@dataclass(frozen=True)
class FanData:
    """Some shots of a launcher, with names or without, and the envelope; metres."""

    epsilon: float
    title: str
    unit: str
    angles: Array  # (n,), radians
    labels: tuple[str, ...]
    x: Array  # (n, samples)
    y: Array
    envelope_x: Array
    envelope_y: Array


def envelope_data(launcher: Launcher, angles_deg: Sequence[float] = FAN_DEG) -> FanData:
    """Return the envelope of a launcher and some shots under it.

    >>> data = envelope_data(Launcher(10.0, epsilon=0.1))
    >>> round(float(data.envelope_y.max()), 6)
    4.782286
    """
    angles = np.radians(np.asarray(angles_deg, dtype=np.float64))
    flights = launcher.shot(angles).sample(SAMPLES)
    x = np.linspace(0.0, float(launcher.envelope.reach), SAMPLES)
    return FanData(
        epsilon=float(launcher.epsilon),
        title=f"all shots at V₀ = {launcher.speed:g} m/s",
        unit="m",
        angles=angles,
        labels=(),
        x=np.asarray(flights.x),
        y=np.asarray(flights.y),
        envelope_x=x,
        envelope_y=np.maximum(launcher.envelope.height(x), 0.0),
    )


ANGLE_NAMES = {
    "greatest_range": "greatest range",
    "rightmost": "rightmost apex",
    "farthest": "farthest apex",
    "longest_path": "longest path",
    "largest_area": "largest area",
    "receding": "always receding",
}


def angles_data(epsilon: float) -> FanData:
    """Return the shots at the named angles, in units of V₀²/g.

    >>> angles_data(0.0).labels[0]
    'greatest range, 45.00°'
    """
    launcher = Launcher(1.0, gravity=1.0, epsilon=epsilon)
    named = launcher.named_angles()
    angles = np.array([getattr(named, name) for name in ANGLE_NAMES])
    flights = launcher.shot(angles).sample(SAMPLES)
    x = np.linspace(0.0, float(launcher.envelope.reach), SAMPLES)
    labels = (
        f"{label}, {degrees:.2f}°"
        for label, degrees in zip(ANGLE_NAMES.values(), np.degrees(angles), strict=True)
    )
    return FanData(
        epsilon=float(launcher.epsilon),
        title="shots at the named angles",
        unit="",
        angles=angles,
        labels=tuple(labels),
        x=np.asarray(flights.x),
        y=np.asarray(flights.y),
        envelope_x=x,
        envelope_y=np.maximum(launcher.envelope.height(x), 0.0),
    )


def draw_fan(ax: Axes, data: FanData) -> None:
    """Draw shots under their envelope on equal axes."""
    unit, metres = "$V_0^2/g$", 1.0
    if data.unit:
        unit, metres = style.length_unit(float(data.envelope_x.max()))
    for index, (x, y) in enumerate(zip(data.x, data.y, strict=True)):
        if data.labels:
            ax.plot(x, y, **style.stroke(index).line(), label=data.labels[index])
        else:
            label = "shots" if index == 0 else None
            ax.plot(x / metres, y / metres, color=style.BLACK, linewidth=style.FAINT, label=label)
    ax.plot(
        data.envelope_x / metres,
        data.envelope_y / metres,
        color=style.GREY if data.labels else style.VERMILLION,
        linestyle=(0, (1, 1.5)) if data.labels else (0, (5, 2)),
        label="envelope",
    )
    ax.set_xlim(left=0.0)
    ax.set_ylim(bottom=0.0)
    _finish(ax, unit, columns=2 if data.labels else 3)


def caption_fan(data: FanData) -> str:
    """Return the caption of shots under their envelope."""
    drag = f"with drag parameter ε = bV₀/g = {data.epsilon:.4g}"
    if data.labels:
        return f"The {data.title} {drag}, under the envelope of all shots (dotted)."
    shots = ", ".join(f"{angle:.4g}°" for angle in np.degrees(data.angles))
    return f"The envelope of {data.title} {drag}. Thin black: shots at {shots}."


def size(data: ShotData | AimData | FanData) -> tuple[float, float]:
    """Return width and height in inches that suit equal axes."""
    if isinstance(data, ShotData):
        x = np.concatenate([data.x, data.drag_free_x])
        y = _finite(data.y, data.drag_free_y, data.locus_y)
    elif isinstance(data, AimData):
        x = np.append(data.envelope_x, data.target[0])
        y = np.append(data.envelope_y, data.target[1])
    else:
        x, y = data.envelope_x, data.envelope_y
    legend = 0.9 if isinstance(data, FanData) and data.labels else 0.45
    height = (WIDTH - 0.7) * float(np.ptp(y)) / max(float(np.ptp(x)), 1e-300)
    return WIDTH, legend + 0.6 + min(max(height, LEAST_HEIGHT), GREATEST_HEIGHT)


def _path(shot: Shot, until: float | None = None) -> Vector:
    """Places of a flight until it lands, or until that time."""
    if until is None:
        until = float(shot.flight_time)
    if np.isnan(until):
        until = 3.0 * float(np.nanmax([shot.apex.time, shot.launcher.time_scale]))
    return shot.position(np.linspace(0.0, until, SAMPLES))


def _along(shot: Shot, place: Vector | Apex) -> Array:
    """How far a place is along the bearing of a shot."""
    return np.asarray(place.x * np.cos(shot.azimuth) + place.z * np.sin(shot.azimuth))


def _finite(*arrays: Array) -> Array:
    """All their numbers that are finite."""
    numbers = np.concatenate(arrays)
    return numbers[np.isfinite(numbers)]


def _envelope(
    launcher: Launcher, wind: Vector, target: tuple[float, float], height: float
) -> tuple[Array, Array]:
    """The envelope in the plane of x and y: in wind, turned with gravity and stretched."""
    drag, gravity = float(launcher.drag_rate), float(launcher.gravity)
    upward = np.array([-drag * float(wind.x), gravity - drag * float(wind.y)])
    strength = float(np.hypot(*upward))
    side = -1.0 if target[0] < 0 else 1.0
    if strength == 0.0:
        # Wind carries the whole weight: straight ways of one length, in every direction.
        length, turn = float(launcher.envelope.wall), np.linspace(-0.5, 0.5, SAMPLES) * np.pi
        return side * length * np.cos(turn), length * np.sin(turn)
    up = upward / strength
    tilted = Launcher(launcher.speed, gravity=strength, drag_rate=drag)
    # Down to where the target is, and to the ground.
    lowest = min(target[1] - height, -height, 0.0) - 0.02 * float(tilted.envelope.highest)
    reach = min(float(tilted.envelope.wall), 4.0 * float(tilted.envelope.reach))
    distance = np.linspace(-reach, reach, 8 * SAMPLES)
    rise = np.asarray(tilted.envelope.height(distance))
    distance, rise = distance[np.isfinite(rise)], rise[np.isfinite(rise)]
    x, y = distance * up[1] + rise * up[0], -distance * up[0] + rise * up[1]
    shown = (y >= lowest) & (x * side >= 0.0)
    return x[shown], y[shown]


def _ground(ax: Axes, height: float) -> None:
    ax.axhline(height, color=style.GREY, linewidth=style.FAINT, zorder=0)


def _finish(ax: Axes, unit: str, columns: int = 4, x: str = "$x$") -> None:
    ax.set_aspect("equal")
    style.plain_ticks(ax.xaxis)
    style.plain_ticks(ax.yaxis)
    ax.set_xlabel(f"horizontal distance {x} ({unit})")
    ax.set_ylabel(f"height $y$ ({unit})")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), borderaxespad=0.2, ncols=columns)

"""What the commands about shots are asked with: one table of flags, columns and defaults.

A parameter is a flag of a single case and a column of a batch; a flag given with a batch holds for
every row.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

import click
import numpy as np
import numpy.typing as npt

from archerfish.launcher import STANDARD_GRAVITY, Launcher

#: Values of parameters by name: numbers, or arrays with one entry a row.
Values = Mapping[str, Any]
Function = TypeVar("Function", bound=Callable[..., Any])


@dataclass(frozen=True)
class Parameter:
    """One number that a command takes; angles are in degrees."""

    name: str
    column: str
    help: str
    default: float | None = None
    given_by: str = ""

    @property
    def flag(self) -> str:
        """The flag of a single case."""
        return self.given_by or "--" + self.name.replace("_", "-")


SPEED = Parameter("speed", "speed_m_per_s", "Launch speed V₀, m/s, above 0.")
GRAVITY = Parameter("gravity", "gravity_m_per_s2", "g, m/s², above 0.", STANDARD_GRAVITY)
DRAGS = (
    Parameter("epsilon", "epsilon", "Drag parameter ε = b V₀/g, at least 0."),
    Parameter("drag_rate", "drag_rate_per_s", "Drag rate b, 1/s, at least 0."),
    Parameter(
        "terminal_speed", "terminal_speed_m_per_s", "Terminal speed g/b, m/s, above 0 (inf: none)."
    ),
)
LAUNCHER = (SPEED, GRAVITY, *DRAGS)
ANGLE = Parameter("angle", "launch_angle_deg", "Launch angle α, degrees, from −180 to 180.")
AZIMUTH = Parameter("azimuth", "azimuth_deg", "Bearing from x towards z, degrees.", 0.0)
HEIGHT = Parameter("height", "height_m", "Height y of the launch point, m.", 0.0)
GROUND = Parameter("ground", "ground_m", "Height y of the ground, m.", 0.0)
WIND = (
    Parameter("wind_x", "wind_x_m_per_s", "Wind along x, m/s.", 0.0),
    Parameter("wind_y", "wind_y_m_per_s", "Wind upward, m/s.", 0.0),
    Parameter("wind_z", "wind_z_m_per_s", "Wind along z, m/s; an aim is then in space."),
)
X = Parameter("x", "x_m", "Horizontal coordinate x, m.")
Y = Parameter("y", "y_m", "Height y, m.")
OBSTACLE = (
    Parameter("obstacle_x", "obstacle_x_m", "x of a point to pass over, m.", None, "--obstacle"),
    Parameter("obstacle_y", "obstacle_y_m", "Height y of that point, m.", None, "--obstacle"),
)
CEILING = Parameter("ceiling", "ceiling_m", "A height to stay under, m.")
Z = Parameter("z", "z_m", "Coordinate z, to the right, m: aims in space.")


def flags(*parameters: Parameter) -> Callable[[Function], Function]:
    """A decorator that gives a command the flags of these parameters."""

    def decorate(function: Function) -> Function:
        for each in reversed(parameters):
            text = each.help
            if each.default is not None:
                text += f"  [default: {each.default:g}]"
            option = click.option(each.flag, each.name, type=float, help=text)
            function = option(function)
        return function

    return decorate


def launcher_of(values: Values) -> Launcher:
    """The launcher that these values describe; ValueError or TypeError where they do not."""
    drags = {each.name: values[each.name] for each in DRAGS if each.name in values}
    return Launcher(values["speed"], gravity=values["gravity"], **drags)


def angle_of(values: Values) -> npt.NDArray[np.float64]:
    """The launch angle in radians; ValueError where it is not one."""
    degrees = np.asarray(values["angle"], dtype=np.float64)
    bad = ~(np.abs(degrees) <= 180.0)
    if np.any(bad):
        worst = degrees if degrees.ndim == 0 else degrees[bad][0]
        raise ValueError(f"launch angle must be from -180 to 180 degrees, got {worst!s}")
    return np.radians(degrees)


def wind_of(values: Values) -> tuple[Any, ...]:
    """The wind, in space where its third component is given at all, be it 0."""
    return tuple(values[each.name] for each in WIND if each.name in values)

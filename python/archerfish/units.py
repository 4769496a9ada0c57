"""Quantities of pint in, quantities of pint out.

A `Launcher` made with at least one pint quantity is dressed: whatever is asked of it is answered in
quantities of the same registry, in SI units, and every argument may be a quantity in any unit of
the right kind. Plain numbers go on meaning SI units and radians. Nothing here imports pint: who
has a quantity has it.
"""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from typing import Any

from archerfish.values import Value, is_quantity

#: The unit of each field and each argument, by its name.
UNITS = {
    "x": "m",
    "y": "m",
    "z": "m",
    "vx": "m/s",
    "vy": "m/s",
    "vz": "m/s",
    "distance": "m",
    "height": "m",
    "ground": "m",
    "ceiling": "m",
    "radius": "m",
    "diameter": "m",
    "length_scale": "m",
    "range": "m",
    "apex_x": "m",
    "apex_y": "m",
    "apex_z": "m",
    "landing_z": "m",
    "margin": "m",
    "highest": "m",
    "reach": "m",
    "wall": "m",
    "clearance_over": "m",
    "clearance_under": "m",
    "height_at": "m",
    "path_length": "m",
    "arc_length": "m",
    "area": "m**2",
    "curvature": "1/m",
    "time": "s",
    "flight_time": "s",
    "apex_time": "s",
    "time_at": "s",
    "time_again_at": "s",
    "time_scale": "s",
    "speed": "m/s",
    "impact_speed": "m/s",
    "minimum_speed": "m/s",
    "terminal_speed": "m/s",
    "wind": "m/s",
    "gravity": "m/s**2",
    "drag_rate": "1/s",
    "density": "kg/m**3",
    "fluid_density": "kg/m**3",
    "fluid_viscosity": "Pa*s",
    "kinetic": "J/kg",
    "potential": "J/kg",
    "total": "J/kg",
    "angle": "rad",
    "azimuth": "rad",
    "impact_angle": "rad",
    "launch_angle": "rad",
    "elevation": "rad",
    "alpha": "rad",
    "theta": "rad",
    "start": "rad",
    "stop": "rad",
    "greatest_range": "rad",
    "greatest_curvature": "rad",
    "greatest_curvature_elevation": "rad",
    "rightmost": "rad",
    "farthest": "rad",
    "receding": "rad",
    "longest_path": "rad",
    "largest_area": "rad",
    "semi_major_axis": "m",
    "semi_minor_axis": "m",
    "epsilon": "dimensionless",
    "reynolds_number": "dimensionless",
}
#: What is a velocity though its components are called x, y and z.
VELOCITIES = {"velocity", "impact_velocity", "wind"}


def dressed(kind: type[Value], arguments: tuple[Any, ...], named: dict[str, Any]) -> Any:
    """The object of this kind with these arguments, answering in quantities of their registry."""
    quantity = type(next(filter(is_quantity, (*arguments, *named.values()))))
    bound = inspect.signature(kind.__init__).bind(None, *arguments, **named).arguments
    plain = {name: _plain(name, value) for name, value in bound.items() if name != "self"}
    return Dressed(kind(**plain), quantity, "")


class Dressed:
    """A value whose fields and methods speak in quantities."""

    def __init__(self, value: Value, quantity: type, origin: str) -> None:
        self._value, self._quantity, self._origin = value, quantity, origin

    @property
    def plain(self) -> Value:
        """The same in plain numbers of SI units."""
        return self._value

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        found = getattr(self._value, name)
        if not callable(found) or isinstance(found, Value):
            return self._dress(name, found)

        def method(*arguments: Any, **named: Any) -> Any:
            try:
                bound = inspect.signature(found).bind(*arguments, **named).arguments
            except TypeError:
                # The method itself says what is wrong.
                return found(*arguments, **named)
            extra = bound.pop("uncertainties", {}) | bound.pop("changes", {})
            plain = {key: _plain(key, value) for key, value in {**bound, **extra}.items()}
            return self._dress(name, found(**plain))

        method.__doc__ = found.__doc__
        return method

    def __dir__(self) -> list[str]:
        return dir(self._value)

    def __repr__(self) -> str:
        return f"{self._value!r} in units"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Dressed) and self._value == other._value

    def __hash__(self) -> int:
        return hash(self._value)

    def __reduce__(self) -> Any:
        # The class of a registry's quantities is not pickled by name, a quantity is.
        return _redressed, (self._value, self._quantity(1, ""), self._origin)

    def _dress(self, name: str, found: Any) -> Any:
        if isinstance(found, Value):
            return Dressed(found, self._quantity, name)
        unit = self._unit(name)
        if unit is None or isinstance(found, bool | str | Dressed):
            return found
        return self._quantity(found, unit)

    def _unit(self, name: str) -> str | None:
        kind = type(self._value).__name__
        if kind == "Vector" and self._origin in VELOCITIES:
            return "m/s"
        if kind == "Partials":
            return f"({UNITS[self._origin]})/({UNITS[name]})"
        if kind == "AngleGradient":
            return f"rad/({UNITS[name]})"
        return UNITS.get(name)


def _redressed(value: Value, quantity: Any, origin: str) -> Dressed:
    return Dressed(value, type(quantity), origin)


def _plain(name: str, value: Any) -> Any:
    """`value` in SI units, which its name says, without a unit."""
    if isinstance(value, Dressed):
        return value.plain
    if is_quantity(value):
        if name not in UNITS:
            raise TypeError(f"{name} must be a plain number, got {value}")
        return value.to(UNITS[name]).magnitude
    if isinstance(value, tuple | list) and any(map(is_quantity, value)):
        return tuple(_plain(name, each) for each in value)
    if isinstance(value, Mapping):
        return {key: _plain(key, each) for key, each in value.items()}
    return value

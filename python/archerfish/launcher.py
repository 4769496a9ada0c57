"""The launcher: a speed, a gravity and a drag, in SI units."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, Self

import numpy as np
import numpy.typing as npt

from archerfish.locus import ApexLocus
from archerfish.values import (
    Quantity,
    Value,
    is_quantity,
    not_negative,
    positive,
    positive_or_infinite,
    product,
    quotient,
    real,
)

if TYPE_CHECKING:
    from archerfish.aim import Aim, Unreachable
    from archerfish.envelope import Envelope, Front
    from archerfish.flight_angles import NamedAngles
    from archerfish.shot import Shot
    from archerfish.sphere import SphereLauncher

STANDARD_GRAVITY = 9.80665


@dataclass(frozen=True, eq=False, init=False)
class Launcher(Value):
    """Shots of one speed at every angle, under gravity, in a medium that resists with −m b v.

    Give the drag in exactly one of three ways; the launcher knows the other two:

    - `epsilon`: the drag parameter ε = b V₀/g, at least 0 (dimensionless);
    - `drag_rate`: b, at least 0 (1/s);
    - `terminal_speed`: g/b, above 0, infinite without drag (m/s).

    `speed` (m/s) and `gravity` (m/s², standard gravity unless given) must be above 0 and finite.
    Every field takes a number or an array; arrays broadcast. A value outside its bounds raises
    ValueError, none or several drags TypeError. Quantities of pint are taken in any unit, and then
    everything asked of the launcher is answered in quantities; a launcher made of plain numbers
    refuses them.

    Source: H. Hernández-Saldaña, Eur. J. Phys. 2010, text above equation (9): ε and ρ.

    >>> launcher = Launcher(10.0, terminal_speed=100.0)
    >>> launcher.epsilon
    0.1
    >>> round(launcher.length_scale, 6)
    10.197162
    >>> Launcher(-1.0, epsilon=0.1)
    Traceback (most recent call last):
        ...
    ValueError: speed must be above 0 and finite, got -1.0
    """

    speed: Quantity
    gravity: Quantity
    epsilon: Quantity
    drag_rate: Quantity
    terminal_speed: Quantity

    #: Names of the arguments; each launcher has its own, which is no field of it.
    _made_of: ClassVar[tuple[str, ...]]

    def __new__(cls, *arguments: Any, **named: Any) -> Any:
        """Return a launcher, or one dressed in units where a quantity of pint is given."""
        if any(map(is_quantity, (*arguments, *named.values()))):
            from archerfish.units import dressed

            return dressed(cls, arguments, named)
        return super().__new__(cls)

    def __init__(
        self,
        speed: npt.ArrayLike,
        *,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
        epsilon: npt.ArrayLike | None = None,
        drag_rate: npt.ArrayLike | None = None,
        terminal_speed: npt.ArrayLike | None = None,
    ) -> None:
        drags = {
            "epsilon": epsilon,
            "drag_rate": drag_rate,
            "terminal_speed": terminal_speed,
        }
        given = [name for name, drag in drags.items() if drag is not None]
        if len(given) != 1:
            raise TypeError(
                "give exactly one of epsilon, drag_rate, terminal_speed; got "
                + (" and ".join(given) or "none")
                + (" (to change a launcher: launcher.replace)" if len(given) == 3 else "")
            )
        fields = {"speed": positive("speed", speed), "gravity": positive("gravity", gravity)}
        [name] = given
        check = positive_or_infinite if name == "terminal_speed" else not_negative
        fields[name] = check(name, drags[name])
        try:
            np.broadcast_shapes(*(np.shape(field) for field in fields.values()))
        except ValueError:
            shapes = ", ".join(f"{name} {np.shape(field)}" for name, field in fields.items())
            raise ValueError(f"shapes must broadcast, got {shapes}") from None
        fields |= _drag(name, **fields)
        for name, field in fields.items():
            object.__setattr__(self, name, field)
        object.__setattr__(self, "_made_of", ("speed", "gravity", *given))
        # A speed like 1e200 is finite, but the lengths it leads to are not.
        positive("length scale speed²/gravity", self.length_scale)
        positive("time scale speed/gravity", self.time_scale)

    def replace(self, **changes: npt.ArrayLike) -> Self:
        """The same launcher with some of the arguments it was made with changed.

        The drag stays as it was given: a launcher made with `drag_rate` keeps that, and its ε
        follows the speed. A drag among the changes takes the place of the one given before.
        `dataclasses.replace` cannot know which it was, and is refused.

        >>> launcher = Launcher(10.0, gravity=10.0, drag_rate=0.2)
        >>> launcher.replace(speed=20.0).epsilon
        0.4
        >>> launcher.replace(speed=20.0, epsilon=launcher.epsilon).drag_rate
        0.1
        """
        kept = {name: getattr(self, name) for name in self._made_of}
        if any(name in changes for name in ("epsilon", "drag_rate", "terminal_speed")):
            kept = {name: kept[name] for name in ("speed", "gravity")}
        return type(self)(**kept | changes)

    __replace__ = replace

    @cached_property
    def length_scale(self) -> Quantity:
        """ρ = V₀²/g (m), the unit of every dimensionless length.

        >>> Launcher(10.0, gravity=10.0, epsilon=0.0).length_scale
        10.0
        """
        return quotient(product(self.speed, self.speed), self.gravity)

    @cached_property
    def time_scale(self) -> Quantity:
        """V₀/g (s), the unit of every dimensionless time.

        >>> Launcher(10.0, gravity=10.0, epsilon=0.0).time_scale
        1.0
        """
        return quotient(self.speed, self.gravity)

    @cached_property
    def locus(self) -> ApexLocus:
        """The curve formed by the apexes of all shots, in metres and seconds.

        >>> round(Launcher(10.0, epsilon=0.1).locus.highest.y, 6)
        4.782286
        """
        return ApexLocus(
            epsilon=self.epsilon, length_scale=self.length_scale, time_scale=self.time_scale
        )

    # What follows is imported when it is first asked for, so that the package starts quickly.

    def shot(
        self,
        angle: npt.ArrayLike,
        *,
        azimuth: npt.ArrayLike = 0.0,
        height: npt.ArrayLike = 0.0,
        ground: npt.ArrayLike = 0.0,
        wind: Any = None,
    ) -> Shot:
        """The shot at elevation `angle` (radians, −π to π), or an array of shots.

        `azimuth` (radians) turns it from x towards z; `height` is the launch point's and `ground`
        the landing point's (m); `wind` is the steady velocity of the medium, (x, y) or (x, y, z) in
        m/s. All broadcast.

        >>> round(Launcher(10.0, epsilon=0.1).shot(np.radians(45), height=2.0).range, 6)
        10.849032
        """
        from archerfish.shot import Shot, wind_vector

        # a shot makes arrays of what it is given
        return Shot(self, angle, azimuth, height, ground, wind_vector(wind))  # type: ignore[arg-type]

    def aim(
        self,
        x: npt.ArrayLike,
        y: npt.ArrayLike,
        z: npt.ArrayLike | None = None,
        *,
        height: npt.ArrayLike = 0.0,
        wind: Any = None,
    ) -> Aim | Unreachable:
        """Both arcs that hit the target at `x`, `y` (m), or the proof that there is none.

        One target that is out of reach gives `Unreachable`; among several, its row of `Aim` is NaN.
        With `z`, or wind in three components, the target is aimed at in space: by elevation and
        azimuth. `height` is that of the launch point (m).

        >>> arcs = Launcher(10.0, epsilon=0.1).aim(6.0, 2.0)
        >>> np.degrees([arcs.low.angle, arcs.high.angle]).round(4).tolist()
        [41.6691, 64.8459]
        """
        from archerfish.aim import aim

        return aim(self, x, y, z, height=height, wind=wind)

    def minimum_speed(
        self,
        x: npt.ArrayLike,
        y: npt.ArrayLike,
        z: npt.ArrayLike | None = None,
        *,
        height: npt.ArrayLike = 0.0,
        wind: Any = None,
    ) -> Quantity:
        """The least speed (m/s) that reaches the target, with this drag rate and gravity.

        >>> round(Launcher(1.0, gravity=10.0, epsilon=0.0).minimum_speed(10.0, 0.0), 12)
        10.0
        """
        from archerfish.aim import minimum_speed

        return minimum_speed(
            x, y, z, gravity=self.gravity, drag_rate=self.drag_rate, height=height, wind=wind
        )

    @cached_property
    def envelope(self) -> Envelope:
        """The curve that no shot crosses and every shot touches.

        >>> round(Launcher(10.0, gravity=10.0, epsilon=0.0).envelope.height(0.0), 12)
        5.0
        """
        from archerfish.envelope import Envelope

        return Envelope(self)

    def reachable(
        self, x: npt.ArrayLike, y: npt.ArrayLike, *, height: npt.ArrayLike = 0.0
    ) -> bool | npt.NDArray[np.bool_]:
        """Whether the target at `x`, `y` (m) lies on or under the envelope.

        >>> Launcher(10.0, epsilon=0.1).reachable([5.0, 9.0, 10.0], 0.0)
        array([ True,  True, False])
        """
        return self.envelope.contains(x, real("y", y) - real("height", height))

    def front(self, time: npt.ArrayLike) -> Front:
        """The synchronous circle: where shots at every angle, fired at once, are at `time` (s).

        >>> front = Launcher(10.0, gravity=10.0, epsilon=0.0).front(1.0)
        >>> front.radius, front.y
        (10.0, -5.0)
        """
        from archerfish.envelope import front

        return front(self, time)

    def named_angles(self) -> NamedAngles:
        """The launch angles that deserve a name (radians), each for every drag parameter.

        >>> angles = Launcher(10.0, epsilon=0.1).named_angles()
        >>> float(np.degrees(angles.greatest_range).round(10))
        43.7096921819
        """
        from archerfish.flight_angles import named_angles

        return named_angles(self.epsilon)

    @classmethod
    def from_sphere(
        cls,
        diameter: npt.ArrayLike,
        density: npt.ArrayLike,
        fluid_viscosity: npt.ArrayLike,
        fluid_density: npt.ArrayLike,
        speed: npt.ArrayLike,
        *,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
    ) -> SphereLauncher:
        """The launcher of a small sphere in a viscous fluid; see `archerfish.sphere`.

        >>> mist = Launcher.from_sphere(20e-6, 1000.0, 1.81e-5, 1.2, 0.5)
        >>> round(mist.drag_rate, 3), round(mist.reynolds_number, 3)
        (814.5, 0.663)
        """
        from archerfish.sphere import SphereLauncher

        return SphereLauncher(
            diameter, density, fluid_viscosity, fluid_density, speed, gravity=gravity
        )


def _drag(name: str, speed: Quantity, gravity: Quantity, **given: Quantity) -> dict[str, Quantity]:
    """All three ways to say the drag that is given in one of them, that one exactly as given."""
    drag = given[name]
    if name == "epsilon":
        epsilon, rate = drag, quotient(product(drag, gravity), speed)
        terminal = quotient(speed, drag)
    elif name == "drag_rate":
        epsilon, rate = quotient(product(drag, speed), gravity), drag
        terminal = quotient(gravity, drag)
    else:
        epsilon, rate = quotient(speed, drag), quotient(gravity, drag)
        terminal = drag
    not_negative(f"epsilon, from this {name},", epsilon)
    return {"epsilon": epsilon, "drag_rate": rate, "terminal_speed": terminal}

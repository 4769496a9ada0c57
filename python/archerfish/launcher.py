"""The launcher: a speed, a gravity and a drag, in SI units."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from archerfish.locus import ApexLocus
from archerfish.values import (
    Quantity,
    Value,
    not_negative,
    positive,
    positive_or_infinite,
    product,
    quotient,
)

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
    ValueError, none or several drags TypeError.

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
        # A speed like 1e200 is finite, but the lengths it leads to are not.
        positive("length scale speed²/gravity", self.length_scale)
        positive("time scale speed/gravity", self.time_scale)

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

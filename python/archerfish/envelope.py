"""The envelope of all shots of one speed, and the circle they are on at one time; SI units."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from archerfish import _core
from archerfish.kinematics import array, drift, fall
from archerfish.shot import Vector, record
from archerfish.values import Quantity, Value, finite, frozen, quotient

if TYPE_CHECKING:
    from archerfish.launcher import Launcher


@dataclass(frozen=True, eq=False)
class Envelope(Value):
    """The curve that every shot of a launcher touches and none crosses, over level ground.

    Symmetric in x; everything on or under it can be hit, nothing above it.

    >>> from archerfish import Launcher
    >>> envelope = Launcher(10.0, gravity=10.0, epsilon=0.0).envelope
    >>> round(envelope.height(6.0), 12), round(envelope.reach, 12)  # 5 − x²/20
    (3.2, 10.0)
    """

    launcher: Launcher

    def height(self, x: npt.ArrayLike) -> Quantity:
        """Height of the envelope (m) above `x` (m): minus infinity at `wall` and beyond.

        >>> from archerfish import Launcher
        >>> Launcher(10.0, epsilon=0.1).envelope.height([0.0, 5.0, 200.0]).round(4)
        array([4.7823, 3.4252,   -inf])
        """
        eps, length = array(self.launcher.epsilon), array(self.launcher.length_scale)
        with np.errstate(all="ignore"):
            distance = np.abs(array(x)) / length
            height = array(_core.envelope_height(distance, eps)) * length
            height = np.where(distance * eps >= 1, -np.inf, height)
        return frozen(height)

    def contains(self, x: npt.ArrayLike, y: npt.ArrayLike) -> bool | npt.NDArray[np.bool_]:
        """Whether the target at `x`, `y` (m) is on or under the envelope; both must be finite."""
        inside = np.asarray((array(y) <= self.height(x)) & np.isfinite(array(y)))
        return bool(inside) if inside.ndim == 0 else inside

    @cached_property
    def highest(self) -> Quantity:
        """The greatest height (m), that of the vertical shot."""
        return self.height(0.0)

    @cached_property
    def reach(self) -> Quantity:
        """Where the envelope meets the ground (m): the greatest range."""
        eps = self.launcher.epsilon
        farthest = _core.flight_range(_core.optimal_angle(eps), eps)
        return frozen(np.asarray(farthest * self.launcher.length_scale))

    @property
    def wall(self) -> Quantity:
        """The horizontal distance V/b (m) that no shot reaches, however far it falls."""
        return quotient(self.launcher.speed, self.launcher.drag_rate)


@dataclass(frozen=True, eq=False)
class Front(Value):
    """Where shots at every angle, fired at once, are: on a circle about `x`, `y` of `radius` (m).

    Radius V D(t), centre at the drop from rest, g F(t) below the launch point.
    """

    x: Quantity
    y: Quantity
    radius: Quantity

    def point(self, angle: npt.ArrayLike) -> Vector:
        """Place (m) of the shot at launch `angle` (radians).

        >>> from archerfish import Launcher
        >>> launcher = Launcher(10.0, epsilon=0.1)
        >>> place = launcher.front(0.5).point(0.75)
        >>> round(place.y - launcher.shot(0.75).position(0.5).y, 12)
        0.0
        """
        sine, cosine = np.sin(array(angle)), np.cos(array(angle))
        return record(Vector, x=self.x + self.radius * cosine, y=self.y + self.radius * sine, z=0.0)


def front(launcher: Launcher, time: npt.ArrayLike) -> Front:
    """What `Launcher.front` does."""
    drag = finite("drag rate of the launcher", launcher.drag_rate)
    with np.errstate(invalid="ignore"):
        radius, fallen = launcher.speed * drift(time, drag), launcher.gravity * fall(time, drag)
    return record(Front, x=0.0, y=-fallen, radius=radius)

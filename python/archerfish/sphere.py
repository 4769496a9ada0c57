"""A real sphere in a real fluid: where linear drag comes from, and when it is only a model."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from archerfish.launcher import STANDARD_GRAVITY, Launcher
from archerfish.values import Quantity, frozen, positive, product, quotient


class LinearDragWarning(UserWarning):
    """The Reynolds number is above 1: real drag grows faster than speed there."""


@dataclass(frozen=True, eq=False, init=False)
class SphereLauncher(Launcher):
    """The launcher of a sphere slowed down by viscosity, by Stokes's law.

    `diameter` d (m), its `density` ρ (kg/m³), `fluid_viscosity` μ (Pa s), `fluid_density` (kg/m³)
    and launch `speed` (m/s) give the drag rate b = 18 μ/(ρ d²). Above a Reynolds number of 1 at
    launch a `LinearDragWarning` says that linear drag is only a model there. Buoyancy, added mass
    and the fluid's memory are left out, which is right where the fluid is much the lighter; for
    buoyancy give `gravity` times 1 − fluid density/density.

    Source: G. G. Stokes, Trans. Cambridge Phil. Soc. 9 (1851).

    >>> with warnings.catch_warnings(record=True) as caught:
    ...     warnings.simplefilter("always")
    ...     golf = Launcher.from_sphere(0.0427, 1130.0, 1.81e-5, 1.2, 70.0)
    >>> print(caught[0].message)
    Reynolds number must be well below 1 for linear drag, got 198166: the result is only a model
    """

    diameter: Quantity
    density: Quantity
    fluid_viscosity: Quantity
    fluid_density: Quantity

    def __init__(
        self,
        diameter: npt.ArrayLike,
        density: npt.ArrayLike,
        fluid_viscosity: npt.ArrayLike,
        fluid_density: npt.ArrayLike,
        speed: npt.ArrayLike,
        *,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
    ) -> None:
        given = {
            "diameter": diameter,
            "density": density,
            "fluid_viscosity": fluid_viscosity,
            "fluid_density": fluid_density,
        }
        for name, value in given.items():
            object.__setattr__(self, name, positive(name.replace("_", " "), value))
        area = product(self.diameter, self.diameter)
        rate = quotient(product(18.0, self.fluid_viscosity), product(self.density, area))
        super().__init__(speed, gravity=gravity, drag_rate=rate)
        object.__setattr__(self, "_made_of", (*given, "speed", "gravity"))
        greatest = np.max(self.reynolds_number)
        if greatest > 1:
            warnings.warn(
                f"Reynolds number must be well below 1 for linear drag, got {greatest:.6g}: "
                "the result is only a model",
                LinearDragWarning,
                stacklevel=2,
            )

    @cached_property
    def reynolds_number(self) -> Quantity:
        """Fluid density × speed × diameter / viscosity, at launch."""
        inertia = product(product(self.fluid_density, self.speed), self.diameter)
        return frozen(np.asarray(quotient(inertia, self.fluid_viscosity)))

"""Projectile motion under gravity and linear drag, right to the last digits.

The functions are NumPy ufuncs, in units of V₀²/g (length) and V₀/g (time), angles in radians;
`Launcher` and `ApexLocus` are the same in SI units.

>>> import archerfish
>>> round(float(archerfish.apex_x(0.75, 0.1)), 6)
0.46692
"""

import importlib
from typing import TYPE_CHECKING

from archerfish import _core, _ufunc_docs
from archerfish._core import (
    aim_high,
    aim_low,
    apex_curvature,
    apex_distance,
    apex_elevation,
    apex_time,
    apex_x,
    apex_y,
    envelope_height,
    flight_range,
    flight_time,
    flight_x,
    flight_y,
    isa,
    lambertw0,
    lambertw0_offset,
    lambertwm1,
    lambertwm1_offset,
    locus_curvature,
    locus_launch_angle,
    locus_launch_angle_d1,
    locus_launch_angle_d2,
    locus_radius,
    log1pmx,
    optimal_angle,
    trajectory_height,
    tree,
)

if TYPE_CHECKING:
    from archerfish.launcher import Launcher
    from archerfish.locus import ApexLocus

__version__ = _core.__version__

_ufunc_docs.attach(_core)

__all__ = [
    "ApexLocus",
    "Launcher",
    "__version__",
    "aim_high",
    "aim_low",
    "apex_curvature",
    "apex_distance",
    "apex_elevation",
    "apex_time",
    "apex_x",
    "apex_y",
    "envelope_height",
    "flight_range",
    "flight_time",
    "flight_x",
    "flight_y",
    "isa",
    "lambertw0",
    "lambertw0_offset",
    "lambertwm1",
    "lambertwm1_offset",
    "locus_curvature",
    "locus_launch_angle",
    "locus_launch_angle_d1",
    "locus_launch_angle_d2",
    "locus_radius",
    "log1pmx",
    "optimal_angle",
    "trajectory_height",
    "tree",
]


#: Modules of the classes: who wants the functions only need not wait for those.
_MODULES = {"ApexLocus": "archerfish.locus", "Launcher": "archerfish.launcher"}


def __getattr__(name: str) -> object:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = globals()[name] = getattr(importlib.import_module(_MODULES[name]), name)
    return found


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})

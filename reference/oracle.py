"""Every public function: its exact values, its arguments, and the error allowed."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from reference import elementary, inputs, lambert, motion
from reference.ball import Rounded, exact
from reference.inputs import Arguments


class Function(NamedTuple):
    exact: Callable[..., Rounded]
    arguments: Arguments
    #: The error demanded, in ulp.
    bound: float


def by(function: Callable, arguments: Arguments, bound: float = 1.0) -> Function:
    return Function(lambda *a: exact(function, *a), arguments, bound)


FUNCTIONS: dict[str, Function] = {
    "exp": by(elementary.exp, inputs.EXP),
    "ln": by(elementary.ln, inputs.LN),
    "ln_1p": by(elementary.ln_1p, inputs.LN_1P),
    "exp_m1": by(elementary.exp_m1, inputs.EXP),
    "sin": by(elementary.sin, inputs.CIRCLE),
    "cos": by(elementary.cos, inputs.CIRCLE),
    "tan": by(elementary.tan, inputs.CIRCLE),
    "atan": by(elementary.atan, inputs.ATAN),
    "atan2": by(elementary.atan2, inputs.ATAN2),
    "log1pmx": by(elementary.log1pmx, inputs.LOG1PMX),
    "lambertw0": by(lambert.lambertw0, inputs.W0),
    "lambertwm1": by(lambert.lambertwm1, inputs.WM1),
    "lambertw0_offset": by(lambert.lambertw0_offset, inputs.W0_OFFSET),
    "lambertwm1_offset": by(lambert.lambertwm1_offset, inputs.WM1_OFFSET),
    "tree": by(lambert.tree, inputs.TREE),
    **{name: by(motion.along(motion.fast_apex, q), inputs.MOTION, 2.0) for name, q in motion.BY_LAUNCH_ANGLE.items()},
    **{name: by(motion.along(motion.fast_locus, q), inputs.MOTION, 2.0) for name, q in motion.BY_ELEVATION.items()},
}


def sample(name: str, count: int, seed: Sequence[int] | int) -> tuple[np.ndarray, ...]:
    """`count` drawn arguments after the corners, as one array an argument."""
    function = FUNCTIONS[name]
    drawn = function.arguments.draw(np.random.default_rng(seed), count)
    corners = zip(*function.arguments.corners, strict=True)
    return tuple(np.concatenate([np.array(c, float), d]) for c, d in zip(corners, drawn, strict=True))


def values(name: str, *arguments: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """hi, rest and ulp of the exact values, as arrays."""
    rows = [FUNCTIONS[name].exact(*(float(v) for v in row)) for row in zip(*arguments, strict=True)]
    hi, rest, ulp = (np.array(column) for column in zip(*rows, strict=True))
    return hi, rest, ulp

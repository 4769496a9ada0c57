"""Every public function: its exact values, its arguments, and the error allowed."""

from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

import numpy as np

from reference import elementary, flight, inputs, lambert, motion
from reference.ball import Rounded, exact, settled
from reference.inputs import Arguments


class Function(NamedTuple):
    #: Exact values, fast enough for 10⁵ of them.
    exact: Callable[..., Rounded]
    #: Exact values by definition alone: what the tables hold.
    defined: Callable[..., Rounded]
    #: The definition, in words, for the head of a table.
    definition: str
    names: tuple[str, ...]
    arguments: Arguments
    #: The error demanded, in ulp.
    bound: float


def direct(
    function: Callable, definition: str, names: str, arguments: Arguments, bound: float = 1.0
) -> Function:
    """A function whose proven balls are both the fast values and the definition."""

    def value(*row: float) -> Rounded:
        return exact(function, *row)

    return Function(value, value, definition, tuple(names.split()), arguments, bound)


def by_road(
    name: str, angle: str, fast: motion.Road, slow: motion.Road, quantity: Callable
) -> Function:
    quick, defined = motion.along(fast, quantity), motion.along(slow, quantity)
    return Function(
        lambda *row: exact(quick, *row),
        lambda *row: settled(defined, *row),
        motion.DEFINITIONS[name],
        (angle, "epsilon"),
        inputs.MOTION,
        2.0,
    )


BY_ANGLE: dict[str, Function] = {
    name: by_road(name, "alpha", motion.fast_apex, motion.slow_apex, quantity)
    for name, quantity in motion.BY_LAUNCH_ANGLE.items()
} | {
    name: by_road(name, "theta", motion.fast_locus, motion.slow_locus, quantity)
    for name, quantity in motion.BY_ELEVATION.items()
}

FLIGHT: dict[str, Function] = {
    name: direct(getattr(flight, name), flight.DEFINITIONS[name], names, arguments, 2.0)
    for name, names, arguments in [
        ("flight_time", "alpha epsilon", inputs.MOTION),
        ("flight_range", "alpha epsilon", inputs.MOTION),
        ("flight_x", "t alpha epsilon", inputs.MOMENT),
        ("flight_y", "t alpha epsilon", inputs.MOMENT),
        ("trajectory_height", "x alpha epsilon", inputs.CURVE),
        ("optimal_angle", "epsilon", inputs.DRAG_ALONE),
        ("envelope_height", "x epsilon", inputs.ABSCISSA),
        ("aim_low", "x y epsilon", inputs.TARGET),
        ("aim_high", "x y epsilon", inputs.TARGET),
    ]
}

FUNCTIONS: dict[str, Function] = {
    "exp": direct(elementary.exp, "e^x", "x", inputs.EXP),
    "ln": direct(elementary.ln, "the natural logarithm of x", "x", inputs.LN),
    "ln_1p": direct(elementary.ln_1p, "ln(1 + x)", "x", inputs.LN_1P),
    "exp_m1": direct(elementary.exp_m1, "e^x - 1", "x", inputs.EXP),
    "sin": direct(elementary.sin, "sin x", "x", inputs.CIRCLE),
    "cos": direct(elementary.cos, "cos x", "x", inputs.CIRCLE),
    "tan": direct(elementary.tan, "tan x", "x", inputs.CIRCLE),
    "atan": direct(elementary.atan, "arctan x", "x", inputs.ATAN),
    "atan2": direct(elementary.atan2, "the angle of the point (x, y)", "y x", inputs.ATAN2),
    "log1pmx": direct(elementary.log1pmx, "ln(1 + x) - x", "x", inputs.LOG1PMX),
    "lambertw0": direct(
        lambert.lambertw0,
        "the root w >= -1 of w e^w = z; -1 at the double nearest -1/e",
        "z",
        inputs.W0,
    ),
    "lambertwm1": direct(
        lambert.lambertwm1,
        "the root w <= -1 of w e^w = z; -1 at the double nearest -1/e",
        "z",
        inputs.WM1,
    ),
    "lambertw0_offset": direct(
        lambert.lambertw0_offset,
        "the root v >= 0 of (v-1) e^(v-1) = d - 1/e",
        "d",
        inputs.W0_OFFSET,
    ),
    "lambertwm1_offset": direct(
        lambert.lambertwm1_offset,
        "the root v <= 0 of (v-1) e^(v-1) = d - 1/e",
        "d",
        inputs.WM1_OFFSET,
    ),
    "tree": direct(
        lambert.tree, "the root t <= 1 of t e^-t = z; 1 at the double nearest 1/e", "z", inputs.TREE
    ),
    **BY_ANGLE,
    **FLIGHT,
}


def groups(names: Iterable[str]) -> list[list[str]]:
    """Names that share their arguments and their road, and so most of the work."""
    together: dict[tuple, list[str]] = {}
    for name in names:
        function = FUNCTIONS[name]
        together.setdefault((id(function.arguments), function.names), []).append(name)
    return list(together.values())


def stream(arguments: Arguments) -> str:
    """A name for the random numbers of these arguments: the first function that has them."""
    return next(name for name, f in FUNCTIONS.items() if f.arguments is arguments)


def sample(name: str, count: int, seed: Sequence[int] | int) -> tuple[np.ndarray, ...]:
    """`count` drawn arguments after the corners, as one array an argument."""
    function = FUNCTIONS[name]
    drawn = function.arguments.draw(np.random.default_rng(seed), count)
    corners = zip(*function.arguments.corners, strict=True)
    return tuple(
        np.concatenate([np.array(c, float), d]) for c, d in zip(corners, drawn, strict=True)
    )


def values(name: str, *arguments: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """hi, rest and ulp of the exact values, as arrays."""
    rows = [FUNCTIONS[name].exact(*(float(v) for v in row)) for row in zip(*arguments, strict=True)]
    hi, rest, ulp = (np.array(column) for column in zip(*rows, strict=True))
    return hi, rest, ulp

"""Who is timed beside whom: each kernel, and what others take for the same answer.

Arrays in random order, ε log-uniform in [0.01, 100] and all of z, as mixed as users' arrays are.
Ufuncs write into an array of their own; formulas allocate as they are typed.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import lambertw

import archerfish
from bench import peers, textbook
from bench.textbook import Array
from reference import oracle
from reference.ball import ulp_errors

SEED = 2010
FEW = 16
"""Contenders above about a microsecond an element get one element in this many."""
FLIGHTS = 8
"""Trajectories that the differential equation is solved for."""
ONE_DRAG = 0.1
"""The drag of contenders that work through a table for one drag alone."""
CHECKED = 100
"""Elements of ours that are compared with exact values."""

#: A function that crosses zero, and one whose question is ill-conditioned next to the envelope:
#: their last digits are held elsewhere, by reference/accuracy.py.
LOOSELY = {"locus_launch_angle_d2": 1e6, "aim_low": 1e6, "aim_high": 1e6}

Function = Callable[[], Array]


class Contender(NamedTuple):
    kernel: str
    name: str
    call: Function
    #: What it should answer, and the relative error that 19 in 20 elements keep.
    expected: Array
    within: float

    @property
    def ours(self) -> bool:
        return self.name == "archerfish"

    def check(self) -> None:
        """Raise where the answer is another."""
        with np.errstate(all="ignore"):
            got = np.asarray(self.call())
            error = np.quantile(np.nan_to_num(abs(got / self.expected - 1), nan=np.inf), 0.95)
        if not error <= self.within:
            raise ValueError(
                f"{self.name} for {self.kernel} must be within {self.within:g}, is off by {error:g}"
            )


def columns(count: int) -> dict[str, Array]:
    """Arguments by name, those of other doors included."""
    rng = np.random.default_rng(SEED)
    half = count // 2
    inner = textbook.BRANCH_POINT * rng.uniform(0, 1, (2, count - half))
    upper = np.concatenate([10.0 ** rng.uniform(-8, 300, half), inner[0]])
    lower = np.concatenate([-(10.0 ** rng.uniform(-300, -1, half)), inner[1]])
    alpha = rng.uniform(0, np.pi / 2, count)
    eps = 10.0 ** rng.uniform(-2, 2, count)
    values = {
        "positive": rng.uniform(0.1, 10.0, count),
        "z of lambertw0": rng.permutation(upper),
        "z of lambertwm1": rng.permutation(lower),
        "z of tree": rng.permutation(-upper),
        "d of lambertw0_offset": 10.0 ** rng.uniform(-16, 2, count),
        "d of lambertwm1_offset": -textbook.BRANCH_POINT * rng.uniform(0, 1, count),
        "x of log1pmx": rng.uniform(-0.99, 10, count),
        "alpha": alpha,
        "theta": np.asarray(archerfish.apex_elevation(alpha, eps)),
        "eps": eps,
        "t": rng.uniform(0, 2, count) * archerfish.apex_time(alpha, eps),
        "x": rng.uniform(0, 1, count) * archerfish.flight_range(alpha, eps),
        "y": rng.uniform(0, 1, count),
    }
    return {name: placed(column) for name, column in values.items()}


def placed(values: Array) -> Array:
    """The values where a large array stands that is new from the system: 16 bytes behind a page.

    One from memory that another left may stand anywhere, and np.log, which is the unit, takes up to
    a sixth longer or a tenth less for it (bench/NOTES.md).
    """
    page, behind = 4096, 16
    room = np.empty(values.nbytes + 2 * page, np.uint8)
    first = (behind - room.ctypes.data) % page
    array = room[first : first + values.nbytes].view(values.dtype)
    array[...] = values
    return array


def empty(count: int) -> Array:
    """Room for results, so placed."""
    return placed(np.zeros(count))


def unit(count: int) -> Function:
    """np.log over an array of the same length."""
    positive, out = columns(count)["positive"], empty(count)
    return lambda: np.log(positive, out=out)


def ours(arguments: dict[str, Array], count: int) -> list[Contender]:
    """Every kernel, its answers compared with exact ones."""
    found = []
    for name, function in oracle.FUNCTIONS.items():
        ufunc = getattr(archerfish, name, None)
        if ufunc is None:
            continue
        names = ["eps" if n == "epsilon" else n for n in function.names]
        x = [arguments.get(f"{n} of {name}", arguments.get(n)) for n in names]
        if name == "envelope_height":
            x[0] = placed(x[0] / np.maximum(1.0, arguments["eps"]))
        if name.startswith("aim"):
            x[1] = placed(x[1] * archerfish.envelope_height(x[0], x[2]))
        out = empty(count)
        result = np.asarray(ufunc(*x))
        exact = oracle.values(name, *(column[:CHECKED] for column in x))
        worst = ulp_errors(result[:CHECKED], *exact).max()
        bound = LOOSELY.get(name, function.bound)
        if worst > bound:
            raise ValueError(f"{name} must be within {bound:g} ulp, is off by {worst:g}")
        found.append(Contender(name, "archerfish", partial(ufunc, *x, out=out), result, 0.0))
    return found


def theirs(
    arguments: dict[str, Array],
    answers: dict[str, Array],
    libraries: dict[str, dict[str, peers.Function]],
) -> list[Contender]:
    """What others take for the same answers."""
    count = arguments["alpha"].size
    a = arguments
    alpha, theta, eps = a["alpha"], a["theta"], a["eps"]
    few = slice(0, max(1, count // FEW))
    flights = slice(0, min(FLIGHTS, count))
    table: list[tuple[str, str, Function, float, slice]] = []

    def add(kernel: str, name: str, call: Function, within: float = 1e-6, part=slice(None)) -> None:
        table.append((kernel, name, call, within, part))

    for kernel, branch in (("lambertw0", 0), ("lambertwm1", -1)):
        z, out = a[f"z of {kernel}"], empty(count)
        add(kernel, "SciPy", lambda z=z, branch=branch: lambertw(z, branch).real)
        for peer, functions in libraries.items():

            def call(function=functions[kernel], z=z, out=out):
                function(z, out)
                return out

            add(kernel, peer, call)
    x = a["x of log1pmx"]
    add("log1pmx", "NumPy, typed", lambda: np.log1p(x) - x)
    add("tree", "SciPy", lambda: -lambertw(-a["z of tree"]).real)
    add("apex_x", "NumPy, typed", lambda: textbook.abscissa(alpha, eps))
    add("apex_y", "NumPy, typed", lambda: textbook.height(alpha, eps))
    add("apex_time", "NumPy, typed", lambda: np.log1p(eps * np.sin(alpha)) / eps)
    add("apex_distance", "NumPy, typed", lambda: textbook.distance(alpha, eps))
    add("apex_elevation", "NumPy, typed", lambda: textbook.elevation(alpha, eps))
    add(
        "locus_radius",
        "(13) with both branches, α given",
        lambda: textbook.radius(theta, alpha, eps),
    )
    add(
        "locus_radius",
        "solve_ivp to the apex",
        lambda: textbook.radius_by_flight(alpha[flights], eps[flights], solve_ivp),
        part=flights,
    )
    add(
        "locus_launch_angle",
        "find_root",
        lambda: textbook.launch_angle_by_root(theta[few], eps[few]),
        part=few,
    )
    add("flight_range", "textbook W₀", lambda: textbook.flight_range(alpha, eps))
    add("flight_time", "textbook W₀", lambda: textbook.flight_time(alpha, eps))
    found = [
        Contender(kernel, name, call, answers[kernel][part], within)
        for kernel, name, call, within, part in table
        if kernel in answers
    ]
    return found + by_table(alpha)


def by_table(alpha: Array) -> list[Contender]:
    """What works on a table of 10 000 points for one drag."""
    eps, grid = ONE_DRAG, textbook.grid()
    theta = np.asarray(archerfish.apex_elevation(alpha, eps))
    on_grid = np.asarray(archerfish.apex_elevation(grid, eps))
    slope = np.asarray(archerfish.locus_launch_angle_d1(on_grid, eps))
    bend = np.asarray(archerfish.locus_launch_angle_d2(on_grid, eps))
    curvature = np.asarray(archerfish.apex_curvature(grid, eps))
    return [
        Contender(
            "locus_launch_angle",
            "np.interp, one drag",
            lambda: textbook.launch_angle(theta, eps),
            alpha,
            1e-4,
        ),
        Contender(
            "locus_launch_angle_d1",
            "differences, one drag",
            lambda: textbook.slope(eps),
            slope,
            1e-4,
        ),
        Contender(
            "locus_launch_angle_d2",
            "differences, one drag",
            lambda: textbook.bend(eps),
            bend,
            1e-2,
        ),
        Contender(
            "apex_curvature",
            "differences, one drag",
            lambda: textbook.curvature(eps),
            curvature,
            1e-4,
        ),
    ]


def contenders(
    count: int, libraries: dict[str, dict[str, peers.Function]] | None = None
) -> list[Contender]:
    """Everybody, kernel by kernel, ours first; everybody checked."""
    arguments = columns(count)
    with np.errstate(all="ignore"):
        mine = ours(arguments, count)
        others = theirs(arguments, {one.kernel: one.expected for one in mine}, libraries or {})
    together = []
    for one in mine:
        together += [one, *(other for other in others if other.kernel == one.kernel)]
    for one in together:
        one.check()
    return together

"""Random and adversarial arguments, by function; a seed gives the same doubles everywhere."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from reference.lambert import BRANCH_POINT

Generator = np.random.Generator
#: Draws `count` values of one argument.
Draw = Callable[[Generator, int], np.ndarray]

TINY = 5e-324
LARGEST = np.finfo(float).max
HALF_PI, PI = np.pi / 2, np.pi
#: ε sin α where (13) changes branch: u - ln(1+u) = 1.
BRANCH_CHANGE = 2.146193220620582585


class Arguments(NamedTuple):
    """How the arguments of a function are drawn, and the points that every run includes."""

    draw: Callable[[Generator, int], tuple[np.ndarray, ...]]
    corners: list[tuple[float, ...]]


def log_uniform(low: float, high: float) -> Draw:
    """Uniform in the logarithm, down to subnormals."""
    return lambda rng, count: 2.0 ** rng.uniform(np.log2(low), np.log2(high), count)


def uniform(low: float, high: float) -> Draw:
    return lambda rng, count: rng.uniform(low, high, count)


def negated(draw: Draw) -> Draw:
    return lambda rng, count: -draw(rng, count)


def mixture(*parts: tuple[float, Draw]) -> Draw:
    """Each value from one of the parts, chosen with the given weights."""

    def draw(rng: Generator, count: int) -> np.ndarray:
        weights = np.array([weight for weight, _ in parts])
        which = rng.choice(len(parts), size=count, p=weights / weights.sum())
        return np.choose(which, [part(rng, count) for _, part in parts])

    return draw


def near(center: float, side: int, reach: float = 0.1) -> Draw:
    """Log-uniformly close to a point, from one ulp on, on one side."""

    def draw(rng: Generator, count: int) -> np.ndarray:
        distance = 2.0 ** rng.uniform(np.log2(np.spacing(abs(center))), np.log2(reach), count)
        return center + side * distance

    return draw


def clipped(draw: Draw, low: float, high: float) -> Draw:
    return lambda rng, count: np.clip(draw(rng, count), low, high)


def signed(draw: Draw) -> Draw:
    return lambda rng, count: draw(rng, count) * rng.choice([-1.0, 1.0], count)


def neighbours(*points: float) -> list[float]:
    return [
        value for p in points for value in (np.nextafter(p, -np.inf), p, np.nextafter(p, np.inf))
    ]


def unary(draw: Draw, corners: list[float]) -> Arguments:
    return Arguments(lambda rng, count: (draw(rng, count),), [(float(c),) for c in corners])


EVERYWHERE = [
    0.0,
    -0.0,
    TINY,
    -TINY,
    2.2250738585072014e-308,
    -2.2250738585072014e-308,
    1e-300,
    -1e-300,
    1e-20,
    -1e-20,
]
ENDS = [LARGEST, -LARGEST, np.inf, -np.inf, np.nan]
FULL = log_uniform(TINY, LARGEST)

# Real functions --------------------------------------------------

EXP = unary(
    mixture(
        (6, uniform(-40, 40)),
        (3, uniform(-745.5, 710)),
        (2, signed(log_uniform(1e-20, 1))),
        (1, signed(FULL)),
    ),
    [
        *EVERYWHERE,
        *ENDS,
        *neighbours(
            0.5 * np.log(2),
            -0.5 * np.log(2),
            709.782712893384,
            -708.3964185322641,
            36.7,
            -36.7,
            1,
            -1,
        ),
        *neighbours(-745.1332191019411, -745.1332191019412),
    ],
)
LN = unary(
    mixture(
        (5, FULL),
        (3, uniform(0.3, 3)),
        (2, near(1, 1)),
        (2, near(1, -1)),
        (1, log_uniform(TINY, 1e-300)),
    ),
    [
        0.0,
        TINY,
        1e-310,
        *ENDS,
        -1.0,
        *neighbours(1, 2, 0.5, np.sqrt(2), np.sqrt(0.5), 2.2250738585072014e-308),
    ],
)
LN_1P = unary(
    mixture(
        (3, signed(log_uniform(1e-20, 1))),
        (3, uniform(-1, 3)),
        (2, FULL),
        (1, signed(log_uniform(TINY, 1))),
        (2, near(-1, 1)),
    ),
    [
        *EVERYWHERE,
        *ENDS,
        *neighbours(-1, 1, np.sqrt(2) - 1, np.sqrt(0.5) - 1, 2.0**53, 2.0**54, -0.5),
        -2.0,
    ],
)
LOG1PMX = unary(
    mixture(
        (4, signed(log_uniform(1e-20, 1))),
        (4, uniform(-1, 3)),
        (2, FULL),
        (1, signed(log_uniform(TINY, 1))),
        (2, near(-1, 1)),
        (1, signed(log_uniform(1e-163, 1e-150))),
    ),
    # where the kernel changes its power of two
    [*(c[0] for c in LN_1P.corners), *neighbours(-0.3134765625, -0.65673828125, 0.5, 2.0)],
)
TURN = 2 * np.pi
CIRCLE = unary(
    clipped(
        mixture(
            (5, uniform(-TURN, TURN)),
            (2, signed(log_uniform(1e-20, 1))),
            (1, signed(log_uniform(TINY, 1))),
            *((0.5, signed(near(k * HALF_PI, side))) for k in (1, 2, 3, 4) for side in (-1, 1)),
        ),
        -TURN,
        TURN,
    ),
    [*EVERYWHERE, np.inf, -np.inf, np.nan, 6.3, -1e300]
    + [v for v in neighbours(*(k * PI / 4 for k in range(-8, 9) if k)) if abs(v) <= TURN],
)
ATAN = unary(
    mixture((4, signed(log_uniform(1e-10, 1e10))), (4, uniform(-4, 4)), (2, signed(FULL))),
    [
        *EVERYWHERE,
        *ENDS,
        *neighbours(
            1, -1, np.sqrt(2) - 1, np.sqrt(2) + 1, np.sqrt(3), 7 / 16, 11 / 16, 19 / 16, 39 / 16
        ),
    ],
)


def plane(rng: Generator, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Points of any two sizes, of like sizes, and close to the diagonals."""
    wide = signed(FULL)
    near_one = signed(log_uniform(1e-3, 1e3))
    y, x = near_one(rng, count), near_one(rng, count)
    some = rng.random(count) < 0.3
    y[some], x[some] = wide(rng, some.sum()), wide(rng, some.sum())
    some = rng.random(count) < 0.1
    x[some] = (rng.choice([-1, 1], some.sum()) * y[some]) * (
        1 + signed(log_uniform(1e-16, 0.1))(rng, some.sum())
    )
    return y, x


ATAN2 = Arguments(
    plane,
    [
        (y, x)
        for y in [0.0, -0.0, TINY, 1e-310, 1.0, -1.0, LARGEST, np.inf, -np.inf]
        for x in [0.0, -0.0, TINY, -TINY, 1e-310, 1.0, -1.0, LARGEST, -LARGEST, np.inf, -np.inf]
    ]
    + [(np.nan, 1.0), (1.0, np.nan)],
)

# Lambert W --------------------------------------------------

INVERSE_E = -BRANCH_POINT
BEFORE_BRANCH = np.nextafter(BRANCH_POINT, 0)
W_CORNERS = [
    *neighbours(BRANCH_POINT),
    np.nextafter(BEFORE_BRANCH, 0),
    -0.4,
    -0.35,
    -0.25,
    -0.1,
    -TINY,
    -1e-310,
    -1e-300,
]

W0 = unary(
    mixture(
        (3, log_uniform(1e-8, LARGEST)),
        (3, log_uniform(1e-3, 1e3)),
        (3, clipped(near(BRANCH_POINT, 1, 0.4), BEFORE_BRANCH, 1)),
        (2, uniform(BEFORE_BRANCH, 0)),
        (1, signed(log_uniform(TINY, 0.3))),
    ),
    [*W_CORNERS, *EVERYWHERE, *ENDS, *neighbours(np.e, 1.0, 2 * np.exp(2.0)), -1.0],
)
WM1 = unary(
    mixture(
        (4, clipped(near(BRANCH_POINT, 1, 0.3), BEFORE_BRANCH, -TINY)),
        (3, uniform(BEFORE_BRANCH, 0)),
        (2, negated(log_uniform(1e-10, 0.3))),
        (1, negated(log_uniform(TINY, 0.3))),
    ),
    [*W_CORNERS, *EVERYWHERE, *ENDS, 1.0],
)
W0_OFFSET = unary(
    mixture(
        (3, log_uniform(1e-20, 1)),
        (3, uniform(0, 3)),
        (2, FULL),
        (1, near(INVERSE_E, 1)),
        (1, near(INVERSE_E, -1)),
    ),
    [*EVERYWHERE, *ENDS, *neighbours(INVERSE_E), 1.0, -1.0],
)
WM1_OFFSET = unary(
    clipped(
        mixture(
            (4, log_uniform(1e-20, 0.36)),
            (4, uniform(0, INVERSE_E)),
            (1, log_uniform(TINY, 0.36)),
            (3, near(INVERSE_E, -1)),
        ),
        TINY,
        np.nextafter(INVERSE_E, 0),
    ),
    [*EVERYWHERE, *ENDS, *neighbours(INVERSE_E), 1.0, -1.0],
)
TREE = Arguments(lambda rng, count: (-W0.draw(rng, count)[0],), [(-z,) for (z,) in W0.corners])

# Motion --------------------------------------------------

ANGLE = clipped(
    mixture(
        (5, uniform(0, HALF_PI)),
        (1, uniform(HALF_PI, PI)),
        (1, log_uniform(1e-20, 1)),
        (0.3, log_uniform(TINY, 1e-20)),
        (0.8, near(HALF_PI, -1)),
        (0.4, near(HALF_PI, 1)),
        (0.4, near(PI, -1)),
    ),
    0,
    PI,
)
DRAG = mixture(
    (6, log_uniform(0.01, 100)),
    (2, log_uniform(1e-8, 1e8)),
    (2, log_uniform(TINY, 1e300)),
    (1, uniform(0, 3)),
)
ANGLES = [
    0.0,
    TINY,
    1e-310,
    1e-300,
    1e-20,
    1e-8,
    0.1,
    PI / 4,
    1.0,
    *neighbours(HALF_PI),
    2.0,
    3.0,
    np.nextafter(PI, 0),
    PI,
]
DRAGS = [0.0, TINY, 1e-308, 1e-20, 1e-8, 0.1, 1.0, 2.0, BRANCH_CHANGE, 3.0, 10.0, 1e8, 1e20, 1e300]
OUTSIDE = [
    (-0.1, 1.0),
    (np.nextafter(PI, 4), 1.0),
    (-TINY, 1.0),
    (1.0, -TINY),
    (1.0, -1.0),
    (np.nan, 1.0),
    (1.0, np.nan),
]
OUTSIDE += [(np.inf, 1.0), (-np.inf, 1.0), (1.0, np.inf), (1.0, -np.inf)]


def angle_and_drag(rng: Generator, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Angles and drags; one pair in ten has ε sin(angle) close to where (13) changes branch."""
    angle, drag = ANGLE(rng, count), DRAG(rng, count)
    some = (rng.random(count) < 0.1) & (angle > 1e-100)
    off = 1 + signed(log_uniform(1e-16, 0.1))(rng, some.sum())
    drag[some] = BRANCH_CHANGE * off / np.sin(angle[some])
    return angle, drag


MOTION = Arguments(angle_and_drag, [(a, e) for a in ANGLES for e in DRAGS] + OUTSIDE)

# Flight --------------------------------------------------

#: Any direction, downward ones included.
DIRECTION = mixture((3, ANGLE), (1, negated(ANGLE)), (0.2, uniform(-TURN, TURN)))


def moment(rng: Generator, count: int, drags: Draw = DRAG) -> tuple[np.ndarray, ...]:
    """Times by every measure: of the flight, of the drag, of any size."""
    alpha, drag = DIRECTION(rng, count), drags(rng, count)
    of_drag = log_uniform(2.0**-6, 2.0**7)(rng, count) / np.maximum(drag, 1e-290)
    of_flight = log_uniform(2.0**-4, 2.0**4)(rng, count) * np.abs(np.sin(alpha))
    t = np.choose(rng.choice(3, count), [of_drag, of_flight, log_uniform(TINY, 1e300)(rng, count)])
    return t, alpha, drag


#: Shares of a way: all of it, its beginning, its end.
SHARE = mixture((5, uniform(0, 1)), (3, log_uniform(1e-12, 1)), (2, near(1, -1, 0.5)))


def reach(rng: Generator, drag: np.ndarray) -> np.ndarray:
    """How far a shot may get: to the wall 1/ε, or several times the drag-free range."""
    far = log_uniform(2.0**-10, 2.0**3)(rng, drag.size)
    return SHARE(rng, drag.size) * np.minimum(1 / np.maximum(drag, 1e-290), far)


def abscissa_on_curve(rng: Generator, count: int) -> tuple[np.ndarray, ...]:
    alpha, drag = DIRECTION(rng, count), DRAG(rng, count)
    return reach(rng, drag) * np.cos(alpha), alpha, drag


def abscissa(rng: Generator, count: int) -> tuple[np.ndarray, ...]:
    drag = DRAG(rng, count)
    return signed(lambda rng, _: reach(rng, drag))(rng, count), drag


#: As DRAG; the tiniest, for which exact values take long, more rarely.
SELDOM_TINY = mixture(
    (6, log_uniform(0.01, 100)),
    (2, log_uniform(1e-8, 1e8)),
    (0.3, log_uniform(TINY, 1e300)),
    (1, log_uniform(1, 1e300)),
    (1, uniform(0, 3)),
)


def target(rng: Generator, count: int) -> tuple[np.ndarray, ...]:
    """Places of shots in every direction at every time, and places next to the envelope."""
    t, alpha, drag = moment(rng, count, SELDOM_TINY)
    t = np.minimum(t, 1e6)
    w = np.maximum(t * drag, 1e-9)
    way = -t * np.expm1(-w) / w
    fallen = np.where(w < 1e-4, t * t / 2, t * (t - way) / w)
    x, y = way * np.cos(alpha), way * np.sin(alpha) - fallen
    near_top = rng.random(count) < 0.25
    off = np.where(near_top, np.abs(reach(rng, drag)), np.abs(x))
    end = np.maximum(1 - (drag * off) ** 2, 1e-16)
    sine = end / (drag * off * off + np.sqrt(off * off + end))
    longest = 1 / (sine + drag)
    v = drag * longest
    # (−ln(1 − v) − v)/v², by its series where the difference would cost digits
    series = np.polynomial.polynomial.polyval(np.minimum(v, 0.25), 1 / np.arange(2, 28))
    direct = (-np.log(sine * longest) - v) / np.maximum(v, 0.25) ** 2
    top = longest * (sine - longest * np.where(v < 0.25, series, direct))
    # not so close that the last digits decide on which side of the envelope they are; next to the
    # wall at 1/ε they decide more, and those of `end` are lost
    below = log_uniform(2.0**-46, 2.0**2)(rng, count)
    y = np.where(near_top, top - below * np.abs(top), y)
    rise = longest * sine
    y = np.minimum(y, top - 2.0**-46 * (np.abs(top) + rise) - 2.0**-50 / end * rise)
    return np.copysign(off, x), y, drag


TIMES = [0.0, TINY, 1e-310, 1e-20, 0.1, 1.0, 30.0, 1e10, 1e300]
SOME_ANGLES = [-TURN, -HALF_PI, -0.5, -TINY, 0.0, TINY, 1e-8, 0.7, HALF_PI, 2.0, PI, 4.0, TURN]
SOME_DRAGS = [0.0, TINY, 1e-20, 0.1, 2.0, 1e8, 1e300]
MOMENT = Arguments(
    moment,
    [(t, a, e) for t in TIMES for a in SOME_ANGLES for e in SOME_DRAGS]
    + [(-TINY, 1.0, 1.0), (np.inf, 1.0, 1.0), (np.nan, 1.0, 1.0), (1.0, np.nan, 1.0)]
    + [(1.0, 6.3, 1.0), (1.0, -6.3, 1.0), (1.0, 1.0, -TINY), (1.0, 1.0, np.inf)],
)
LENGTHS = [0.0, TINY, 1e-310, 1e-20, 0.1, 0.5, 1.0, 1e8, 1e300]
CURVE = Arguments(
    abscissa_on_curve,
    [(s * x, a, e) for x in LENGTHS for s in (-1, 1) for a in SOME_ANGLES for e in SOME_DRAGS]
    + [(np.inf, 1.0, 0.0), (np.nan, 1.0, 1.0), (0.1, np.nan, 1.0), (0.1, 1.0, np.nan)]
    + [(0.1, 6.3, 1.0), (0.1, -6.3, 1.0), (0.1, 1.0, -TINY), (0.1, 1.0, np.inf)],
)
ABSCISSA = Arguments(
    abscissa,
    [(s * x, e) for x in LENGTHS for s in (-1, 1) for e in DRAGS]
    + [(s * x, 1 / x) for s in (-1, 1) for y in (0.25, 1.0, 2.0) for x in neighbours(y)]
    + [(np.inf, 0.0), (np.nan, 1.0), (0.1, np.nan), (0.1, -TINY), (0.1, np.inf)],
)
DRAG_ALONE = unary(
    mixture((6, DRAG), (2, log_uniform(1e-3, 30)), (1, near(2.0**40, 1)), (1, near(2.0**40, -1))),
    [*DRAGS, *neighbours(2.0**40, 1e-8, 1.0), 1e-162, 1e-154, 1e154, *ENDS, -TINY, -1.0],
)

TARGET = Arguments(
    target,
    [
        (s * x, y, e)
        for x in [0.0, TINY, 1e-20, 0.1, 1.0, 10.0]
        for s in (-1, 1)
        for y in [-1e5, -0.1, -TINY, 0.0, 1e-20, 0.1, 0.5]
        for e in SOME_DRAGS
    ]
    + [(np.inf, 0.1, 0.1), (0.1, np.inf, 0.1), (0.1, -np.inf, 0.1), (0.1, 0.1, -TINY)]
    + [(np.nan, 0.1, 0.1), (0.1, np.nan, 0.1), (0.1, 0.1, np.nan), (0.1, 0.1, np.inf)],
)

# Hard cases --------------------------------------------------

#: Inputs at which a kernel once was at its worst, found by longer searches than a run makes.
HARD: dict[str, list[tuple[float, ...]]] = {
    "lambertw0": [(-6.926145520459907e-17,)],
    "tree": [(6.406722755491773e-17,)],
    "apex_curvature": [(0.7549014608875808, 1.455976468789219)],
    "locus_curvature": [
        (0.7451352360233541, 0.00971957377226547),
        (0.7622929466841202, 0.005954422691331499),
        (0.7275603485676038, 0.3335208596234571),
    ],
    "locus_launch_angle": [(0.07823764787808882, 46.585678906530084)],
    "locus_launch_angle_d2": [
        (1e-310, 1e-308),
        (3.1415926535897905, 6.9085681953531405e221),
        (1.047049169987363e-07, 2249069.1630480345),
    ],
}

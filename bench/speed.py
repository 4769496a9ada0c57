"""Nanoseconds an element, ours and theirs side by side in one run."""

from __future__ import annotations

import time
from collections.abc import Callable
from statistics import median

import numpy as np
from scipy.special import lambertw

import archerfish
from bench import textbook
from bench.accuracy import SEED, regions

Call = Callable[[], object]

SLOW = 32
"""Contenders above about a microsecond an element get one element in this many."""


def calls(count: int) -> dict[str, tuple[int, Call]]:
    """Every contender by name: how many elements a call computes, and the call.

    Functions that are ufuncs write into an array of their own; formulas allocate as they are typed.
    """
    rng = np.random.default_rng(SEED)
    eps = 0.1
    alpha = rng.uniform(0.0, np.pi / 2, count)
    theta = np.asarray(archerfish.apex_elevation(alpha, eps))
    few = theta[: count // SLOW]
    positive = rng.uniform(0.1, 10.0, count)
    out = np.empty(count)
    drawn = {region: z for region, (_, z) in regions(count).items()}
    wide, inner = drawn["W₀, 10^[−8, 300]"], drawn["W₋₁, (−1/e, 0)"]
    f = archerfish
    table: dict[str, Call] = {
        "np.log": lambda: np.log(positive, out=out),
        "np.sin": lambda: np.sin(alpha, out=out),
        "lambertw0(z), z in 10^[−8, 300]": lambda: f.lambertw0(wide, out=out),
        "scipy lambertw(z), z in 10^[−8, 300]": lambda: lambertw(wide).real,
        "lambertw0(z), z in (−1/e, 0)": lambda: f.lambertw0(inner, out=out),
        "scipy lambertw(z), z in (−1/e, 0)": lambda: lambertw(inner).real,
        "lambertwm1(z), z in (−1/e, 0)": lambda: f.lambertwm1(inner, out=out),
        "scipy lambertw(z, −1), z in (−1/e, 0)": lambda: lambertw(inner, -1).real,
        "lambertw0_offset(d)": lambda: f.lambertw0_offset(positive, out=out),
        "log1pmx(x)": lambda: f.log1pmx(positive, out=out),
        "np.log1p(x) − x": lambda: np.log1p(positive) - positive,
        "apex_y": lambda: f.apex_y(alpha, eps, out=out),
        "y = (u − log1p(u))/ε²": lambda: textbook.height(alpha, eps),
        "apex_elevation": lambda: f.apex_elevation(alpha, eps, out=out),
        "θ by (10), typed": lambda: textbook.elevation(alpha, eps),
        "apex_curvature": lambda: f.apex_curvature(alpha, eps, out=out),
        "locus_launch_angle": lambda: f.locus_launch_angle(theta, eps, out=out),
        "α(θ), np.interp on 10⁴": lambda: textbook.launch_angle(theta, eps),
        "locus_radius": lambda: f.locus_radius(theta, eps, out=out),
        "r by (13), α given": lambda: textbook.radius(theta, alpha, eps),
        "locus_curvature": lambda: f.locus_curvature(theta, eps, out=out),
    }
    return {name: (count, call) for name, call in table.items()} | {
        "ρK, differences on 10⁴": (textbook.GRID, lambda: textbook.curvature(eps)),
        "α(θ), scipy find_root": (few.size, lambda: textbook.launch_angle_by_root(few, eps)),
    }


def nanoseconds(count: int, rounds: int) -> dict[str, float]:
    """Median nanoseconds of this thread's processor time an element.

    Contenders take turns, so that all see the same machine, whatever else it does meanwhile.
    """
    table = calls(count)
    seen: dict[str, list[float]] = {name: [] for name in table}
    for _, call in table.values():
        call()
    for _ in range(rounds):
        for name, (elements, call) in table.items():
            start = time.thread_time_ns()
            call()
            seen[name].append((time.thread_time_ns() - start) / elements)
    return {name: median(times) for name, times in seen.items()}

"""Worst errors, ours and theirs, against the exact values of ``reference``."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from flint import arb
from scipy.special import lambertw

import archerfish
from bench import textbook
from bench.textbook import Array
from reference import oracle
from reference.ball import exact, ulp_errors

EPSILONS = (1e-12, 1e-8, 1e-4, 0.1, 1.0, 2.0, 3.0, 10.0, 1e4)
MARGIN = 0.01
"""Launch angles lie this far inside (0, π/2), radians; nearer to the ends all theirs are worse."""
SEED = 2010

Table = dict[str, dict[str, float]]
"""Worst error by row and column."""


def launch_angles(count: int) -> Array:
    """Random launch angles, the same for every drag."""
    drawn = np.random.default_rng(SEED).uniform(MARGIN, np.pi / 2 - MARGIN, count)
    return np.sort(drawn)


def worst(got: Array, true: tuple[Array, Array, Array]) -> float:
    """The worst relative error."""
    high, rest, ulp = true
    return float(np.max(np.abs((got - high - rest * ulp) / high)))


def exact_range(alpha: float, eps: float) -> arb:
    """Range on level ground, the textbook form in as many bits as it wants."""
    q = 1 + arb(eps) * arb(alpha).sin()
    tau = q + (-q * (-q).exp()).lambertw()
    return arb(alpha).cos() * (1 - (-tau).exp()) / arb(eps)


def range_by_offset(alpha: Array, eps: float) -> Array:
    """The same range through ``lambertw0_offset``, which does not cancel.

    s c (1 + d/u)/q, where −d − ln(1 − d) = u − ln(1 + u): d = 1 + W₀(−1/e + (1 − e^{−σ})/e) with
    σ = u − ln(1 + u) = −log1pmx(u).
    """
    s, c = np.sin(alpha), np.cos(alpha)
    u = eps * s
    d = archerfish.lambertw0_offset(-np.expm1(archerfish.log1pmx(u)) / np.e)
    return np.asarray(s * c * (1 + d / u) / (1 + u))


def formulas(count: int) -> Table:
    """Worst relative error of each formula and of ours, by drag."""
    alpha = launch_angles(count)
    table: Table = {}

    def note(row: str, eps: float, got: Array, true: tuple[Array, Array, Array]) -> None:
        table.setdefault(row, {})[f"{eps:g}"] = worst(got, true)

    for eps in EPSILONS:
        drag = np.full_like(alpha, eps)
        theta = archerfish.apex_elevation(alpha, eps)

        true = oracle.values("apex_y", alpha, drag)
        note("y = (u − log1p(u))/ε²", eps, textbook.height(alpha, eps), true)
        note("apex_y", eps, archerfish.apex_y(alpha, eps), true)

        # (13) wants α(θ): it gets the exact one, rounded, which is more than its user has.
        launch = oracle.values("locus_launch_angle", theta, drag)
        true = oracle.values("locus_radius", theta, drag)
        note("r by (13), principal W", eps, textbook.principal_radius(theta, launch[0], eps), true)
        note("locus_radius", eps, archerfish.locus_radius(theta, eps), true)

        rounded = [exact(exact_range, float(angle), eps, bits=512) for angle in alpha]
        true = tuple(np.array(column) for column in zip(*rounded, strict=True))
        note("range, textbook W₀", eps, textbook.flight_range(alpha, eps), true)
        note("range, lambertw0_offset", eps, range_by_offset(alpha, eps), true)

        note("α(θ), np.interp on 10⁴", eps, textbook.launch_angle(theta, eps), launch)
        note("locus_launch_angle", eps, archerfish.locus_launch_angle(theta, eps), launch)

        # Difference quotients exist on their grid only.
        grid = textbook.grid()
        inside = np.flatnonzero((grid > MARGIN) & (grid < np.pi / 2 - MARGIN))
        inside = inside[:: max(1, inside.size // count)]
        true = oracle.values("apex_curvature", grid[inside], np.full(inside.size, eps))
        note("ρK, differences on 10⁴", eps, textbook.curvature(eps)[inside], true)
        note("apex_curvature", eps, archerfish.apex_curvature(grid[inside], eps), true)
    return table


def regions(count: int) -> dict[str, tuple[str, Array]]:
    """Where Lambert W is measured: a branch (``lambertw0`` or ``lambertwm1``) and arguments."""
    rng = np.random.default_rng(SEED)
    near = textbook.BRANCH_POINT + 10.0 ** rng.uniform(-16, -6, count)
    inner = textbook.BRANCH_POINT * rng.uniform(0, 1, count)
    sign = rng.choice([-1.0, 1.0], count)
    return {
        "W₀, 10^[−8, 300]": ("lambertw0", 10.0 ** rng.uniform(-8, 300, count)),
        "W₀, ±10^[−300, −8]": ("lambertw0", sign * 10.0 ** rng.uniform(-300, -8, count)),
        "W₀, (−1/e, 0)": ("lambertw0", inner),
        "W₀, next to −1/e": ("lambertw0", near),
        "W₋₁, (−1/e, 0)": ("lambertwm1", inner),
        "W₋₁, −10^[−300, −1]": ("lambertwm1", -(10.0 ** rng.uniform(-300, -1, count))),
        "W₋₁, next to −1/e": ("lambertwm1", near),
    }


CONTENDERS: dict[str, Callable[[str, Array], Array]] = {
    "SciPy": lambda name, z: lambertw(z, 0 if name == "lambertw0" else -1).real,
    "archerfish": lambda name, z: np.asarray(getattr(archerfish, name)(z)),
}


def lambert(count: int) -> Table:
    """Worst error of Lambert W in ulp, by contender and region."""
    table: Table = {contender: {} for contender in CONTENDERS}
    for region, (name, z) in regions(count).items():
        true = oracle.values(name, z)
        for contender, function in CONTENDERS.items():
            table[contender][region] = float(ulp_errors(function(name, z), *true).max())
    return table

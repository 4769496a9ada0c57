"""The series for the launch angle α in powers of T = 2 tan θ: equations (16) and (17).

    α(θ) = arctan T + Σ aₖ(ε) Tᵏ

The paper (H. Hernández-Saldaña, Eur. J. Phys. 2010) cuts equation (10) at first order in ε, which
is (16), T = tan α (1 + (ε/3) sin α), and reverts that: (17). Reverting (10) itself gives other
coefficients from T³ on. Both are here, exact: `paper_series` and `exact_series`. SymPy does the
algebra and is imported when a series is first asked for (extra `series`).

Neither converges beyond T = 1, θ = 26.6 degrees; `radius` tells how far each one does, and
`locus_launch_angle` is right everywhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from archerfish import _core
from archerfish.values import not_negative, without_unit

FloatArray = npt.NDArray[np.float64]
ComplexArray = npt.NDArray[np.complex128]
Of = Literal["paper", "exact"]

ORDER = 18
#: The reversion takes a few seconds here; the time grows with the fifth power of the order.
HIGHEST_ORDER = 40


@dataclass(frozen=True)
class LaunchAngleSeries:
    """One of the two series, cut after `order`: the coefficients aₖ(ε), exact.

    `coefficients[k][j]` is the rational number at εʲTᵏ. Those without ε belong to arctan T and are
    not among them.
    """

    of: Of
    order: int
    coefficients: tuple[tuple[Fraction, ...], ...]

    def coefficients_at(self, epsilon: float) -> list[Fraction]:
        """aₖ(ε) for k = 0 … order, exact, at one drag parameter (at least 0 and finite).

        >>> paper_series(4).coefficients_at(1.0)[2:]
        [Fraction(-1, 3), Fraction(2, 9), Fraction(17, 54)]
        """
        exact = Fraction(float(not_negative("epsilon", epsilon)))
        return [_evaluated(polynomial, exact) for polynomial in self.coefficients]

    def launch_angle(
        self, theta: npt.ArrayLike, epsilon: float, *, order: int | None = None
    ) -> FloatArray:
        """α (radians) at elevation `theta` (radians, 0 to below π/2), after `order` powers of T.

        An array of the shape of `theta`. Where the series diverges, so do the numbers.

        >>> float(exact_series().launch_angle(0.1, 0.1).round(12))
        0.196801614187
        """
        last = self.order if order is None else order
        if not 1 <= last <= self.order:
            raise ValueError(f"order must be from 1 to {self.order}, got {last}")
        doubled = 2 * np.tan(np.asarray(without_unit(theta, "theta"), dtype=np.float64))
        numbers = [float(number) for number in self.coefficients_at(epsilon)[: last + 1]]
        return np.asarray(np.arctan(doubled) + np.polynomial.polynomial.polyval(doubled, numbers))


def paper_series(order: int = ORDER) -> LaunchAngleSeries:
    """The paper's equation (17), to any order: the reversion of (16).

    >>> paper_series().coefficients[4]  # (27ε − 10ε³)/54
    (Fraction(0, 1), Fraction(1, 2), Fraction(0, 1), Fraction(-5, 27))
    """
    return _series("paper", order)


def exact_series(order: int = ORDER) -> LaunchAngleSeries:
    """The reversion of equation (10) itself.

    >>> exact_series().coefficients[3]  # 7ε²/18
    (Fraction(0, 1), Fraction(0, 1), Fraction(7, 18))
    """
    return _series("exact", order)


@cache
def _series(of: Of, order: int) -> LaunchAngleSeries:
    if not 1 <= order <= HIGHEST_ORDER:
        raise ValueError(f"order must be from 1 to {HIGHEST_ORDER}, got {order}")
    try:
        from sympy import QQ, ring  # type: ignore[import-untyped]
        from sympy.polys.ring_series import (  # type: ignore[import-untyped]
            rs_mul,
            rs_series_reversion,
            rs_sin,
            rs_tan,
        )
    except ImportError as error:
        raise ImportError("series need sympy: pip install 'archerfish[series]'") from error
    _, alpha, eps, doubled = ring("alpha, epsilon, T", QQ)
    end = order + 1
    sine, tangent = rs_sin(alpha, alpha, end), rs_tan(alpha, alpha, end)
    if of == "paper":
        factor = 1 + eps * sine / 3
    else:
        # 2(1 + u) φ(u) = 1 − 2 Σ (−u)ᵏ / ((k + 1)(k + 2)), u = ε sin α.
        factor, power = alpha.ring.one, alpha.ring.one
        for k in range(1, order):
            power = rs_mul(power, -eps * sine, alpha, end)
            factor -= power * QQ(2, (k + 1) * (k + 2))
    reverted = rs_series_reversion(rs_mul(tangent, factor, alpha, end), alpha, end, doubled)
    table: list[dict[int, Fraction]] = [{} for _ in range(end)]
    for (_, j, k), number in reverted.terms():
        if j > 0:
            table[k][j] = Fraction(int(number.numerator), int(number.denominator))
    rows = tuple(
        tuple(row.get(j, Fraction(0)) for j in range(max(row, default=-1) + 1)) for row in table
    )
    return LaunchAngleSeries(of, order, rows)


def _evaluated(polynomial: Sequence[Fraction], value: Fraction) -> Fraction:
    total = Fraction(0)
    for number in reversed(polynomial):
        total = total * value + number
    return total


def radius(of: Of, epsilon: float) -> float:
    """Radius of convergence of Σ aₖ(ε) Tᵏ: it converges for 2 tan θ below it, not above.

    `epsilon`: at least 0 and finite. Infinite at 0, where every aₖ is 0. The nearest singularities
    of α(T) are where dT/dα = 0 for a complex α: s³ − 2s = 3/ε (s = sin α) for the paper's series,
    a transcendental equation for the exact one. Those of the resummed arctan T lie at ±i, so that
    no radius exceeds 1.

    >>> round(radius("paper", 0.1), 4), round(radius("exact", 0.1), 4)
    (0.9263, 0.9344)
    """
    eps = float(not_negative("epsilon", epsilon))
    if eps == 0.0:
        return float("inf")
    with np.errstate(all="ignore"):
        sine = _paper_turns(eps) if of == "paper" else _exact_turns(eps)
        u = eps * sine
        factor = 1 + u / 3 if of == "paper" else 2 * (1 + u) * _phi(u)
        turn = np.abs(factor * sine / np.sqrt(1 - sine * sine))
    # At s = ±1 the tangent is infinite, whatever the equation for s says.
    genuine = np.isfinite(turn) & (np.abs(1 - sine * sine) > 1e-9)
    return float(np.min(turn[genuine], initial=1.0))


def _paper_turns(eps: float) -> ComplexArray:
    return np.asarray(np.roots([1.0, 0.0, -2.0, -3.0 / eps]), dtype=np.complex128)


def _exact_turns(eps: float) -> ComplexArray:
    """Complex s with 1 + (1 − s²) u G′(u)/G(u) = 0, u = εs: Newton's method from a grid."""

    def condition(s: ComplexArray) -> ComplexArray:
        u = eps * s
        slope = u / (1 + u) + 1 / ((1 + u) * _phi(u)) - 2
        return np.asarray(1 + (1 - s * s) * slope)

    # Where the nearest ones lie: (3/ε)^{1/3} from 0 for weak drag, 1/ε for strong.
    across, up = np.meshgrid(np.linspace(-3, 1, 41), np.linspace(0, 3, 31))
    s = min((3 / eps) ** (1 / 3), 1 / eps) * np.ravel(across + 1j * up)
    for _ in range(60):
        step = 1e-6 * np.abs(s)
        slope = (condition(s + step) - condition(s - step)) / (2 * step)
        s = s - condition(s) / slope
    return np.asarray(s[np.abs(condition(s)) < 1e-9])


def _phi(u: ComplexArray) -> ComplexArray:
    """φ(u) = (u − ln(1 + u))/u² for complex u; near 0 its power series Σ (−u)ᵏ/(k + 2)."""
    near = np.polynomial.polynomial.polyval(np.where(np.abs(u) < 0.1, -u, 0), 1 / np.arange(2, 22))
    return np.asarray(np.where(np.abs(u) < 0.1, near, (u - np.log(1 + u)) / (u * u)))


@dataclass(frozen=True)
class ConvergenceData:
    """Errors of both series on a grid: what the table and the figure of convergence show."""

    #: Drag parameters, shape (n,).
    epsilon: FloatArray
    #: Elevations θ in radians, shape (p,).
    elevation: FloatArray
    #: Where the series are cut, shape (m,).
    orders: tuple[int, ...]
    #: The true α(θ) in radians, shape (n, p).
    launch_angle: FloatArray
    #: Series minus truth in radians, by `of`: shape (n, m, p).
    error: dict[Of, FloatArray]
    #: Radius of convergence in T = 2 tan θ, by `of`: shape (n,).
    radius: dict[Of, FloatArray]

    def limit(self, of: Of) -> FloatArray:
        """Elevation (radians) up to which the series converges, shape (n,)."""
        return np.asarray(np.arctan(self.radius[of] / 2))


def convergence_data(
    epsilons: Sequence[float] = (0.1, 1.0, 3.0),
    *,
    elevation: npt.ArrayLike | None = None,
    orders: Sequence[int] = (6, 12, 18),
) -> ConvergenceData:
    """Both series against the true α(θ), at every drag parameter, elevation and order asked for.

    `elevation` in radians, from 0 to below π/2; unless given, every quarter of a degree to 45.

    >>> data = convergence_data([0.1], elevation=[0.2, 0.6])
    >>> bool(abs(data.error["exact"][0, -1, 0]) < 1e-6 < abs(data.error["exact"][0, -1, 1]))
    True
    """
    if elevation is None:
        elevation = np.radians(np.linspace(0, 45, 181))
    theta = np.asarray(elevation, dtype=np.float64)
    drags = [float(not_negative("epsilon", eps)) for eps in epsilons]
    truth = np.stack([np.asarray(_core.locus_launch_angle(theta, eps)) for eps in drags])
    error: dict[Of, Any] = {}
    reach: dict[Of, Any] = {}
    for series in (paper_series(max(orders)), exact_series(max(orders))):
        error[series.of] = np.array(
            [
                [series.launch_angle(theta, eps, order=order) - true for order in orders]
                for eps, true in zip(drags, truth, strict=True)
            ]
        )
        reach[series.of] = np.array([radius(series.of, eps) for eps in drags])
    return ConvergenceData(
        epsilon=np.array(drags),
        elevation=theta,
        orders=tuple(orders),
        launch_angle=truth,
        error=error,
        radius=reach,
    )

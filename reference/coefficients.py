"""Minimax polynomials of the kernels, as Rust tables.

    python reference/coefficients.py            # all of them
    python reference/coefficients.py exp_tail   # one

Each entry of FITS names a function, an interval, a degree and a weight; the polynomial with the
smallest greatest weighted error is found by Remez's exchange at 60 digits and printed with its
error after rounding the coefficients to double.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any, NamedTuple

import mpmath as mp

mp.mp.dps = 60


class Fit(NamedTuple):
    """What to approximate: function, interval, degree and the weight of the error."""

    function: Callable[[Any], Any]
    lower: Any
    upper: Any
    degree: int
    weight: Callable[[Any], Any]


def taylor_near_zero(function, coefficients, radius="1e-4"):
    """The function, by its Taylor coefficients where its closed form cancels."""

    def value(x):
        if abs(x) < mp.mpf(radius):
            return mp.fsum(coefficients(k) * x**k for k in range(16))
        return function(x)

    return value


def one(_):
    return mp.mpf(1)


def exp_tail(x):
    """(e^x − 1 − x − x²/2) / x³."""
    return taylor_near_zero(
        lambda t: (mp.expm1(t) - t - t * t / 2) / t**3, lambda k: 1 / mp.factorial(k + 3)
    )(x)


def atanh_tail(z):
    """((artanh(√z)/√z − 1) / z − 1/3) / z."""
    return taylor_near_zero(
        lambda t: ((mp.atanh(mp.sqrt(t)) / mp.sqrt(t) - 1) / t - mp.mpf(1) / 3) / t,
        lambda k: mp.mpf(1) / (2 * k + 5),
    )(z)


def sin_tail(z):
    """(sin(√z)/√z − 1) / z."""
    return taylor_near_zero(
        lambda t: (mp.sin(mp.sqrt(t)) / mp.sqrt(t) - 1) / t,
        lambda k: (-1) ** (k + 1) / mp.factorial(2 * k + 3),
    )(z)


def cos_tail(z):
    """(cos √z − 1 + z/2) / z²."""
    return taylor_near_zero(
        lambda t: (mp.cos(mp.sqrt(t)) - 1 + t / 2) / t**2,
        lambda k: (-1) ** k / mp.factorial(2 * k + 4),
    )(z)


def atan_tail(z):
    """(arctan(√z)/√z − 1) / z."""
    return taylor_near_zero(
        lambda t: (mp.atan(mp.sqrt(t)) / mp.sqrt(t) - 1) / t,
        lambda k: (-1) ** (k + 1) * mp.mpf(1) / (2 * k + 3),
    )(z)


HALF_LN2 = mp.log(2) / 2 * mp.mpf("1.0001")
ATANH_END = ((mp.sqrt(2) - 1) / (mp.sqrt(2) + 1)) ** 2 * mp.mpf("1.0001")
QUARTER_PI = (mp.pi / 4) ** 2 * mp.mpf("1.0001")
TAN_EIGHTH_PI = mp.tan(mp.pi / 8) ** 2 * mp.mpf("1.0001")

FITS = {
    "exp_tail": Fit(exp_tail, -HALF_LN2, HALF_LN2, 9, lambda x: abs(x) ** 3),
    "atanh_tail": Fit(atanh_tail, 0, ATANH_END, 6, lambda z: z),
    "sin_tail": Fit(sin_tail, 0, QUARTER_PI, 5, lambda z: z),
    "cos_tail": Fit(cos_tail, 0, QUARTER_PI, 5, lambda z: z * z),
    "atan_tail": Fit(atan_tail, 0, TAN_EIGHTH_PI, 11, lambda z: z),
}


def remez(fit, iterations=12):
    """Coefficients, lowest degree first, and the greatest weighted error."""
    lower, upper = mp.mpf(fit.lower), mp.mpf(fit.upper)
    unknowns = fit.degree + 2
    middle, half = (lower + upper) / 2, (upper - lower) / 2
    nodes = [
        middle - half * mp.cos(mp.pi * (k + mp.mpf(1) / 2) / unknowns) for k in range(unknowns)
    ]

    def weighted_error(coefficients, x):
        return fit.weight(x) * (fit.function(x) - mp.polyval(coefficients[::-1], x))

    for _ in range(iterations):
        rows = mp.matrix(unknowns, unknowns)
        right = mp.matrix(unknowns, 1)
        for i, x in enumerate(nodes):
            weight = fit.weight(x)
            for k in range(fit.degree + 1):
                rows[i, k] = weight * x**k
            rows[i, fit.degree + 1] = (-1) ** i
            right[i] = weight * fit.function(x)
        solution = mp.lu_solve(rows, right)
        coefficients = [solution[k] for k in range(fit.degree + 1)]
        # extrema between sign changes, on a fine grid that is dense at both ends
        grid = [
            middle - half * mp.cos(mp.pi * k / (24 * unknowns)) for k in range(24 * unknowns + 1)
        ]
        errors = [weighted_error(coefficients, x) for x in grid]
        extrema = []
        for x, error in zip(grid, errors, strict=True):
            if extrema and (error >= 0) == (extrema[-1][1] >= 0):
                if abs(error) > abs(extrema[-1][1]):
                    extrema[-1] = (x, error)
            else:
                extrema.append((x, error))
        if len(extrema) < unknowns:
            break
        while len(extrema) > unknowns:
            extrema.pop(0 if abs(extrema[0][1]) < abs(extrema[-1][1]) else -1)
        sizes = [abs(error) for _, error in extrema]
        nodes = [x for x, _ in extrema]
        if max(sizes) / min(sizes) < mp.mpf("1.01"):
            break
    rounded = [mp.mpf(float(c)) for c in coefficients]
    worst = max(abs(weighted_error(rounded, x)) for x in grid)
    return [float(c) for c in coefficients], worst


def main(names):
    for name in names or FITS:
        fit = FITS[name]
        coefficients, worst = remez(fit)
        interval = f"[{mp.nstr(mp.mpf(fit.lower), 6)}, {mp.nstr(mp.mpf(fit.upper), 6)}]"
        print(f"// {name}: minimax on {interval}, degree {fit.degree},")
        print(f"// weighted error {mp.nstr(worst, 3)}: reference/coefficients.py {name}")
        print(f"const {name.upper()}: [f64; {fit.degree + 1}] = [")
        for c in coefficients:
            print(f"    {c!r},")
        print("];")


if __name__ == "__main__":
    main(sys.argv[1:])

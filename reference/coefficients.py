"""Minimax polynomials of the kernels, as Rust tables.

    python reference/coefficients.py            # all of them
    python reference/coefficients.py exp_tail   # one

Each entry of FITS names a function, an interval, a degree and a weight; the polynomial with the
smallest greatest weighted error is found by Remez's exchange at 60 digits and printed with its
error after rounding the coefficients to double.

`log_table` is no fit: numbers next to the inverses of 1, 1 + 1/16, …, 1 + 15/16, and minus their
logarithms, which have 42 bits behind the point and so add exactly to multiples of ln 2's first
part; what they leave out is below 2⁻⁷⁰.

Each entry of STARTS names a rational function that starts an iteration. It needs few digits, so it
is found by Lawson's weighted least squares in double precision; another machine's linear algebra
may print other last digits of an equally good start.
"""

from __future__ import annotations

import itertools
import sys
from collections.abc import Callable
from typing import Any, NamedTuple

import mpmath as mp
import numpy as np
from scipy.optimize import minimize

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


def residual_tail(r):
    """E (e^(−r) − 1 + r) / r², E being the double nearest e."""
    return mp.mpf(float(mp.e)) * taylor_near_zero(
        lambda t: (mp.expm1(-t) + t) / t**2, lambda k: (-1) ** k / mp.factorial(k + 2)
    )(r)


def atanh_tail(z):
    """((artanh(√z)/√z − 1) / z − 1/3) / z."""
    return taylor_near_zero(
        lambda t: ((mp.atanh(mp.sqrt(t)) / mp.sqrt(t) - 1) / t - mp.mpf(1) / 3) / t,
        lambda k: mp.mpf(1) / (2 * k + 5),
    )(z)


def log_tail(f):
    """2 (ln(1 + f) − f + f²/2) / f³."""
    return taylor_near_zero(
        lambda t: 2 * (mp.log1p(t) - t + t * t / 2) / t**3,
        lambda k: 2 * mp.mpf(-1) ** k / (k + 3),
    )(f)


def weak_gain(u):
    """(1/3 − (2G(u) − 1)/u) / u."""
    return taylor_near_zero(
        lambda t: (mp.mpf(1) / 3 - ((1 + t) ** 2 - 1 - 2 * (1 + t) * mp.log1p(t)) / t**3) / t,
        lambda k: 2 * mp.mpf(-1) ** k / ((k + 3) * (k + 4)),
    )(u)


def sin_tail(z):
    """(sin(√z)/√z − 1) / z."""
    return taylor_near_zero(
        lambda t: (mp.sin(mp.sqrt(t)) / mp.sqrt(t) - 1) / t,
        lambda k: (-1) ** (k + 1) / mp.factorial(2 * k + 3),
    )(z)


def sinc(z):
    """sin(√z)/√z."""
    return 1 + z * sin_tail(z)


def long_sin_tail(z):
    """(sin(√z)/√z − 1 + c z) / z², c being the double nearest 1/6."""
    rest = mp.mpf(1 / 6) - mp.mpf(1) / 6
    exact = taylor_near_zero(
        lambda t: (mp.sin(mp.sqrt(t)) / mp.sqrt(t) - 1 + t / 6) / t**2,
        lambda k: (-1) ** k / mp.factorial(2 * k + 5),
    )(z)
    return exact + (rest / z if z else 0)


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


def half_tan(z):
    """tan(β/2)/tan β as a function of tan²β."""
    return 1 / (1 + mp.sqrt(1 + z))


def twice_atan_tail(z):
    """2 (arctan(√z)/√z − 1) / z."""
    return 2 * atan_tail(z)


def branch_tail(branch):
    """(v − p + p²/3) / p³ with v = 1 + W and p = ±√(2(1 + ez)), + on the principal branch."""
    taylor = ["11/72", "-43/540", "769/17280", "-221/8505", "680863/43545600", "-1963/204120"]

    def value(p):
        if abs(p) < mp.mpf("1e-9"):
            return mp.fsum(mp.fdiv(*map(int, c.split("/"))) * p**k for k, c in enumerate(taylor))
        with mp.workdps(120):
            v = 1 + mp.lambertw((p * p / 2 - 1) / mp.e, branch).real
            return (v - p + p * p / 3) / p**3

    return value


def rough_log(f):
    """ln(1 + f) / f."""
    return taylor_near_zero(lambda t: mp.log1p(t) / t, lambda k: mp.mpf(-1) ** k / (k + 1))(f)


def rough_atan(z):
    """arctan(√z)/√z."""
    return 1 + z * atan_tail(z)


def fall_tail(w):
    """((w − 1 + e^−w)/w² − 1/2 + w/6)/w²."""
    return taylor_near_zero(
        lambda t: ((t + mp.expm1(-t)) / t**2 - mp.mpf(1) / 2 + t / 6) / t**2,
        lambda k: (-1) ** k / mp.factorial(k + 4),
    )(w)


def aim_exp_tail(r):
    """(e^r − 1 − r − r²/2) / r³."""
    return taylor_near_zero(
        lambda t: (mp.expm1(t) - t - t**2 / 2) / t**3, lambda k: 1 / mp.factorial(k + 3)
    )(r)


HALF_LN2 = mp.log(2) / 2 * mp.mpf("1.0001")
ATANH_END = ((mp.sqrt(2) - 1) / (mp.sqrt(2) + 1)) ** 2 * mp.mpf("1.0001")
QUARTER_PI = (mp.pi / 4) ** 2 * mp.mpf("1.0001")
HALF_PI = (mp.pi / 2) ** 2 * mp.mpf("1.0001")
TAN_EIGHTH_PI = mp.tan(mp.pi / 8) ** 2 * mp.mpf("1.0001")

FITS = {
    "exp_tail": Fit(exp_tail, -HALF_LN2, HALF_LN2, 9, lambda x: abs(x) ** 3),
    "residual_tail": Fit(residual_tail, -HALF_LN2, HALF_LN2, 10, abs),
    "atanh_tail": Fit(atanh_tail, 0, ATANH_END, 6, lambda z: z),
    "log_tail": Fit(log_tail, mp.mpf("-0.0298"), mp.mpf("0.03126"), 7, abs),
    "weak_gain": Fit(weak_gain, 0, mp.mpf("0.0626"), 7, lambda u: u),
    "sin_tail": Fit(sin_tail, 0, QUARTER_PI, 5, lambda z: z),
    "long_sin_tail": Fit(long_sin_tail, mp.mpf("0.1"), HALF_PI, 6, lambda z: z * z),
    "rough_sinc": Fit(sinc, 0, mp.mpf("2.4675"), 3, one),
    "cos_tail": Fit(cos_tail, 0, QUARTER_PI, 5, lambda z: z * z),
    "rough_log": Fit(rough_log, mp.mpf("-0.2930"), mp.mpf("0.4143"), 4, one),
    "aim_exp_tail": Fit(aim_exp_tail, -HALF_LN2, HALF_LN2, 5, lambda r: abs(r) ** 3),
    "aim_log": Fit(rough_log, mp.mpf("-0.2930"), mp.mpf("0.4143"), 3, one),
    "fall_tail": Fit(fall_tail, 0, mp.mpf("0.7001"), 9, lambda w: w * w),
    "rough_atan": Fit(rough_atan, 0, mp.mpf("0.1251"), 4, one),
    "principal_tail": Fit(branch_tail(0), 0, mp.mpf("0.501"), 13, lambda p: p * p),
    "lower_tail": Fit(branch_tail(-1), mp.mpf("-0.501"), 0, 15, lambda p: p * p),
    "half_tan": Fit(half_tan, 0, mp.mpf("0.126"), 3, one),
    "half_atan_tail": Fit(twice_atan_tail, 0, mp.mpf("0.0298"), 6, lambda z: z),
    "small_atan_tail": Fit(atan_tail, 0, mp.mpf("0.1251"), 9, lambda z: z),
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


class Start(NamedTuple):
    """Samples of a variable y, the function there, and the relative error that can be borne.

    The fit is done in y/(1 + y), or 1/(1 + y), which makes a long interval short; the coefficients
    are of powers of y, or where `compressed` of 1/(1 + y). A function of `growth` 1 grows like y,
    and its numerator is to be one degree above its denominator; one of growth −1 falls so. The
    first coefficient of the denominator is 1, or where `monic` the last, which saves a product;
    `at_zero` is a value at y = 0 that is to be met to the last digit.
    """

    variable: Any
    function: Any
    bearable: Any
    numerator_degree: int
    denominator_degree: int
    iterations: int = 800
    compressed: bool = False
    growth: int = 0
    monic: bool = False
    at_zero: float | None = None


def bearable_error(v):
    """Relative error of w = v − 1 whose fourth power one step (lambert/step.rs) brings to 2⁻⁵³."""
    i, w = 1 / v, v - 1
    a, b, c = (1 + w / 2) * i, (1 / 2 + w / 6) * i, (1 / 6 + w / 24) * i
    return (2.0**-53 * abs(w) / abs(5 * a**3 - 5 * a * b + c)) ** 0.25 / abs(w)


def principal_start():
    """W₀(z)/ln(1+z) − 1 as a function of y = √(ln(1+z) − ln(1 − 1/e))."""
    end = -mp.log(1 - 1 / mp.e)
    y = [np.geomspace(1e-7, 0.1, 800), np.linspace(0.1, 3, 2500), np.linspace(3, 26.651, 2500)]
    y = [mp.mpf(x) for x in np.concatenate(y) if abs(x * x - end) > 1e-2]
    logarithm = [x * x - end for x in y]
    w = [mp.lambertw(mp.expm1(x)).real for x in logarithm]
    excess = np.array([float(a / b - 1) for a, b in zip(w, logarithm, strict=True)])
    # the error of w is that of the excess, so many times as small
    bearable = bearable_error(np.array([float(1 + x) for x in w])) * (1 + excess) / abs(excess)
    at_zero = float(1 / end - 1)
    y = np.array(y, dtype=float)
    return Start(y, excess, bearable, 6, 6, 1500, growth=-1, monic=True, at_zero=at_zero)


def lower_start():
    """(1 + W₋₁(z))/η as a function of η = √(−1 − ln(−z))."""
    v = np.concatenate([np.geomspace(1e-7, 0.2, 800), np.linspace(0.2, 3, 1500)])
    v = np.concatenate([v, np.geomspace(3, 751, 1500)])
    eta = np.array([float(mp.sqrt(x - mp.log1p(x))) for x in map(mp.mpf, v)])
    # the error of v is that of W
    bearable = bearable_error(-v) * (1 + v) / v
    return Start(eta, -v / eta, bearable, 4, 3, iterations=2500, growth=1, monic=True)


def gain(u):
    """G(u) = (1 + u)(u − ln(1 + u))/u²."""
    with np.errstate(invalid="ignore", divide="ignore"):
        direct = (1 + u) * (u - np.log1p(u)) / u**2
    return np.where(u < 1e-3, 1 / 2 + u / 6 - u**2 / 12 + u**3 / 20, direct)


DRAGS = np.concatenate([[0], np.geomspace(3e-4, 1e15, 6000)])


def rough_gain():
    """G as a function of 1/√(1 + u), in which it is smoother than in 1/(1 + u), to 2⁻¹⁸."""
    root = np.sqrt(1 + DRAGS) - 1
    return Start(root, gain(DRAGS), 2.0**-18 / gain(DRAGS), 4, 4, compressed=True)


def rougher_gain():
    """G as a function of 1/(1 + u), for the guess before."""
    return Start(DRAGS, gain(DRAGS), 2.0**-9 / gain(DRAGS), 2, 2, compressed=True)


def stretch_root():
    """The square root on [1/4, 1], to 2⁻¹⁵."""
    stretch = np.linspace(0.25, 1, 4000)
    return Start(stretch, np.sqrt(stretch), np.full_like(stretch, 2.0**-15), 2, 2)


def half_time_start():
    """h/u as a function of u, where h is half the time of flight times b: u = h + h coth h − 1.

    With a relative error s, a step of third order leaves B s³, B depending on three derivatives.
    """
    time = np.concatenate(
        [np.geomspace(1e-6, 1, 800), np.linspace(1, 60, 2500), np.geomspace(60, 1e6, 300)]
    )
    half = [mp.mpf(x) / 2 for x in time]
    u = np.array([float(h + h * mp.coth(h) - 1) for h in half])
    bearable = [half_time_start_error(h) for h in half]
    return Start(u, time / 2 / u, np.array(bearable), 3, 4, iterations=6000)


def half_time_start_error(h):
    """The relative error of h that a step of third order brings below 2⁻⁵⁷."""
    coth, loss = mp.coth(h), mp.csch(h) ** 2
    first, second = 1 + coth - h * loss, 2 * loss * (h * coth - 1)
    third = 2 * loss * (3 * coth + h - 3 * h * coth**2)
    curvature = (2 * (second / (2 * first)) ** 2 - third / (6 * first)) * h**2
    return min(2.0**-9, float((mp.mpf(2) ** -57 / abs(curvature)) ** (mp.mpf(1) / 3)))


def aim_way():
    """(1 + q)(1 − e⁻ʷ)/q as a function of q = √(2(w − 1 + e⁻ʷ)); w is to be good to 2⁻¹²."""
    w = np.concatenate([np.geomspace(1e-6, 1, 800), np.linspace(1, 500, 2500)])
    w = np.concatenate([w, np.geomspace(500, 1e14, 500)])
    gone = -np.expm1(-w)
    near = w * w * (1 / 2 - w * (1 / 6 - w * (1 / 24 - w / 120)))
    q = np.sqrt(2 * np.where(w < 1e-2, near, w - gone))
    return Start(q, (1 + q) * gone / q, 2.0**-12 * w / gone, 3, 3, iterations=1500)


STARTS = {
    "aim_way": aim_way,
    "half_time_start": half_time_start,
    "principal_start": principal_start,
    "lower_start": lower_start,
    "rough_gain": rough_gain,
    "rougher_gain": rougher_gain,
    "stretch_root": stretch_root,
}


def lawson(start):
    """Numerator and denominator in the variable, lowest degree first, and the greatest error."""
    y, m, n = start.variable, start.numerator_degree, start.denominator_degree
    x = 1 / (1 + y) if start.compressed else y / (1 + y)
    function = start.function / (1.0 + y) ** start.growth
    low, high = x.min(), x.max()
    basis = np.polynomial.chebyshev.chebvander(2 * (x - low) / (high - low) - 1, max(m, n))
    weight = 1 / start.bearable / abs(function)
    lawson_weight, bottom, best = np.ones_like(x), np.ones_like(x), (np.inf, None)
    for _ in range(start.iterations):
        rows = np.hstack([basis[:, : m + 1], -function[:, None] * basis[:, 1 : n + 1]])
        scale = np.sqrt(lawson_weight) * weight / abs(bottom)
        solution, *_ = np.linalg.lstsq(rows * scale[:, None], function * scale, rcond=None)
        bottom = 1 + basis[:, 1 : n + 1] @ solution[m + 1 :]
        errors = abs(basis[:, : m + 1] @ solution[: m + 1] / bottom - function) * weight
        if errors.max() < best[0]:
            best = (errors.max(), solution)
        lawson_weight *= errors / errors.mean() + 1e-3
        lawson_weight /= lawson_weight.mean()

    def in_variable(chebyshev):
        """A Chebyshev series in the scaled variable as a polynomial."""
        scaled = np.polynomial.Polynomial([(-2 * low) / (high - low) - 1, 2 / (high - low)])
        in_x = np.polynomial.Polynomial(np.polynomial.chebyshev.cheb2poly(chebyshev))(scaled).coef
        if start.compressed:
            return in_x
        y, degree = np.polynomial.Polynomial([0, 1]), max(m, n)
        return sum(c * y**k * (y + 1) ** (degree - k) for k, c in enumerate(in_x)).coef

    top, bottom = in_variable(best[1][: m + 1]), in_variable(np.append(1, best[1][m + 1 :]))
    # the fit is of a denominator with one factor 1 + y more, or less
    if start.growth > 0:
        bottom = np.polynomial.polynomial.polydiv(bottom, [1, 1])[0]
    if start.growth < 0:
        bottom = np.polynomial.polynomial.polymul(bottom, [1, 1])
    scale = bottom[-1] if start.monic else bottom[0]
    top, bottom = ([float(f"{c:.10g}") for c in part / scale] for part in (top, bottom))
    if start.at_zero is not None:
        top[0] = bottom[0] * start.at_zero
    return top, bottom, best[0]


def rough_root():
    """The a, b, c that make `rougher_gain` at v (1 + c v)/(1 + c v − (a + b v) cos²θ) a guess of g.

    g solves `g = G(v/√(sin²θ + g² cos²θ))`, where v = ε sin θ.
    """
    top, bottom, _ = lawson(rougher_gain())
    v, cos2 = np.meshgrid(np.append(1e-6, np.geomspace(1e-3, 1e8, 260)), np.linspace(0, 1, 41))
    g = np.full_like(v, 0.7)
    for _ in range(200):
        g = gain(v / np.sqrt(1 - (1 - g * g) * cos2))

    def worst_error(coefficients):
        a, b, c = coefficients
        root = 1 + c * v - (a + b * v) * cos2
        x = root / (root + v * (1 + c * v))
        rough = np.polynomial.Polynomial(top)(x) / np.polynomial.Polynomial(bottom)(x)
        return abs(rough - g).max()

    found = minimize(
        worst_error, [0.46, 0.014, 0.33], method="Nelder-Mead", options={"xatol": 1e-9}
    )
    return [float(f"{c:.10g}") for c in found.x], worst_error(found.x)


SEARCHES = {
    "rough_root": ("least greatest error", rough_root),
}


def accurate_inverse(i, bits=40, grid=42, precision=70):
    """The number of so many bits nearest 1/(1 + i/16) whose logarithm is almost one of 2^−grid.

    The idea is S. Gal's: a table of such needs no second column for what rounding leaves.
    """
    step, length = mp.mpf(2) ** -bits, 2**16
    nearest, j = mp.nint(1 / (1 + mp.mpf(i) / 16) / step) * step, np.arange(2.0**16)
    for block in itertools.count():
        # up and down from the inverse in turns
        first = nearest + (block + 1) // 2 * (1 if block % 2 else -1) * length * step
        # −ln(first + j step) in units of 2^−grid, by Taylor, without whole numbers
        place, slope = -mp.log(first) * 2**grid, -step / first * 2**grid
        bend = float(step**2 / (2 * first**2) * 2**grid)
        phase = float(place % 1) + (float(slope % 1) * j) % 1 + bend * j * j
        best = int(np.argmin(abs(phase - np.rint(phase))))
        r = first + best * step
        logarithm = mp.nint(-mp.log(r) * 2**grid) / 2**grid
        if abs(mp.log(r) + logarithm) < mp.mpf(2) ** -precision:
            return float(r), float(logarithm)
    raise AssertionError


def log_table():
    """Numbers next to inverses, and their logarithms with the sign changed."""
    pairs = [(1.0, 0.0)] + [accurate_inverse(i) for i in range(1, 16)]
    return {"inverses": [r for r, _ in pairs], "logarithms": [x for _, x in pairs]}


#: What is computed in single precision.
SINGLE = {"rough_gain", "rougher_gain", "stretch_root", "rough_sinc", "rough_root"}


def print_table(name, coefficients, single=False):
    kind = "f32" if single else "f64"
    print(f"const {name.upper()}: [{kind}; {len(coefficients)}] = [")
    for c in coefficients:
        print(f"    {np.float32(c) if single else c},")
    print("];")


def main(names):
    for name in names or ["log_table", *FITS, *STARTS, *SEARCHES]:
        if name == "log_table":
            print("// log_table: reference/coefficients.py log_table")
            for part, numbers in log_table().items():
                print_table(part, numbers)
            continue
        if name in SEARCHES:
            how, search = SEARCHES[name]
            coefficients, worst = search()
            print(f"// {name}: {how}, error {worst:.2g}: reference/coefficients.py {name}")
            print_table(name, coefficients, name in SINGLE)
            continue
        if name in STARTS:
            top, bottom, worst = lawson(STARTS[name]())
            print(
                f"// {name}: {worst:.2f} of the error that can be borne:"
                f" reference/coefficients.py {name}"
            )
            print_table(f"{name}_top", top, name in SINGLE)
            print_table(f"{name}_bottom", bottom, name in SINGLE)
            continue
        fit = FITS[name]
        coefficients, worst = remez(fit)
        interval = f"[{mp.nstr(mp.mpf(fit.lower), 6)}, {mp.nstr(mp.mpf(fit.upper), 6)}]"
        print(f"// {name}: minimax on {interval}, degree {fit.degree},")
        print(f"// weighted error {mp.nstr(worst, 3)}: reference/coefficients.py {name}")
        print_table(name, coefficients, name in SINGLE)


if __name__ == "__main__":
    main(sys.argv[1:])

"""What is read off a locus (x, y) given in power series of a small change of α: plane geometry."""

from typing import NamedTuple

from flint import arb, arb_series

#: Series in the change of α keep this many terms: the value and three derivatives.
TERMS = 4


class Locus(NamedTuple):
    """The apex of the shot `alpha`, and how it moves when the shot changes."""

    alpha: arb
    time: arb_series
    x: arb_series
    y: arb_series


def derivative(series: arb_series, order: int = 1) -> arb_series:
    for _ in range(order):
        series = series.derivative()
    return series


def distance(locus: Locus) -> arb:
    return (locus.x[0] ** 2 + locus.y[0] ** 2).sqrt()


def elevation(locus: Locus) -> arb:
    """The polar angle; of the apex at the launch point itself, α = 0, the limit."""
    if locus.x[0] == 0 and locus.y[0] == 0:
        return arb(0)
    return arb.atan2(locus.y[0], locus.x[0])


def curvature(locus: Locus) -> arb:
    """(x′y″ - y′x″) / (x′² + y′²)^(3/2), of a plane curve."""
    (x1, y1), (x2, y2) = ((derivative(locus.x, k)[0], derivative(locus.y, k)[0]) for k in (1, 2))
    return (x1 * y2 - y1 * x2) / (x1**2 + y1**2) ** arb(1.5)


def away_from_origin(locus: Locus) -> tuple[arb_series, arb_series]:
    """x and y as series, divided by the change of α where the apex is the launch point itself."""
    if locus.x[0] == 0 and locus.y[0] == 0:
        return tuple(arb_series(s.coeffs()[1:], prec=TERMS - 1) for s in (locus.x, locus.y))
    return locus.x, locus.y


def elevation_slope(locus: Locus) -> arb_series:
    """dθ/dα as a series: (x y′ - y x′) / (x² + y²); a common factor of x and y drops out."""
    x, y = away_from_origin(locus)
    return (x * derivative(y) - y * derivative(x)) / (x * x + y * y)


def launch_angle_d1(locus: Locus) -> arb:
    """dα/dθ, by the inverse function theorem."""
    return 1 / elevation_slope(locus)[0]


def launch_angle_d2(locus: Locus) -> arb:
    """d²α/dθ² = -θ″/θ′³."""
    slope = elevation_slope(locus)
    return -derivative(slope)[0] / slope[0] ** 3

"""Integrals over launch angles, to the last few digits at every drag."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from archerfish.values import without_unit

FloatArray = npt.NDArray[np.float64]

_NODES = 16
#: Panels at ε = 0: there the nearest singularity of the arc length lies 0.27 beside 45 degrees.
_LEAST_PANELS = 4
#: Panels for every factor e in 1 + ε.
_PANELS_PER_E_FOLD = 1


def integral(
    integrand: Callable[[FloatArray, FloatArray], FloatArray],
    start: npt.ArrayLike,
    stop: npt.ArrayLike,
    epsilon: npt.ArrayLike,
) -> FloatArray:
    """∫ integrand(α, ε) dα from `start` to `stop`, angles in radians within [0, π].

    `start`, `stop` and `epsilon` broadcast; the integrand is called with arrays that have one more
    axis, the last, for the nodes.

    With drag the integrands change on the scale 1/ε near the ground and 1/√ε at the bend, however
    large ε is. Panels that grow geometrically from 1/ε up keep every feature a few panels wide;
    on each of them Gauss-Legendre quadrature converges to full precision.
    """
    first, last, eps = np.broadcast_arrays(
        *(np.asarray(without_unit(value), np.float64) for value in (start, stop, epsilon))
    )
    low, high = np.minimum(first, last), np.maximum(first, last)
    edges = _graded_edges(eps)
    if np.any(high > np.pi / 2):
        edges += [np.pi - edge for edge in reversed(edges[:-1])]
    # The outermost edges are the caller's own, so that an angle outside [0, π] reaches the
    # integrand, whose NaN is the answer.
    edges = [low, *(np.clip(edge, low, high) for edge in edges[1:-1]), high]

    total = over_panels(lambda alpha: integrand(alpha, eps[..., np.newaxis]), edges)
    return np.where(first <= last, total, -total)


def over_panels(
    integrand: Callable[[FloatArray], FloatArray], edges: list[FloatArray]
) -> FloatArray:
    """The integral from the first edge to the last, by Gauss-Legendre quadrature on each panel.

    Edges are arrays of one shape; the integrand is called with arrays that have one more axis, the
    last, for the nodes.
    """
    nodes, weights = gauss_legendre()
    total = np.zeros(np.shape(edges[0]))
    for left, right in pairwise(edges):
        if np.array_equal(left, right):
            continue
        half = 0.5 * (right - left)
        variable = (0.5 * (right + left))[..., np.newaxis] + half[..., np.newaxis] * nodes
        total += half * weighted_sum(integrand(variable), weights)
    return total


def weighted_sum(values: FloatArray, weights: FloatArray) -> FloatArray:
    """Σ `values` × `weights` over the last axis.

    A product of matrices adds up in an order that depends on the number of rows: the last digit of
    a row would depend on its neighbours.
    """
    return np.asarray(np.ascontiguousarray(values * weights).sum(axis=-1))


def _graded_edges(eps: FloatArray) -> list[FloatArray]:
    """Edges (π/2)(q^{j/J} − 1)/ε with q = 1 + ε, from 0 to π/2; at weak drag equal steps."""
    # Each ε has as many as it wants, whatever its neighbours want: the others are empty, at π/2.
    panels = _LEAST_PANELS + _PANELS_PER_E_FOLD * np.ceil(np.log1p(eps))
    # So little drag moves no edge that matters, and the quotient below keeps its digits.
    eps = np.maximum(eps, 1e-6)
    log_q = np.log1p(eps)
    return [
        np.where(j < panels, np.expm1(j / panels * log_q) / eps, 1.0) * (np.pi / 2)
        for j in range(int(np.max(panels, initial=_LEAST_PANELS)) + 1)
    ]


@cache
def gauss_legendre() -> tuple[FloatArray, FloatArray]:
    """The 16 nodes, between −1 and 1, and their weights."""
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    return nodes, weights

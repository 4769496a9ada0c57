"""Nanoseconds an element, ours and theirs in turns, and in units of one logarithm."""

from __future__ import annotations

import time

import numpy as np

from bench import peers
from bench.contenders import contenders, unit

UNIT = "np.log"

#: What a kernel may take with AVX-512, in logarithms; twice that with AVX2.
BARS = {
    "lambertw0": 4.0,
    "lambertwm1": 4.0,
    "log1pmx": 1.5,
    "apex_x": 2.5,
    "apex_y": 2.5,
    "apex_elevation": 4.0,
    "apex_curvature": 4.0,
    "locus_launch_angle": 10.0,
    "locus_radius": 10.0,
    "locus_curvature": 12.0,
    "locus_launch_angle_d1": 12.0,
    "locus_launch_angle_d2": 12.0,
    "flight_time": 8.0,
    "flight_range": 8.0,
    "aim_low": 20.0,
    "aim_high": 20.0,
}

Rows = dict[str, dict[str, float]]
Libraries = dict[str, dict[str, peers.Function]]


def times(count: int, rounds: int, libraries: Libraries | None = None) -> Rows:
    """Median nanoseconds of this thread's processor time an element, their spread, in logarithms.

    The rows are named `kernel: who`. Contenders take turns, so that all see the same machine,
    whatever else it does meanwhile; each is called twice and timed the second time, its arrays at
    hand. The spread is half the distance between the quartiles.
    """
    calls = {UNIT: (unit(count), count)} | {
        f"{one.kernel}: {one.name}": (one.call, one.expected.size)
        for one in contenders(count, libraries)
    }
    seen: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(rounds):
        for name, (call, elements) in calls.items():
            call()
            start = time.thread_time_ns()
            call()
            seen[name].append((time.thread_time_ns() - start) / elements)
    logarithm = np.median(seen[UNIT])
    return {name: row(np.array(taken), float(logarithm)) for name, taken in seen.items()}


def row(taken: np.ndarray, logarithm: float) -> dict[str, float]:
    low, middle, high = np.quantile(taken, [0.25, 0.5, 0.75])
    return {
        "nanoseconds": float(middle),
        "spread": float((high - low) / 2),
        "logarithms": float(middle / logarithm),
    }


def kernel_and_name(row_name: str) -> tuple[str, str]:
    """The two halves of a row's name."""
    kernel, _, name = row_name.partition(": ")
    return kernel, name

"""How cost grows with length: ns an element from 1 to 10⁸, calls, threads, memory, starts."""

from __future__ import annotations

import resource
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

import archerfish

#: One kernel of each family, and what calls of NumPy's own cost.
FAMILIES = ("log1pmx", "lambertw0", "apex_y", "locus_launch_angle", "flight_range", "arctan2")
#: Those whose calls on one element are counted too: the longest kernels, and one of three numbers.
LONGEST_KERNELS = ("locus_radius", "locus_curvature", "trajectory_height", "aim_low")
LENGTHS = tuple(10**k for k in range(9))
#: Each length is timed at least so long, in at least so many pieces.
SECONDS, PIECES = 0.05, 5

Call = Callable[[], object]


def ufunc(name: str) -> np.ufunc:
    return getattr(archerfish, name, None) or getattr(np, name)


def arguments(function: np.ufunc, count: int) -> list[np.ndarray]:
    """Numbers in the domain of every family, and room for the results."""
    rng = np.random.default_rng(2010)
    high = 1.5 if function.nin < 3 else 0.3  # targets within reach
    return [rng.uniform(0.01, high, count) for _ in range(function.nin)] + [np.empty(count)]


def call_of(name: str, count: int) -> Call:
    function = ufunc(name)
    *x, out = arguments(function, count)
    return lambda: function(*x, out=out)


def seconds(call: Call) -> float:
    """The best of some pieces: what the call costs when nothing interrupts it."""
    start = time.perf_counter()
    call()
    repeats = max(1, int(SECONDS / PIECES / max(time.perf_counter() - start, 1e-9)))
    pieces = []
    for _ in range(PIECES):
        start = time.thread_time_ns()
        for _ in range(repeats):
            call()
        pieces.append((time.thread_time_ns() - start) / repeats)
    return min(pieces) * 1e-9


def by_length(longest: int) -> dict[str, dict[str, float]]:
    """Nanoseconds an element by kernel and length."""
    return {
        name: {
            str(count): 1e9 * seconds(call_of(name, count)) / count
            for count in LENGTHS
            if count <= longest
        }
        for name in FAMILIES
    }


def calls(
    rounds: int = 40, names: tuple[str, ...] = (*FAMILIES, *LONGEST_KERNELS)
) -> dict[str, float]:
    """What a call on one element takes, in units of np.arctan2's; best of turns."""
    table = {name: call_of(name, 1) for name in names}
    taken: dict[str, list[int]] = {name: [] for name in table}
    for _ in range(rounds):
        for name, call in table.items():
            start = time.thread_time_ns()
            for _ in range(500):
                call()
            taken[name].append(time.thread_time_ns() - start)
    return {name: min(times) / min(taken["arctan2"]) for name, times in taken.items()}


def two_threads(count: int = 2_000_000) -> dict[str, float]:
    """How many times as fast a pool of two threads is, on arrays of its own.

    np.sin beside ours says what the machine had to give.
    """
    found = {}
    for name in (*FAMILIES[:-1], "sin"):
        work = [call_of(name, count) for _ in range(4)]
        with ThreadPoolExecutor(1) as one, ThreadPoolExecutor(2) as two:
            turns = [(wall(one, work), wall(two, work)) for _ in range(9)]
        alone, together = (min(taken) for taken in zip(*turns, strict=True))
        found[name] = alone / together
    return found


def wall(pool: ThreadPoolExecutor, calls: list[Call]) -> float:
    start = time.perf_counter()
    list(pool.map(lambda call: call(), calls))
    return time.perf_counter() - start


MEMORY = """
import resource, sys
import numpy as np, archerfish
peak = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
count = 10_000_000
alpha, out = np.full(count, 0.5), np.zeros(count)
before = peak()
archerfish.apex_y(alpha, 0.1, out=out)
print((peak() - before) / out.nbytes)
"""


def extra_memory() -> float:
    """Peak memory of a call beyond its arguments and results, over the size of the results."""
    return float(output(sys.executable, "-c", MEMORY))


def output(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def starts(rounds: int = 20) -> dict[str, float]:
    """Processor time of whole processes in units of `import numpy`'s, best of turns."""
    python = sys.executable
    program = str(Path(python).with_name("archerfish"))
    commands = {
        "import numpy": (python, "-c", "import numpy"),
        "import archerfish": (python, "-c", "import archerfish"),
        "archerfish locus": (program, "locus", "--speed", "10", "--epsilon", "0.1"),
    }
    taken: dict[str, list[float]] = {name: [] for name in commands}
    for _ in range(rounds):
        for name, command in commands.items():
            before = children_seconds()
            output(*command)
            taken[name].append(children_seconds() - before)
    unit = min(taken["import numpy"])
    return {name: min(times) / unit for name, times in taken.items()}


def children_seconds() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def measured(longest: int) -> dict[str, dict[str, float]]:
    """Everything, as tables of numbers."""
    return {f"scaling of {name}": row for name, row in by_length(longest).items()} | {
        "calls": calls(),
        "threads": two_threads(),
        "memory": {"apex_y": extra_memory()},
        "starts": starts(),
    }

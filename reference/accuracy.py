"""The worst error of every public function, in ulp, and the record of it that only tightens.

    python -m reference.accuracy                    the recorded inputs, against the record
    python -m reference.accuracy --record           the same, and write the record
    python -m reference.accuracy --fresh            new inputs, against what is demanded
    python -m reference.accuracy --fresh --record   the same, and keep the worse ones

Against the record a function fails when it is worse, and also when it is clearly better, until the
record is tightened. Every run evaluates the adversarial corners and the recorded worst inputs
beside the random ones.
"""

import argparse
import json
import os
import secrets
import sys
import time
import tomllib
import zlib
from collections.abc import Iterable
from multiprocessing import Pool
from pathlib import Path
from typing import NamedTuple

import numpy as np

from reference import inputs, kernels, oracle
from reference.ball import Rounded, ulp_errors

RECORD = Path(__file__).with_name("accuracy.toml")
SEED = 2010
INPUTS = 100_000
CHUNK = 2_000
#: In each chunk, so many of the worst inputs are followed to so many neighbours.
WORST_FOLLOWED, NEIGHBOURS = 8, 16
#: Recorded errors are rounded to 1e-4 ulp; anything beyond that is a change.
WORSE = 2e-4
#: An improvement by more than this must be recorded.
BETTER = 0.02

HEADER = """\
# The worst error of every public function, in ulp of the exact value, over at least {inputs} inputs
# each, random and adversarial (reference/inputs.py); exact values from reference/oracle.py.
# Where flight functions cross zero their ulp is that of the larger of the value and its greatest
# term (reference/flight.py).
#
# Written by `python -m reference.accuracy --record`; a run without --record fails if a function is
# worse or clearly better. `at` is where the worst error happens. Where `demanded_ulp` is not
# reached, `allowed_ulp` and `why`, put here by hand, say what is and why.
"""


class Worst(NamedTuple):
    error: float
    at: tuple[float, ...]
    inputs: int


def read_record() -> dict[str, dict]:
    return tomllib.loads(RECORD.read_text()) if RECORD.exists() else {}


def recorded_inputs(record: dict[str, dict], names: Iterable[str]) -> list[tuple[float, ...]]:
    return [tuple(float.fromhex(v) for v in record[name]["at"]) for name in names if name in record]


class Task(NamedTuple):
    names: list[str]
    chunk: int
    count: int
    seed: int
    record: dict[str, dict]

    def random(self, name: str) -> np.random.Generator:
        """A stream that depends on the name, not on what else is measured in the same run."""
        return np.random.default_rng([self.seed, self.chunk, zlib.crc32(name.encode())])


def errors_at(name: str, rows: list[tuple[float, ...]], exact: list[Rounded]) -> np.ndarray:
    arguments = [np.array(column) for column in zip(*rows, strict=True)]
    hi, rest, ulp = (np.array(column) for column in zip(*exact, strict=True))
    return ulp_errors(kernels.evaluate(name, *arguments), hi, rest, ulp)


def nearby(
    rows: list[tuple[float, ...]], errors: np.ndarray, random: np.random.Generator
) -> list[tuple[float, ...]]:
    """Inputs around the worst ones, at distances from a few ulp to a few percent: where the terms
    of a formula conspire, the roundings of a neighbour may conspire more.
    """
    worst = [rows[i] for i in np.argsort(-errors, kind="stable")[:WORST_FOLLOWED]]
    return [
        tuple(float(v * (1 + random.choice([-1, 1]) * 2.0 ** random.uniform(-51, -4))) for v in row)
        for row in worst
        for _ in range(NEIGHBOURS)
    ]


def measure_chunk(task: Task) -> dict[str, Worst]:
    """Random inputs, then neighbours of the worst of them; the first chunk brings the corners, the
    hard cases and the recorded worst input along.
    """
    arguments = oracle.FUNCTIONS[task.names[0]].arguments
    drawn = arguments.draw(task.random(oracle.stream(arguments)), task.count)
    rows = list(zip(*(column.tolist() for column in drawn), strict=True))
    if task.chunk == 0:
        rows = [tuple(map(float, row)) for row in arguments.corners] + rows
    exact = {name: [] for name in task.names}
    for row in rows:  # all functions of one input together: they share its launch angle
        for name in task.names:
            exact[name].append(oracle.FUNCTIONS[name].exact(*row))
    answer = {}
    for name in task.names:
        errors = errors_at(name, rows, exact[name])
        more = nearby(rows, errors, task.random(name + " nearby"))
        if task.chunk == 0:
            more += recorded_inputs(task.record, [name]) + inputs.HARD.get(name, [])
        errors_nearby = errors_at(name, more, [oracle.FUNCTIONS[name].exact(*row) for row in more])
        everywhere, errors = rows + more, np.concatenate([errors, errors_nearby])
        i = int(np.argmax(errors))
        answer[name] = Worst(float(errors[i]), everywhere[i], len(everywhere))
    return answer


def measure(
    names: Iterable[str], inputs: int, seed: int, record: dict[str, dict]
) -> dict[str, Worst]:
    kernels.binary()  # build once, before the workers ask for it
    tasks = []
    for group in oracle.groups(names):
        for chunk, start in enumerate(range(0, inputs, CHUNK)):
            tasks.append(Task(group, chunk, min(CHUNK, inputs - start), seed, record))
    worst: dict[str, Worst] = {}
    with Pool(os.cpu_count()) as pool:
        for done, part in enumerate(pool.imap_unordered(measure_chunk, tasks), 1):
            for name, new in part.items():
                old = worst.get(name, Worst(-1.0, (), 0))
                # Ties go to the smaller input, so that the order of the workers does not show.
                better = max(old, new, key=lambda w: (w.error, [-abs(v) for v in w.at]))
                worst[name] = Worst(better.error, better.at, old.inputs + new.inputs)
            if sys.stderr.isatty():
                print(f"\r{done}/{len(tasks)}", end="", file=sys.stderr, flush=True)
    return {name: worst[name] for name in names}


def demanded(name: str, record: dict[str, dict]) -> float:
    """The bound demanded, or where the record says why it is not reached, the one allowed."""
    row = record.get(name, {})
    if "allowed_ulp" in row and row.get("why"):
        return float(row["allowed_ulp"])
    return oracle.FUNCTIONS[name].bound


def faults(name: str, worst: Worst, record: dict[str, dict], fresh: bool) -> list[str]:
    at = ", ".join(f"{v!r}" for v in worst.at)
    found = []
    bound = demanded(name, record)
    if not worst.error <= bound:
        found.append(f"{name}: {worst.error:.5g} ulp at ({at}), demanded {bound:g}")
    if fresh:
        return found
    if name not in record:
        return [*found, f"{name}: not in {RECORD.name}; run with --record"]
    was = record[name]["worst_ulp"]
    if not worst.error <= was + WORSE:
        found.append(f"{name}: {worst.error:.5g} ulp at ({at}), worse than the recorded {was:.4f}")
    if worst.error < was - BETTER:
        found.append(
            f"{name}: {worst.error:.5g} ulp, better than the recorded {was:.4f}: "
            "tighten the record with --record"
        )
    return found


def written(name: str, worst: Worst, row: dict) -> str:
    lines = [
        f"[{name}]",
        f"worst_ulp = {worst.error:.4f}",
        f"at = {json.dumps([v.hex() for v in worst.at])}  # {', '.join(map(repr, worst.at))}",
        f"inputs = {worst.inputs}",
        f"demanded_ulp = {oracle.FUNCTIONS[name].bound:.1f}",
    ]
    if "allowed_ulp" in row:
        lines += [
            f"allowed_ulp = {row['allowed_ulp']}",
            f"why = {json.dumps(row.get('why', ''))}",
        ]
    return "\n".join(lines) + "\n"


def write_record(results: dict[str, Worst], record: dict[str, dict], fresh: bool) -> None:
    """Replace the rows measured. Fresh inputs only ever raise a row; the recorded run sets it."""
    rows = []
    for name in oracle.FUNCTIONS:
        row = record.get(name, {})
        old = (
            Worst(row["worst_ulp"], *recorded_inputs(record, [name]), row["inputs"])
            if row
            else None
        )
        new = results.get(name)
        if new is None or (fresh and old is not None and new.error <= old.error + WORSE):
            new = old
        elif fresh and old is not None:
            new = new._replace(inputs=old.inputs)
        if new is not None:
            rows.append(written(name, new, row))
    RECORD.write_text(HEADER.format(inputs=INPUTS) + "\n" + "\n".join(rows))


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help="public functions; all of them without"
    )
    parser.add_argument(
        "--inputs", type=int, default=INPUTS, help="random inputs for each function"
    )
    parser.add_argument(
        "--fresh", action="store_true", help="draw inputs that no earlier run has seen"
    )
    parser.add_argument("--record", action="store_true", help="write what was measured")
    options = parser.parse_args()
    unknown = [name for name in options.names if name not in oracle.FUNCTIONS]
    if unknown:
        parser.error(f"no function is named {unknown[0]!r}; they are {', '.join(oracle.FUNCTIONS)}")
    if options.record and options.inputs < INPUTS:
        parser.error(f"a record needs at least {INPUTS} inputs a function, got {options.inputs}")
    if not options.fresh and options.inputs != INPUTS:
        parser.error(
            f"the recorded run has {INPUTS} inputs a function; other numbers go with --fresh"
        )

    record = read_record()
    seed = secrets.randbits(48) if options.fresh else SEED
    start = time.monotonic()
    results = measure(options.names or list(oracle.FUNCTIONS), options.inputs, seed, record)
    for name, worst in results.items():
        at = ", ".join(f"{v!r}" for v in worst.at)
        print(
            f"{name:24} {worst.error:12.5g} ulp of {demanded(name, record):g}"
            f"   {worst.inputs} inputs, worst at ({at})"
        )
    print(f"seed {seed}, {time.monotonic() - start:.0f} s")
    if options.record:
        write_record(results, record, options.fresh)
        record = read_record()
    wrong = [
        fault
        for name, worst in results.items()
        for fault in faults(name, worst, record, options.fresh)
    ]
    for fault in wrong:
        print(fault, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

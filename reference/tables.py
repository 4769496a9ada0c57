"""Write reference/tables/*.csv: exact values at adversarial and random points.

    python -m reference.tables              all of them
    python -m reference.tables apex_x exp   some

Values come by definition alone (`Function.defined`: the slow road for the motion), and the fast
road must give the same. Doubles are written in hexadecimal. `value` is the double nearest to the
exact value, `rest` the exact value minus it, in units of `ulp`, so that a computed double has the
error abs((got - value) / ulp - rest).
"""

import argparse
import os
import sys
from multiprocessing import Pool
from pathlib import Path

import flint
import numpy as np

from reference import oracle
from reference.ball import Rounded, agree

FOLDER = Path(__file__).with_name("tables")
SEED = 1758
RANDOM_ROWS = 200
Row = tuple[float, ...]


def rows(name: str) -> list[Row]:
    """The corners, then random arguments; each once."""
    columns = oracle.sample(name, RANDOM_ROWS, SEED)
    listed = zip(*(column.tolist() for column in columns), strict=True)
    return list({tuple(v.hex() for v in row): row for row in listed}.values())


def written(arguments: Row, value: Rounded) -> str:
    return ",".join(
        [*(v.hex() for v in arguments), value.hi.hex(), repr(value.rest), value.ulp.hex()]
    )


def line(name: str, arguments: Row) -> str:
    function = oracle.FUNCTIONS[name]
    value = function.defined(*arguments)
    if not agree(value, function.exact(*arguments)):
        raise ArithmeticError(
            f"{name}{arguments}: the roads differ: {value}, {function.exact(*arguments)}"
        )
    return written(arguments, value)


def lines(task: tuple[list[str], Row]) -> list[str]:
    """One row of several tables: functions of one input share the work."""
    names, arguments = task
    return [line(name, arguments) for name in names]


def header(name: str) -> str:
    function = oracle.FUNCTIONS[name]
    return (
        f"# {name}({', '.join(function.names)}): {function.definition}\n"
        f"# written by: python -m reference.tables {name} "
        f"(python-flint {flint.__version__}, FLINT {flint.__FLINT_VERSION__})\n"
        "# value: the nearest double; rest: exact - value, in ulp; "
        "error of a double: abs((got - value) / ulp - rest)\n"
        f"{','.join(function.names)},value,rest,ulp\n"
    )


def write(names: list[str]) -> None:
    FOLDER.mkdir(exist_ok=True)
    with Pool(os.cpu_count()) as pool:
        for group in oracle.groups(names):
            parts = pool.map(lines, [(group, row) for row in rows(group[0])], chunksize=1)
            for name, column in zip(group, zip(*parts, strict=True), strict=True):
                (FOLDER / f"{name}.csv").write_text(header(name) + "\n".join(column) + "\n")
                print(f"{name}: {len(column)} rows", file=sys.stderr)


def read(name: str) -> tuple[np.ndarray, ...]:
    """The columns of a table: the arguments, value, rest and ulp."""
    lines = (FOLDER / f"{name}.csv").read_text().splitlines()
    data = [text.split(",") for text in lines if not text.startswith("#")][1:]
    columns = zip(*data, strict=True)
    return tuple(np.array([number(v) for v in column]) for column in columns)


def number(text: str) -> float:
    return float.fromhex(text) if "0x" in text else float(text)


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help="public functions; all of them without"
    )
    names = parser.parse_args().names or list(oracle.FUNCTIONS)
    unknown = [name for name in names if name not in oracle.FUNCTIONS]
    if unknown:
        parser.error(f"no function is named {unknown[0]!r}; they are {', '.join(oracle.FUNCTIONS)}")
    write(names)


if __name__ == "__main__":
    main()

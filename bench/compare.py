"""The honest comparison: ``python -m bench.compare``.

Prints the tables of COMPARE.md as measured here and now, and which bars they miss. With
``--record`` it also writes them, with the date and the machine, to ``bench/record/``, puts them
into COMPARE.md and, a few, into the README, and draws
``docs/speed.svg`` and ``docs/scaling.svg``.
"""

from __future__ import annotations

import argparse
import datetime
import platform
import re
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import scipy

import archerfish
from archerfish.files import write_whole
from bench import accuracy, peers, pictures, scaling, speed
from bench.accuracy import Table

ROOT = Path(__file__).resolve().parent.parent
RECORDS = ROOT / "bench" / "record"
#: The documents that quote the newest record, and the tables each has room for.
DOCUMENTS = {
    ROOT / "COMPARE.md": ("about", "formulas", "lambert", "speed", "scaling"),
    ROOT / "README.md": ("digest",),
}
#: How much faster two threads are at least.
TWO_THREADS = 1.8
#: Processor time of a whole process, in that of `import numpy`.
STARTS = (("import archerfish", 1.3), ("archerfish locus", 2.5))
#: What the README shows of each family.
DIGEST = ("lambertw0", "lambertwm1", "apex_y", "locus_launch_angle", "locus_radius", "flight_range")


def measured(count: int, elements: int, rounds: int, longest: int) -> dict[str, Any]:
    """Return everything the tables show, and where and when it was measured."""
    return {
        "about": {
            "date": datetime.datetime.now(datetime.UTC).date().isoformat(),
            "processor": processor(),
            "instruction_set": archerfish.isa(),
            "python": platform.python_version(),
            **{module.__name__: module.__version__ for module in (archerfish, np, scipy)},
            "inputs": count,
            "elements": elements,
            "rounds": rounds,
        },
        # The inputs are chosen to overflow and to leave what their formulas can do.
        "formulas": quiet(accuracy.formulas, count),
        "lambert": quiet(accuracy.lambert, count),
        "speed": quiet(speed.times, elements, rounds, peers.libraries()),
        **quiet(scaling.measured, longest),
    }


def quiet(function: Any, *arguments: Any) -> Any:
    """Call without NumPy's warnings: the tables say what they would."""
    with np.errstate(all="ignore"):
        return function(*arguments)


def processor() -> str:
    """Return the processor's own name for itself, as far as the system tells it."""
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return platform.processor() or platform.machine()
    found = re.search(r"^model name\s*: (.+)$", text, re.MULTILINE)
    return found[1].strip() if found else platform.machine()


def tables(record: dict[str, Any]) -> dict[str, str]:
    """Return the Markdown of each table of COMPARE.md, by its marker."""
    about = record["about"]
    return {
        "formulas": markdown(record["formulas"], "{:.0e}", "ε ="),
        "lambert": markdown(transposed(record["lambert"]), "{:.3g}", "argument"),
        "speed": speed_table(record["speed"]),
        "scaling": scaling_table(record),
        "digest": digest(record),
        "about": (
            f"Measured on {about['date']} on {about['processor']} ({about['instruction_set']} "
            f"kernels, one thread): archerfish {about['archerfish']}, Python {about['python']}, "
            f"NumPy {about['numpy']}, SciPy {about['scipy']}; errors over {about['inputs']} inputs "
            f"a cell, times the median of {about['rounds']} rounds over {about['elements']} "
            f"elements. Absolute times vary from run to run: compare within a table."
        ),
    }


def transposed(table: Table) -> Table:
    """Return the table with rows and columns exchanged."""
    columns = next(iter(table.values()))
    return {column: {row: table[row][column] for row in table} for column in columns}


def markdown(table: Table, number: str, corner: str) -> str:
    """Return a Markdown table of errors."""
    columns = list(next(iter(table.values())))
    lines = [f"| {corner} | {' | '.join(columns)} |", f"|---|{'---|' * len(columns)}"]
    for row, cells in table.items():
        name = f"**{row}**" if hasattr(archerfish, row) or "offset" in row else row
        texts = (shown(cells[column], number) for column in columns)
        lines.append(f"| {name} | {' | '.join(texts)} |")
    return "\n".join(lines)


def shown(value: float, number: str) -> str:
    """Return an error as text: ``2e-8``, not ``2e-08``."""
    if np.isnan(value):
        return "NaN"
    return re.sub(r"e([+-])0+(?=\d)", r"e\1", number.format(value)).replace("e+", "e")


def speed_table(rows: speed.Rows) -> str:
    """Return a Markdown table of times, kernel by kernel, ours in bold."""
    lines = [
        "| kernel | who | ns an element | in logarithms | at most |",
        "|---|---|---|---|---|",
    ]
    for row_name, row in rows.items():
        kernel, name = speed.kernel_and_name(row_name)
        ours = name == "archerfish"
        bar = f"{speed.BARS[kernel]:g}" if ours and kernel in speed.BARS else ""
        time = f"{row['nanoseconds']:.3g} ± {row['spread']:.1g}"
        names = (f"**{kernel}**", "archerfish") if ours else ("", name or kernel)
        lines.append(f"| {names[0]} | {names[1]} | {time} | {row['logarithms']:.3g} | {bar} |")
    return "\n".join(lines)


def digest(record: dict[str, Any]) -> str:
    """Return what the README quotes: a kernel of each family beside the others, and the start."""
    about, starts = record["about"], record["starts"]
    rows: dict[str, dict[str, str]] = {kernel: {} for kernel in DIGEST}
    for row_name, row in record["speed"].items():
        kernel, name = speed.kernel_and_name(row_name)
        time = row["nanoseconds"]
        if kernel in rows:
            rows[kernel][name] = f"{time:.3g}" if time < 1000 else f"{time:,.0f}"
    lines = ["| ns an element | archerfish | others |", "|---|---|---|"]
    for kernel, times in rows.items():
        mine = times.pop("archerfish")
        others = "; ".join(f"{name}: {time}" for name, time in times.items())
        lines.append(f"| `{kernel}` | {mine} | {others} |")
    logarithm = record["speed"][speed.UNIT]["nanoseconds"]
    lines += [
        "",
        f"One thread of {about['processor']} ({about['instruction_set']} kernels), where `np.log`",
        f"takes {logarithm:.2g} ns. In the time of `import numpy`, `import archerfish` takes "
        f"{starts['import archerfish']:.2f}, and",
        f"`archerfish locus`, start to end, {starts['archerfish locus']:.2f}.",
    ]
    return "\n".join(lines)


def scaling_table(record: dict[str, Any]) -> str:
    """Return a Markdown table of what does not depend on the elements."""
    lines = ["| | | measured | at most |", "|---|---|---|---|"]
    for name, ratio in record["calls"].items():
        if name != "arctan2":
            lines.append(f"| call on one element, in np.arctan2's | {name} | {ratio:.2f} | 1.5 |")
    for name, ratio in record["threads"].items():
        lines.append(
            f"| two threads, times as fast | {name} | {ratio:.2f} | at least {TWO_THREADS:g} |"
        )
    (memory,) = record["memory"].values()
    lines.append(f"| memory beyond arguments and results | apex_y, 10⁷ | {memory:.2f} | 0 |")
    for name, bar in STARTS:
        ratio = record["starts"][name]
        lines.append(f"| whole process, in `import numpy`'s | {name} | {ratio:.2f} | {bar:g} |")
    return "\n".join(lines)


def drawn(record: dict[str, Any]) -> dict[str, bytes]:
    """Return the pictures by file name."""
    prefix = "scaling of "
    lengths = {n.removeprefix(prefix): row for n, row in record.items() if n.startswith(prefix)}
    return {
        "speed.svg": pictures.bars(record["speed"], record["about"]["instruction_set"]),
        "scaling.svg": pictures.lengths(lengths),
    }


def updated(document: str, record: dict[str, Any], names: tuple[str, ...]) -> str:
    """Return the document with each of these tables replaced between its markers."""
    texts = tables(record)
    for name in names:
        text = texts[name]
        begin, end = f"<!-- {name}: made by make bench -->", f"<!-- end of {name} -->"
        pattern = re.compile(re.escape(begin) + ".*?" + re.escape(end), re.DOTALL)
        if len(pattern.findall(document)) != 1:
            raise ValueError(f"the document must have one pair of markers for {name}")
        document = pattern.sub(lambda _, new=f"{begin}\n{text}\n{end}": new, document)
    return document


def missed(record: dict[str, Any]) -> list[str]:
    """Return a line for each bar that the record does not reach."""
    factor = {"avx512": 1.0, "avx2": 2.0}.get(record["about"]["instruction_set"], np.inf)
    bars = [
        (f"{kernel}, in logarithms", row["logarithms"], speed.BARS[kernel] * factor)
        for (kernel, name), row in (
            (speed.kernel_and_name(name), row) for name, row in record["speed"].items()
        )
        if name == "archerfish" and kernel in speed.BARS
    ]
    bars += [
        (f"call on one element, {name}, in np.arctan2's", ratio, 1.5)
        for name, ratio in record["calls"].items()
    ]
    bars += [(f"{name}, in import numpy's", record["starts"][name], bar) for name, bar in STARTS]
    slow = [
        f"two threads, {name}: {ratio:.3g} times as fast, at least {TWO_THREADS:g}"
        for name, ratio in record["threads"].items()
        if ratio < TWO_THREADS and name in archerfish.__all__  # NumPy's own shows the machine's
    ]
    return [
        f"{name}: {value:.3g}, at most {bar:g}" for name, value, bar in bars if value > bar
    ] + slow


def toml(record: dict[str, Any]) -> str:
    """Return the record as TOML."""
    lines: list[str] = []
    for name, table in record.items():
        for inner, cells in subtables(name, table):
            lines += [
                f"[{inner}]",
                *(f'"{key}" = {literal(cell)}' for key, cell in cells.items()),
                "",
            ]
    return "\n".join(lines)


def subtables(name: str, table: dict[str, Any]) -> list[tuple[str, dict[str, Any]]]:
    """Return the table, or its rows where it has rows, under their TOML names."""
    if all(isinstance(cells, dict) for cells in table.values()):
        return [(f'{name}."{row}"', cells) for row, cells in table.items()]
    return [(f'"{name}"' if " " in name else name, table)]


def literal(value: str | float) -> str:
    """Return a TOML literal; four digits are more than a measurement has."""
    if isinstance(value, str):
        return f'"{value}"'
    return str(value) if isinstance(value, int) else f"{value:.4g}"


def latest() -> dict[str, Any]:
    """Return the newest record."""
    path = max(RECORDS.glob("*.toml"))
    return tomllib.loads(path.read_text(encoding="utf-8"))


def main() -> None:
    """Measure, print, and on request record."""
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False)
    parser.add_argument("--inputs", type=int, default=1000, help="inputs for each error")
    parser.add_argument("--elements", type=int, default=200_000, help="array length for times")
    parser.add_argument("--rounds", type=int, default=15, help="rounds for times")
    parser.add_argument("--longest", type=int, default=10**8, help="longest array for scaling")
    parser.add_argument("--record", action="store_true", help="write bench/record and COMPARE.md")
    chosen = parser.parse_args()
    record = measured(chosen.inputs, chosen.elements, chosen.rounds, chosen.longest)
    for text in tables(record).values():
        print(text, end="\n\n")
    for line in missed(record):
        print("not met:", line)
    if chosen.record:
        # What stands in COMPARE.md is what stands in the record, rounding included.
        text = toml(record)
        path = RECORDS / f"{record['about']['date']}.toml"
        RECORDS.mkdir(exist_ok=True)
        write_whole(path, text.encode())
        for page, names in DOCUMENTS.items():
            document = updated(page.read_text(encoding="utf-8"), tomllib.loads(text), names)
            write_whole(page, document.encode())
        for name, picture in drawn(tomllib.loads(text)).items():
            write_whole(ROOT / "docs" / name, picture)
        print(f"wrote {path.relative_to(ROOT)}, COMPARE.md, README.md and two pictures in docs")


if __name__ == "__main__":
    main()

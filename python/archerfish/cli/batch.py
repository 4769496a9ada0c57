"""A CSV in, a CSV out: the columns of the input, those of the answer, and a reason for each NaN.

Rows are read, answered and written a block at a time, so that memory does not grow with the input.
"""

from __future__ import annotations

import contextlib
import csv
import io
import itertools
import os
import sys
import time
from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO, TextIO

import click
import numpy as np
import numpy.typing as npt

from archerfish.cli.errors import RefusedValue
from archerfish.cli.parameters import DRAGS, Parameter, Values
from archerfish.files import whole_file

BLOCK = 8192
"""Rows answered at once."""
TOLD = 20
"""Bad rows told of one by one."""
SLOW = 1.0
"""Seconds after which a terminal gets a progress bar."""
REASON = "reason"
QUOTED = ',"\r\n'
"""What a cell of a CSV may hold in quotes only."""

Answer = Mapping[str, Any]
Compute = Callable[[Values], Answer]


@dataclass(frozen=True)
class Extra:
    """Parameters to be given together or not at all, and the columns they are answered by."""

    parameters: tuple[Parameter, ...]
    columns: tuple[str, ...]


@dataclass(frozen=True)
class Question:
    """What a command asks of each row.

    `compute` takes arrays by parameter name and returns columns by name: numbers, or lists of
    words; only the column `reason` may hold sentences with commas. It raises ValueError or
    TypeError where a value is refused; `reason` then gets its sentence.
    """

    required: tuple[Parameter, ...]
    optional: tuple[Parameter, ...]
    columns: tuple[str, ...]
    compute: Compute
    extras: tuple[Extra, ...] = ()

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """All of them."""
        extras = (extra.parameters for extra in self.extras)
        return self.required + self.optional + tuple(itertools.chain(*extras))

    def answered(self, names: Container[str]) -> tuple[str, ...]:
        """The columns that answer these parameters."""
        asked = (extra for extra in self.extras if extra.parameters[0].name in names)
        return self.columns + tuple(itertools.chain(*(extra.columns for extra in asked)))


@dataclass
class _Tally:
    """Rows so far, and how many of them were bad."""

    command: str
    rows: int = 0
    bad: int = 0
    lines: list[str] = field(default_factory=list)

    def note(self, row: int, reason: str) -> None:
        self.bad += 1
        if self.bad <= TOLD:
            self.lines.append(f"{self.command}: row {row}: {reason}")

    def tell(self) -> None:
        """Say what has not been said yet."""
        for line in self.lines:
            click.echo(line, err=True)
        self.lines.clear()

    def end(self) -> None:
        self.tell()
        if self.bad:
            click.echo(
                f"{self.command}: {self.bad} of {self.rows} rows are bad: NaN, with the reason in "
                "the last column",
                err=True,
            )


def run_batch(
    question: Question, source: str, given: Values, output: Path | None, command: str
) -> None:
    """Answer every row of the CSV at `source` ('-': standard input) into `output`."""
    with _opened(source) as (stream, size):
        if output is None:
            sys.stdout.flush()
            _convert(question, stream, size, given, sys.stdout.buffer, command)
            sys.stdout.flush()
        else:
            with whole_file(output) as target:
                _convert(question, stream, size, given, target, command)
            click.echo(f"wrote {output}")


@contextlib.contextmanager
def _opened(source: str) -> Iterator[tuple[TextIO, int | None]]:
    """The input as text, and its size in bytes where that is known."""
    try:
        if source == "-":
            if sys.stdin is None:
                raise click.ClickException("cannot read standard input: it is closed")
            raw: BinaryIO = sys.stdin.buffer
            size = None
        else:
            raw = Path(source).open("rb")  # noqa: SIM115 - closed below, standard input is not
            status = os.fstat(raw.fileno())
            size = status.st_size or None
    except OSError as error:
        raise click.ClickException(f"cannot read {source}: {error.strerror}") from error
    # Bytes that are not UTF-8 pass through as they are; a byte order mark is dropped.
    text = io.TextIOWrapper(raw, "utf-8-sig", errors="surrogateescape", newline="")
    try:
        yield text, size
    finally:
        text.detach()
        if source != "-":
            raw.close()


def _convert(
    question: Question,
    stream: TextIO,
    size: int | None,
    given: Values,
    target: BinaryIO,
    command: str,
) -> None:
    # A CSV that goes to the same terminal is progress enough.
    told = sys.stderr is not None and sys.stderr.isatty()
    shown = told and not (target is sys.stdout.buffer and sys.stdout.isatty())
    reader = csv.reader(stream, strict=True)
    header = _header(reader, question, given)
    columns = question.answered(_names(question, header, given))
    text = io.TextIOWrapper(
        target, "utf-8", errors="surrogateescape", newline="", write_through=True
    )
    try:
        csv.writer(text, lineterminator="\n").writerow([*header, *columns, REASON])
        tally = _Tally(command)
        with _progress(stream, size, shown) as advance:
            for block in _blocks(reader):
                _answer_block(question, columns, header, block, given, text, tally)
                advance(tally)
        tally.end()
        text.flush()
    finally:
        with contextlib.suppress(ValueError):
            text.detach()


def _header(reader: Iterator[list[str]], question: Question, given: Values) -> list[str]:
    """The names of the columns; RefusedValue where they do not make a question."""
    try:
        header = [name.strip() for name in next(reader, [])]
    except csv.Error as error:
        raise _refused(f"the input is not CSV: {error}") from error
    if not header:
        raise _refused("the input must start with a line of column names, got nothing")
    for name in header:
        if header.count(name) > 1:
            raise _refused(f"each column must have a name of its own, got {name!r} twice")
    for parameter in question.required:
        if parameter.column not in header and parameter.name not in given:
            raise _refused(
                f"give column {parameter.column} or {parameter.flag}, got columns "
                f"{', '.join(header)}"
            )
    drags = [drag.name for drag in DRAGS if drag.column in header or drag.name in given]
    if len(drags) != 1:
        raise _refused(
            "give exactly one of epsilon, drag_rate, terminal_speed, as a column or a flag; got "
            + (" and ".join(drags) or "none")
        )
    for parameter in question.parameters:
        if parameter.column in header and given.get(parameter.name) is not None:
            raise _refused(f"give column {parameter.column} or {parameter.flag}, got both")
    names = _names(question, header, given)
    for extra in question.extras:
        found = [each for each in extra.parameters if each.name in names]
        if found and len(found) < len(extra.parameters):
            columns = " and ".join(each.column for each in extra.parameters)
            raise _refused(f"give {columns} together, got {found[0].column} alone")
    for name in (*question.answered(names), REASON):
        if name in header:
            raise _refused(f"column {name} is written by this command: rename it in the input")
    return header


def _names(question: Question, header: list[str], given: Values) -> set[str]:
    """The parameters that are columns or flags."""
    return {
        each.name for each in question.parameters if each.column in header or each.name in given
    }


def _refused(message: str) -> RefusedValue:
    return RefusedValue(message, click.get_current_context(silent=True))


def _blocks(reader: Any) -> Iterator[list[list[str]]]:
    """The rows, some thousands at a time; blank lines are no rows.

    What comes before a line that is no CSV is answered.
    """
    rows: list[list[str]] = []
    read = reader.line_num
    try:
        for row in reader:
            read = reader.line_num
            if row:
                rows.append(row)
            if len(rows) == BLOCK:
                yield rows
                rows = []
    except csv.Error as error:
        if rows:
            yield rows
        raise _refused(f"the input is not CSV from line {read + 1} on: {error}") from error
    if rows:
        yield rows


def _answer_block(
    question: Question,
    columns: tuple[str, ...],
    header: list[str],
    block: list[list[str]],
    given: Values,
    target: TextIO,
    tally: _Tally,
) -> None:
    reasons = [""] * len(block)
    if set(map(len, block)) != {len(header)}:
        _complete(block, header, reasons)
    kept: list[Sequence[str]] = list(zip(*block, strict=True))
    values: dict[str, Any] = {}
    for parameter in question.parameters:
        if parameter.column in header:
            cells = kept[header.index(parameter.column)]
            values[parameter.name] = _numbers(cells, parameter, reasons)
        elif given.get(parameter.name) is not None:
            values[parameter.name] = np.full(len(block), float(given[parameter.name]))
        elif parameter.default is not None:
            values[parameter.name] = np.full(len(block), parameter.default)
    results: dict[str, list[Any]] = {name: ["nan"] * len(block) for name in columns}
    results[REASON] = reasons
    good = np.array([index for index, reason in enumerate(reasons) if not reason], dtype=np.intp)
    bad = set(range(len(block))) - set(good.tolist())
    for rows, answer in _answers(question.compute, values, good):
        if isinstance(answer, str):
            reasons[rows[0]] = answer
            bad.add(int(rows[0]))
            continue
        for name, column in answer.items():
            found = column if isinstance(column, list) else np.asarray(column).tolist()
            if len(found) == len(block):
                results[name] = found
                continue
            for row, cell in zip(rows.tolist(), found, strict=True):
                results[name][row] = cell
    for index in sorted(bad):
        tally.note(tally.rows + index + 1, reasons[index])
    tally.rows += len(block)
    _write(target, kept, [results[name] for name in columns], results[REASON])


def _complete(block: list[list[str]], header: list[str], reasons: list[str]) -> None:
    """Give each row as many cells as the header has, and a reason to those that have not."""
    for index, row in enumerate(block):
        if len(row) != len(header):
            reasons[index] = f"{len(row)} cells where the header has {len(header)}"
            if extra := row[len(header) :]:
                reasons[index] += f", left over: {', '.join(map(repr, extra))}"
            row[len(header) :] = []
            row += [""] * (len(header) - len(row))


def _write(
    target: TextIO, kept: list[Sequence[str]], answers: list[list[Any]], reasons: list[str]
) -> None:
    """Write columns side by side, numbers with the digits that give them back."""
    rows = zip(*kept, *answers, reasons, strict=True)
    text = "".join(map("".join, [*kept, reasons]))
    if any(mark in text for mark in QUOTED):
        csv.writer(target, lineterminator="\n").writerows(rows)
        return
    # Where no cell wants quotes a block is one template: a third of the time the writer takes.
    line = ",".join(["%s"] * (len(kept) + len(answers) + 1)) + "\n"
    target.write(line * len(reasons) % tuple(itertools.chain.from_iterable(rows)))


def _numbers(
    cells: Sequence[str], parameter: Parameter, reasons: list[str]
) -> npt.NDArray[np.float64]:
    """One column as numbers: NaN, and a reason, where a cell is none."""
    try:
        if "_" not in "".join(cells):
            return np.array(list(map(float, cells)))
    except ValueError:
        pass
    numbers = np.full(len(cells), np.nan)
    for index, cell in enumerate(cells):
        try:
            # Python would take 1_0 for 10.
            numbers[index] = float(cell.replace("_", "?"))
        except ValueError:
            what = f"got {cell!r}" if cell.strip() else "the cell is empty"
            reasons[index] = reasons[index] or f"{parameter.column} must be a number, {what}"
    return numbers


def _answers(
    compute: Compute, values: Values, rows: npt.NDArray[np.intp]
) -> Iterator[tuple[npt.NDArray[np.intp], Answer | str]]:
    """Answers to these rows, some at a time, or the sentence that refuses one.

    A refused value refuses all rows it comes with; halving finds it in a few steps.
    """
    if rows.size == 0:
        return
    try:
        yield rows, compute({name: column[rows] for name, column in values.items()})
    except (TypeError, ValueError) as error:
        if rows.size > 1:
            half = rows.size // 2
            yield from _answers(compute, values, rows[:half])
            yield from _answers(compute, values, rows[half:])
            return
        # The same once more with plain numbers, whose sentence does not speak of arrays.
        sentence = str(error)
        try:
            compute({name: float(column[rows[0]]) for name, column in values.items()})
        except (TypeError, ValueError) as plain:
            sentence = str(plain)
        yield rows, sentence


@contextlib.contextmanager
def _progress(stream: TextIO, size: int | None, shown: bool) -> Iterator[Callable[[_Tally], None]]:
    """What to call after each block; where `shown`, a bar for work that takes above a second."""
    if not shown:
        yield lambda tally: tally.tell()
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    bar = Progress(
        BarColumn(),
        TextColumn("" if size is None else "{task.percentage:3.0f}%"),
        TextColumn("{task.fields[rows]:,} rows"),
        TimeRemainingColumn(),
        console=Console(stderr=True),
        transient=True,
    )
    task = bar.add_task("", total=size, rows=0)
    begun = time.monotonic()

    def advance(tally: _Tally) -> None:
        if not bar.live.is_started and time.monotonic() - begun > SLOW:
            bar.start()
        done = stream.buffer.tell() if size is not None else tally.rows
        bar.update(task, completed=done, rows=tally.rows)
        if bar.live.is_started:
            for line in tally.lines:
                bar.console.print(line, markup=False, highlight=False)
            tally.lines.clear()
        else:
            tally.tell()

    try:
        yield advance
    finally:
        bar.stop()

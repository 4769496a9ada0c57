"""The committed tables: complete, and written again they come out the same."""

import math
import random

import pytest

from reference import oracle, tables
from reference.ball import Rounded, agree


def body(name):
    lines = (tables.FOLDER / f"{name}.csv").read_text().splitlines()
    return [text for text in lines if not text.startswith("#")][1:]


def test_every_function_has_its_table():
    assert {path.stem for path in tables.FOLDER.iterdir()} == set(oracle.FUNCTIONS)


@pytest.mark.parametrize("name", oracle.FUNCTIONS)
def test_table_has_a_row_for_every_input(name):
    text = (tables.FOLDER / f"{name}.csv").read_text()
    assert text.startswith(f"# {name}(")
    listed = [tuple(v.hex() for v in row) for row in tables.rows(name)]
    arguments = len(listed[0])
    assert [tuple(line.split(",")[:arguments]) for line in body(name)] == listed


@pytest.mark.parametrize("name", oracle.FUNCTIONS)
def test_some_rows_come_out_identically_from_the_definition(name):
    listed = tables.rows(name)
    # An ε of 1e300 takes the integration a thousand steps; one far smaller shows as much.
    quick = [
        i
        for i, row in enumerate(listed)
        if math.isnan(row[-1]) or name not in oracle.BY_ANGLE or row[-1] < 1e10
    ]
    for i in random.Random(name).sample(quick, 4):
        assert tables.line(name, listed[i]) == body(name)[i]


@pytest.mark.parametrize("name", oracle.BY_ANGLE)
def test_every_row_agrees_with_the_fast_road(name):
    *arguments, value, rest, ulp = (column.tolist() for column in tables.read(name))
    compared = 0
    for *row, hi, left, unit in zip(*arguments, value, rest, ulp, strict=True):
        assert agree(Rounded(hi, left, unit), oracle.FUNCTIONS[name].exact(*row)), (name, row)
        compared += 1
    assert compared == len(body(name))

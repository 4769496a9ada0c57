"""The names, arguments, types and pages of the ufuncs are what was published."""

import ast
import doctest
import inspect
from pathlib import Path

import numpy as np
import pytest

import archerfish
from archerfish import _core, _ufunc_docs


def test_exactly_the_published_names(table):
    registered = {name for name, value in vars(_core).items() if isinstance(value, np.ufunc)}
    assert registered == set(table)
    assert set(_ufunc_docs.DOCS) == set(table)
    assert set(table) <= set(archerfish.__all__)
    assert all(hasattr(archerfish, name) for name in archerfish.__all__)


def test_arguments(name, ufunc, table):
    arguments = list(table[name])
    assert ufunc.__name__ == name
    assert (ufunc.nin, ufunc.nout, ufunc.signature) == (len(arguments), 1, None)
    assert list(inspect.signature(ufunc).parameters)[: ufunc.nin + 1] == [*arguments, "out"]
    assert ufunc.__doc__.startswith(f"{name}({', '.join(arguments)}, /, out=None, ")


def test_wrong_number_of_arguments(ufunc):
    with pytest.raises(TypeError):
        ufunc()
    with pytest.raises(TypeError):
        ufunc(*[0.1] * (ufunc.nin + 2))


def test_loops_are_float32_before_float64(ufunc):
    assert ufunc.types == [f"{'f' * ufunc.nin}->f", f"{'d' * ufunc.nin}->d"]


def test_page_says_all_that_a_reader_needs(name, ufunc, table):
    page = inspect.getdoc(ufunc)
    for part in ("Parameters\n-----", "Returns\n-----", "Source\n-----", "Examples\n-----", "NaN"):
        assert part in page
    for argument in table[name]:
        assert f"\n{argument} : array_like\n" in page


def test_examples_of_the_page(name, ufunc):
    test = doctest.DocTestParser().get_doctest(ufunc.__doc__, {}, name, None, None)
    assert len(test.examples) >= 2
    report: list[str] = []
    result = doctest.DocTestRunner(verbose=False).run(test, out=report.append)
    assert result.failed == 0, "".join(report)


def test_stub_has_the_same_names_and_shapes(table):
    stub = ast.parse(Path(_core.__file__).with_name("_core.pyi").read_text(encoding="utf-8"))
    typed = {
        line.target.id: ast.unparse(line.annotation)
        for line in stub.body
        if isinstance(line, ast.AnnAssign) and isinstance(line.target, ast.Name)
    }
    shapes = {1: "Final[_UnaryUfunc]", 2: "Final[_BinaryUfunc]", 3: "Final[_TernaryUfunc]"}
    expected = {name: shapes[len(arguments)] for name, arguments in table.items()}
    assert typed == expected | {"__version__": "Final[str]"}


def test_version_and_instruction_set():
    assert archerfish.__version__ == _core.__version__
    assert archerfish.isa() in {"baseline", "avx2", "avx512"}

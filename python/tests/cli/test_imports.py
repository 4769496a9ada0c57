"""Who asks for no figure and no series does not pay for their libraries."""

import subprocess
import sys

import pytest

HEAVY = {"matplotlib", "sympy", "scipy", "pandas", "mpmath", "http"}


def imported(*arguments):
    code = (
        "import sys\n"
        "from archerfish.cli.app import run\n"
        f"status = run({list(arguments)!r})\n"
        "print(*sorted({name.split('.')[0] for name in sys.modules}), file=sys.stderr)\n"
        "sys.exit(status)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=120
    )
    return set(done.stderr.split())


@pytest.mark.parametrize("form", ["table", "csv", "json"])
def test_a_locus_without_a_figure(form):
    modules = imported("locus", "--speed", "10", "--epsilon", "0.1", "--format", form)
    assert "numpy" in modules
    assert not modules & HEAVY
    assert form == "table" or "rich" not in modules


def test_a_figure_needs_matplotlib_and_a_series_sympy(tmp_path):
    assert "matplotlib" in imported("figure", "2", "--output", str(tmp_path / "a.svg"))
    modules = imported("series", "--order", "3")
    assert "sympy" in modules
    assert "matplotlib" not in modules


@pytest.mark.parametrize(
    ("library", "arguments", "line"),
    [
        (
            "matplotlib",
            ["locus", "--speed", "10", "--epsilon", "1", "--figure", "a.svg"],
            "archerfish: figures need matplotlib: pip install 'archerfish[figures]'",
        ),
        ("sympy", ["series"], "archerfish: series need sympy: pip install 'archerfish[series]'"),
    ],
)
def test_a_missing_library_is_one_line_that_says_how_to_get_it(tmp_path, library, arguments, line):
    code = (
        "import sys\n"
        f"sys.modules[{library!r}] = None\n"
        "from archerfish.cli.app import run\n"
        f"sys.exit(run({arguments!r}))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path, check=False
    )
    assert (done.returncode, done.stdout, done.stderr) == (1, "", line + "\n")
    assert list(tmp_path.iterdir()) == []

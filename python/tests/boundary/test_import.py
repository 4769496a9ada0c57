"""Importing and pickling, each in a process of its own."""

import copy
import pickle
import subprocess
import sys

import pytest

#: For commands, figures, series and users: never for `import archerfish`.
HEAVY = {"click", "matplotlib", "pandas", "rich", "scipy", "sympy"}


def python(code: str) -> str:
    """What a fresh interpreter prints."""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return run.stdout


def test_import_is_light():
    loaded = python("import sys, archerfish; print(*{name.split('.')[0] for name in sys.modules})")
    assert not HEAVY & set(loaded.split())


def test_pickle(ufunc):
    assert pickle.loads(pickle.dumps(ufunc)) is ufunc
    assert copy.deepcopy(ufunc) is ufunc


def test_pickle_is_found_by_another_process(ufunc, name):
    data = pickle.dumps(ufunc)
    assert b"archerfish" in data
    if name == "apex_x":
        assert python(f"import pickle; print(pickle.loads({data!r}))") == "<ufunc 'apex_x'>\n"


SUBINTERPRETER = """
try:
    import _interpreters as interpreters
except ImportError:
    import _xxsubinterpreters as interpreters
{before}
number = interpreters.create()
interpreters.run_string(number, '''
try:
    import archerfish
except ImportError as error:
    print("ImportError:", error, flush=True)
''')
interpreters.destroy(number)
{after}
"""


@pytest.mark.parametrize("before", ["", "import archerfish"])
def test_subinterpreter_is_refused(before):
    after = "import archerfish; print(archerfish.apex_x(0.0, 1.0))"
    printed = python(SUBINTERPRETER.format(before=before, after=after)).splitlines()
    assert len(printed) == 2
    assert printed[0].startswith("ImportError: ")
    assert "subinterpreters" in printed[0]
    assert printed[1] == "0.0"


@pytest.mark.parametrize("wanted", ["baseline", "avx2", "avx512"])
def test_environment_chooses_the_instruction_set(monkeypatch, wanted):
    monkeypatch.setenv("ARCHERFISH_ISA", wanted)
    chosen = python("import archerfish; print(archerfish.isa())").strip()
    order = ["baseline", "avx2", "avx512"]
    assert order.index(chosen) <= order.index(wanted)
    if wanted == "baseline":
        assert chosen == wanted

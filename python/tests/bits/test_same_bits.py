"""Every instruction set, and WebAssembly, give the same bits."""

import json
import os
import re
import shutil
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest

import archerfish
from reference import oracle

COUNT = 200_001  # odd: WebAssembly goes by pairs, and one is left
#: One input in so many is any double at all: NaN, infinities, subnormals, nonsense.
ANYTHING = 20
HERE = Path(__file__).resolve().parent
WASM = HERE.parents[2] / "crates/archerfish-wasm/js"
NODE = shutil.which("node")

SETS = ["baseline", "avx2", "avx512"]
#: Those this machine has: up to the widest, which is the one in use unless the environment says
#: otherwise.
AVAILABLE = SETS[: SETS.index(archerfish.isa()) + 1]
UFUNCS = [name for name in archerfish.__all__ if isinstance(getattr(archerfish, name), np.ufunc)]


def columns(name):
    """Random and adversarial arguments of a ufunc; some of them no arguments at all."""
    drawn = oracle.FUNCTIONS[name].arguments
    rng = np.random.default_rng([2010, zlib.crc32(name.encode())])
    corners = np.array(drawn.corners, dtype=float).T
    inputs = np.concatenate([corners, drawn.draw(rng, COUNT - corners.shape[1])], axis=1)
    for column in inputs:
        column[::ANYTHING] = rng.integers(2**64, size=column[::ANYTHING].size, dtype="u8").view(
            "f8"
        )
    return inputs


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    place = tmp_path_factory.mktemp("columns")
    with np.errstate(all="ignore"):
        for name in UFUNCS:
            for k, column in enumerate(columns(name)):
                for element in ("float64", "float32"):
                    column.astype(element).tofile(place / f"{name}.{element}.{k}")
    return place


def printed(command, **environment):
    run = subprocess.run(
        command, env=os.environ | environment, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)


def natively(folder, isa):
    answer = printed([sys.executable, HERE / "digests.py", folder], ARCHERFISH_ISA=isa)
    assert answer["isa"] == isa
    return answer["digests"]


@pytest.fixture(scope="module")
def baseline(folder):
    digests = natively(folder, "baseline")
    assert len(digests) == 2 * len(UFUNCS)
    return digests


@pytest.mark.parametrize("isa", AVAILABLE[1:])
def test_instruction_sets_agree(folder, baseline, isa):
    assert natively(folder, isa) == baseline


@pytest.mark.parametrize("isa", AVAILABLE)
def test_company_makes_no_difference(folder, isa):
    answer = printed([sys.executable, HERE / "company.py", folder], ARCHERFISH_ISA=isa)
    assert answer == {"isa": isa, "compared": len(UFUNCS), "differing": []}


def test_typescript_knows_every_function():
    declared = re.findall(
        r'^ *\| "(\w+)"', (WASM / "kernels.d.ts").read_text("utf-8"), re.MULTILINE
    )
    assert sorted(declared) == sorted(UFUNCS)


# Without node nothing could run the other side, without rustup nothing builds it.
if NODE is not None and shutil.which("rustup") is not None:

    def test_webassembly_agrees(folder, baseline):
        module = WASM / "archerfish.wasm"
        assert module.exists(), "build it first: make wasm"
        answer = printed([NODE, HERE / "digests.mjs", WASM / "kernels.js", module, folder])
        assert answer["digests"] == baseline
        together = answer["together"]
        assert len(together) == 2 * 6
        assert together == {name: baseline[name] for name in together}

    def test_webassembly_is_small():
        assert (WASM / "archerfish.wasm").stat().st_size <= 60_000

    def test_webassembly_computes_no_quantity_with_another():
        """x, y and elevation of an apex leave out its curvature, which shares their first steps.

        Natively the compiler sees to that. Between functions it may be unable to: with a pointer to
        a function handed to the curvature, x took twice the time, the others half as much again.
        """
        most = {"apex_x": 0.8, "apex_y": 1.35, "apex_elevation": 1.6, "apex_curvature": 1.0}
        command = [NODE, HERE / "work.mjs", WASM / "kernels.js", WASM / "archerfish.wasm", *most]
        times = dict(zip(most, printed(command), strict=True))
        assert [name for name in most if times[name] > most[name]] == []

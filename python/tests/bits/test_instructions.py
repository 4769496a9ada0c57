"""What the compiler made of the kernels: vectors at full width, no fused arithmetic, no libm.

Same bits everywhere rests on the instructions: a fused multiply-add rounds once where the source
rounds twice, and each system's libm rounds in its own way. Speed rests on them too: a kernel that
the compiler leaves scalar is several times slower, and only the assembly tells.
"""

import platform
import re
import subprocess
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

import archerfish
from archerfish import _core

ROOT = Path(__file__).resolve().parents[3]
UFUNCS = [name for name in archerfish.__all__ if isinstance(getattr(archerfish, name), np.ufunc)]
#: The letter of the widest registers, and their share of all arithmetic that a vector loop beside a
#: scalar one for the last elements has at least. SSE2 lacks selection and 64-bit comparison, so
#: there a compiler may rightly keep a kernel mostly scalar.
WIDEST = {"baseline": ("x", 0.0), "avx2": ("y", 0.4), "avx512": ("z", 0.4)}
ARITHMETIC = re.compile(r"\tv?(?:add|sub|mul|div|sqrt)([sp])d .*?%([xyz])mm")
FUSED = re.compile(r"\tvfn?m(?:add|sub)")
CALL = re.compile(r"\tcall +(.*)")
#: What a kernel may call: itself, Rust's panics, and copies of memory.
HARMLESS = re.compile(r"<(?:archerfish::|core::|std::|mem(?:cpy|set|move)\b)")
#: What the package may take from the C library's mathematics, on processors other than x86-64.
FLAGS = {"fetestexcept", "feclearexcept", "feraiseexcept"}
LIBM = re.compile(
    r"a?(?:sin|cos|tan)h?f?|atan2f?|exp(?:2|10|m1)?f?|log(?:2|10|1p|b)?f?|pow[if]?|cbrtf?|hypotf?"
    r"|fmaf?|fmodf?|remainderf?|sqrtf?|(?:floor|ceil|trunc|l?l?rint|l?l?round|nearbyint)f?"
    r"|(?:ld|fr)expf?|scalbl?nf?|modff?|sincosf?|fe\w+except"
)


def output(*command):
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout


def test_package_asks_the_c_library_for_no_function():
    symbols = output("nm", "--dynamic", "--undefined-only", _core.__file__).split()
    names = {symbol.split("@")[0] for symbol in symbols}
    assert {name for name in names if LIBM.fullmatch(name)} <= FLAGS


# On other processors there is one instruction set alone, and other names for registers.
if platform.machine() in {"x86_64", "AMD64"}:

    def test_package_has_no_fused_arithmetic():
        assert not FUSED.search(output("objdump", "--disassemble", _core.__file__))

    @pytest.fixture(scope="module")
    def clones():
        """Assembly of the kernels by (name, instruction set).

        The package's own symbols are stripped; an example built from the same source in the same
        profile still has them.
        """
        output(
            *("cargo", "build", "--release", "--locked", "--quiet"),
            *("--package", "archerfish", "--example", "evaluate"),
        )
        text = output("objdump", "--disassemble", "--demangle", executable())
        found = {}
        for part in re.split(r"\n(?=[0-9a-f]+ <)", text):
            head = re.match(r"[0-9a-f]+ <archerfish::batch::(\w+)(?:::(avx2|avx512))?>:", part)
            if head:
                found[head[1], head[2] or "baseline"] = part
        return found

    def test_every_kernel_is_found(clones):
        assert {(name, isa) for name in UFUNCS for isa in WIDEST} <= set(clones)

    @pytest.mark.parametrize("isa", WIDEST)
    @pytest.mark.parametrize("name", UFUNCS)
    def test_kernel_fills_the_widest_registers(clones, name, isa):
        count = Counter(ARITHMETIC.findall(clones[name, isa]))
        register, share = WIDEST[isa]
        assert count["p", register] > share * count.total()

    @pytest.mark.parametrize("name", UFUNCS)
    def test_kernel_calls_nothing_that_computes(clones, name):
        for isa in WIDEST:
            assert not FUSED.search(clones[name, isa])
            called = CALL.findall(clones[name, isa])
            assert [target for target in called if not HARMLESS.search(target)] == []


def executable():
    metadata = output("cargo", "metadata", "--format-version=1", "--no-deps")
    folder = re.search(r'"target_directory":"([^"]+)"', metadata)
    assert folder is not None
    return Path(folder[1]) / "release/examples/evaluate"

"""What the compiler made of the kernels: vectors at full width, no libm, nothing fused but exactly.

Same bits everywhere rests on the instructions: a fused multiply-add rounds once where the source
rounds twice, unless it yields the rounding error of a product, which is a double, or the rest of a
quotient, which the source forms exactly until its last rounding; and each system's libm rounds in
its own way. Speed rests on them too: a kernel that the compiler leaves scalar is several times
slower, and only the assembly tells.
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
#: there a compiler may rightly keep a kernel mostly scalar. Blocks of twins have no last ones.
WIDEST = {"baseline": ("x", 0.0), "avx2": ("y", 0.4), "avx512": ("z", 0.4), "twins": ("z", 0.99)}
ARITHMETIC = re.compile(r"\tv?(?:add|sub|mul|div|sqrt)([sp])d .*?%([xyz])mm")
FUSED = re.compile(r"\tvf(?:n?madd|n?msub|maddsub|msubadd)")
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


INSTRUCTION = re.compile(r"\t([vk]\w+) +([^#\n]*?)(?: +# ([0-9a-f]+) <.*)?$", re.MULTILINE)
OPERAND = re.compile(r"[^,(]*\([^)]*\)[^,]*|[^,]+")
MOVED = re.compile(
    r"vmov[au]p[ds]|vmovdq[au]\d*|vbroadcasts[ds]|vpbroadcastq|vmovddup|vmovs[ds]|vmovq"
)
#: By the form of a fused instruction: which operands (destination last) are the factors.
FACTORS = {"132": (0, 2), "213": (1, 2), "231": (0, 1)}
FORM = re.compile(r"vf(n?)m(add|sub)(132|213|231)[ps]d")


def exact_transforms(assembly, register):
    """How many fused instructions compute ±(a b − p), p being a b as rounded, or what is left of c
    by ±(c − x y), x being a product or a quotient of c; and the others.

    Of those in registers of one letter: for the last elements of an array, where the compiler
    shuffles numbers of one element into a vector, the comparison of bits has to do.

    Every value gets a number when an instruction makes it, and keeps it through moves, memory and
    changes of sign, which are counted apart.
    """
    held, products, sources = {}, {}, {}
    count, others = 0, []
    for instruction in INSTRUCTION.finditer(assembly):
        mnemonic, text, constant = instruction.groups()
        wide = f"%{register}mm" in text
        places = [place(operand, constant) for operand in OPERAND.findall(text)]
        values = [held.get(where, (1, where)) for where in places]
        if wide and (form := FORM.fullmatch(mnemonic)):
            first, second = (values[k] for k in FACTORS[form[3]])
            (rest,) = (values[k] for k in {0, 1, 2} - set(FACTORS[form[3]]))
            sign = first[0] * second[0] * (-1 if form[1] else 1)
            rest_sign, factors = products.get(rest[1], (0, None))
            rest_sign *= rest[0] * (-1 if form[2] == "sub" else 1)
            error = factors == {first[1], second[1]} and sign == -rest_sign
            made_of = sources.get(first[1], set()) | sources.get(second[1], set())
            opposite = sign * rest[0] * (-1 if form[2] == "sub" else 1) < 0
            if error or (rest[1] in made_of and opposite):
                count += 1
            else:
                others.append(instruction[0])
        elif wide and FUSED.match(instruction[0]):
            others.append(instruction[0])
        made = (1, instruction.start())
        if MOVED.fullmatch(mnemonic) and len(values) == 2:
            made = values[0]
        elif re.fullmatch(r"vp?(?:xor|or|and)(?:p[sd]|[dq])?", mnemonic) and len(values) == 3:
            constants = [k for k in (0, 1) if str(values[k][1]).startswith("constant")]
            # the bit of the sign is what numbers are combined with, or all the others; a size
            # is the same number however it came about
            if len(constants) == 1:
                sign, number = values[1 - constants[0]]
                made = {
                    "x": (-sign, number),
                    "o": (-1, f"size of {number}"),
                    "a": (1, f"size of {number}"),
                }[mnemonic.removeprefix("v").removeprefix("p")[0]]
        elif mnemonic == "vblendvpd":
            made = selected(values[0][1], values[1], values[2]) or made
        if mask := re.search(r"{(%k\d)}", text):
            condition = held.get(mask[1], (1, mask[1]))[1]
            # kept where the condition fails: the second operand of a blend, else what was there
            kept = values[1] if mnemonic.startswith("vblendm") else values[-1]
            taken = values[0] if mnemonic.startswith("vblendm") else made
            made = None if "{z}" in text else selected(condition, taken, kept)
            made = made or (1, instruction.start())
        elif re.match(r"vmul[ps]d", mnemonic):
            (sign, number), (other_sign, other) = values[:2]
            products[made[1]] = (sign * other_sign, {number, other})
            sources[made[1]] = {number, other}
        elif re.match(r"vdiv[ps]d", mnemonic):
            sources[made[1]] = {values[1][1]}  # the numerator
        held[places[-1]] = made
    return count, others


def selected(condition, taken, kept):
    """Either of two values, where the sign is the same for both."""
    if taken[0] == kept[0]:
        return taken[0], f"({condition} ? {taken[1]} : {kept[1]})"
    return None


def place(operand, constant):
    """Where an operand stands, the same for a register's every width."""
    if register := re.match(r"%[xyz]mm(\d+)", operand):
        return f"register {register[1]}"
    return f"constant {constant}" if "%rip" in operand else operand.split("{")[0]


def output(*command):
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout


def test_package_asks_the_c_library_for_no_function():
    symbols = output("nm", "--dynamic", "--undefined-only", _core.__file__).split()
    names = {symbol.split("@")[0] for symbol in symbols}
    assert {name for name in names if LIBM.fullmatch(name)} <= FLAGS


# On other processors there is one instruction set alone, and other names for registers.
if platform.machine() in {"x86_64", "AMD64"}:

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
            head = re.match(
                r"[0-9a-f]+ <archerfish::batch::(\w+)(?:::(avx2|avx512|twins))?>:", part
            )
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
    def test_fused_arithmetic_is_exact_but_for_a_last_rounding(clones, name):
        assert not FUSED.search(clones[name, "baseline"])
        for isa in ("avx2", "avx512", "twins"):
            count, others = exact_transforms(clones[name, isa], WIDEST[isa][0])
            assert others == []
            assert count > 0

    @pytest.mark.parametrize("name", UFUNCS)
    def test_kernel_calls_nothing_that_computes(clones, name):
        for isa in WIDEST:
            called = CALL.findall(clones.get((name, isa), ""))
            assert [target for target in called if not HARMLESS.search(target)] == []


def executable():
    metadata = output("cargo", "metadata", "--format-version=1", "--no-deps")
    folder = re.search(r'"target_directory":"([^"]+)"', metadata)
    assert folder is not None
    return Path(folder[1]) / "release/examples/evaluate"

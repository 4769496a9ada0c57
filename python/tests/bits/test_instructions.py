"""What the compiler made of the kernels: vectors at full width, no libm, nothing fused but exactly.

Same bits everywhere rests on the instructions: a fused multiply-add rounds once where the source
rounds twice, unless it yields the rounding error of a product, which is a double, or the rest of a
quotient, which the source forms exactly until its last rounding; and each system's libm rounds in
its own way. Speed rests on them too: a kernel that the compiler leaves scalar is several times
slower, and only the assembly tells.
"""

import platform
import re
import struct
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
#: there a compiler may rightly keep a kernel mostly scalar. Whole blocks have no last ones.
WIDEST = {"baseline": ("x", 0.0), "avx2": ("y", 0.4), "avx512": ("z", 0.4)}
WIDEST |= {"twins_avx2": ("y", 0.99), "wides_avx512": ("z", 0.99)}
ARITHMETIC = re.compile(r"\tv?(?:add|sub|mul|div|sqrt)([sp])d .*?%([xyz])mm")
FUSED = re.compile(r"\tvf(?:n?madd|n?msub|maddsub|msubadd)")
CLONE = r"[0-9a-f]+ <archerfish::batch::(\w+)(?:::((?:twins_|wides_)?avx(?:2|512)))?>:"
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


def exact_transforms(assembly, register, number_at):
    """How many fused instructions compute ±(a b − p), p being a b as rounded, or what is left of c
    by ±(c − x y), x being a product, a quotient or a root of c; and the others.

    p may have been rounded as a part of 1 + a b or 2 + a b, which is taken away again: then a sum
    of two numbers is what is left of.

    Of those in registers of one letter: for the last elements of an array, where the compiler
    shuffles numbers of one element into a vector, the comparison of bits has to do.

    Every value gets a number when an instruction makes it, and keeps it through moves, memory and
    changes of sign, which are counted apart.
    """
    held, products, sources, sums = {}, {}, {}, {}
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
        elif re.match(r"vsqrt[ps]d", mnemonic):
            sources[made[1]] = {values[0][1]}
        elif wide and (form := re.match(r"v(add|sub)[ps]d", mnemonic)):
            (subtracted, number), (sign, other) = values[:2]
            subtracted *= 1 if form[1] == "add" else -1
            for (s, term), (c, constant) in (
                ((subtracted, number), (sign, other)),
                ((sign, other), (subtracted, number)),
            ):
                if str(constant).startswith("constant") and (term in products or term in sums):
                    of, total = sums.get(term, ((1, term), 0.0))
                    of, total = (s * of[0], of[1]), s * total + c * number_at(constant)
                    sums[made[1]] = of, total
                    if total == 0:
                        products[made[1]] = (of[0] * products[of[1]][0], products[of[1]][1])
        held[places[-1]] = made
    return count, others


def numbers_of(path):
    """What double a constant's address in an ELF file stands for."""
    content = Path(path).read_bytes()
    start, size, count = (
        *struct.unpack_from("<Q", content, 32),
        *struct.unpack_from("<HH", content, 54),
    )
    segments = [struct.unpack_from("<IIQQQQ", content, start + k * size) for k in range(count)]

    def number_at(constant):
        address = int(constant.removeprefix("constant "), 16)
        for kind, _, offset, virtual, _, length in segments:
            if kind == 1 and virtual <= address < virtual + length:
                return struct.unpack_from("<d", content, offset + address - virtual)[0]
        raise LookupError(constant)

    return number_at


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
    def binary():
        """The package's own symbols are stripped; an example built from the same source in the same
        profile still has them."""
        output(
            *("cargo", "build", "--release", "--locked", "--quiet"),
            *("--package", "archerfish", "--example", "evaluate"),
        )
        return executable()

    @pytest.fixture(scope="module")
    def clones(binary):
        """Assembly of the kernels by (name, instruction set)."""
        text = output("objdump", "--disassemble", "--demangle", binary)
        found = {}
        for part in re.split(r"\n(?=[0-9a-f]+ <)", text):
            head = re.match(CLONE, part)
            if head:
                found[head[1], head[2] or "baseline"] = part
        return found

    @pytest.fixture(scope="module")
    def numbers(binary):
        return numbers_of(binary)

    def test_every_kernel_is_found(clones):
        assert {(name, isa) for name in UFUNCS for isa in WIDEST} <= set(clones)

    @pytest.mark.parametrize("isa", WIDEST)
    @pytest.mark.parametrize("name", UFUNCS)
    def test_kernel_fills_the_widest_registers(clones, name, isa):
        count = Counter(ARITHMETIC.findall(clones[name, isa]))
        register, share = WIDEST[isa]
        assert count["p", register] > share * count.total()

    @pytest.mark.parametrize("name", UFUNCS)
    def test_fused_arithmetic_is_exact_but_for_a_last_rounding(clones, numbers, name):
        assert not FUSED.search(clones[name, "baseline"])
        for isa in ("avx2", "avx512", "twins_avx2", "wides_avx512"):
            count, others = exact_transforms(clones[name, isa], WIDEST[isa][0], numbers)
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

"""What a kernel costs by counting: instructions of its AVX-512 loop, and a prediction.

    python -m bench.operations              # every kernel
    python -m bench.operations log1pmx      # some

Counts are of one vector of eight doubles; what single precision does for two vectors at once
counts half. The model is a Zen 4 core, by its measured peaks: one addition and one multiplication
a cycle, two vector instructions of any kind, a division every 9 and a square root every 16 cycles,
which also hold the multiplier for 3 and 4. A prediction is what the busiest of these needs; what is
measured beyond it is waiting for results (bench/NOTES.md).
"""

import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
#: Cycles that np.log takes for eight doubles on that machine.
LOG = 23
#: What is counted, by mnemonic, in this order: the first that fits.
KINDS = {
    "add": r"v(?:add|sub)p[ds]",
    "mul": r"vmulp[ds]",
    "fused": r"vf",
    "div": r"vdivp[ds]",
    "sqrt": r"vsqrtp[ds]",
    "move": r"vmov[au]p[ds]|vmovdq",
    "other": r"v",
}


def run(*command):
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout


def disassembly():
    """Functions of the release build, by name: addresses and instructions."""
    package = ("--package", "archerfish", "--example", "evaluate")
    run("cargo", "build", "--release", "--locked", "--quiet", *package)
    metadata = json.loads(run("cargo", "metadata", "--format-version=1", "--no-deps"))
    binary = Path(metadata["target_directory"]) / "release/examples/evaluate"
    text = run("objdump", "--disassemble", "--demangle", "--no-show-raw-insn", str(binary))
    for part in re.split(r"\n(?=[0-9a-f]+ <)", text):
        if name := re.match(r"[0-9a-f]+ <archerfish::batch::(\w+)::wides_avx512>:", part):
            yield name[1], re.findall(r"^\s*([0-9a-f]+):\t(.*)$", part, re.MULTILINE)


def main_loop(lines):
    """The loop with the most instructions on the widest registers."""
    position = {address: i for i, (address, _) in enumerate(lines)}
    loops = [
        [text for _, text in lines[position[target[1]] : i + 1]]
        for i, (_, jump) in enumerate(lines)
        if (target := re.match(r"j\w+\s+([0-9a-f]+)", jump)) and position.get(target[1], i) < i
    ]
    return max(loops, key=lambda loop: sum("zmm" in text for text in loop))


def count(loop):
    """Instructions of each kind for one vector."""
    counts = dict.fromkeys(KINDS, 0)
    for text in loop:
        if "zmm" in text:
            counts[next(kind for kind, form in KINDS.items() if re.match(form, text))] += 1
    # as many vectors in flight as the loop stores
    stores = sum(bool(re.match(r"vmovup[ds]\s+%zmm\d+,.*\(%r(?!sp)", text)) for text in loop)
    return {kind: number / max(stores, 1) for kind, number in counts.items()}


def cycles(n):
    """Cycles that the busiest unit needs."""
    every = n["add"] + n["mul"] + n["fused"] + n["other"] + 3 * n["div"] + 4 * n["sqrt"]
    multiplier = n["mul"] + n["fused"] + 3 * n["div"] + 4 * n["sqrt"]
    return max(n["add"], multiplier, every / 2, 9 * n["div"] + 16 * n["sqrt"])


def main(names):
    print(f"{'kernel':24}" + "".join(f"{kind:>7}" for kind in KINDS) + "  cycles  in np.log")
    for name, lines in sorted(disassembly()):
        if not names or name in names:
            n = count(main_loop(lines))
            numbers = "".join(f"{number:7.0f}" for number in n.values())
            print(f"{name:24}{numbers}{cycles(n):8.0f}{cycles(n) / LOG:10.1f}")


if __name__ == "__main__":
    main(sys.argv[1:])

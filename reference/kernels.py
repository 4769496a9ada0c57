"""The crate's functions on NumPy arrays, through `crates/archerfish/examples/evaluate.rs`."""

import json
import subprocess
from functools import cache
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent


@cache
def binary() -> str:
    """Build the example and answer where cargo put it.

    In the profile that `cargo test` builds it in as well; every profile gives the same bits.
    """
    command = [
        "cargo",
        "build",
        "--profile",
        "test",
        "--quiet",
        "--package",
        "archerfish",
        "--example",
        "evaluate",
    ]
    done = subprocess.run(
        [*command, "--message-format=json"], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True
    )
    messages = [json.loads(line) for line in done.stdout.splitlines()]
    return next(m["executable"] for m in messages if m.get("executable"))


def evaluate(name: str, *arguments: np.ndarray) -> np.ndarray:
    interleaved = np.stack([np.asarray(a, "<f8") for a in arguments], axis=-1)
    done = subprocess.run(
        [binary(), name], input=interleaved.tobytes(), check=True, stdout=subprocess.PIPE
    )
    return np.frombuffer(done.stdout, "<f8").astype(float)

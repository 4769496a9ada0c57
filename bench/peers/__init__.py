"""Lambert W of other languages, compiled here and called on arrays."""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Function = Callable[[Array, Array], object]

HERE = Path(__file__).resolve().parent
BUILT = HERE.parent.parent / "target" / "bench"
NAMES = ("lambertw0", "lambertwm1")


def libraries(say: Callable[[str], object] = print) -> dict[str, dict[str, Function]]:
    """Return the functions of each peer that can be compiled here; say which cannot, and why."""
    found = {}
    for peer, compiled, wanting in (
        ("lambert_w", lambert_w, "its crate cannot be built here"),
        (
            "Boost.Math",
            boost,
            "its headers are not here (Debian: apt-get install libboost-math-dev)",
        ),
    ):
        try:
            library = ctypes.CDLL(str(compiled()))
        except (subprocess.CalledProcessError, OSError):
            say(f"left out: {peer}: {wanting}")
        else:
            found[peer] = {name: caller(getattr(library, name)) for name in NAMES}
    return found


def lambert_w() -> Path:
    """Build the lambert_w crate as a C library."""
    manifest = HERE / "lambert_w" / "Cargo.toml"
    command = ["cargo", "build", "--release", "--locked", "--quiet", "--manifest-path", manifest]
    run([*command, "--target-dir", BUILT], {"RUSTFLAGS": "-C target-cpu=native"})
    return next((BUILT / "release").glob("*lambert_w_peer.*[!d]"))


def boost() -> Path:
    """Build Boost.Math's functions as a C library."""
    library = BUILT / "boost.so"
    BUILT.mkdir(parents=True, exist_ok=True)
    compiler = shutil.which("c++") or "c++"
    options = ["-std=c++17", "-O3", "-march=native", "-shared", "-fPIC"]
    run([compiler, *options, HERE / "boost.cpp", "-o", library])
    return library


def run(command: list[str | Path], environment: dict[str, str] | None = None) -> None:
    """Run a compiler; what it has to say matters only as failure."""
    subprocess.run(command, check=True, capture_output=True, env=os.environ | (environment or {}))


def caller(function: Callable[..., object]) -> Function:
    """Return a C function of (arguments, results, count) as one of two arrays."""
    pointer = ctypes.POINTER(ctypes.c_double)

    def call(z: Array, out: Array) -> object:
        return function(
            z.ctypes.data_as(pointer), out.ctypes.data_as(pointer), ctypes.c_size_t(z.size)
        )

    return call

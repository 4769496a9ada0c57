"""What mypy --strict makes of user code. Never run: `make lint` has mypy check every line."""

from typing import Any, assert_type

import numpy as np
import pandas as pd
from numpy.typing import NDArray

import archerfish
from archerfish import ApexLocus, Launcher

f64: NDArray[np.float64] = np.zeros(3)
f32: NDArray[np.float32] = np.zeros(3, np.float32)
whole: NDArray[np.int64] = np.zeros(3, np.int64)
series: pd.Series[float] = pd.Series([0.1, 0.2])

assert_type(archerfish.lambertw0(1.0), np.float64)
assert_type(archerfish.lambertw0(1), np.float64)
assert_type(archerfish.lambertw0(np.float64(1)), np.float64)
assert_type(archerfish.lambertw0(np.float32(1)), np.float32)
assert_type(archerfish.lambertw0(f64), NDArray[np.float64])
assert_type(archerfish.lambertw0(f32), NDArray[np.float32])
assert_type(archerfish.lambertw0(whole), NDArray[np.floating[Any]])
assert_type(archerfish.lambertw0(f64, out=f32), NDArray[np.float32])
assert_type(archerfish.lambertw0(f64, f64, where=f64 > 0), NDArray[np.float64])
assert_type(archerfish.lambertw0(series), "pd.Series[float]")

assert_type(archerfish.apex_x(1.0, 0), np.float64)
assert_type(archerfish.apex_x(f64, 0.1), NDArray[np.float64])
assert_type(archerfish.apex_x(0.5, f64), NDArray[np.float64])
assert_type(archerfish.apex_x(f64, f64), NDArray[np.float64])
assert_type(archerfish.apex_x(f64, f32), NDArray[np.float64])
assert_type(archerfish.apex_x(f32, f64), NDArray[np.float64])
assert_type(archerfish.apex_x(f32, 0.1), NDArray[np.float32])
assert_type(archerfish.apex_x(f32, f32), NDArray[np.float32])
assert_type(archerfish.apex_x(f64, 0.1, out=f64), NDArray[np.float64])
assert_type(archerfish.apex_x(series, 0.1), "pd.Series[float]")

# A list, or an option: an array or a number, as with NumPy's own ufuncs.
archerfish.apex_x([0.1, 0.2], 0.1)
archerfish.apex_x(f64, 0.1, where=f64 > 0, dtype=np.float64)
archerfish.apex_x.outer(f64, f64)
assert_type(archerfish.apex_x.nin, int)

# Mistakes are found: under --strict an `ignore` that hides nothing is an error itself.
archerfish.apex_x(0.5)  # type: ignore[call-overload]
archerfish.apex_x(0.5, 0.1, wher=True)  # type: ignore[call-overload]
archerfish.lambertw0(1.0, 2.0, 3.0)  # type: ignore[call-overload]

assert_type(Launcher(10.0, epsilon=0.1).locus, ApexLocus)
assert_type(archerfish.isa(), str)

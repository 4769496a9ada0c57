"""Prints, as JSON, which ufuncs give an element other bits alone than in blocks of its like.

``python company.py FOLDER``, under the instruction set that ``ARCHERFISH_ISA`` names, with columns
as for `digests.py`. In a short array an element goes through the plain loop, in a long one through
blocks, and through the ordinary part where all its company does.
"""

import json
import sys
from pathlib import Path

import numpy as np

import archerfish

#: The longest block (wide.rs), less than SHORT (twins.rs), and short arrays of that.
BLOCK, FEW, ARRAYS = 32, 200, 333


def is_the_same(folder: Path, name: str) -> bool:
    ufunc = getattr(archerfish, name)
    columns = [np.fromfile(folder / f"{name}.float64.{k}") for k in range(ufunc.nin)]
    inputs = np.array(columns)[:, : FEW * ARRAYS]
    with np.errstate(all="ignore"):
        alone = [ufunc(*part.T) for part in np.split(inputs.T, ARRAYS)]
        in_blocks = ufunc(*np.repeat(inputs, BLOCK, axis=1)).reshape(-1, BLOCK)
    expected = np.repeat(np.concatenate(alone)[:, None], BLOCK, axis=1)
    return np.array_equal(in_blocks.view("u8"), expected.view("u8"))


if __name__ == "__main__":
    place = Path(sys.argv[1])
    names = sorted({path.name.split(".")[0] for path in place.iterdir()})
    differing = [name for name in names if not is_the_same(place, name)]
    print(json.dumps({"isa": archerfish.isa(), "compared": len(names), "differing": differing}))

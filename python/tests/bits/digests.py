"""Prints, as JSON, the SHA-256 of what each ufunc makes of the columns in a folder.

``python digests.py FOLDER``, under the instruction set that ``ARCHERFISH_ISA`` names. Columns lie
in files ``NAME.TYPE.NUMBER``; `digests.mjs` does the same with the WebAssembly build.
"""

import hashlib
import json
import sys
from pathlib import Path

import numpy as np

import archerfish


def digest(folder: Path, name: str, element: str) -> str:
    ufunc = getattr(archerfish, name)
    columns = [np.fromfile(folder / f"{name}.{element}.{k}", element) for k in range(ufunc.nin)]
    with np.errstate(all="ignore"):
        values = ufunc(*columns)
    assert values.dtype == element
    return hashlib.sha256(values.tobytes()).hexdigest()


if __name__ == "__main__":
    place = Path(sys.argv[1])
    names = sorted({path.name.split(".")[0] for path in place.iterdir()})
    digests = {
        f"{name} {element}": digest(place, name, element)
        for name in names
        for element in ("float64", "float32")
    }
    print(json.dumps({"isa": archerfish.isa(), "digests": digests}))

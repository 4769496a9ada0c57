"""``python -m archerfish.figures DIR``: every figure as PNG and SVG, captions as text."""

from __future__ import annotations

import sys
from pathlib import Path

from archerfish.files import write_whole

from .registry import FIGURES
from .save import caption, save


def main(arguments: list[str]) -> int:
    """Draw every figure into a folder, made if it is not there; return the exit status."""
    if len(arguments) != 1 or arguments[0].startswith("-"):
        print("usage: python -m archerfish.figures DIR", file=sys.stderr)
        return 2
    folder = Path(arguments[0])
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for number in sorted(FIGURES):
            for suffix in (".svg", ".png"):
                print(save(number, folder / f"figure{number}{suffix}"))
            write_whole(folder / f"figure{number}.txt", f"{caption(number)}\n".encode())
    except (OSError, ImportError) as error:
        print(f"archerfish.figures: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

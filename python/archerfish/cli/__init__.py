"""The command line: `archerfish locus`, `archerfish figure`, `archerfish series`.

It reads flags, calls the package and writes text; it computes nothing. Angles are in degrees here.
"""

from archerfish.cli.app import main

__all__ = ["main"]

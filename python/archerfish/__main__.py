"""`python -m archerfish` is the command `archerfish`."""

from archerfish.cli import main

main()

"""Projectile motion under gravity and linear drag, right to the last digits."""

from archerfish import _core
from archerfish._core import *  # noqa: F403

__version__ = _core.__version__

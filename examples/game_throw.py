"""A game character throws at many targets at once, over a crate and under a ceiling.

Engines that damp velocity have exactly the drag of this package: their damping is `drag_rate`, as
long as it is applied as exp(−damping × time step).

    python examples/game_throw.py
"""

import numpy as np

from archerfish import Launcher
from archerfish.aim import Aim

HAND = 1.6  # m above the floor
CRATE = (4.0, 2.2)  # m: how far away its near edge is, how high its top
CEILING = 5.0  # m


def main() -> dict[str, float]:
    """Print which throw takes each target; return how many are taken and the first angle."""
    character = Launcher(13.0, gravity=20.0, drag_rate=0.4)
    x = np.linspace(5.0, 9.0, 9)
    throws = character.aim(x, np.full(x.shape, 0.5), height=HAND)
    assert isinstance(throws, Aim)
    free = {
        name: (arc.clearance_over(*CRATE) > 0) & (arc.clearance_under(CEILING) > 0)
        for name, arc in (("low", throws.low), ("high", throws.high))
    }
    # The low throw is the quicker one: it goes first where it is free.
    angle = np.where(
        free["low"], throws.low.angle, np.where(free["high"], throws.high.angle, np.nan)
    )
    kinds = np.where(free["low"], "low", np.where(free["high"], "high", ""))
    for target, kind, degrees in zip(x, kinds, np.degrees(angle), strict=True):
        print(f"target at {target:.1f} m:", f"{kind} throw, {degrees:.2f}°" if kind else "none")
    return {"taken": float(np.sum(~np.isnan(angle))), "last": float(angle[~np.isnan(angle)][-1])}


if __name__ == "__main__":
    main()

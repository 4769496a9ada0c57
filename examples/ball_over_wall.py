"""A robot tosses a ball over a wall into a bin behind it.

The gentlest toss that clears the wall and comes down steeply enough is found among many speeds at
once; then it is asked how steady the hand must be.

    python examples/ball_over_wall.py
"""

import numpy as np

from archerfish import Launcher
from archerfish.aim import Aim

BIN, BIN_RADIUS = (2.0, 0.4), 0.12  # m: middle of the opening; half its width
WALL = (1.3, 1.25)  # m
HAND = 0.9  # m above the floor
MARGIN = 0.06  # m between the middle of the ball and the wall
STEEPEST = np.radians(-55.0)
TERMINAL_SPEED = 9.0  # m/s: a light ball


def main() -> dict[str, float]:
    """Print the toss and the spread of its landing point; return both."""
    speed = np.linspace(3.0, 7.0, 401)
    tosses = Launcher(speed, terminal_speed=TERMINAL_SPEED).aim(*BIN, height=HAND)
    assert isinstance(tosses, Aim)
    high = tosses.high
    good = (high.clearance_over(*WALL) >= MARGIN) & (high.impact_angle <= STEEPEST)
    gentlest = speed[good][0]

    aimed = Launcher(gentlest, terminal_speed=TERMINAL_SPEED).aim(*BIN, height=HAND)
    assert isinstance(aimed, Aim)
    toss = aimed.high
    spread = toss.shot.propagate(speed=0.03, angle=np.radians(0.5))
    print(f"toss at {gentlest:.2f} m/s and {np.degrees(toss.angle):.2f}°")
    print(f"over the wall by {100 * float(toss.clearance_over(*WALL)):.1f} cm")
    print(f"into the bin after {toss.time:.3f} s at {np.degrees(toss.impact_angle):.1f}°")
    print(
        f"lands within ±{100 * float(spread.range):.1f} cm; the bin forgives {100 * BIN_RADIUS} cm"
    )
    return {
        "speed": float(gentlest),
        "angle": float(toss.angle),
        "clearance": float(toss.clearance_over(*WALL)),
        "spread": float(spread.range),
    }


if __name__ == "__main__":
    main()

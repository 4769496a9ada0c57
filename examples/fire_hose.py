"""A fire hose aimed at a window, in wind from the side and from ahead.

The jet is modelled as drops with linear drag. Where must the nozzle point, how hard does the water
arrive, and what is the least pump speed that still reaches the window?

    python examples/fire_hose.py
"""

import numpy as np

from archerfish import Launcher
from archerfish.aim import Aim

WINDOW = (22.0, 9.0, 0.0)  # m: ahead, up, to the right
NOZZLE = 1.2  # m above the ground
WIND = (-4.0, 0.0, 6.0)  # m/s
DRAG_RATE = 0.25  # 1/s


def main() -> dict[str, float]:
    """Print both ways to aim the hose; return the flat one."""
    hose = Launcher(28.0, drag_rate=DRAG_RATE)
    aimed = hose.aim(*WINDOW, height=NOZZLE, wind=WIND)
    assert isinstance(aimed, Aim), f"the window is {aimed.margin:.1f} m too high"
    for name, arc in (("flat", aimed.low), ("steep", aimed.high)):
        print(
            f"{name:5}: elevation {np.degrees(arc.angle):5.1f}°, "
            f"azimuth {np.degrees(arc.azimuth):5.1f}°, "
            f"{arc.time:.2f} s, arrives at {arc.impact_speed:.1f} m/s"
        )
    still_air = hose.aim(*WINDOW, height=NOZZLE)
    assert isinstance(still_air, Aim)
    print(f"without wind: elevation {np.degrees(still_air.low.angle):.1f}°, azimuth 0°")
    print(f"least speed in this wind: {aimed.minimum_speed:.2f} m/s")
    return {
        "elevation": float(aimed.low.angle),
        "azimuth": float(aimed.low.azimuth),
        "impact_speed": float(aimed.low.impact_speed),
        "minimum_speed": float(aimed.minimum_speed),
    }


if __name__ == "__main__":
    main()

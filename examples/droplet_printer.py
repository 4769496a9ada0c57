"""A printer that shoots droplets straight down at paper, through a draught.

How far does the draught carry them, and how much do uneven launch speeds smear the dots?

    python examples/droplet_printer.py
"""

import numpy as np

from archerfish import Launcher

AIR_VISCOSITY, AIR_DENSITY = 1.81e-5, 1.2  # Pa s, kg/m³, at room temperature
INK_DENSITY = 1050.0  # kg/m³
GAP = 0.3e-3  # m, nozzle to paper
DRAUGHT = 0.2  # m/s, along the paper


def main() -> dict[str, float]:
    """Print where droplets of three sizes land; return it for the largest."""
    diameter = np.array([8e-6, 10e-6, 12e-6])
    launcher = Launcher.from_sphere(diameter, INK_DENSITY, AIR_VISCOSITY, AIR_DENSITY, 1.2)
    shot = launcher.shot(-np.pi / 2, height=GAP, wind=(DRAUGHT, 0.0))
    smear = shot.propagate(speed=0.05 * launcher.speed)
    landing = shot.landing
    print("diameter  Reynolds  flight     carried by the draught")
    columns = (diameter, launcher.reynolds_number, landing.time, landing.x, smear.range)
    rows = np.stack(np.broadcast_arrays(*columns), axis=-1)
    for d, number, time, x, spread in rows:
        print(
            f"{d * 1e6:5.0f} µm {number:8.2f}  {time * 1e3:6.3f} ms  "
            f"{x * 1e6:6.1f} ± {spread * 1e6:.1f} µm"
        )
    names = ("diameter", "reynolds_number", "time", "carried", "smear")
    return dict(zip(names, rows[-1].tolist(), strict=True))


if __name__ == "__main__":
    main()

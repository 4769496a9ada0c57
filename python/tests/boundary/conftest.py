"""Every ufunc by name, and numbers from inside its domain."""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt
import pytest

import archerfish

#: For mypy alone; some of its types exist in stubs only.
collect_ignore = ["typing_cases.py"]

ANGLE = (0.0, np.pi)
EPSILON = (0.0, 10.0)

#: Arguments of each ufunc, as the published table of names has them, and a stretch of each domain.
TABLE: dict[str, dict[str, tuple[float, float]]] = {
    "lambertw0": {"z": (-0.36, 10.0)},
    "lambertwm1": {"z": (-0.36, -1e-9)},
    "lambertw0_offset": {"d": (0.0, 10.0)},
    "lambertwm1_offset": {"d": (0.0, 0.36)},
    "tree": {"z": (-10.0, 0.36)},
    "log1pmx": {"x": (-0.99, 10.0)},
    "apex_x": {"alpha": ANGLE, "eps": EPSILON},
    "apex_y": {"alpha": ANGLE, "eps": EPSILON},
    "apex_time": {"alpha": ANGLE, "eps": EPSILON},
    "apex_distance": {"alpha": ANGLE, "eps": EPSILON},
    "apex_elevation": {"alpha": ANGLE, "eps": EPSILON},
    "apex_curvature": {"alpha": ANGLE, "eps": EPSILON},
    "locus_launch_angle": {"theta": ANGLE, "eps": EPSILON},
    "locus_launch_angle_d1": {"theta": ANGLE, "eps": EPSILON},
    "locus_launch_angle_d2": {"theta": ANGLE, "eps": EPSILON},
    "locus_radius": {"theta": ANGLE, "eps": EPSILON},
    "locus_curvature": {"theta": ANGLE, "eps": EPSILON},
    "flight_time": {"alpha": ANGLE, "eps": EPSILON},
    "flight_range": {"alpha": ANGLE, "eps": EPSILON},
    "flight_x": {"t": (0.0, 3.0), "alpha": (-6.0, 6.0), "eps": EPSILON},
    "flight_y": {"t": (0.0, 3.0), "alpha": (-6.0, 6.0), "eps": EPSILON},
    "trajectory_height": {"x": (0.0, 0.05), "alpha": (-1.0, 1.0), "eps": EPSILON},
    "optimal_angle": {"eps": EPSILON},
    "envelope_height": {"x": (-0.09, 0.09), "eps": EPSILON},
    "aim_low": {"x": (-0.09, 0.09), "y": (-1.0, -0.1), "eps": EPSILON},
    "aim_high": {"x": (-0.09, 0.09), "y": (-1.0, -0.1), "eps": EPSILON},
}

Array = npt.NDArray[np.float64]
Draw = Callable[..., list[Array]]


def one_by_one(ufunc: np.ufunc, *inputs: npt.ArrayLike) -> Array:
    """The oracle of these tests: the ufunc on one element after another, in plain Python."""
    broadcast = np.broadcast(*inputs)
    values = [ufunc(*(float(x) for x in element)) for element in broadcast]
    return np.array(values).reshape(broadcast.shape)


@pytest.fixture(params=TABLE)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def ufunc(name: str) -> np.ufunc:
    found = getattr(archerfish, name)
    assert isinstance(found, np.ufunc)
    return found


@pytest.fixture
def draw(name: str) -> Draw:
    """draw(shape): one array of that shape for each input, from the domain."""
    generator = np.random.default_rng(2010)

    def arrays(shape: int | tuple[int, ...]) -> list[Array]:
        return [generator.uniform(low, high, shape) for low, high in TABLE[name].values()]

    return arrays


@pytest.fixture
def elementwise(ufunc: np.ufunc) -> Callable[..., Array]:
    return lambda *inputs: one_by_one(ufunc, *inputs)


@pytest.fixture
def table() -> dict[str, dict[str, tuple[float, float]]]:
    return TABLE

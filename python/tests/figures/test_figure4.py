import numpy as np

from archerfish import apex_elevation
from archerfish.figures import figure4_data

# mathematics.md, section 8: ε, α and θ in degrees, greatest ρK.
GREATEST = np.array(
    [
        [0.0, 45.0, 26.5650511771, 8.0],
        [0.1, 43.7869703699, 26.1026334706, 8.4246013385226],
        [1.0, 35.9889139986, 22.7180004668, 12.298109766078],
        [10.0, 16.8599371883, 12.2048522798, 59.281577657409],
    ]
)


def test_greatest_curvature():
    data = figure4_data(GREATEST[:, 0])
    np.testing.assert_allclose(np.degrees(data.greatest_launch_angle), GREATEST[:, 1], rtol=3e-12)
    np.testing.assert_allclose(np.degrees(data.greatest_elevation), GREATEST[:, 2], rtol=3e-12)
    np.testing.assert_allclose(data.greatest, GREATEST[:, 3], rtol=5e-14)


def test_nothing_is_above_the_marker():
    data = figure4_data(points=20_001)
    for curve in (data.by_launch_angle, data.by_elevation):
        excess = curve.max(axis=1) / data.greatest - 1.0
        assert np.all(excess < 1e-14)
        assert np.all(excess > -1e-6)


def test_ends_are_1_and_1_plus_epsilon():
    data = figure4_data()
    for curve in (data.by_launch_angle, data.by_elevation):
        np.testing.assert_allclose(curve[:, 0], 1.0, rtol=1e-14)
        np.testing.assert_allclose(curve[:, -1], 1.0 + data.epsilon, rtol=1e-14)


def test_both_panels_show_one_curve():
    """The curvature is a property of the point: panel (b) is panel (a) with the abscissa moved."""
    data = figure4_data([1.0], points=5001)
    theta = apex_elevation(data.angle, 1.0)
    moved = np.interp(theta, data.angle, data.by_elevation[0])
    np.testing.assert_allclose(moved, data.by_launch_angle[0], rtol=1e-5)

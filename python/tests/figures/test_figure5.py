import numpy as np
import pytest

from archerfish.figures import figure5_data
from archerfish.figures.trajectory import fall

# mathematics.md, section 8, degrees, at ε = 0, 0.1, 1, 10.
EPSILONS = [0.0, 0.1, 1.0, 10.0]
TABLE = {
    "greatest range": [45.0, 43.7096921819, 35.5896941068, 15.8287214478],
    r"greatest curvature, $\alpha$": [45.0, 43.7869703699, 35.9889139986, 16.8599371883],
    r"greatest curvature, $\theta$": [26.5650511771, 26.1026334706, 22.7180004668, 12.2048522798],
    "rightmost apex": [45.0, 44.0375634638, 38.172707627, 23.9642438],
    "farthest apex": [54.7356103172, 54.0365143493, 49.7491455747, 39.1265680437],
    "distance stops growing": [70.5287793655, 69.2844661792, 60.039409929, 26.7041359196],
}
TYPED_DIGITS = {"rightmost apex": 3e-9}


def test_every_named_angle_is_drawn():
    assert set(figure5_data([1.0, 2.0]).angles) == set(TABLE)


@pytest.mark.parametrize("name", TABLE)
def test_named_angles(name):
    tolerance = TYPED_DIGITS.get(name, 3e-12)
    data = figure5_data(EPSILONS[1:])
    np.testing.assert_allclose(np.degrees(data.angles[name]), TABLE[name][1:], rtol=tolerance)
    assert np.degrees(data.drag_free[name]) == pytest.approx(TABLE[name][0], rel=tolerance)


@pytest.mark.parametrize("epsilons", [[], [1.0], [1.0, 1.0], [0.0, 1.0]])
def test_refuses_what_no_axis_can_show(epsilons):
    with pytest.raises(ValueError, match="figure 5 needs at least 2 values of epsilon, all above"):
        figure5_data(epsilons)


def test_epsilons_may_come_in_any_order():
    np.testing.assert_array_equal(figure5_data([3.0, 1.0, 3.0]).epsilon, [1.0, 3.0])


def test_angles_fall_with_drag_from_their_limits():
    data = figure5_data()
    for name, angle in data.angles.items():
        assert np.all(np.diff(angle) < 0.0), name
        assert angle[0] == pytest.approx(data.drag_free[name], rel=1e-3)
        assert angle[0] < data.drag_free[name]


@pytest.mark.parametrize("epsilon", [0.1, 1.0, 10.0, 1000.0])
def test_distance_stops_growing_there(epsilon):
    """r·ṙ stays positive just below the angle and turns negative just above it."""
    critical = figure5_data([epsilon, 2.0 * epsilon]).angles["distance stops growing"][0]
    sigma = np.geomspace(0.3, 10.0 + 10.0 * epsilon, 400_001)

    def least(alpha):
        sine, kappa = np.sin(alpha), fall(epsilon * sigma)
        # r·ṙ (1 + u)²/σ, with the x, y, ẋ, ẏ of the trajectory module.
        return (np.cos(alpha) ** 2 + (sine - sigma) * (sine - sigma * kappa)).min()

    assert least(critical * (1.0 - 1e-6)) > 0.0
    assert least(critical * (1.0 + 1e-6)) < 0.0

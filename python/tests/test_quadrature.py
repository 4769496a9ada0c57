"""Quadrature on graded panels against integrals known in closed form."""

import numpy as np
import pytest

from archerfish.launcher import Launcher
from archerfish.quadrature import integral


@pytest.mark.parametrize("epsilon", [0.0, 5e-324, 1e-8, 1.0, 1e8, 1e300])
def test_a_feature_on_the_scale_of_one_over_epsilon(epsilon):
    # ∫₀^{π/2} dα / (1 + εα)² = (π/2) / (1 + επ/2)
    found = integral(
        lambda alpha, eps: 1 / (1 + eps * alpha) / (1 + eps * alpha), 0.0, np.pi / 2, epsilon
    )
    assert found == pytest.approx((np.pi / 2) / (1 + epsilon * np.pi / 2), rel=1e-14, abs=0)


def test_a_bend_on_the_scale_of_one_over_its_root():
    # ∫₀^{π/2} √ε / (1 + εα²) dα = arctan(√ε π/2)
    eps = np.array([0.5, 1.0, 1e3, 1e10, 1e100])
    found = integral(lambda a, e: np.sqrt(e) / (1 + e * a * a), 0.0, np.pi / 2, eps)
    np.testing.assert_allclose(found, np.arctan(np.sqrt(eps) * np.pi / 2), rtol=3e-14)


@pytest.mark.parametrize("epsilon", [0.0, 5e-324, 1e-323, 1e-310, 1e-160, 1e-17])
def test_weak_drag_down_to_the_least_double_changes_nothing(epsilon):
    # Half the circumference of the drag-free ellipse: a peak at 45 degrees that wants its panels.
    found = Launcher(1.0, gravity=1.0, epsilon=epsilon).locus.arc_length()
    assert found == pytest.approx(1.2110560275684594, rel=1e-15, abs=0)


@pytest.mark.parametrize(("start", "stop"), [(0.0, np.pi), (0.3, 2.9), (2.0, 2.5), (2.5, 0.1)])
def test_any_part_of_the_half_turn_in_either_direction(start, stop):
    found = integral(lambda alpha, _: np.sin(alpha), start, stop, 3.0)
    assert found == pytest.approx(np.cos(start) - np.cos(stop), rel=1e-14, abs=0)


def test_what_an_element_gives_does_not_depend_on_its_neighbours():
    eps = np.concatenate([[0.0, 1e-310, 1e300], 10 ** np.linspace(-3, 6, 200)])
    locus = Launcher(1.0, gravity=1.0, epsilon=eps).locus
    lengths = locus.arc_length(0.3, 2.0)
    for index, each in enumerate(eps):
        alone = Launcher(1.0, gravity=1.0, epsilon=each).locus
        assert alone.area == locus.area[index]
        assert alone.arc_length(0.3, 2.0) == lengths[index]


def test_an_empty_interval_is_zero_and_shapes_broadcast():
    found = integral(lambda a, _: np.cos(a), [[0.0], [1.0]], [1.0, 0.5, 0.0], [0.0, 1.0, 1e6])
    expected = np.sin([1.0, 0.5, 0.0]) - np.sin([[0.0], [1.0]])
    np.testing.assert_allclose(found, expected, rtol=1e-14)
    assert found[1, 0] == 0.0

import numpy as np
import pytest

from archerfish.figures import figure6_data


@pytest.fixture(scope="module")
def data():
    return figure6_data()


def test_exact_series_converges_inside_its_radius_only(data):
    for index, radius in enumerate(data.radius["exact"]):
        inside = (data.argument > 0.3 * radius) & (data.argument < 0.8 * radius)
        outside = data.argument > 1.6 * radius
        low, middle, high = data.error["exact"][index]
        assert np.all(high[inside] < middle[inside])
        assert np.all(middle[inside] < low[inside])
        assert np.all(high[outside] > middle[outside])
        assert np.all(middle[outside] > low[outside])


def test_the_papers_series_keeps_the_error_of_equation_16(data):
    """It differs from the exact one by (2/9 − 7/18) ε² T³ at least, whatever the order."""
    small = data.argument < 0.05
    for index, epsilon in enumerate(data.epsilon):
        for error in data.error["paper"][index][:, small]:
            expected = epsilon**2 * data.argument[small] ** 3 / 6.0
            np.testing.assert_allclose(error, expected, rtol=0.35)


def test_no_radius_exceeds_1(data):
    for radius in data.radius.values():
        assert np.all((radius > 0.0) & (radius <= 1.0))


@pytest.mark.parametrize("epsilons", [(), (1.0,) * 5])
def test_refuses_more_panels_than_fit(epsilons):
    with pytest.raises(ValueError, match=f"from 1 to 4 values of epsilon, got {len(epsilons)}"):
        figure6_data(epsilons)


def test_refuses_more_orders_than_dashes():
    with pytest.raises(ValueError, match="at most 3 orders, got 4"):
        figure6_data(orders=(2, 4, 6, 8))

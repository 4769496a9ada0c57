"""The series (16), (17): coefficients, values, and where they converge."""

from fractions import Fraction

import flint
import numpy as np
import pytest

from archerfish import locus_launch_angle
from archerfish.series import convergence_data, exact_series, paper_series, radius

#: Coefficients of T², T³, … as {power of ε: number}; T⁴ of the paper is its own equation (17).
KNOWN = {
    paper_series: [
        {1: Fraction(-1, 3)},
        {2: Fraction(2, 9)},
        {1: Fraction(27, 54), 3: Fraction(-10, 54)},
        {2: Fraction(-54, 81), 4: Fraction(14, 81)},
        {1: Fraction(-405, 648), 3: Fraction(560, 648), 5: Fraction(-112, 648)},
    ],
    exact_series: [
        {1: Fraction(-1, 3)},
        {2: Fraction(7, 18)},
        {1: Fraction(135, 270), 3: Fraction(-152, 270)},
        {2: Fraction(-1620, 1620), 4: Fraction(1477, 1620)},
        {1: Fraction(-2835, 4536), 3: Fraction(9464, 4536), 5: Fraction(-7174, 4536)},
    ],
}


@pytest.mark.parametrize("make", KNOWN)
def test_coefficients_to_order_6(make):
    rows = make(6).coefficients
    assert rows[0] == rows[1] == ()
    for row, known in zip(rows[2:], KNOWN[make], strict=True):
        assert {j: number for j, number in enumerate(row) if number} == known


def reverted(make, epsilon, order):
    """The same coefficients at one rational ε by another library, from (16) or (10) as written."""
    cap = flint.ctx.cap
    flint.ctx.cap = order + 4
    try:
        alpha, eps = flint.fmpq_series([0, 1]), flint.fmpq(epsilon.numerator, epsilon.denominator)
        u = eps * alpha.sin()
        if make is paper_series:
            doubled = alpha.tan() * (1 + u / 3)
        else:
            # Dividing by u² and by sin α cos α costs three orders, which the cap has in hand.
            doubled = 2 * (u - (1 + u).log()) * (1 + u) / u / u * alpha.tan()
        series = doubled.reversion() - alpha.atan()
        return [Fraction(int(series[k].p), int(series[k].q)) for k in range(order + 1)]
    finally:
        flint.ctx.cap = cap


@pytest.mark.parametrize("make", KNOWN)
@pytest.mark.parametrize("epsilon", [Fraction(1, 8), Fraction(3), Fraction(-2)])
def test_every_coefficient_to_order_18_against_another_library(make, epsilon):
    expected = reverted(make, epsilon, 18)
    rows = make().coefficients
    assert len(rows) == 19
    found = [
        sum((number * epsilon**j for j, number in enumerate(row)), Fraction(0)) for row in rows
    ]
    assert found == expected


def test_coefficients_at_are_exact():
    at = exact_series(4).coefficients_at(0.1)
    assert at[4] == Fraction(0.1) * (135 - 152 * Fraction(0.1) ** 2) / 270
    assert at[:2] == [0, 0]


def test_a_lower_order_is_a_prefix():
    assert exact_series(18).coefficients[:10] == exact_series(9).coefficients


@pytest.mark.parametrize("epsilon", [0.0, 0.1, 0.5])
def test_the_exact_series_is_the_launch_angle_where_it_converges(epsilon):
    theta = np.radians([0.0, 1.0, 3.0, 5.0])
    found = exact_series().launch_angle(theta, epsilon)
    np.testing.assert_allclose(found, locus_launch_angle(theta, epsilon), rtol=1e-13)


def test_the_papers_series_converges_to_the_angle_of_equation_16():
    theta, epsilon = 0.1, 0.5
    alpha = float(paper_series().launch_angle(theta, epsilon))
    assert np.tan(alpha) / 2 * (1 + epsilon / 3 * np.sin(alpha)) == pytest.approx(np.tan(theta))
    # which the true one is not:
    assert abs(alpha - locus_launch_angle(theta, epsilon)) > 1e-4


@pytest.mark.parametrize("make", KNOWN)
@pytest.mark.parametrize("epsilon", [0.1, 0.6, 0.87, 1.0, 2.0, 3.0, 10.0, 1e3])
def test_radius_against_the_growth_of_120_coefficients(make, epsilon):
    # |aₖ| ~ C R^{−k} k^{−3/2} at a square-root branch point; the greatest of a few, since they
    # swing in sign. Sharper than a hundredth only where no two branch points are close.
    numbers = reverted(make, Fraction(epsilon), 120)
    logs = np.array([flint_log(abs(number)) for number in numbers])
    k = np.arange(60, 121)
    greatest = [max(logs[i - 6 : i + 1]) + 1.5 * np.log(i) for i in k]
    slope = np.polyfit(k, greatest, 1)[0]
    assert radius(make().of, epsilon) == pytest.approx(np.exp(-slope), rel=0.01)


def flint_log(number):
    if number == 0:
        return -np.inf
    return float(flint.arb(flint.fmpq(number.numerator, number.denominator)).log())


@pytest.mark.parametrize("of", ["paper", "exact"])
def test_radius_falls_from_1_and_is_infinite_without_drag(of):
    assert radius(of, 0.0) == np.inf
    epsilons = np.logspace(-9, 3, 60)
    radii = np.array([radius(of, float(eps)) for eps in epsilons])
    assert np.all(radii < 1)
    # The exact one rises a little, by a hundredth, from ε = 0.6 to 0.87.
    assert np.all(np.diff(radii) < (0 if of == "paper" else 0.01))
    # Near ε = 0 both follow 1 − (3/4)(ε/3)^{2/3}: the turns lie at s³ = 3/ε.
    np.testing.assert_allclose(1 - radii[:20], 0.75 * (epsilons[:20] / 3) ** (2 / 3), rtol=0.02)


def test_convergence_data():
    data = convergence_data([0.1, 1.0], orders=(6, 18))
    assert data.epsilon.tolist() == [0.1, 1.0]
    assert data.launch_angle.shape == (2, 181)
    for of in ("paper", "exact"):
        assert data.error[of].shape == (2, 2, 181)
        assert data.radius[of].tolist() == [radius(of, 0.1), radius(of, 1.0)]
        np.testing.assert_allclose(2 * np.tan(data.limit(of)), data.radius[of])
    for row, limit in zip(np.abs(data.error["exact"]), data.limit("exact"), strict=True):
        six, eighteen = row
        inside = (data.elevation > 0.3 * limit) & (data.elevation < 0.9 * limit)
        outside = data.elevation > 1.2 * limit
        assert inside.sum() > 20
        assert outside.sum() > 20
        assert np.all(eighteen[inside] < six[inside])
        assert np.all(eighteen[outside] > six[outside])


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: paper_series(0), "order must be from 1 to 40, got 0"),
        (lambda: exact_series(41), "order must be from 1 to 40, got 41"),
        (
            lambda: exact_series(6).launch_angle(0.1, 0.1, order=7),
            "order must be from 1 to 6, got 7",
        ),
        (lambda: radius("paper", -1.0), "epsilon must be at least 0 and finite, got -1.0"),
        (lambda: convergence_data([-1.0]), "epsilon must be at least 0 and finite, got -1.0"),
    ],
)
def test_refusals(call, message):
    with pytest.raises(ValueError) as refusal:  # noqa: PT011
        call()
    assert str(refusal.value) == message

"""Named angles against the definition each of them has, solved in 60 digits and more."""

import mpmath as mp
import numpy as np
import pytest

from archerfish import named_angles as named

EPSILONS = [0.0, 1e-12, 1e-3, 0.1, 1.0, 3.0, 10.0, 1e3, 1e8, 1e30]

#: Degrees at ε = 0, 0.1, 1, 10.
KNOWN = {
    named.greatest_range_angle: [45, 43.7096921819, 35.5896941068, 15.8287214478],
    named.greatest_curvature_angle: [45, 43.7869703699, 35.9889139986, 16.8599371883],
    named.rightmost_angle: [45, 44.0375634638, 38.172707627, 23.9642438],
    named.farthest_angle: [54.7356103172, 54.0365143493, 49.7491455747, 39.1265680437],
    named.receding_angle: [70.5287793655, 69.2844661792, 60.039409929, 26.7041359196],
}


@pytest.fixture(autouse=True)
def digits():
    with mp.workdps(150):
        yield


def apex(alpha, eps):
    """x and y of the apex as the equation of motion gives them: where ẏ = 0."""
    s, c, eps = mp.sin(alpha), mp.cos(alpha), mp.mpf(eps)
    if eps == 0:
        return s * c, s * s / 2
    # ẏ = (s + 1/ε) e^{−εt} − 1/ε vanishes at t.
    t = mp.log1p(eps * s) / eps
    return c * (1 - mp.exp(-eps * t)) / eps, (s + 1 / eps) * (1 - mp.exp(-eps * t)) / eps - t / eps


def derivative(function, alpha, order=1):
    """By central differences in 150 digits: 30 right ones at least."""
    return mp.diff(function, alpha, order, h=alpha * mp.mpf(10) ** -40)


def log_curvature(alpha, eps):
    x, x1, x2 = (derivative(lambda a: apex(a, eps)[0], alpha, n) for n in range(3))
    y1, y2 = (derivative(lambda a: apex(a, eps)[1], alpha, n) for n in (1, 2))
    del x
    return mp.log((x1 * y2 - y1 * x2) / (x1 * x1 + y1 * y1) ** mp.mpf(1.5))


def x_slope(alpha, eps):
    return derivative(lambda a: apex(a, eps)[0], alpha)


def distance_slope(alpha, eps):
    return derivative(lambda a: mp.hypot(*apex(a, eps)), alpha)


def curvature_slope(alpha, eps):
    return derivative(lambda a: log_curvature(a, eps), alpha)


def test_receding_angle_at_overwhelming_drag():
    # sin α = (1 + 2 ln ε)/ε, up to terms that vanish as ln(ln ε)/ln ε.
    eps = 1e290
    assert named.receding_angle(eps) * eps == pytest.approx(1 + 2 * np.log(eps), rel=0.01, abs=0)


@pytest.mark.parametrize("eps", EPSILONS)
@pytest.mark.parametrize(
    ("angle", "slope", "ulps"),
    [
        (named.rightmost_angle, x_slope, 4),
        (named.farthest_angle, distance_slope, 6),
        (named.greatest_curvature_angle, curvature_slope, 6),
    ],
)
def test_the_slope_changes_sign_within_a_few_ulp(angle, slope, ulps, eps):
    alpha = angle(eps)
    before = mp.mpf(alpha) * (1 - ulps * mp.mpf(2) ** -53)
    after = mp.mpf(alpha) * (1 + ulps * mp.mpf(2) ** -53)
    assert slope(before, eps) > 0 > slope(after, eps)


@pytest.mark.parametrize("eps", [1e-3, 0.1, 1.0, 10.0, 1e6])
def test_at_the_greatest_range_launch_and_landing_are_perpendicular(eps):
    alpha = mp.mpf(named.greatest_range_angle(eps))
    s, c, eps = mp.sin(alpha), mp.cos(alpha), mp.mpf(eps)
    y = lambda t: (s + 1 / eps) * (1 - mp.exp(-eps * t)) / eps - t / eps  # noqa: E731
    flown = mp.findroot(
        y, (1 / eps, 2 * (s + 1 / eps)), solver="anderson", tol=1e-200, verify=False
    )
    down = (s + 1 / eps) * mp.exp(-eps * flown) - 1 / eps
    across = c * mp.exp(-eps * flown)
    # The cosine of the angle between the velocities.
    assert abs(c * across + s * down) / mp.hypot(across, down) < 1e-14


@pytest.mark.parametrize("eps", [0.0, 1e-3, 0.1, 1.0, 10.0, 1e4])
def test_beyond_the_receding_angle_a_shot_comes_nearer(eps):
    alpha = named.receding_angle(eps)
    time = (
        np.geomspace(1e-3, 3.0, 20001) if eps == 0 else np.geomspace(1e-3, 30.0, 20001) / (1 + eps)
    )

    def least_growth(angle):
        s, c = np.sin(angle), np.cos(angle)
        if eps == 0:
            x, y, vx, vy = c * time, s * time - time**2 / 2, c, s - time
        else:
            lost = -np.expm1(-eps * time) / eps
            x, y = c * lost, (s + 1 / eps) * lost - time / eps
            vx, vy = c * np.exp(-eps * time), (s + 1 / eps) * np.exp(-eps * time) - 1 / eps
        return np.min((x * vx + y * vy)[1:-1] / time[1:-1])

    assert least_growth(alpha - 1e-4) > 0 > least_growth(alpha + 1e-4)


@pytest.mark.parametrize(
    ("angle", "degrees"), KNOWN.items(), ids=lambda item: getattr(item, "__name__", "")
)
def test_known_digits(angle, degrees):
    found = np.degrees(angle([0.0, 0.1, 1.0, 10.0]))
    np.testing.assert_allclose(found, degrees, rtol=0, atol=0.51e-10)


@pytest.mark.parametrize("angle", KNOWN)
def test_shapes_and_refusals(angle):
    assert type(angle(0.5)) is float
    assert angle(np.ones((2, 3))).shape == (2, 3)
    with pytest.raises(ValueError, match=r"^epsilon must be at least 0 and finite, got -0\.1$"):
        angle(-0.1)


def test_greatest_range_at_overwhelming_drag():
    found = named.greatest_range_angle([1e150, 1e300])
    expected = [2 * np.log(1e150) / 1e150, 2 * np.log(1e300) / 1e300]
    np.testing.assert_allclose(found, expected, rtol=0.02)


@pytest.mark.parametrize("angle", KNOWN)
def test_falling_with_drag_from_the_first_to_the_greatest(angle):
    alpha = angle(np.concatenate([[0.0], np.logspace(-3, 300, 500)]))
    assert np.all(np.diff(alpha) < 0)
    assert np.all(alpha > 0)


def test_apex_x_slope_is_the_derivative():
    for eps in (0.0, 0.1, 10.0, 1e5):
        for alpha in (1e-3, 0.4, 1.2, 1.57):
            exact = float(x_slope(mp.mpf(alpha), eps))
            assert float(named.apex_x_slope(alpha, eps)) == pytest.approx(exact, rel=1e-13, abs=0)

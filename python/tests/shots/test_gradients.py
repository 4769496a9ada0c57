"""Derivatives against differences in 50 digits; spread against Monte Carlo."""

import mpmath as mp
import numpy as np
import pytest

from archerfish import Launcher
from archerfish.gradients import INPUTS, OUTPUTS, propagate

CASE = {"speed": 20.0, "angle": 0.8, "drag_rate": 0.3, "gravity": 9.5}
WIND, HEIGHT = (-3.0, 0.4), 2.0


def exact(speed, angle, drag_rate, gravity, *, height, wind, near):
    """The five quantities from the solution of the equation of motion."""
    b = drag_rate
    vx, vy = speed * mp.cos(angle) - wind[0], speed * mp.sin(angle) - wind[1]

    def place(t):
        moved = t if b == 0 else -mp.expm1(-b * t) / b
        fallen = t * t / 2 if b == 0 else (t - moved) / b
        return vx * moved + wind[0] * t, height + vy * moved + wind[1] * t - gravity * fallen

    def climb(t):
        moved = t if b == 0 else -mp.expm1(-b * t) / b
        return vy * mp.exp(-b * t) + wind[1] - gravity * moved

    top = mp.findroot(climb, near[0])
    end = mp.findroot(lambda t: place(t)[1], near[1])
    return place(end)[0], end, *place(top), top


@pytest.mark.parametrize("drag_rate", [0.0, 1e-8, 0.3, 4.0])
@pytest.mark.parametrize(("height", "wind"), [(0.0, (0.0, 0.0)), (HEIGHT, WIND)])
def test_every_derivative(drag_rate, height, wind):
    case = CASE | {"drag_rate": drag_rate}
    launcher = Launcher(case["speed"], gravity=case["gravity"], drag_rate=drag_rate)
    shot = launcher.shot(case["angle"], height=height, wind=wind)
    gradients, near = shot.gradients, (shot.apex.time, shot.flight_time)
    with mp.workdps(50):
        for name in INPUTS:
            step = mp.mpf(10) ** -16
            around = [
                exact(
                    **{k: mp.mpf(v) + sign * step * (k == name) for k, v in case.items()},
                    height=mp.mpf(height),
                    wind=[mp.mpf(w) for w in wind],
                    near=near,
                )
                for sign in (1, -1)
            ]
            for output, plus, minus in zip(OUTPUTS, *around, strict=True):
                expected = float((plus - minus) / (2 * step))
                found = getattr(getattr(gradients, output), name)
                assert found == pytest.approx(expected, rel=2e-13), (output, name)


def test_a_flat_shot_has_the_derivatives_of_the_limit():
    gradients = Launcher(10.0, gravity=10.0, drag_rate=0.1).shot([0.0, 1e-9]).gradients
    np.testing.assert_allclose(gradients.flight_time.angle, 2.0, rtol=1e-8)
    np.testing.assert_allclose(gradients.range.angle, 20.0, rtol=1e-8)


@pytest.mark.parametrize("side", ["low", "high"])
@pytest.mark.parametrize("wind", [None, (-2.0, 0.3), (1.0, 0.2, -2.0)])
def test_the_angle_of_an_aim(side, wind):
    case = {"speed": 20.0, "drag_rate": 0.3, "gravity": 9.5}

    def angle(**changed):
        now = case | changed
        launcher = Launcher(now["speed"], drag_rate=now["drag_rate"], gravity=now["gravity"])
        return getattr(launcher.aim(12.0, 3.0, wind=wind), side)

    gradient = angle().angle_gradient
    for name, value in case.items():
        step = 1e-5 * value
        up, down = angle(**{name: value + step}).angle, angle(**{name: value - step}).angle
        assert getattr(gradient, name) == pytest.approx((up - down) / (2 * step), rel=1e-7)


def test_spread_against_monte_carlo():
    deviations = {"speed": 0.05, "angle": 0.003, "drag_rate": 0.004, "gravity": 0.01}
    shot = Launcher(CASE["speed"], gravity=CASE["gravity"], drag_rate=CASE["drag_rate"]).shot(
        CASE["angle"], height=HEIGHT, wind=WIND
    )
    spread = shot.propagate(**deviations)
    rng = np.random.default_rng(11)
    draws = {name: rng.normal(CASE[name], deviations[name], 200_000) for name in INPUTS}
    shots = Launcher(draws["speed"], gravity=draws["gravity"], drag_rate=draws["drag_rate"]).shot(
        draws["angle"], height=HEIGHT, wind=WIND
    )
    seen = [shots.range, shots.flight_time, shots.apex.x, shots.apex.y, shots.apex.time]
    expected = [getattr(spread, name) for name in OUTPUTS]
    # 200 000 draws know a standard deviation to 1/√400 000 = 0.16 %: four times that.
    np.testing.assert_allclose([np.std(values) for values in seen], expected, rtol=0.0064)
    np.testing.assert_allclose(np.corrcoef(seen), _correlation(spread.covariance), atol=0.01)


def _correlation(covariance):
    deviation = np.sqrt(np.diag(covariance))
    return covariance / np.outer(deviation, deviation)


def test_a_covariance_says_the_same_as_its_diagonal_and_more():
    shot = Launcher(10.0, drag_rate=[0.1, 0.2]).shot(0.7)
    apart = shot.propagate(speed=0.1, angle=0.01)
    same = shot.propagate(covariance=np.diag([0.01, 0.0001, 0.0, 0.0]))
    np.testing.assert_allclose(same.range, apart.range)
    tied = np.zeros((4, 4))
    tied[:2, :2] = [[0.01, 0.001], [0.001, 0.0001]]
    assert np.all(shot.propagate(covariance=tied).range > apart.range)
    assert same.covariance.shape == (2, 5, 5)


def test_refused():
    shot = Launcher(10.0, epsilon=0.1).shot(0.7)
    with pytest.raises(ValueError, match="deviation of speed must be at least 0, got -1"):
        propagate(shot, speed=-1)
    with pytest.raises(ValueError, match=r"covariance must have the shape \(..., 4, 4\)"):
        propagate(shot, covariance=np.eye(3))
    with pytest.raises(TypeError, match="standard deviations or a covariance, got both"):
        propagate(shot, speed=0.1, covariance=np.eye(4))

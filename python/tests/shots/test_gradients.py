"""Derivatives against those of the equation of motion in ball arithmetic; spread by Monte Carlo."""

import numpy as np
import pytest
from flint import arb

from archerfish import Launcher
from archerfish.gradients import INPUTS, OUTPUTS, propagate
from reference.sensitivity import QUANTITIES, Case

CASE = {"speed": 20.0, "angle": 0.8, "drag_rate": 0.3, "gravity": 9.5}
CROSSWIND = {"height": 2.0, "azimuth": 0.4, "wind": (-3.0, 0.4, 2.0)}
#: Errors allowed: units of 2⁻⁵³ for each unit of condition.
BOUND, IN_WIND = 8.0, 64.0


def scenes(seed, count):
    """Launchers from no drag to strong drag, launch angles from almost flat to almost upright."""
    rng = np.random.default_rng(seed)
    for k in range(count):
        eps = 0.0 if k % 8 == 0 else 10 ** rng.uniform(-9, 3)
        speed, gravity = rng.uniform(3, 60), rng.uniform(1, 20)
        angle = 10 ** rng.uniform(-8, 0) if k % 3 == 0 else rng.uniform(0.02, 1.55)
        yield rng, Launcher(speed, gravity=gravity, drag_rate=eps * gravity / speed), angle


def case(launcher, **others):
    """The same as numbers of Arb."""
    numbers = {name: getattr(launcher, name) for name in ("speed", "drag_rate", "gravity")} | others
    wind = tuple(arb(float(part)) for part in numbers.pop("wind", (0.0, 0.0, 0.0)))
    return Case(**{name: arb(float(value)) for name, value in numbers.items()}, wind=wind)


def compare(quantity, scene, found, bound):
    """Hold each derivative of a record against the exact one, by its condition."""
    names = [name for name in found.__dataclass_fields__ if name != "z" or "space" in quantity]
    inputs = [
        name
        for name in (*INPUTS, "azimuth", "height", "x", "y", "z")
        if getattr(scene, name) != 0 and name not in QUANTITIES[quantity].unknowns
    ]
    for name, exact in QUANTITIES[quantity].slopes(scene, names, inputs).items():
        error = abs(getattr(found, name) - exact.value)
        allowed = bound * 2.0**-53 * (1 + exact.condition) * abs(exact.value)
        assert error <= allowed, (quantity, name, error / allowed, exact, scene)


@pytest.mark.parametrize("windy", [False, True])
def test_every_derivative_of_a_shot(windy):
    for rng, launcher, angle in scenes(1, 48):
        size = launcher.length_scale / (1 + launcher.epsilon)
        height = rng.choice([0.0, rng.uniform(-0.1, 3), 10 ** rng.uniform(-6, 0)]) * size
        wind = rng.uniform(-0.5, 0.5, 3) * launcher.speed / (1 + launcher.epsilon) * windy
        shot = launcher.shot(angle, azimuth=0.7 * windy, height=height, wind=tuple(wind))
        for output in OUTPUTS if windy else OUTPUTS[:5]:
            time = shot.apex.time if output.startswith("apex") else shot.flight_time
            if np.isnan(time):
                continue  # the launcher stands in a pit that the shot does not leave
            scene = case(
                launcher, angle=angle, azimuth=shot.azimuth, height=height, wind=wind, time=time
            )
            compare(output, scene, getattr(shot.gradients, output), BOUND)


def test_every_derivative_of_an_aim():
    """By speed, drag rate, gravity and the target's coordinates, of both arcs."""
    arcs = 0
    for rng, launcher, angle in scenes(2, 40):
        shot = launcher.shot(angle)
        share = 10 ** rng.uniform(-5, 0)
        place = shot.position(share * shot.flight_time)
        aim = launcher.aim(place.x, place.y)
        if not aim.reachable:
            continue  # on the envelope, within rounding
        for arc in (aim.low, aim.high):
            scene = case(launcher, angle=arc.angle, time=arc.time, x=place.x, y=place.y)
            compare("aim", scene, arc.angle_gradient, BOUND)
            arcs += 1
    assert arcs > 70


@pytest.mark.parametrize("quantity", ["aim", "aim in space"])
def test_every_derivative_of_an_aim_in_wind(quantity):
    """In wind gravity is tilted, so that an angle is right to a rounding of 1, not of itself."""
    arcs, z = 0, quantity == "aim in space"
    for rng, launcher, _ in scenes(3, 24):
        wind = rng.uniform(-0.5, 0.5, 3) * launcher.speed / (1 + launcher.epsilon) * (1, 1, z)
        shot = launcher.shot(rng.uniform(0.1, 1.4), azimuth=rng.uniform(-3, 3) * z, wind=wind)
        place = shot.position(rng.uniform(0.1, 1.0) * shot.flight_time)
        aim = launcher.aim(place.x, place.y, place.z if z else None, wind=wind[: 2 + z])
        if not aim.reachable:
            continue
        for arc in (aim.low, aim.high):
            where = {"x": place.x, "y": place.y, "z": place.z, "azimuth": arc.azimuth}
            scene = case(launcher, angle=arc.angle, time=arc.time, wind=wind, **where)
            compare(quantity, scene, arc.angle_gradient, IN_WIND)
            arcs += 1
    assert arcs > 40


def test_a_flat_shot_has_the_derivatives_of_the_limit():
    gradients = Launcher(10.0, gravity=10.0, drag_rate=0.1).shot([0.0, 1e-9]).gradients
    np.testing.assert_allclose(gradients.flight_time.angle, 2.0, rtol=1e-8)
    np.testing.assert_allclose(gradients.range.angle, 20.0, rtol=1e-8)


def test_what_an_element_gives_does_not_depend_on_its_neighbours():
    drag = 10 ** np.linspace(-3, 4, 61)
    together = Launcher(10.0, drag_rate=drag).shot(0.7, height=1.0).gradients
    for index, rate in enumerate(drag):
        alone = Launcher(10.0, drag_rate=rate).shot(0.7, height=1.0).gradients
        for output in OUTPUTS:
            found, expected = getattr(together, output), getattr(alone, output)
            assert all(getattr(found, name)[index] == getattr(expected, name) for name in INPUTS)


def test_spread_against_monte_carlo():
    deviations = {"speed": 0.05, "angle": 0.003, "drag_rate": 0.004, "gravity": 0.01}
    shot = Launcher(CASE["speed"], gravity=CASE["gravity"], drag_rate=CASE["drag_rate"]).shot(
        CASE["angle"], **CROSSWIND
    )
    spread = shot.propagate(**deviations)
    rng = np.random.default_rng(11)
    draws = {name: rng.normal(CASE[name], deviations[name], 200_000) for name in INPUTS}
    shots = Launcher(draws["speed"], gravity=draws["gravity"], drag_rate=draws["drag_rate"]).shot(
        draws["angle"], **CROSSWIND
    )
    landing, apex = shots.landing, shots.apex
    seen = [landing.x, landing.time, apex.x, apex.y, apex.time, landing.z, apex.z]
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
    assert same.covariance.shape == (2, 7, 7)
    assert np.all(same.landing_z == 0.0)  # nothing leads out of the plane


def test_a_covariance_that_leaves_an_output_certain():
    """Inputs that vary together, and an output that does not feel it: 0, not the root of −1e-20."""
    rng = np.random.default_rng(12)
    shot = Launcher(rng.uniform(5, 50, 3000), drag_rate=0.1).shot(rng.uniform(0.1, 1.5, 3000))
    slopes = [getattr(shot.gradients.range, name) for name in INPUTS[:2]]
    direction = np.stack([slopes[1], -slopes[0], *np.zeros((2, 3000))], axis=-1)
    direction /= np.linalg.norm(direction, axis=-1, keepdims=True)
    spread = shot.propagate(covariance=direction[:, :, np.newaxis] * direction[:, np.newaxis])
    assert np.all(spread.range < 1e-6 * np.hypot(*slopes))
    assert np.all(spread.apex_y > 0)


def test_refused():
    shot = Launcher(10.0, epsilon=0.1).shot(0.7)
    for bad in (-1.0, np.nan, np.inf):
        with pytest.raises(
            ValueError, match=f"deviation of speed must be at least 0 and finite, got {bad}"
        ):
            propagate(shot, speed=bad)
    with pytest.raises(ValueError, match="covariance must be finite, got nan"):
        propagate(shot, covariance=np.full((4, 4), np.nan))
    with pytest.raises(ValueError, match=r"covariance must be symmetric, got correlations 0\.1"):
        propagate(shot, covariance=np.eye(4) + 0.1 * np.eye(4, k=1))
    tied = 1.01 * np.sqrt(1e-12) * (np.eye(4, k=1) + np.eye(4, k=-1))
    tied[1:3, 1:3] = 0.0
    for indefinite in (-np.eye(4), tied + np.diag([1.0, 1e-12, 1e-12, 1.0])):
        with pytest.raises(ValueError, match="covariance must be positive semidefinite, got the"):
            propagate(shot, covariance=[np.eye(4), indefinite])
    with pytest.raises(ValueError, match=r"covariance must have the shape \(..., 4, 4\)"):
        propagate(shot, covariance=np.eye(3))
    with pytest.raises(TypeError, match="standard deviations or a covariance, got both"):
        propagate(shot, speed=0.1, covariance=np.eye(4))

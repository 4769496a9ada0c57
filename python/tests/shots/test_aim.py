"""Aiming: fly there and arrive; out of reach is a statement that a bit more speed overturns."""

import numpy as np
import pytest

from archerfish import Launcher
from archerfish.aim import UNDEFINED, Aim, Unreachable, minimum_speed

TARGETS = 1_000_000


def reachable_targets(rng, count):
    """Targets hit by known shots: epsilon, x, y in units of V²/g."""
    eps = np.where(rng.random(count) < 0.1, 0.0, 10 ** rng.uniform(-6, 2, count))
    launcher = Launcher(1.0, gravity=1.0, epsilon=eps)
    angle = rng.uniform(-1.5, 1.5, count)
    time = 10 ** rng.uniform(-2, 0.5, count)
    place = launcher.shot(angle).position(time)
    return launcher, place.x, place.y


def miss(arc, x, y, z=0.0):
    """Distance from the target at the time of arrival, over the distance flown to it."""
    place = arc.shot.position(arc.time)
    off = np.sqrt((place.x - x) ** 2 + (place.y - y) ** 2 + (place.z - z) ** 2)
    return off / np.hypot(np.hypot(x, y), z)


def test_aim_fly_arrive():
    launcher, x, y = reachable_targets(np.random.default_rng(5), TARGETS)
    arcs = launcher.aim(x, y)
    # A target on the envelope may come out a rounding above it; then it is a rounding above.
    lost = ~arcs.reachable
    assert lost.mean() < 1e-4
    assert np.all(arcs.margin[lost] < 4e-16 * np.maximum(1, np.abs(y[lost]) + np.abs(x[lost])))
    for arc in (arcs.low, arcs.high):
        assert miss(arc, x, y)[~lost].max() < 1e-13
    assert np.all(arcs.low.time[~lost] <= arcs.high.time[~lost] * (1 + 1e-6))
    assert np.all(arcs.low.angle[~lost] <= arcs.high.angle[~lost])


def test_in_any_wind_in_space():
    rng = np.random.default_rng(6)
    count = 20_000
    drag = 10 ** rng.uniform(-2, 1, count)
    launcher = Launcher(rng.uniform(5, 50, count), drag_rate=drag)
    wind = rng.uniform(-8, 8, (3, count))
    wind[1] *= 0.1
    x, y, z = rng.uniform(-30, 30, (3, count)) / (1 + drag)
    arcs = launcher.aim(x, y, z, height=2.0, wind=tuple(wind))
    hit = arcs.reachable
    assert 0.2 < hit.mean() < 0.98
    for arc in (arcs.low, arcs.high):
        assert miss(arc, x, y, z)[hit].max() < 3e-13
        assert np.isnan(arc.time[~hit]).all()
    # The least speed is the boundary between the two.
    least = np.asarray(arcs.minimum_speed)
    for factor, reached in ((1 + 1e-9, True), (1 - 1e-9, False)):
        again = Launcher(least * factor, drag_rate=drag).aim(x, y, z, height=2.0, wind=tuple(wind))
        assert np.all(again.reachable == reached)
    assert np.all((least <= launcher.speed) == hit)


def test_wind_that_carries_the_whole_weight_leaves_a_straight_way():
    launcher = Launcher(20.0, gravity=10.0, drag_rate=1.0)
    arcs = launcher.aim(3.0, 4.0, wind=(0.0, 10.0))
    low = arcs.low
    assert low.angle == pytest.approx(np.arctan2(4.0, 3.0), rel=1e-15)
    assert low.time == pytest.approx(-np.log1p(-5 / 20), rel=1e-15)  # 20 (1 − e⁻ᵗ) is 5
    assert miss(low, 3.0, 4.0) < 1e-15
    assert arcs.high == low
    among = launcher.aim(3.0, 4.0, wind=(0.0, [9.0, 10.0]))
    assert among.high.time[0] > among.low.time[0]
    assert among.high.time[1] == low.time
    assert miss(among.high, 3.0, 4.0).max() < 1e-14
    beyond = launcher.aim(30.0, 40.0, wind=(0.0, 10.0))
    assert isinstance(beyond, Unreachable)
    assert beyond.minimum_speed == pytest.approx(50.0, rel=1e-15)


@pytest.mark.parametrize("drag_rate", [0.4, 1e-9])  # so weak a drag tilts gravity by 1e-9
def test_in_the_plane_the_wind_leaves_the_shot_there(drag_rate):
    launcher = Launcher(25.0, drag_rate=drag_rate)
    arcs = launcher.aim(20.0, 3.0, wind=(-6.0, 1.0), height=1.0)
    assert isinstance(arcs, Aim)
    assert (arcs.low.azimuth, arcs.high.azimuth) == (0.0, 0.0)
    assert max(miss(arcs.low, 20.0, 3.0), miss(arcs.high, 20.0, 3.0)) < 1e-14
    mirrored = launcher.aim(-20.0, 3.0, wind=(6.0, 1.0), height=1.0)
    assert mirrored.low.angle == pytest.approx(np.pi - arcs.low.angle, rel=1e-14)


def test_above_and_below_the_launcher():
    launcher = Launcher(10.0, gravity=10.0, epsilon=0.3)
    above = launcher.aim(0.0, 2.0)
    assert above.low.angle == above.high.angle == np.pi / 2
    assert above.low.impact_velocity.y > 0 > above.high.impact_velocity.y
    for arc in (above.low, above.high):
        assert arc.shot.position(arc.time).y == pytest.approx(2.0, rel=1e-14)
    below = launcher.aim(0.0, -2.0)
    assert below.low.angle == pytest.approx(-np.pi / 2)
    assert below.high.angle == pytest.approx(np.pi / 2)
    for arc in (below.low, below.high):
        assert arc.shot.position(arc.time).y == pytest.approx(-2.0, rel=1e-14)
    assert below.minimum_speed == 0.0


@pytest.mark.parametrize("epsilon", [0.0, 1e-6, 0.5, 3.0, 100.0])
def test_on_the_envelope_both_arcs_are_one(epsilon):
    launcher = Launcher(1.0, gravity=1.0, epsilon=epsilon)
    wall = min(launcher.envelope.wall, 1.0)
    x = np.linspace(0.05, 0.9, 30) * wall
    y = launcher.envelope.height(x)
    breath = 1e-14 * (np.abs(y) + x)
    under = launcher.aim(x, y - breath)
    assert under.reachable.all()
    np.testing.assert_allclose(under.low.angle, under.high.angle, atol=3e-5)
    # Half of the digits of the angle are lost there, none of the hit.
    for arc in (under.low, under.high):
        assert miss(arc, x, y).max() < 3e-13
    over = launcher.aim(x, y + breath)
    assert not over.reachable.any()
    assert np.all(over.margin > 0)


def tops(rng, count):
    """Launchers, and winds in whose tilted gravity the target is at the top of the envelope."""
    drag = np.where(rng.random(count) < 0.1, 0.0, 10 ** rng.uniform(-6, 3, count))
    launcher = Launcher(10 ** rng.uniform(-1, 2, count), drag_rate=drag)
    return launcher, rng.uniform(-4, 4, (2, count)) / (1 + drag)


@pytest.mark.parametrize("beside", [0.0, 1e-12, 1e-9, 1e-6])
def test_at_the_top_of_the_envelope(beside):
    """There the projectile stands still, and a step by its velocity leads anywhere."""
    launcher, _ = tops(np.random.default_rng(7), 20_000)
    highest = launcher.envelope.highest
    x = beside * highest
    y = launcher.envelope.height(x)
    arcs = launcher.aim(x, y)
    hit = arcs.reachable
    assert hit.mean() > (0.99 if beside == 0 else 0.5)
    for arc in (arcs.low, arcs.high):
        assert miss(arc, x, y)[hit].max() < 1e-13
        if beside == 0.0:
            apex = launcher.shot(np.pi / 2).apex
            np.testing.assert_allclose(arc.time[hit], apex.time[hit], rtol=1e-6)


def test_at_the_top_of_the_envelope_that_wind_tilts():
    launcher, wind = tops(np.random.default_rng(8), 20_000)
    pull = launcher.drag_rate * wind
    pull[1] -= launcher.gravity
    strength = np.hypot(*pull)
    tilted = Launcher(launcher.speed, gravity=strength, drag_rate=launcher.drag_rate)
    x, y = -pull / strength * tilted.envelope.highest * (1 - 1e-15)
    arcs = launcher.aim(x, y, wind=tuple(wind))
    hit = arcs.reachable
    assert hit.mean() > 0.9
    for arc in (arcs.low, arcs.high):
        assert miss(arc, x, y)[hit].max() < 1e-13


def test_unreachable_says_by_how_much_and_what_speed_would_do():
    launcher = Launcher(10.0, drag_rate=0.1)
    answer = launcher.aim(9.0, 3.0)
    assert isinstance(answer, Unreachable)
    assert answer.margin == pytest.approx(3.0 - launcher.envelope.height(9.0), rel=1e-14)
    faster = Launcher(answer.minimum_speed, drag_rate=0.1)
    assert faster.reachable(9.0, 3.0)
    assert not Launcher(answer.minimum_speed * (1 - 1e-12), drag_rate=0.1).reachable(9.0, 3.0)
    assert answer.minimum_speed == launcher.minimum_speed(9.0, 3.0)
    beyond = launcher.aim(150.0, -1e6)
    assert beyond.margin == np.inf
    assert beyond.minimum_speed == pytest.approx(15.0)  # V/b is the distance, but for 1e6 m.


def test_batches_have_a_status_and_no_exception():
    arcs = Launcher(10.0, epsilon=0.1).aim([4.0, 9.0, np.nan, -4.0], [1.0, 3.0, 1.0, 1.0])
    assert arcs.status.tolist() == [0, 1, 2, 0]
    assert np.isnan(arcs.low.angle).tolist() == [False, True, True, False]
    assert np.isnan(arcs.high.impact_speed).tolist() == [False, True, True, False]
    assert arcs.reachable.tolist() == [True, False, False, True]
    assert np.isnan(arcs.minimum_speed).tolist() == [False, False, True, False]
    one = Launcher(10.0, epsilon=0.1).aim(4.0, 1.0)
    assert arcs.low.angle[0] == one.low.angle
    assert arcs.low.angle[3] == np.pi - one.low.angle


@pytest.mark.parametrize("wind", [None, (1.0, 2.0), (1.0, 2.0, 3.0)])
def test_a_target_at_infinity_is_no_target(wind):
    launcher = Launcher(10.0, epsilon=0.1)
    for place in ((np.inf, 0.0), (-np.inf, 0.0), (5.0, np.inf), (5.0, -np.inf), (0.0, -np.inf)):
        alone = launcher.aim(*place, wind=wind)
        assert alone.status == UNDEFINED
        for number in (alone.margin, alone.minimum_speed, alone.low.angle, alone.high.time):
            assert np.isnan(number)
        assert not alone.reachable
        assert not launcher.reachable(*place)
        x, y = zip(place, (5.0, 1.0), strict=True)
        assert launcher.aim(x, y, wind=wind).status.tolist() == [UNDEFINED, 0]


def test_minimum_speed_without_drag_is_the_textbook_s():
    x, y = np.array([3.0, 3.0, 3.0, 1e-3]), np.array([4.0, -4.0, 0.0, -1e6])
    found = minimum_speed(x, y, gravity=2.0, drag_rate=0.0)
    away = np.hypot(x, y)
    expected = np.sqrt(2.0 * np.where(y < 0, x**2 / (away - y), away + y))
    np.testing.assert_allclose(found, expected, rtol=1e-14)


def test_minimum_speed_at_the_extremes():
    """It is the boundary however strong the drag is, near the launcher and far from it."""
    rng = np.random.default_rng(10)
    count = 20_000
    speed, eps = 10 ** rng.uniform(-1, 2, count), 10 ** rng.uniform(-3, 300, count)
    launcher = Launcher(speed, epsilon=eps)
    x = rng.uniform(0.01, 0.99, count) * launcher.envelope.reach
    depth = np.where(rng.random(count) < 0.5, x, 10 ** rng.uniform(-3, 3, count))
    y = depth * rng.choice([-1.0, 0.0], count)
    least = launcher.minimum_speed(x, y)
    assert np.all(least >= x * launcher.drag_rate * (1 - 1e-15))
    assert np.all(least <= speed)
    for factor, reached in ((1 + 1e-9, True), (1 - 1e-9, False)):
        again = launcher.replace(speed=least * factor, drag_rate=launcher.drag_rate)
        assert np.all(again.reachable(x, y) == reached)
    far = Launcher(10.0, drag_rate=0.5).minimum_speed([1e200, 1e10], 0.0)
    np.testing.assert_allclose(far, [5e199, 5e9], rtol=1e-7)


@pytest.mark.parametrize("epsilon", [1e3, 1e100, 1e170, 1e250, 1e300])
def test_a_fall_through_the_thickest_medium(epsilon):
    """A metre down at terminal speed, which is as little as 1e-299 m/s."""
    launcher = Launcher(10.0, epsilon=epsilon)
    arcs = launcher.aim(0.5 * launcher.envelope.wall, -1.0)
    for arc in (arcs.low, arcs.high):
        assert arc.time == pytest.approx(1.0 / launcher.terminal_speed, rel=1e-14 + 10.0 / epsilon)
        assert arc.impact_speed == pytest.approx(launcher.terminal_speed, rel=1e-12)


def test_clearance():
    arcs = Launcher(10.0, epsilon=0.1).aim([6.0, 7.0], 1.0)
    for arc in (arcs.low, arcs.high):
        time = arc.shot.time_at(4.0)
        over = arc.clearance_over(4.0, 1.5)
        np.testing.assert_allclose(over, np.asarray(arc.shot.position(time).y) - 1.5)
        np.testing.assert_allclose(arc.clearance_under(5.0), 5.0 - np.asarray(arc.apex.y))
        assert np.isnan(arc.clearance_over(6.5, 0.0)).tolist() == [True, False]
    # A target met on the way up is the highest point of the way there.
    rising = Launcher(30.0, epsilon=0.1).aim(6.0, 4.0).low
    assert rising.apex.y > 4.0
    assert rising.highest == 4.0
    assert rising.clearance_under(5.0) == 1.0


def test_clearance_at_the_target_itself():
    rng = np.random.default_rng(9)
    x, y = rng.uniform(1.0, 8.0, 2000), rng.uniform(-3.0, 1.0, 2000)
    for wind in (None, (-3.0, 1.0)):
        arcs = Launcher(10.0, epsilon=0.1).aim(x, y, wind=wind)
        for arc in (arcs.low, arcs.high):
            np.testing.assert_allclose(arc.clearance_over(x, y - 1.0)[arcs.reachable], 1.0)
            assert np.isnan(arc.clearance_over(x, y)[~arcs.reachable]).all()


def test_clearance_of_a_shot_straight_up_or_down():
    """It stays at its x: the obstacle is hit from above or from below, whichever end is lower."""
    launcher = Launcher(10.0, epsilon=0.1)
    assert launcher.aim(0.0, -3.0, height=1.0).low.clearance_over(0.0, 0.0) == -3.0
    assert launcher.aim(0.0, 3.0, height=1.0).low.clearance_over(0.0, 0.0) == 1.0
    assert np.isnan(launcher.aim(0.0, 3.0).low.clearance_over(1.0, 0.0))


def test_clearance_of_an_obstacle_for_each_target():
    launcher = Launcher(12.0, drag_rate=[0.1, 0.2, 0.3])
    x, y = np.array([3.0, 2.0, 4.0]), np.array([1.0, 2.0, 0.5])
    ceiling = np.array([5.0, 4.0, 3.0])
    arcs = launcher.aim([6.0, 7.0, 5.0], [1.0, 0.0, -1.0])
    for side in ("low", "high"):
        arc = getattr(arcs, side)
        over, under = arc.clearance_over(x, y), arc.clearance_under(ceiling)
        assert over.shape == under.shape == (3,)
        for row in range(3):
            alone = Launcher(12.0, drag_rate=float(launcher.drag_rate[row])).aim(
                float(arcs.target.x[row]), float(arcs.target.y[row])
            )
            one = getattr(alone, side)
            assert over[row] == one.clearance_over(x[row], y[row])
            assert under[row] == one.clearance_under(ceiling[row])


def test_a_headwind_that_brings_the_shot_back_over_the_obstacle():
    launcher = Launcher(8.0, drag_rate=1.5)
    high = launcher.aim(-0.5, -9.0, wind=(-3.0, 0.0)).high
    forth, back = high.shot.time_at(0.1), high.shot.time_again_at(0.1)
    assert forth < back < high.time
    heights = [high.shot.position(time).y for time in (forth, back)]
    assert high.clearance_over(0.1, 0.25) == pytest.approx(min(heights) - 0.25)


def test_impact_is_the_landing_of_a_shot_at_that_height():
    arcs = Launcher(10.0, epsilon=0.2).aim(5.0, 1.0)
    landing = arcs.high.shot.landing
    assert landing.time == pytest.approx(arcs.high.time, rel=1e-13)
    assert landing.speed == pytest.approx(arcs.high.impact_speed, rel=1e-13)
    assert landing.angle == pytest.approx(arcs.high.impact_angle, rel=1e-13)


def test_targets_that_are_none():
    launcher = Launcher(10.0, epsilon=0.1)
    with pytest.raises(TypeError, match=r"^target x must be a real number .* got 'a'$"):
        launcher.aim("a", 0.0)
    with pytest.raises(
        ValueError, match=r"^targets must broadcast, got x \(2,\), y \(3,\), z \(\)$"
    ):
        launcher.aim([1.0, 2.0], [1.0, 2.0, 3.0])
    # So near that its square is nothing: V² = g x all the same.
    assert launcher.minimum_speed(1e-200, 0.0) == pytest.approx(np.sqrt(9.80665e-200))

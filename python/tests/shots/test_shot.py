"""Shots against the equation of motion, integrated by a solver that knows none of our formulas."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from archerfish import Launcher

SHOTS = 200


def integrated(case):
    """Time, place, velocity and path at landing, and height and time of the apex."""
    gravity, drag, wind = case["gravity"], case["drag_rate"], np.array(case["wind"])
    level = np.cos(case["angle"])
    launch = case["speed"] * np.array(
        [
            level * np.cos(case["azimuth"]),
            np.sin(case["angle"]),
            level * np.sin(case["azimuth"]),
        ]
    )

    def motion(_, state):
        velocity = state[3:6]
        pull = -drag * (velocity - wind) - [0, gravity, 0]
        return np.concatenate([velocity, pull, [np.linalg.norm(velocity)]])

    def landing(_, state):
        return state[1] - case["ground"]

    def apex(_, state):
        return state[4]

    landing.terminal, landing.direction, apex.direction = True, -1, -1
    start = np.concatenate([[0, case["height"], 0], launch, [0]])
    done = solve_ivp(
        motion, (0, 1e4), start, "DOP853", rtol=1e-12, atol=1e-13, events=[landing, apex]
    )
    tops = done.t_events[1], done.y_events[1]
    return done.t_events[0][0], done.y_events[0][0], tops


def random_case(rng):
    drag, gravity = 10 ** rng.uniform(-3, 1), rng.uniform(1, 15)
    height = rng.uniform(0, 20)
    wind = rng.uniform(-6, 6, 3)
    wind[1] *= 0.15 * min(1.0, gravity / drag / 6)  # No updraught that carries the shot away.
    return {
        "speed": rng.uniform(1, 50),
        "gravity": gravity,
        "drag_rate": drag,
        "angle": rng.uniform(-1.3, 3.1),
        "azimuth": rng.uniform(-3, 3),
        "height": height,
        "ground": height - rng.uniform(0.1, 15),
        "wind": tuple(wind),
    }


def test_random_shots_with_wind_and_heights_agree_with_an_ode_solver():
    rng = np.random.default_rng(20100106)
    for _ in range(SHOTS):
        case = random_case(rng)
        launcher = Launcher(case["speed"], gravity=case["gravity"], drag_rate=case["drag_rate"])
        names = ("angle", "azimuth", "height", "ground", "wind")
        shot = launcher.shot(**{name: case[name] for name in names})
        time, state, (top_times, tops) = integrated(case)
        landing = shot.landing
        scale = case["speed"] * time
        found = [landing.x, landing.y, landing.z]
        np.testing.assert_allclose(landing.time, time, rtol=2e-10)
        np.testing.assert_allclose(found, state[:3], rtol=0, atol=2e-10 * scale)
        np.testing.assert_allclose(
            [landing.vx, landing.vy, landing.vz], state[3:6], rtol=0, atol=2e-10 * case["speed"]
        )
        np.testing.assert_allclose(shot.path_length(), state[6], rtol=2e-10)
        if case["angle"] > 0:
            np.testing.assert_allclose(shot.apex.time, top_times[0], rtol=2e-9)
            apex = [shot.apex.x, shot.apex.y, shot.apex.z]
            np.testing.assert_allclose(apex, tops[0][:3], rtol=0, atol=2e-9 * scale)
        else:
            assert np.isnan(shot.apex.y)


@pytest.mark.parametrize("epsilon", [0.0, 1e-12])
def test_without_drag_a_shot_is_the_textbook_parabola(epsilon):
    speed, gravity, height = 12.0, 9.8, 3.0
    angle = np.linspace(0.01, 1.56, 40)
    shot = Launcher(speed, gravity=gravity, epsilon=epsilon).shot(angle, height=height)
    sine, cosine = np.sin(angle), np.cos(angle)
    time = speed * (sine + np.sqrt(sine**2 + 2 * gravity * height / speed**2)) / gravity
    np.testing.assert_allclose(shot.flight_time, time, rtol=2e-12)
    np.testing.assert_allclose(shot.range, speed * cosine * time, rtol=3e-12)
    np.testing.assert_allclose(shot.apex.y, height + (speed * sine) ** 2 / 2 / gravity, rtol=2e-12)
    np.testing.assert_allclose(shot.landing.speed, np.sqrt(speed**2 + 2 * gravity * height))
    x = 5.0
    height_at = height + x * sine / cosine - gravity * x**2 / 2 / (speed * cosine) ** 2
    np.testing.assert_allclose(shot.height_at(x), height_at, rtol=1e-9)
    tangent = sine / cosine
    level = Launcher(speed, gravity=gravity, epsilon=epsilon).shot(angle)
    arc = speed**2 / gravity * (sine + cosine**2 * np.arcsinh(tangent))
    np.testing.assert_allclose(level.path_length(), arc, rtol=3e-12)


@pytest.mark.parametrize("epsilon", [0.0, 1e-20, 1e-3, 1.0, 40.0])
def test_level_ground_and_a_breath_of_height_agree(epsilon):
    """The ufunc for level ground and the road over the apex are two computations."""
    launcher = Launcher(10.0, gravity=10.0, epsilon=epsilon)
    angle = np.linspace(0.1, 3.0, 30)
    level = launcher.shot(angle)
    high = launcher.shot(angle, height=1e-300)
    np.testing.assert_allclose(level.flight_time, high.flight_time, rtol=2e-15)
    np.testing.assert_allclose(level.range, high.range, rtol=1e-14, atol=1e-14)


@pytest.mark.parametrize("drag_rate", [0.0, 1e-9, 0.3, 5.0])
@pytest.mark.parametrize("wind", [None, (2.0, 0.3), (-9.0, 0.0, 4.0)])
def test_time_at_is_the_inverse_of_position(drag_rate, wind):
    shot = Launcher(20.0, drag_rate=drag_rate).shot([0.3, 1.0, 2.0], wind=wind, azimuth=0.2)
    for share in (0.05, 0.3, 0.6):
        # Before a headwind turns the shot round.
        time = share * np.minimum(shot.flight_time, 0.4 if drag_rate > 1 else np.inf)
        place = shot.position(time)
        if np.any(shot.velocity(time).x * np.cos(shot.angle) <= 0):
            continue
        np.testing.assert_allclose(shot.time_at(place.x), time, rtol=1e-9)
        np.testing.assert_allclose(shot.height_at(place.x), place.y, atol=1e-8)


def test_a_headwind_brings_a_shot_back_over_its_launch_point():
    shot = Launcher(5.0, drag_rate=2.0).shot(1.4, wind=(-10.0, 0.0), height=50.0)
    forward = shot.velocity(0.0).x
    assert forward > 0 > shot.range
    # The first time at x, then never beyond the turn, and behind the launcher only later.
    first = shot.time_at(0.01)
    assert shot.velocity(first).x > 0
    assert np.isnan(shot.time_at(5.0))
    back = shot.time_at(-3.0)
    assert back > first
    assert shot.position(back).x == pytest.approx(-3.0, rel=1e-12)
    assert shot.velocity(back).x < 0


def test_the_second_time_is_after_the_turn_and_at_the_same_place():
    windy = Launcher(8.0, drag_rate=1.5).shot([1.2, 0.6], wind=(-6.0, 0.0), height=9.0)
    x = np.array([[0.05], [0.2]])
    first, again = windy.time_at(x), windy.time_again_at(x)
    assert np.all(first < again)
    for time, sign in ((first, 1), (again, -1)):
        np.testing.assert_allclose(windy.position(time).x, np.broadcast_to(x, (2, 2)), rtol=1e-12)
        assert np.all(sign * windy.velocity(time).x > 0)
    # Beyond the turn never; behind the launch point once, at the launch point a second time.
    assert np.isnan([windy.time_again_at(9.0), windy.time_again_at(-1.0)]).all()
    np.testing.assert_allclose(windy.position(windy.time_again_at(0.0)).x, 0.0, atol=1e-12)
    assert np.all(windy.time_again_at(0.0) > 0)
    for shot in (Launcher(8.0, drag_rate=1.5).shot(1.2), windy):
        assert np.isnan(shot.time_again_at(np.nan)).all()
    assert np.isnan(Launcher(8.0, drag_rate=1.5).shot(1.2).time_again_at(0.1))
    assert np.isnan(Launcher(8.0, drag_rate=1.5).shot(1.2, wind=(6.0, 0.0)).time_again_at(0.1))


def test_energy_is_lost_to_drag_alone():
    times = np.linspace(0.0, 1.2, 7)
    kept = Launcher(10.0, epsilon=0.0).shot(0.9, height=2.0).energy(times)
    np.testing.assert_allclose(kept.total, 50.0 + 2.0 * 9.80665, rtol=1e-14)
    lost = Launcher(10.0, epsilon=0.3).shot(0.9).energy(times)
    assert np.all(np.diff(lost.total) < 0)
    np.testing.assert_array_equal(lost.total, lost.kinetic + lost.potential)


def test_path_length_of_steep_and_of_strongly_resisted_shots():
    launcher = Launcher(1.0, gravity=1.0, epsilon=[0.0, 0.1, 1e3, 1e8])
    up = launcher.shot(np.pi / 2)
    np.testing.assert_allclose(up.path_length(), 2 * up.apex.y, rtol=1e-14)
    nearly = launcher.shot(np.pi / 2 - 1e-9)
    np.testing.assert_allclose(nearly.path_length(), up.path_length(), rtol=1e-13)
    halves = launcher.shot(0.8).path_length(np.array([[0.1], [0.2]]))
    assert np.all(halves[1] > halves[0])
    assert np.isnan(launcher.shot(0.8).path_length(-1.0)).all()


def test_a_shot_that_is_none_is_nowhere():
    launcher = Launcher(10.0, epsilon=0.1)
    for wind in (None, (-1.0, 0.0)):
        shots = launcher.shot([np.nan, 4.0, 0.7], wind=wind)
        assert np.isnan(shots.time_at(0.0)).tolist() == [True, True, False]
        assert np.isnan(shots.height_at(0.0)).tolist() == [True, True, False]


def test_path_length_in_weightless_air():
    """Straight on, V (1 − e^{−bt})/b, however long one waits: not less and less of it."""
    launcher = Launcher(10.0, terminal_speed=5.0)
    time = np.concatenate([[0.0], 10.0 ** np.arange(-3.0, 300.0, 0.5)])
    found = launcher.shot(0.7, wind=(0.0, 5.0)).path_length(time)
    rate = launcher.drag_rate
    np.testing.assert_allclose(found, -10.0 / rate * np.expm1(-rate * time), rtol=1e-14)


def test_samples_run_from_launch_to_landing():
    shot = Launcher([[10.0], [20.0]], epsilon=0.2).shot([0.3, 0.6, 0.9], height=1.0)
    samples = shot.sample(11)
    assert samples.x.shape == (2, 3, 11)
    np.testing.assert_array_equal(samples.y[..., 0], 1.0)
    np.testing.assert_array_equal(samples.y[..., -1], 0.0)
    np.testing.assert_allclose(samples.x[..., -1], shot.range, rtol=1e-14)
    np.testing.assert_allclose(samples.time[..., -1], shot.flight_time, rtol=1e-15)
    np.testing.assert_allclose(samples.vy[..., 0], [[10.0], [20.0]] * np.sin([0.3, 0.6, 0.9]))


def test_arrays_broadcast_and_give_what_numbers_give():
    speeds, angles = np.array([[5.0], [30.0]]), np.array([0.4, 1.1, 2.2])
    many = Launcher(speeds, drag_rate=0.2).shot(angles, height=[1.0, 2.0, 3.0], wind=(1.0, 0.0))
    for i, j in np.ndindex(2, 3):
        one = Launcher(float(speeds[i, 0]), drag_rate=0.2).shot(
            float(angles[j]), height=1.0 + j, wind=(1.0, 0.0)
        )
        assert many.range[i, j] == one.range
        assert many.apex.y[i, j] == one.apex.y
        assert isinstance(one.range, float)


def test_what_does_not_exist_is_nan_in_silence():
    launcher = Launcher(10.0, epsilon=0.1)
    shots = launcher.shot([0.5, -0.5, 4.0, np.nan], ground=2.0)
    assert np.isnan(shots.flight_time).tolist() == [True, True, True, True]
    assert np.isnan(shots.apex.y).tolist() == [False, True, True, True]
    assert np.isnan(launcher.shot(0.5, ground=-2.0).flight_time) == False  # noqa: E712
    # An updraught above the terminal speed keeps everything aloft.
    aloft = Launcher(10.0, drag_rate=1.0).shot(0.5, wind=(0.0, 20.0))
    assert np.isnan([aloft.flight_time, aloft.apex.y, aloft.range]).all()
    assert aloft.position(3.0).y > 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"height": np.inf}, "height must be finite, got inf"),
        ({"wind": (1.0,)}, "wind must have 2 or 3 components, got 1"),
        ({"wind": (np.nan, 0.0)}, "wind x must be finite, got nan"),
        ({"height": [1.0, 2.0], "ground": [1.0, 2.0, 3.0]}, "shapes must broadcast, got launcher"),
    ],
)
def test_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        Launcher(10.0, epsilon=0.1).shot(0.5, **arguments)


def test_launch_and_landing_are_perpendicular_at_the_best_angle():
    launcher = Launcher(10.0, epsilon=[0.0, 0.1, 1.0, 10.0, 1e4])
    shot = launcher.shot(launcher.named_angles().greatest_range)
    turn = np.asarray(shot.angle) - shot.landing.angle
    np.testing.assert_allclose(turn, np.pi / 2, rtol=1e-7)
    np.testing.assert_allclose(launcher.envelope.reach, shot.range, rtol=1e-15)


def test_a_shot_aimed_into_the_ground_lands_where_it_stands():
    landing = Launcher(10.0, epsilon=0.1).shot([-0.5, 0.5], azimuth=1.0).landing
    assert (landing.time[0], landing.x[0], landing.z[0], landing.speed[0]) == (0.0, 0.0, 0.0, 10.0)
    assert landing.x[1] > 0


@pytest.mark.parametrize("updraft", [1.0, 1.3])  # in terminal speeds
def test_thrown_down_through_air_that_carries(updraft):
    launcher = Launcher(10.0, gravity=10.0, drag_rate=0.5)
    wind = (0.0, updraft * launcher.terminal_speed)
    shot = launcher.shot(-1.2, height=[0.0, 1.0, 3.0, 50.0], wind=wind)
    landing = shot.landing
    assert np.isnan(landing.time).tolist() == [False, False, False, True]  # it is blown up again
    assert landing.time[0] == 0.0
    down = slice(1, 3)
    np.testing.assert_allclose(shot.position(landing.time).y[down], 0.0, atol=1e-14)
    assert np.all(landing.vy[down] < 0)
    assert np.all(np.isnan(launcher.shot([0.5, 1.2], height=1.0, wind=wind).flight_time))


def test_a_wind_that_is_no_vector_is_refused():
    with pytest.raises(TypeError, match=r"^wind must be \(x, y\) or \(x, y, z\) in m/s, got 3\.0$"):
        Launcher(10.0, epsilon=0.1).shot(0.5, wind=3.0)

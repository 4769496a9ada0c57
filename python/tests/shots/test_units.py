"""Quantities of pint: the same numbers, with units on them."""

import copy
import pickle

import numpy as np
import pint
import pytest

from archerfish import Launcher
from archerfish.aim import minimum_speed
from archerfish.named_angles import rightmost_angle
from archerfish.series import paper_series

UREG = pint.UnitRegistry()
Q = UREG.Quantity
PLAIN = Launcher(10.0, drag_rate=0.3)


@pytest.fixture
def launcher():
    return Launcher(Q(36.0, "km/hour"), drag_rate=Q(18.0, "1/minute"))


def test_any_unit_of_the_kind_is_taken(launcher):
    assert launcher.speed == Q(10.0, "m/s")
    assert launcher.epsilon.magnitude == pytest.approx(PLAIN.epsilon, rel=1e-15)
    assert launcher.length_scale.to("cm").magnitude == pytest.approx(100 * PLAIN.length_scale)
    with pytest.raises(pint.DimensionalityError):
        Launcher(Q(1.0, "kg"), epsilon=0.1)


def test_shots_answer_in_units(launcher):
    shot = launcher.shot(Q(45, "degree"), height=Q(150, "cm"), wind=(Q(-2, "m/s"), Q(0, "m/s")))
    plain = PLAIN.shot(np.radians(45), height=1.5, wind=(-2.0, 0.0))
    for found, number, unit in (
        (shot.range, plain.range, "m"),
        (shot.flight_time, plain.flight_time, "s"),
        (shot.apex.y, plain.apex.y, "m"),
        (shot.landing.speed, plain.landing.speed, "m/s"),
        (shot.landing.velocity.x, plain.landing.velocity.x, "m/s"),
        (shot.landing.angle, plain.landing.angle, "rad"),
        (shot.position(Q(200, "ms")).x, plain.position(0.2).x, "m"),
        (shot.velocity(0.2).y, plain.velocity(0.2).y, "m/s"),
        (shot.height_at(Q(300, "cm")), plain.height_at(3.0), "m"),
        (shot.path_length(), plain.path_length(), "m"),
        (shot.energy(Q(0.2, "s")).total, plain.energy(0.2).total, "J/kg"),
        (shot.gradients.range.angle, plain.gradients.range.angle, "m/rad"),
        (shot.gradients.apex_time.gravity, plain.gradients.apex_time.gravity, "s/(m/s**2)"),
        (shot.propagate(speed=Q(10, "cm/s")).range, plain.propagate(speed=0.1).range, "m"),
    ):
        assert found.units == Q(1.0, unit).units
        assert found.magnitude == pytest.approx(number, rel=1e-13)


def test_aim_envelope_and_angles(launcher):
    arcs = launcher.aim(Q(500, "cm"), Q(1, "m"))
    plain = PLAIN.aim(5.0, 1.0)
    assert arcs.reachable is True
    assert arcs.low.angle.to("degree").magnitude == pytest.approx(np.degrees(plain.low.angle))
    assert arcs.high.clearance_over(Q(3, "m"), Q(2, "m")).units == UREG.meter
    assert arcs.low.angle_gradient.speed.units == Q(1.0, "rad/(m/s)").units
    assert launcher.aim(Q(50, "m"), Q(50, "m")).margin.units == UREG.meter
    assert launcher.minimum_speed(Q(9, "m"), 3.0).magnitude == pytest.approx(
        PLAIN.minimum_speed(9.0, 3.0)
    )
    assert launcher.envelope.height(Q(3, "m")).magnitude == pytest.approx(
        PLAIN.envelope.height(3.0)
    )
    assert launcher.locus.highest.y.units == UREG.meter
    assert launcher.named_angles().longest_path.units == UREG.radian
    assert launcher.front(Q(1, "s")).radius.units == UREG.meter


LENGTH, TIME, ANGLE = Q(150, "cm"), Q(200, "ms"), Q(40, "degree")
SHOT, ARCS = PLAIN.shot(0.7), PLAIN.aim(5.0, 1.0)
WITHOUT_UNITS = {
    "shot": lambda: PLAIN.shot(ANGLE),
    "shot, azimuth": lambda: PLAIN.shot(0.7, azimuth=ANGLE),
    "shot, height": lambda: PLAIN.shot(0.7, height=LENGTH),
    "shot, list of grounds": lambda: PLAIN.shot(0.7, ground=[0.0, LENGTH]),
    "shot, wind": lambda: PLAIN.shot(0.7, wind=(Q(1, "km/hour"), 0.0)),
    "shot, array of winds": lambda: PLAIN.shot(0.7, wind=Q([1.0, 2.0], "km/hour")),
    "aim, x": lambda: PLAIN.aim(LENGTH, 1.0),
    "aim, y": lambda: PLAIN.aim(1.0, LENGTH),
    "aim, z": lambda: PLAIN.aim(1.0, 1.0, LENGTH),
    "aim, height": lambda: PLAIN.aim(1.0, 1.0, height=LENGTH),
    "minimum speed": lambda: PLAIN.minimum_speed(LENGTH, LENGTH),
    "minimum speed by itself": lambda: minimum_speed(LENGTH, 1.0, gravity=9.8, drag_rate=0.0),
    "its gravity": lambda: minimum_speed(1.0, 1.0, gravity=Q(1, "cm/s**2"), drag_rate=0.0),
    "reachable, x": lambda: PLAIN.reachable(LENGTH, 1.0),
    "reachable, y": lambda: PLAIN.reachable(1.0, LENGTH),
    "reachable, height": lambda: PLAIN.reachable(1.0, 1.0, height=LENGTH),
    "front": lambda: PLAIN.front(TIME),
    "point of a front": lambda: PLAIN.front(1.0).point(ANGLE),
    "envelope": lambda: PLAIN.envelope.height(LENGTH),
    "envelope contains": lambda: PLAIN.envelope.contains(1.0, LENGTH),
    "position": lambda: SHOT.position(TIME),
    "velocity": lambda: SHOT.velocity(TIME),
    "energy": lambda: SHOT.energy(TIME),
    "time at": lambda: SHOT.time_at(LENGTH),
    "time again at": lambda: SHOT.time_again_at(LENGTH),
    "height at": lambda: SHOT.height_at(LENGTH),
    "path length": lambda: SHOT.path_length(TIME),
    "sample": lambda: SHOT.sample(LENGTH),
    "propagate": lambda: SHOT.propagate(speed=Q(10, "cm/s")),
    "covariance": lambda: SHOT.propagate(covariance=Q(np.eye(4), "m**2")),
    "clearance over x": lambda: ARCS.low.clearance_over(LENGTH, 1.0),
    "clearance over y": lambda: ARCS.low.clearance_over(1.0, LENGTH),
    "clearance under": lambda: ARCS.low.clearance_under(LENGTH),
    "locus": lambda: PLAIN.locus.at_launch_angle(ANGLE),
    "locus by elevation": lambda: PLAIN.locus.at_elevation(ANGLE),
    "length from": lambda: PLAIN.locus.arc_length(ANGLE, 1.0),
    "length to": lambda: PLAIN.locus.arc_length(0.0, ANGLE),
    "series": lambda: paper_series(4).launch_angle(ANGLE, 0.1),
    "series, drag": lambda: paper_series(4).launch_angle(0.1, Q(10, "percent")),
    "named angle": lambda: rightmost_angle(Q(10, "percent")),
    "launcher, nested lists": lambda: Launcher([[1.0], [Q(10, "cm/s")]], epsilon=0.1),
}


@pytest.mark.parametrize("call", WITHOUT_UNITS.values(), ids=WITHOUT_UNITS)
def test_no_unit_is_lost_without_a_word(call):
    """NumPy drops a unit where it makes an array of doubles: 150 cm would be 150 m."""
    with pytest.raises(TypeError, match=r"must be plain numbers in SI units, got .*: quantities"):
        call()


def test_a_sphere_and_arrays():
    mist = Launcher.from_sphere(
        Q([10, 20], "µm"), Q(1, "g/cm**3"), Q(0.0181, "mPa*s"), Q(1.2, "g/l"), Q(20, "cm/s")
    )
    plain = Launcher.from_sphere([10e-6, 20e-6], 1000.0, 1.81e-5, 1.2, 0.2)
    np.testing.assert_allclose(mist.drag_rate.to("1/s").magnitude, plain.drag_rate)
    assert mist.reynolds_number.dimensionless
    assert mist.shot(0.5).range.shape == (2,)
    np.testing.assert_allclose(mist.plain.drag_rate, plain.drag_rate)


def test_plain_numbers_stay_plain():
    assert isinstance(PLAIN.shot(0.5).range, float)
    assert type(Launcher(10.0, epsilon=0.1)) is Launcher


def test_a_changed_launcher_answers_in_units(launcher):
    faster = launcher.replace(speed=Q(72.0, "km/hour"))
    assert faster.speed == Q(20.0, "m/s")
    assert faster.drag_rate == launcher.drag_rate


def test_a_launcher_in_units_is_pickled_and_copied(launcher):
    for again in (pickle.loads(pickle.dumps(launcher)), copy.deepcopy(launcher)):
        assert again == launcher
        assert str(again.shot(0.5).range.units) == "meter"

"""The launcher: one drag said three ways, its scales, what it refuses."""

import copy
import dataclasses

import numpy as np
import pytest

from archerfish import ApexLocus, Launcher


@pytest.mark.parametrize("name", ["epsilon", "drag_rate", "terminal_speed"])
@pytest.mark.parametrize("drag", [1e-9, *np.linspace(0.1, 0.9, 17).tolist(), 7.0, 1e6])
def test_the_drag_given_is_kept_and_the_other_two_follow(name, drag):
    launcher = Launcher(12.5, gravity=3.7, **{name: drag})
    assert getattr(launcher, name) == drag
    assert launcher.epsilon == pytest.approx(launcher.drag_rate * 12.5 / 3.7, rel=4e-16, abs=0)
    assert launcher.epsilon == pytest.approx(12.5 / launcher.terminal_speed, rel=4e-16, abs=0)


@pytest.mark.parametrize("drag", [{"epsilon": 0}, {"drag_rate": 0}, {"terminal_speed": np.inf}])
def test_no_drag_said_three_ways(drag):
    launcher = Launcher(10, **drag)
    assert (launcher.epsilon, launcher.drag_rate, launcher.terminal_speed) == (0.0, 0.0, np.inf)


def test_scales():
    launcher = Launcher(10.0, epsilon=0.1)
    assert launcher.gravity == 9.80665
    assert launcher.length_scale == 100 / 9.80665
    assert launcher.time_scale == 10 / 9.80665


def test_locus_is_made_once_and_carries_the_scales():
    launcher = Launcher(10.0, epsilon=0.1)
    assert launcher.locus is launcher.locus
    assert launcher.locus == ApexLocus(0.1, launcher.length_scale, launcher.time_scale)


@pytest.mark.parametrize(
    ("given", "got"),
    [
        ({}, "none"),
        ({"epsilon": 0.1, "drag_rate": 1.0}, "epsilon and drag_rate"),
        (
            {"epsilon": 0.1, "drag_rate": 1.0, "terminal_speed": 3.0},
            "epsilon and drag_rate and terminal_speed (to change a launcher: launcher.replace)",
        ),
    ],
)
def test_exactly_one_drag(given, got):
    with pytest.raises(TypeError) as refusal:
        Launcher(10.0, **given)
    assert str(refusal.value) == (
        f"give exactly one of epsilon, drag_rate, terminal_speed; got {got}"
    )


@pytest.mark.parametrize("drag", ["epsilon", "drag_rate", "terminal_speed"])
def test_a_launcher_with_another_speed_keeps_the_drag_it_was_given(drag):
    launcher = Launcher(10.0, gravity=9.0, **{drag: 0.3})
    assert launcher.replace() == launcher
    assert launcher.replace(speed=20.0) == Launcher(20.0, gravity=9.0, **{drag: 0.3})
    again = launcher.replace(speed=20.0, gravity=3.0).replace(speed=[1.0, 2.0])
    assert again == Launcher([1.0, 2.0], gravity=3.0, **{drag: 0.3})
    for other in ("epsilon", "drag_rate", "terminal_speed"):
        changed = launcher.replace(**{other: getattr(launcher, other)}, speed=4.0)
        assert changed == Launcher(4.0, gravity=9.0, **{other: getattr(launcher, other)})
    with pytest.raises(ValueError, match=r"^speed must be above 0 and finite, got -1.0$"):
        launcher.replace(speed=-1)
    with pytest.raises(TypeError, match=r"to change a launcher: launcher\.replace"):
        dataclasses.replace(launcher, speed=20.0)
    if hasattr(copy, "replace"):  # Python 3.13
        assert copy.replace(launcher, speed=20.0) == launcher.replace(speed=20.0)


@pytest.mark.parametrize("bad", [0.0, -1.0, np.nan, np.inf])
def test_speed_and_gravity_are_above_0_and_finite(bad):
    with pytest.raises(ValueError, match=f"^speed must be above 0 and finite, got {bad}$"):
        Launcher(bad, epsilon=0.1)
    with pytest.raises(ValueError, match=f"^gravity must be above 0 and finite, got {bad}$"):
        Launcher(10.0, gravity=bad, epsilon=0.1)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"epsilon": -0.1}, "epsilon must be at least 0 and finite, got -0.1"),
        ({"epsilon": np.nan}, "epsilon must be at least 0 and finite, got nan"),
        ({"drag_rate": np.inf}, "drag_rate must be at least 0 and finite, got inf"),
        ({"terminal_speed": 0.0}, "terminal_speed must be above 0, got 0.0"),
        (
            {"terminal_speed": 5e-324},
            "epsilon, from this terminal_speed, must be at least 0 and finite, got inf",
        ),
        (
            {"epsilon": [0.1, -2.0]},
            "epsilon must be at least 0 and finite, got -2.0 among 2 values",
        ),
    ],
)
def test_drag_within_its_bounds(given, message):
    with pytest.raises(ValueError) as refusal:  # noqa: PT011
        Launcher(10.0, **given)
    assert str(refusal.value) == message


def test_scales_must_be_finite_and_above_0_too():
    with pytest.raises(ValueError, match=r"^length scale speed²/gravity must be .*, got inf$"):
        Launcher(1e200, epsilon=0.1)
    with pytest.raises(ValueError, match=r"^length scale speed²/gravity must be .*, got 0.0$"):
        Launcher(1e-200, epsilon=0.1)


def test_a_drag_rate_that_overflows_leaves_the_locus_and_no_shot():
    launcher = Launcher(10.0, gravity=100.0, epsilon=1e308)
    assert launcher.locus.highest.y > 0
    asked = [
        lambda: launcher.shot(0.7),
        lambda: launcher.aim(0.0, -1.0),
        lambda: launcher.front(1.0),
        lambda: launcher.minimum_speed(0.0, -1.0),
    ]
    for ask in asked:
        with pytest.raises(ValueError, match=r"^drag rate.* must be .*finite, got inf$"):
            ask()


def test_fields_broadcast_or_are_refused():
    launcher = Launcher([[5.0], [10.0]], epsilon=[0.0, 0.1, 1.0])
    assert launcher.terminal_speed.shape == (2, 3)
    assert launcher.length_scale.shape == (2, 1)
    with pytest.raises(ValueError, match=r"^shapes must broadcast, got speed \(2,\), .*\(3,\)"):
        Launcher([5.0, 10.0], epsilon=[0.0, 0.1, 1.0])


def test_a_launcher_is_a_value():
    launcher = Launcher(10.0, epsilon=0.1)
    assert launcher == Launcher(10, epsilon=0.1)
    assert launcher != Launcher(10.0, epsilon=0.2)
    assert launcher != launcher.locus
    assert hash(launcher) == hash(Launcher(10, epsilon=0.1))
    arrays = Launcher([5.0, 10.0], epsilon=0.1), Launcher([5.0, 10.0], epsilon=0.1)
    assert arrays[0] == arrays[1]
    assert hash(arrays[0]) == hash(arrays[1])
    with pytest.raises(dataclasses.FrozenInstanceError):
        launcher.speed = 5.0
    with pytest.raises(AttributeError):
        launcher.length_scale = 5.0


def test_repr_tells_every_way_to_say_the_drag():
    assert repr(Launcher(10, gravity=10, epsilon=0.5)) == (
        "Launcher(speed=10.0, gravity=10.0, epsilon=0.5, drag_rate=0.5, terminal_speed=20.0)"
    )

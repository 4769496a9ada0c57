"""The examples run, and what they find is so: checked with an ODE solver and by Monte Carlo."""

import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

FOLDER = Path(__file__).parents[2] / "examples"
NAMES = ["ball_over_wall", "droplet_printer", "fire_hose", "game_throw"]


def load(name):
    spec = importlib.util.spec_from_file_location(name, FOLDER / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def flown(velocity, start, drag_rate, *, gravity=9.80665, wind=(0.0, 0.0, 0.0), until=4.0):
    """A solution of the equation of motion, as a function of time: place, then velocity."""

    def motion(_, state):
        pull = -drag_rate * (state[3:] - wind) - [0.0, gravity, 0.0]
        return np.concatenate([state[3:], pull])

    state = np.concatenate([start, velocity])
    return solve_ivp(
        motion, (0, until), state, "DOP853", rtol=1e-11, max_step=until / 100, dense_output=True
    ).sol


def test_they_are_all_here():
    assert sorted(path.stem for path in FOLDER.glob("*.py")) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_as_a_user_runs_it(name, tmp_path):
    done = subprocess.run(
        [sys.executable, FOLDER / f"{name}.py"],
        capture_output=True,
        encoding="utf-8",
        cwd=tmp_path,
        env={**os.environ, "PYTHONIOENCODING": "utf-8"},
        check=True,
    )
    assert done.stderr == ""
    assert len(done.stdout.splitlines()) >= 4
    assert "nan" not in done.stdout


def test_the_hose_hits_the_window(capsys):
    hose = load("fire_hose")
    found = hose.main()
    elevation, azimuth = found["elevation"], found["azimuth"]
    level = 28.0 * np.cos(elevation)
    launch = [level * np.cos(azimuth), 28.0 * np.sin(elevation), level * np.sin(azimuth)]
    path = flown(launch, [0.0, hose.NOZZLE, 0.0], hose.DRAG_RATE, wind=hose.WIND)
    states = path(np.linspace(0, 4, 200_001))
    miss = np.linalg.norm(states[:3].T - hose.WINDOW, axis=1)
    assert miss.min() < 1e-3
    assert np.linalg.norm(states[3:, miss.argmin()]) == pytest.approx(
        found["impact_speed"], rel=1e-4
    )
    assert 15 < found["minimum_speed"] < 28
    assert "azimuth" in capsys.readouterr().out


def test_the_ball_clears_the_wall_and_lands_in_the_bin(capsys):
    ball = load("ball_over_wall")
    found = ball.main()
    speed, angle = found["speed"], found["angle"]
    drag_rate = 9.80665 / ball.TERMINAL_SPEED
    launch = [speed * np.cos(angle), speed * np.sin(angle), 0.0]
    x, y, _, _, vy, _ = flown(launch, [0.0, ball.HAND, 0.0], drag_rate)(np.linspace(0, 2, 200_001))
    over = np.interp(ball.WALL[0], x, y) - ball.WALL[1]
    assert over == pytest.approx(found["clearance"], abs=1e-7)
    assert over >= ball.MARGIN
    down = np.flatnonzero((y <= ball.BIN[1]) & (vy < 0))[0]
    assert x[down] == pytest.approx(ball.BIN[0], abs=1e-4)
    assert found["spread"] < ball.BIN_RADIUS / 3
    assert "into the bin" in capsys.readouterr().out


def test_the_throws_are_free(capsys):
    game = load("game_throw")
    found = game.main()
    lines = capsys.readouterr().out.splitlines()
    assert found["taken"] == sum("throw" in line for line in lines)
    assert 0 < found["taken"] < len(lines)
    assert {"low", "high"} == {line.split()[4] for line in lines if "throw" in line}
    last = [line for line in lines if "throw" in line][-1]
    target = float(last.split()[2])
    launch = [13.0 * np.cos(found["last"]), 13.0 * np.sin(found["last"]), 0.0]
    x, y, *_ = flown(launch, [0.0, game.HAND, 0.0], 0.4, gravity=20.0)(np.linspace(0, 2, 100_001))
    assert np.interp(game.CRATE[0], x, y) > game.CRATE[1]
    assert y[x <= target].max() < game.CEILING
    assert np.interp(target, x, y) == pytest.approx(0.5, abs=1e-3)


def test_the_droplets_are_carried_as_far_as_an_integration_says(capsys):
    printer = load("droplet_printer")
    found = printer.main()
    drag_rate = 18 * printer.AIR_VISCOSITY / printer.INK_DENSITY / found["diameter"] ** 2
    wind = (printer.DRAUGHT, 0.0, 0.0)

    def carried(speed):
        path = flown([0.0, -speed, 0.0], [0.0, printer.GAP, 0.0], drag_rate, wind=wind, until=2e-3)
        x, y, *_ = path(np.linspace(0, 2e-3, 20_001))
        return np.interp(0.0, -y, x)

    assert carried(1.2) == pytest.approx(found["carried"], rel=1e-5)
    slope = (carried(1.21) - carried(1.19)) / 0.02
    assert abs(slope) * 0.06 == pytest.approx(found["smear"], rel=1e-2)
    assert found["reynolds_number"] < 1
    assert "µm" in capsys.readouterr().out

"""`archerfish shot`, `aim`, `angles`, `envelope`: one case each, as the library has it."""

import csv
import io
import json
import re
import shlex

import numpy as np
import pytest

from archerfish import Launcher

SHOT = ("shot", "--speed", "10", "--epsilon", "0.1", "--angle", "45")
AIM = ("aim", "--speed", "10", "--epsilon", "0.1")
ENVELOPE = ("envelope", "--speed", "10", "--epsilon", "0.1")
COMMANDS = ["shot", "aim", "angles", "envelope"]
INPUTS = {
    "shots.csv": "launch_angle_deg,speed_m_per_s,epsilon\n45,10,0.1\n",
    "angles.csv": "launch_angle_deg\n45\n",
    "targets.csv": "x_m,y_m\n6,2\n",
    "drags.csv": "epsilon\n0.1\n",
    "places.csv": "x_m\n6\n",
}


def cells(text):
    """The rows of a table by their first cell; columns are two blanks apart."""
    rows = [re.split(r"\s{2,}", line.strip()) for line in text.splitlines() if line.strip()]
    return {row[0]: row[1:] for row in rows}


def row(text):
    [found] = csv.DictReader(io.StringIO(text))
    return found


@pytest.mark.parametrize("name", COMMANDS)
def test_help_has_examples_and_each_runs(output, tmp_path, name):
    for file, content in INPUTS.items():
        (tmp_path / file).write_text(content)
    text = output(name, "--help")
    assert max(map(len, text.splitlines())) <= 100
    lines = [line for line in text.splitlines() if line.startswith("    archerfish")]
    assert len(lines) >= 3
    for line in lines:
        call, _, source = line.split(">")[0].partition("<")
        given = (tmp_path / source.strip()).read_text() if source else None
        assert output(*shlex.split(call)[1:], input=given)


def test_shot_table(output):
    shot = Launcher(10, epsilon=0.1).shot(np.radians(45))
    free = Launcher(10, epsilon=0.0).shot(np.radians(45))
    table = cells(output(*SHOT))
    for label, get in {
        "apex x (m)": lambda s: s.apex.x,
        "apex height y (m)": lambda s: s.apex.y,
        "range x (m)": lambda s: s.range,
        "flight time (s)": lambda s: s.flight_time,
        "landing speed (m/s)": lambda s: s.landing.speed,
        "landing angle (°)": lambda s: np.degrees(s.landing.angle),
        "length of the path (m)": lambda s: s.path_length(),
    }.items():
        found = [float(cell) for cell in table[label]]
        np.testing.assert_allclose(found, [get(shot), get(free)], rtol=1e-5)
    assert "sideways z (m)" not in table


def test_a_shot_in_wind_from_a_height_as_csv_and_json(output):
    flags = ("--height", "2", "--ground", "-1", "--wind-x", "-3", "--wind-z", "4", "--azimuth", "9")
    shot = Launcher(10, epsilon=0.1).shot(
        np.radians(45), azimuth=np.radians(9), height=2, ground=-1, wind=(-3, 0, 4)
    )
    found = row(output(*SHOT, *flags, "--format", "csv"))
    assert float(found["landing_x_m"]) == shot.range
    assert float(found["landing_z_m"]) == shot.landing.z
    assert float(found["flight_time_s"]) == shot.flight_time
    assert float(found["apex_y_m"]) == shot.apex.y
    document = json.loads(output(*SHOT, *flags, "--format", "json"))
    assert {name: str(value) for name, value in document.items()} == found


def test_a_shot_that_never_lands_says_so(output):
    text = output(*SHOT, "--ground", "5")
    assert text.endswith("It never comes down to the ground.\n")
    assert cells(text)["range x (m)"] == ["–", "–"]
    assert json.loads(output(*SHOT, "--ground", "5", "--format", "json"))["flight_time_s"] is None


def test_aim_table(output):
    text = output(*AIM, "--x", "6", "--y", "2", "--obstacle", "3", "2.5", "--ceiling", "4")
    arcs = Launcher(10, epsilon=0.1).aim(6, 2)
    table = cells(text)
    pair = (arcs.low, arcs.high)
    for label, get in {
        "launch angle (°)": lambda arc: np.degrees(arc.angle),
        "time to the target (s)": lambda arc: arc.time,
        "impact speed (m/s)": lambda arc: arc.impact_speed,
        "impact angle (°)": lambda arc: np.degrees(arc.impact_angle),
    }.items():
        found = [float(cell) for cell in table[label]]
        np.testing.assert_allclose(found, [get(arc) for arc in pair], rtol=1e-5)
    over, under = table["above 3 m, 2.5 m (m)"], table["below 4 m (m)"]
    assert [cell.split()[1] for cell in (*over, *under)] == ["hits", "clear", "clear", "clear"]
    assert float(over[1].split()[0]) == pytest.approx(arcs.high.clearance_over(3.0, 2.5), rel=1e-5)
    assert float(table["least speed that reaches it"][0].split()[0]) == pytest.approx(
        arcs.minimum_speed, rel=1e-5
    )


def test_aim_in_space(output):
    flags = ("--x", "6", "--y", "1", "--z", "2", "--wind-z", "-3", "--format", "json")
    document = json.loads(output(*AIM, *flags))
    arcs = Launcher(10, epsilon=0.1).aim(6, 1, 2, wind=(0, 0, -3))
    assert document["low_azimuth_deg"] == np.degrees(arcs.low.azimuth)
    assert document["high_launch_angle_deg"] == np.degrees(arcs.high.angle)
    assert document["status"] == "reachable"


@pytest.mark.parametrize("form", ["table", "csv", "json"])
def test_out_of_reach_is_status_3_and_says_by_how_much(command, form):
    done = command(*AIM, "--x", "9", "--y", "3", "--format", form)
    assert (done.returncode, done.stderr) == (3, "")
    answer = Launcher(10, epsilon=0.1).aim(9, 3)
    if form == "table":
        assert (
            f"unreachable                  {answer.margin:.6g} m above the envelope" in done.stdout
        )
        assert f"{answer.minimum_speed:.6g} m/s" in done.stdout
    elif form == "csv":
        assert float(row(done.stdout)["margin_m"]) == answer.margin
        assert row(done.stdout)["status"] == "unreachable"
    else:
        assert json.loads(done.stdout)["minimum_speed_m_per_s"] == answer.minimum_speed
    wall = command(*AIM, "--x", "150", "--y", "-1000")
    assert wall.returncode == 3
    assert "beyond the distance V₀/b that drag allows" in wall.stdout


def test_angles(output):
    table = cells(output("angles", "--epsilon", "0.1"))
    assert table["greatest range"] == ["43.7096921819", "45.0000000000"]
    assert table["sharpest bend of the locus"] == ["43.7869703699", "45.0000000000"]
    assert table["longest path"] == ["56.3091153064", "56.4658351275"]
    assert table["largest area under the path"] == ["59.3188519596", "60.0000000000"]
    assert table["greatest ρK"] == ["8.424601339", "8"]
    same = json.loads(
        output("angles", "--speed", "9.80665", "--terminal-speed", "98.0665", "--format", "json")
    )
    assert same["farthest_deg"] == pytest.approx(54.0365143493, abs=1e-10)


def test_envelope(output):
    envelope = Launcher(10, epsilon=0.1).envelope
    table = cells(output(*ENVELOPE))
    assert table["highest"] == ["4.78229 m (drag-free 5.09858 m)"]
    assert table["greatest range"][0].startswith(f"{envelope.reach:.6g} m")
    assert table["no shot gets to x"] == ["101.972 m"]
    text = output(*ENVELOPE, "--format", "csv", "--points", "7")
    header, *rows = csv.reader(io.StringIO(text))
    assert header == ["x_m", "envelope_height_m"]
    x, y = np.array(rows, dtype=float).T
    np.testing.assert_array_equal(x, np.linspace(0, envelope.reach, 7))
    np.testing.assert_array_equal(y, np.maximum(envelope.height(x), 0.0))


@pytest.mark.parametrize(
    "arguments",
    [
        SHOT,
        (*SHOT, "--height", "3", "--wind-x", "-5"),
        (*AIM, "--x", "6", "--y", "2"),
        (*AIM, "--x", "-6", "--y", "2", "--wind-x", "1"),
        ("angles", "--epsilon", "0.1"),
        ENVELOPE,
    ],
)
def test_figures_and_files(output, tmp_path, arguments):
    text = output(*arguments, "--output", "a.csv", "--figure", "a.svg")
    assert text.endswith("wrote a.csv\nwrote a.svg\n")
    assert (tmp_path / "a.svg").read_bytes().startswith(b"<?xml")
    assert (tmp_path / "a.csv").read_text() == output(*arguments, "--format", "csv")


def test_an_unreachable_target_has_a_figure_too(command, tmp_path):
    done = command(*AIM, "--x", "9", "--y", "3", "--figure", "a.svg")
    assert done.returncode == 3
    assert "above the envelope" in (tmp_path / "a.svg").read_text()


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (("shot", "--speed", "1", "--epsilon", "1"), "shot: Missing option '--angle'. See"),
        (
            ("shot", "--speed", "1", "--angle", "3"),
            "shot: give exactly one of epsilon, drag_rate, terminal_speed; got none",
        ),
        (
            (*SHOT[:-1], "200"),
            "shot: launch angle must be from -180 to 180 degrees, got 200.0",
        ),
        ((*SHOT, "--height", "inf"), "shot: height must be finite, got inf"),
        ((*AIM, "--x", "1"), "aim: Missing option '--y'. See"),
        ((*AIM, "--x", "nan", "--y", "1"), "aim: target x must be finite, got nan"),
        (("angles",), "angles: give exactly one of epsilon, drag_rate, terminal_speed; got none"),
        (("angles", "--drag-rate", "1"), "angles: give --speed with --drag-rate, or --epsilon"),
        (("envelope", "--epsilon", "1"), "envelope: Missing option '--speed'. See"),
        ((*SHOT, "--figure", "a.txt"), "shot: a figure must end in .png, .svg, .pdf, got a.txt"),
    ],
)
def test_bad_input_is_one_line_and_status_2(command, tmp_path, arguments, line):
    done = command(*arguments)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith(f"archerfish {line}")
    assert done.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == []

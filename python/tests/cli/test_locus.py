"""`archerfish locus`: the same numbers as the library, in columns that name their units."""

import csv
import io
import json
import re

import numpy as np
import pytest

from archerfish import Launcher

SHOT = ("locus", "--speed", "10", "--epsilon", "0.1")
COLUMNS = [
    "launch_angle_deg",
    "elevation_deg",
    "x_m",
    "y_m",
    "distance_m",
    "time_s",
    "curvature_per_m",
]


def columns(text):
    header, *rows = csv.reader(io.StringIO(text))
    assert header == COLUMNS
    return dict(zip(header, np.array(rows, dtype=float).T, strict=True))


def assert_same_points(found, points):
    for name, field in zip(COLUMNS[2:], ("x", "y", "distance", "time", "curvature"), strict=True):
        assert np.array_equal(found[name], getattr(points, field)), name


def test_csv_gives_back_every_number_exactly(output):
    found = columns(output(*SHOT, "--format", "csv", "--points", 37))
    degrees = np.linspace(0, 90, 37)
    points = Launcher(10, epsilon=0.1).locus.at_launch_angle(np.radians(degrees))
    assert np.array_equal(found["launch_angle_deg"], degrees)
    assert np.array_equal(found["elevation_deg"], np.degrees(points.elevation))
    assert_same_points(found, points)


def test_by_elevation(output):
    found = columns(output(*SHOT, "--format", "csv", "--points", 19, "--by", "elevation"))
    degrees = np.linspace(0, 90, 19)
    points = Launcher(10, epsilon=0.1).locus.at_elevation(np.radians(degrees))
    assert np.array_equal(found["elevation_deg"], degrees)
    assert np.array_equal(found["launch_angle_deg"], np.degrees(points.launch_angle))
    assert_same_points(found, points)


@pytest.mark.parametrize(
    ("flags", "drag"),
    [
        (("--drag-rate", "0.7"), {"drag_rate": 0.7}),
        (("--terminal-speed", "30"), {"terminal_speed": 30}),
        (("--terminal-speed", "inf"), {"epsilon": 0}),
    ],
)
def test_drag_and_gravity(output, flags, drag):
    text = output("locus", "--speed", "8", "--gravity", "1.62", *flags, "--format", "csv")
    found = columns(text)
    points = Launcher(8, gravity=1.62, **drag).locus.at_launch_angle(np.radians(np.arange(91.0)))
    assert_same_points(found, points)


def test_json_carries_launcher_summary_and_points(output):
    document = json.loads(output(*SHOT, "--format", "json", "--points", 5))
    launcher = Launcher(10, epsilon=0.1)
    assert document["launcher"] == {
        "speed_m_per_s": 10.0,
        "gravity_m_per_s2": 9.80665,
        "epsilon": 0.1,
        "drag_rate_per_s": launcher.drag_rate,
        "terminal_speed_m_per_s": 100.0,
        "length_scale_m": launcher.length_scale,
        "time_scale_s": launcher.time_scale,
    }
    for key, locus in (("with_drag", launcher.locus), ("drag_free", launcher.locus.drag_free)):
        summary = document["summary"][key]
        assert summary["arc_length_m"] == locus.arc_length()
        assert summary["area_m2"] == locus.area
        for name in ("highest", "rightmost", "farthest", "max_curvature"):
            assert list(summary[name]) == COLUMNS
            assert summary[name]["x_m"] == getattr(locus, name).x
            assert summary[name]["curvature_per_m"] == getattr(locus, name).curvature
    assert [list(point) for point in document["points"]] == [COLUMNS] * 5
    assert [point["launch_angle_deg"] for point in document["points"]] == [0, 22.5, 45, 67.5, 90]


def test_json_has_null_for_an_infinite_terminal_speed(output):
    text = output("locus", "--speed", "10", "--epsilon", "0", "--format", "json")
    document = json.loads(text, parse_constant=lambda name: pytest.fail(f"{name} is not JSON"))
    assert document["launcher"]["terminal_speed_m_per_s"] is None


def test_the_summary_says_what_the_library_says(output):
    text = output(*SHOT)
    launcher = Launcher(10, epsilon=0.1)
    rows = {}
    for line in text.splitlines():
        label, *cells = re.split(r"\s{2,}", line.strip())
        rows.setdefault(label, []).append(cells)
    assert rows["drag parameter ε"] == [["0.1"]]
    assert rows["length scale ρ = V₀²/g"] == [["10.1972 m"]]
    assert rows["terminal speed"] == [["100 m/s"]]
    for index, (label, name) in enumerate(
        [
            ("highest", "highest"),
            ("rightmost", "rightmost"),
            ("farthest", "farthest"),
            ("sharpest bend", "max_curvature"),
        ]
    ):
        for cells, locus in (
            (rows[label][0], launcher.locus),
            (rows["drag-free"][index], launcher.locus.drag_free),
        ):
            point = getattr(locus, name)
            expected = [
                np.degrees(point.launch_angle),
                np.degrees(point.elevation),
                point.x,
                point.y,
                point.distance,
                point.time,
                point.curvature,
            ]
            np.testing.assert_allclose([float(cell) for cell in cells], expected, atol=6e-5)
    [[length, free, ratio]] = rows["length (m)"]
    assert float(length) == pytest.approx(launcher.locus.arc_length(), rel=1e-5)
    assert float(free) == pytest.approx(launcher.locus.drag_free.arc_length(), rel=1e-5)
    assert float(ratio) == pytest.approx(float(length) / float(free), rel=1e-3)
    [[area, _, _]] = rows["area to the vertical axis (m²)"]
    assert float(area) == pytest.approx(launcher.locus.area, rel=1e-5)
    [[bend, _, _]] = rows["greatest ρK"]
    assert float(bend) == pytest.approx(8.4246013385226, rel=1e-5)


def test_the_table_has_ten_points_or_as_many_as_asked(output):
    def angles(text):
        table = text.split("Apexes, evenly spaced in launch angle\n")[1]
        return [float(line.split()[0]) for line in table.splitlines()[2:] if line]

    assert angles(output(*SHOT)) == list(range(0, 91, 10))
    assert angles(output(*SHOT, "--points", "3")) == [0, 45, 90]


def test_output_takes_its_format_from_the_name_and_the_terminal_gets_the_summary(output, tmp_path):
    text = output(*SHOT, "--output", "locus.csv", "--points", "7")
    assert columns((tmp_path / "locus.csv").read_text())["x_m"].size == 7
    assert "Named apexes" in text
    assert text.endswith("wrote locus.csv\n")
    output(*SHOT, "--output", "locus.json")
    assert json.loads((tmp_path / "locus.json").read_text())["points"]
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["locus.csv", "locus.json"]


def test_a_table_can_be_written_too(output, tmp_path):
    assert output(*SHOT, "--output", "locus.txt") == "wrote locus.txt\n"
    assert (tmp_path / "locus.txt").read_text(encoding="utf-8") == output(*SHOT)


def test_the_demo_leaves_a_csv_and_figure_1_twice(output, tmp_path):
    text = output(
        *SHOT, "--output", "locus.csv", "--figure", "figure1.svg", "--figure", "figure1.png"
    )
    assert text.splitlines()[-3:] == ["wrote locus.csv", "wrote figure1.svg", "wrote figure1.png"]
    assert columns((tmp_path / "locus.csv").read_text())["x_m"].size == 91
    assert (tmp_path / "figure1.svg").read_bytes().startswith(b"<?xml")
    assert (tmp_path / "figure1.png").read_bytes().startswith(b"\x89PNG\r\n")


@pytest.mark.parametrize("epsilon", ["0", "5e-324", "1e-9", "1e9", "1e300"])
@pytest.mark.parametrize("speed", ["1e-90", "1e90"])
def test_any_drag_at_any_speed_is_answered_in_silence(output, speed, epsilon):
    assert "Named apexes" in output("locus", "--speed", speed, "--epsilon", epsilon)

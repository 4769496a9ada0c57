"""Batches: every row answered or explained, in little memory, whole or not at all."""

import csv
import io
import os
import subprocess
import sys

import numpy as np
import pytest

from archerfish import Launcher
from archerfish.cli import batch

SHOTS = """\
name,launch_angle_deg,speed_m_per_s
one,45,10
"two, too",x,10
three,30,-1
four,200,3
five,,5
six,10
seven,-20,8,9

eight,90,8
nine,1_0,8
"""
BAD = {
    2: "launch_angle_deg must be a number, got 'x'",
    3: "speed must be above 0 and finite, got -1.0",
    4: "launch angle must be from -180 to 180 degrees, got 200.0",
    5: "launch_angle_deg must be a number, the cell is empty",
    6: "2 cells where the header has 3",
    7: "4 cells where the header has 3, left over: '9'",
    9: "launch_angle_deg must be a number, got '1_0'",
}


def rows(text):
    return list(csv.DictReader(io.StringIO(text)))


def test_columns_are_kept_and_bad_rows_told_of(command, tmp_path):
    (tmp_path / "in.csv").write_text(SHOTS)
    done = command("shot", "--batch", "in.csv", "--epsilon", "0.1")
    assert done.returncode == 0
    found = rows(done.stdout)
    assert [row["name"] for row in found][:3] == ["one", "two, too", "three"]
    assert len(found) == 9
    for number, row in enumerate(found, start=1):
        assert row["reason"] == BAD.get(number, "")
        assert (row["flight_time_s"] == "nan") == (number in BAD)
    shot = Launcher(10, epsilon=0.1).shot(np.radians(45.0))
    assert float(found[0]["landing_x_m"]) == shot.range
    assert float(found[0]["landing_angle_deg"]) == np.degrees(shot.landing.angle)
    assert done.stderr.splitlines() == [
        *(f"archerfish shot: row {number}: {reason}" for number, reason in BAD.items()),
        "archerfish shot: 7 of 9 rows are bad: NaN, with the reason in the last column",
    ]


@pytest.mark.parametrize(
    ("line", "what"),
    [
        ('4,"a', "unexpected end of data"),
        ('4,"a"b', "',' expected after '\"'"),
        ("4," + "a" * 200_000, "field larger than field limit (131072)"),
    ],
)
def test_what_comes_before_a_line_that_is_no_csv_is_answered(command, tmp_path, line, what):
    names = ["one", "two\nlines", "", "three"]
    table = io.StringIO()
    csv.writer(table).writerows([["launch_angle_deg", "name"], *([45, name] for name in names)])
    text = "\n".join([table.getvalue() + line, *["50,good"] * 6, ""])
    flags = ("shot", "--speed", "10", "--epsilon", "0.1", "--batch", "-")
    done = command(*flags, input=text)
    assert done.returncode == 2
    message = f"the input is not CSV from line 7 on: {what}"
    assert done.stderr == f"archerfish shot: {message}\n"
    assert [row["name"] for row in rows(done.stdout)] == names
    assert command(*flags, "--output", "out.csv", input=text).returncode == 2
    assert list(tmp_path.iterdir()) == []


def test_a_single_case_is_a_batch_of_one(output):
    flags = ("--speed", "10", "--drag-rate", "0.2", "--height", "1")
    single = output("shot", *flags, "--angle", "30", "--format", "csv")
    text = output("shot", *flags, "--batch", "-", input="launch_angle_deg\n30\n")
    one, other = rows(single)[0], rows(text)[0]
    assert all(one[name] == other[name] for name in list(other)[1:])


def test_aim_angles_and_envelope(output):
    targets = rows(
        output(
            "aim",
            "--batch",
            "-",
            "--speed",
            "10",
            "--epsilon",
            "0.1",
            input="x_m,y_m\n6,2\n9,3\n500,-3\n",
        )
    )
    arcs = Launcher(10, epsilon=0.1).aim([6, 9, 500], [2, 3, -3])
    assert [row["status"] for row in targets] == ["reachable", "unreachable", "unreachable"]
    assert float(targets[0]["high_launch_angle_deg"]) == np.degrees(arcs.high.angle[0])
    assert float(targets[1]["minimum_speed_m_per_s"]) == arcs.minimum_speed[1]
    assert (
        targets[1]["reason"]
        == f"out of reach: {arcs.margin[1]:.6g} m above the envelope of all shots"
    )
    assert targets[2]["margin_m"] == "inf"
    assert targets[2]["reason"] == "out of reach: beyond the distance V₀/b that drag allows"
    drags = rows(output("angles", "--batch", "-", input="epsilon\n0\n1\n"))
    assert float(drags[0]["largest_area_deg"]) == pytest.approx(60.0, rel=1e-15)
    places = rows(
        output("envelope", "--batch", "-", "--speed", "10", input="x_m,y_m,epsilon\n3,1,0.1\n")
    )
    assert float(places[0]["envelope_height_m"]) == Launcher(10, epsilon=0.1).envelope.height(3)
    assert places[0]["status"] == "reachable"


def test_a_row_does_not_depend_on_its_neighbours(output):
    """A column wind_z_m_per_s aims in space, whether there is such a wind in the block or not."""
    flags = ("aim", "--batch", "-", "--speed", "10", "--epsilon", "0.1")
    header, calm = "x_m,y_m,wind_z_m_per_s\n", "-5,1,0\n"
    alone = rows(output(*flags, input=header + calm))[0]
    assert alone == rows(output(*flags, input=f"{header}{calm}5,1,3\n"))[0]
    assert float(alone["low_azimuth_deg"]) == 180.0
    in_plane = rows(output(*flags, input="x_m,y_m\n-5,1\n"))[0]
    assert float(in_plane["low_launch_angle_deg"]) > 90.0


OBSTACLES = """\
x_m,y_m,obstacle_x_m,obstacle_y_m,ceiling_m
6,2,3,2.5,4
6,2,7,1,2
9,3,3,2.5,4
6,2,inf,1,2
"""


def test_aim_clears_the_obstacle_and_the_ceiling_of_each_row(command, output):
    flags = ("aim", "--batch", "-", "--speed", "10", "--epsilon", "0.1")
    done = command(*flags, input=OBSTACLES)
    assert done.returncode == 0
    found = rows(done.stdout)
    arcs = Launcher(10, epsilon=0.1).aim(6, 2)
    for side in ("low", "high"):
        arc = getattr(arcs, side)
        over, under = f"{side}_over_obstacle_m", f"{side}_under_ceiling_m"
        assert float(found[0][over]) == arc.clearance_over(3, 2.5)
        assert float(found[0][under]) == arc.clearance_under(4)
        assert found[1][over] == "nan"  # behind the target
        assert float(found[1][under]) == arc.clearance_under(2)
        assert (found[2][over], found[2][under]) == ("nan", "nan")  # out of reach
    assert found[3]["reason"] == "obstacle x must be finite, got inf"
    # As flags they hold for every row; without them there are no such columns.
    held = output(*flags, "--obstacle", "3", "2.5", "--ceiling", "4", input="x_m,y_m\n6,2\n")
    assert {name: held for name, held in found[0].items() if "obstacle_" not in name[:9]} == {
        **rows(held)[0],
        "ceiling_m": "4",
    }
    assert "obstacle" not in output(*flags, input="x_m,y_m\n6,2\n")
    single = flags[:1] + flags[3:] + ("--x", "6", "--y", "2", "--format", "csv")
    alone = rows(output(*single, "--obstacle", "3", "2.5", "--ceiling", "4"))[0]
    assert alone["high_over_obstacle_m"] == found[0]["high_over_obstacle_m"]
    assert alone["obstacle_y_m"] == "2.5"


@pytest.mark.parametrize(
    ("text", "flags", "line"),
    [
        (
            "x_m,y_m,obstacle_y_m\n",
            (),
            "give obstacle_x_m and obstacle_y_m together, got obstacle_y_m alone\n",
        ),
        (
            "x_m,y_m,obstacle_x_m,obstacle_y_m\n",
            ("--obstacle", "1", "2"),
            "give column obstacle_x_m or --obstacle, got both\n",
        ),
        (
            "x_m,y_m\n",
            ("--obstacle", "1", "2", "--obstacle", "3", "2"),
            "only a table has room for several --obstacle, got 2. See archerfish aim --help.\n",
        ),
        (
            "x_m,y_m,ceiling_m,low_under_ceiling_m\n",
            (),
            "column low_under_ceiling_m is written by this command: rename it in the input\n",
        ),
    ],
)
def test_obstacles_that_ask_nothing_are_refused(command, text, flags, line):
    done = command("aim", "--batch", "-", "--speed", "9", "--epsilon", "1", *flags, input=text)
    assert (done.returncode, done.stderr) == (2, f"archerfish aim: {line}")


def test_a_value_in_many_blocks_is_found_where_it_is(command):
    count = 2 * batch.BLOCK + 100
    lines = ["45"] * count
    for index in (0, batch.BLOCK - 1, batch.BLOCK, count - 1):
        lines[index] = "999"
    text = "launch_angle_deg\n" + "\n".join(lines) + "\n"
    done = command("shot", "--batch", "-", "--speed", "3", "--epsilon", "1", input=text)
    found = rows(done.stdout)
    assert len(found) == count
    bad = [number for number, row in enumerate(found, start=1) if row["reason"]]
    assert bad == [1, batch.BLOCK, batch.BLOCK + 1, count]
    assert [f"row {number}:" in done.stderr for number in bad] == [True] * 4
    assert {row["flight_time_s"] for row in found if not row["reason"]} == {
        repr(Launcher(3, epsilon=1).shot(np.radians(45.0)).flight_time)
    }


def test_only_the_first_bad_rows_are_told_of_one_by_one(command):
    text = "launch_angle_deg\n" + "x\n" * 50
    done = command("shot", "--batch", "-", "--speed", "3", "--epsilon", "1", input=text)
    assert len(done.stderr.splitlines()) == batch.TOLD + 1
    assert "50 of 50 rows are bad" in done.stderr


@pytest.mark.parametrize(
    ("text", "flags", "line"),
    [
        ("", ("--epsilon", "1"), "the input must start with a line of column names, got nothing"),
        ("a,a\n", ("--epsilon", "1"), "each column must have a name of its own, got 'a' twice"),
        (
            "speed_m_per_s\n",
            ("--epsilon", "1"),
            "give column launch_angle_deg or --angle, got columns speed_m_per_s",
        ),
        (
            "launch_angle_deg,speed_m_per_s\n",
            ("--epsilon", "1", "--speed", "2"),
            "give column speed_m_per_s or --speed, got both",
        ),
        (
            "launch_angle_deg,speed_m_per_s\n",
            (),
            "give exactly one of epsilon, drag_rate, terminal_speed, as a column or a flag; "
            "got none",
        ),
        (
            "launch_angle_deg,speed_m_per_s,apex_x_m\n",
            ("--epsilon", "1"),
            "column apex_x_m is written by this command: rename it in the input",
        ),
        ("launch_angle_deg\n1\n", ("--format", "json"), "--batch writes csv, got --format json"),
        ("launch_angle_deg\n1\n", ("--figure", "a.svg"), "--figure draws one case, not a --batch"),
    ],
)
def test_an_input_that_asks_nothing_is_one_line_and_status_2(command, tmp_path, text, flags, line):
    done = command("shot", "--batch", "-", "--output", "out.csv", *flags, input=text)
    assert done.returncode == 2
    assert done.stderr.startswith(f"archerfish shot: {line}")
    assert list(tmp_path.iterdir()) == []


def test_what_cannot_be_read_or_written(command, tmp_path):
    (tmp_path / "in.csv").write_text("launch_angle_deg\n1\n")
    flags = ("--speed", "1", "--epsilon", "1")
    done = command("shot", *flags, "--batch", "nowhere.csv")
    message = "archerfish: cannot read nowhere.csv: No such file or directory\n"
    assert (done.returncode, done.stderr) == (1, message)
    done = command("shot", *flags, "--batch", "in.csv", "--output", "nowhere/out.csv")
    message = "archerfish: cannot write nowhere/out.csv: No such file or directory\n"
    assert (done.returncode, done.stderr) == (1, message)
    assert [entry.name for entry in tmp_path.iterdir()] == ["in.csv"]


def test_bytes_that_are_not_text_pass_through(tmp_path):
    (tmp_path / "in.csv").write_bytes(b"\xef\xbb\xbfname,launch_angle_deg\ncaf\xe9,45\n")
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "archerfish",
            "shot",
            "--speed",
            "1",
            "--epsilon",
            "1",
            "--batch",
            "in.csv",
            "--output",
            "out.csv",
        ],
        cwd=tmp_path,
        capture_output=True,
        check=True,
    )
    assert done.stderr == b""
    content = (tmp_path / "out.csv").read_bytes()
    assert content.startswith(b"name,launch_angle_deg,apex_x_m")
    assert b"\ncaf\xe9,45,0." in content


# VmHWM is this program's own peak; ru_maxrss also remembers that of the process that started it
MEMORY = """
import re, sys
from pathlib import Path
from archerfish.cli.app import run
status = run(sys.argv[1:])
print(status, re.search(r"VmHWM:\\s+(\\d+) kB", Path("/proc/self/status").read_text())[1])
"""


def test_memory_does_not_grow_with_the_input(tmp_path):
    """Ten million rows must fit in 300 MB: so a hundred thousand take no more than a block does."""
    used = []
    for count in (batch.BLOCK, 12 * batch.BLOCK):
        angles = np.linspace(0, 90, count).tolist()
        (tmp_path / "in.csv").write_text("launch_angle_deg\n" + "\n".join(map(repr, angles)))
        arguments = ["shot", "--speed", "9", "--epsilon", "1", "--batch", "in.csv"]
        done = subprocess.run(
            [sys.executable, "-c", MEMORY, *arguments, "--output", "out.csv"],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=True,
        )
        status, memory = done.stdout.splitlines()[-1].split()
        assert status == "0"
        used.append(int(memory))
    assert used[1] < used[0] + 15_000  # kB
    assert used[1] < 200_000


def test_a_terminal_gets_a_bar_for_long_work(tmp_path):
    pty = pytest.importorskip("pty")
    (tmp_path / "in.csv").write_text("launch_angle_deg\n" + "45\n" * (4 * batch.BLOCK))
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(tmp_path)
        code = (
            "from archerfish.cli import batch\nbatch.SLOW = 0.0\n"
            "from archerfish.cli.app import run\nimport sys\nsys.exit(run(sys.argv[1:]))"
        )
        arguments = ["shot", "--speed", "9", "--epsilon", "1", "--batch", "in.csv"]
        environment = {**os.environ, "TERM": "xterm"}
        command = [sys.executable, "-c", code, *arguments, "--output", "out.csv"]
        os.execve(sys.executable, command, environment)
    received = b""
    while True:
        try:
            part = os.read(terminal, 65536)
        except OSError:
            break
        if not part:
            break
        received += part
    os.close(terminal)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    text = received.decode()
    assert "%" in text
    assert "rows" in text
    assert text.rstrip().endswith("wrote out.csv")


def test_blank_lines_are_no_rows(output):
    flags = ("shot", "--speed", "3", "--epsilon", "1", "--batch", "-")
    many = "\n" * (batch.BLOCK + 5)
    for text, count in (("", 0), ("\n\n", 0), (f"\n45\n\n30{many}45", 3), (many, 0)):
        assert len(rows(output(*flags, input="launch_angle_deg\n" + text))) == count


def test_cells_that_want_quotes_keep_them(output):
    """A block with such a cell and one without are written in two ways, which must agree."""
    names = ["plain", "a, b", 'said "so"', "two\nlines", "", " spaces "]
    table = io.StringIO()
    csv.writer(table).writerows([["name", "launch_angle_deg"], *([name, 45] for name in names)])
    flags = ("--speed", "3", "--epsilon", "1", "--batch", "-")
    found = rows(output("shot", *flags, input=table.getvalue()))
    assert [row["name"] for row in found] == names
    alone = output("shot", *flags, input="name,launch_angle_deg\nplain,45\n")
    assert rows(alone)[0] == found[0]
    assert len({tuple(list(row.values())[1:]) for row in found}) == 1

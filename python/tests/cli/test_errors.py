"""Bad input: one clear line, status 2. What cannot be written: one line, status 1, no file."""

import os
import signal
import subprocess
import sys
import time

import pytest

SHOT = ("locus", "--speed", "10", "--epsilon", "0.1")

BAD = [
    (
        ("locus", "--speed", "10"),
        "archerfish locus: give exactly one of epsilon, drag_rate, terminal_speed; got none",
    ),
    (
        ("locus", "--speed", "10", "--epsilon", "1", "--drag-rate", "2"),
        "archerfish locus: give exactly one of epsilon, drag_rate, terminal_speed; "
        "got epsilon and drag_rate",
    ),
    (
        ("locus", "--speed", "0", "--epsilon", "1"),
        "archerfish locus: speed must be above 0 and finite, got 0.0",
    ),
    (
        ("locus", "--speed", "nan", "--epsilon", "1"),
        "archerfish locus: speed must be above 0 and finite, got nan",
    ),
    (
        ("locus", "--speed", "10", "--epsilon", "-0.1"),
        "archerfish locus: epsilon must be at least 0 and finite, got -0.1",
    ),
    (
        ("locus", "--speed", "10", "--terminal-speed", "0"),
        "archerfish locus: terminal_speed must be above 0, got 0.0",
    ),
    ((*SHOT, "--gravity", "inf"), "archerfish locus: gravity must be above 0 and finite, got inf"),
    (
        ("locus", "--epsilon", "1"),
        "archerfish locus: Missing option '--speed'. See archerfish locus --help.",
    ),
    (
        (*SHOT, "--points", "1"),
        "archerfish locus: Invalid value for '--points': 1 is not in the range 2<=x<=10000000. "
        "See archerfish locus --help.",
    ),
    (
        (*SHOT, "--by", "time"),
        "archerfish locus: Invalid value for '--by': 'time' is not one of 'launch-angle', "
        "'elevation'. See archerfish locus --help.",
    ),
    (
        (*SHOT, "--output", "a.csv", "--figure", "a.gif"),
        "archerfish locus: a figure must end in .png, .svg, .pdf, got a.gif",
    ),
    (("figure", "7"), "archerfish figure: figure must be from 1 to 6, got 7"),
    (
        ("figure", "2", "--epsilon", "-1"),
        "archerfish figure: epsilon must be at least 0 and finite, got -1.0",
    ),
    (("series", "--order", "99"), "archerfish series: order must be from 1 to 40, got 99"),
    (
        ("series", "--epsilon", "1"),
        "archerfish series: --epsilon and --elevation go with --compare. "
        "See archerfish series --help.",
    ),
    (
        ("series", "--compare", "--epsilon", "nan"),
        "archerfish series: epsilon must be at least 0 and finite, got nan",
    ),
    (
        ("locos",),
        "archerfish: No such command 'locos'. Did you mean 'locus'? See archerfish --help.",
    ),
]


@pytest.mark.parametrize(("arguments", "line"), BAD)
def test_bad_input_is_one_line_and_status_2(command, tmp_path, arguments, line):
    done = command(*arguments)
    assert done.stderr == line + "\n"
    assert done.returncode == 2
    assert done.stdout == ""
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("path", "reason"),
    [
        ("missing/a.csv", "No such file or directory"),
        ("file/a.csv", "Not a directory"),
        ("folder", "Is a directory"),
    ],
)
@pytest.mark.parametrize(
    "arguments",
    [(*SHOT, "--format", "csv", "--output"), ("series", "--order", "2", "--output")],
)
def test_unwritable_output_is_one_line_and_status_1(command, tmp_path, path, reason, arguments):
    (tmp_path / "file").touch()
    (tmp_path / "folder").mkdir()
    done = command(*arguments, path)
    assert done.stderr == f"archerfish: cannot write {path}: {reason}\n"
    assert done.returncode == 1
    assert done.stdout == ""
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["file", "folder"]
    assert list((tmp_path / "folder").iterdir()) == []


def test_unwritable_figure_is_one_line_and_status_1(command, tmp_path):
    done = command(*SHOT, "--output", "a.csv", "--figure", "missing/a.svg")
    assert done.stderr == "archerfish: cannot write missing/a.svg: No such file or directory\n"
    assert done.returncode == 1
    assert list(tmp_path.iterdir()) == []


def test_a_disk_that_fills_up_leaves_no_part_of_a_file(tmp_path):
    resource = pytest.importorskip("resource")
    done = subprocess.run(
        [sys.executable, "-m", "archerfish", *SHOT, "--output", "a.csv"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512)),
    )
    assert done.stderr == "archerfish: cannot write a.csv: File too large\n"
    assert done.returncode == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("unbuffered", ["", "1"])
def test_standard_output_that_is_full(tmp_path, unbuffered):
    with open("/dev/full", "w") as full:  # noqa: PTH123
        done = subprocess.run(
            [sys.executable, "-m", "archerfish", *SHOT],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            cwd=tmp_path,
            env=os.environ | {"PYTHONUNBUFFERED": unbuffered},
            check=False,
        )
    assert done.stderr == "archerfish: cannot write standard output: No space left on device\n"
    assert done.returncode == 1


def shell(line, folder):
    return subprocess.run(
        ["bash", "-c", line], capture_output=True, text=True, cwd=folder, check=False
    )


def test_standard_output_that_is_closed(tmp_path):
    done = shell(f"{sys.executable} -m archerfish {' '.join(SHOT)} --output a.csv >&-", tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "a.csv").read_text().startswith("launch_angle_deg,")


BATCH = f"{sys.executable} -m archerfish shot --speed 10 --epsilon 0.1 --batch"


@pytest.mark.parametrize("source", ["-", "in.csv"])
def test_standard_input_that_is_closed(tmp_path, source):
    (tmp_path / "in.csv").write_text("launch_angle_deg\n45\n")
    done = shell(f"{BATCH} {source} <&-", tmp_path)
    if source == "-":
        message = "archerfish: cannot read standard input: it is closed\n"
        assert (done.returncode, done.stdout, done.stderr) == (1, "", message)
    else:
        assert (done.returncode, done.stderr) == (0, "")


def test_standard_error_that_is_closed(tmp_path):
    (tmp_path / "in.csv").write_text("launch_angle_deg\n45\nx\n")
    done = shell(f"{BATCH} in.csv --output out.csv 2>&-", tmp_path)
    assert (done.returncode, done.stdout) == (0, "wrote out.csv\n")
    assert "must be a number" in (tmp_path / "out.csv").read_text()


def test_standard_output_by_its_name_is_the_one_that_is_open(tmp_path):
    """A log stays the file it is: nothing is put in its place, and nothing in it overwritten."""
    log = tmp_path / "log"
    log.write_text("before\n")
    number = log.stat().st_ino
    command = f"{sys.executable} -m archerfish {' '.join(SHOT)} --format csv --output /dev/stdout"
    done = shell(f"{command} >> log; echo after >> log", tmp_path)
    text = log.read_text()
    assert (done.stderr, log.stat().st_ino) == ("", number)
    assert text.startswith("before\nlaunch_angle_deg,")
    assert text.endswith("wrote /dev/stdout\nafter\n")
    assert [entry.name for entry in tmp_path.iterdir()] == ["log"]


def test_a_command_asked_to_end_leaves_no_part_of_a_file(tmp_path):
    process = subprocess.Popen(
        [*BATCH.split(), "-", "--output", "out.csv"], stdin=subprocess.PIPE, cwd=tmp_path
    )
    process.stdin.write(b"launch_angle_deg\n")
    process.stdin.flush()
    for _ in range(600):
        if any(tmp_path.iterdir()):
            break
        time.sleep(0.1)
    assert [entry.suffix for entry in tmp_path.iterdir()] == [".part"]
    process.terminate()
    assert process.wait(60) == 128 + signal.SIGTERM
    process.stdin.close()
    assert list(tmp_path.iterdir()) == []


def test_a_device_that_is_full_is_named(command):
    done = command(*SHOT, "--output", "/dev/full")
    assert done.stderr == "archerfish: cannot write /dev/full: No space left on device\n"
    assert done.returncode == 1


def test_a_reader_that_stops_reading_ends_the_command_quietly(tmp_path):
    ask = f"{sys.executable} -m archerfish locus --speed 10 --epsilon 1 --points 50000 --format csv"
    done = subprocess.run(
        ["bash", "-c", f"set -o pipefail; {ask} | head -1"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        check=False,
    )
    assert done.stderr == ""
    assert done.stdout.startswith("launch_angle_deg,")
    assert done.returncode == 128 + 13


def test_a_terminal_without_greek_letters_gets_an_answer(output):
    text = output(*SHOT, encoding="latin-1", env=os.environ | {"PYTHONIOENCODING": "latin-1"})
    assert "drag parameter ?" in text

"""The command in a process of its own, as a shell runs it."""

import subprocess
import sys

import pytest


@pytest.fixture
def command(tmp_path):
    """Run `archerfish …` in an empty folder and return the finished process, output as text."""

    def run(*arguments, encoding="utf-8", **options):
        return subprocess.run(
            [sys.executable, "-m", "archerfish", *map(str, arguments)],
            capture_output=True,
            text=True,
            encoding=encoding,
            cwd=tmp_path,
            timeout=120,
            check=False,
            **options,
        )

    return run


@pytest.fixture
def output(command):
    """Run `archerfish …`, which must succeed without a word of complaint, and return its output."""

    def run(*arguments, **options):
        done = command(*arguments, **options)
        assert (done.returncode, done.stderr) == (0, "")
        return done.stdout

    return run

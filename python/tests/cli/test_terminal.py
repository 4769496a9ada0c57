"""What a terminal shows: colours where it has them, every digit however narrow it is."""

import os
import re
import select
import struct
import sys

import pytest

pty = pytest.importorskip("pty")
fcntl = pytest.importorskip("fcntl")
termios = pytest.importorskip("termios")

ESCAPE = re.compile(r"\x1b\[[0-9;]*m")


def shown(*arguments, columns=100, **environment):
    """All that a terminal of that width receives from the command."""
    child, terminal = pty.fork()
    if child == 0:
        # Not what the process has inherited: readline adds COLUMNS to it, behind Python's back.
        known = {**os.environ, "TERM": "xterm-256color", **environment}
        os.execve(sys.executable, [sys.executable, "-m", "archerfish", *arguments], known)
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 50, columns, 0, 0))
    received = b""
    while select.select([terminal], [], [], 60)[0]:
        try:
            part = os.read(terminal, 65536)
        except OSError:  # The other end is closed.
            break
        if not part:
            break
        received += part
    os.close(terminal)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    return received.decode().replace("\r\n", "\n")


def test_colours_in_a_terminal_only(output):
    arguments = ("locus", "--speed", "10", "--epsilon", "0.1")
    plain = output(*arguments)
    colourful = shown(*arguments)
    assert "\x1b[" not in plain
    assert "\x1b[1m" in colourful
    assert [line.rstrip() for line in ESCAPE.sub("", colourful).splitlines()] == plain.splitlines()


def test_a_narrow_terminal_loses_nothing(output):
    arguments = ("series", "--compare", "--epsilon", "0.1")
    narrow = ESCAPE.sub("", shown(*arguments, columns=40))
    assert "…" not in narrow
    assert [line.rstrip() for line in narrow.splitlines()] == output(*arguments).splitlines()


def test_a_csv_has_no_colours_anywhere():
    text = shown("locus", "--speed", "10", "--epsilon", "0.1", "--format", "csv")
    assert "\x1b" not in text

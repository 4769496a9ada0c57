"""Help: every command explains itself, and its examples run."""

import re
import shlex

import pytest

import archerfish

COMMANDS = [(), ("locus",), ("figure",), ("series",)]


def examples(text):
    """The command lines of a help page's examples, without the redirections."""
    lines = text.split("Examples:")[1].splitlines()
    return [
        shlex.split(line.split(">")[0])[1:] for line in lines if line.startswith("    archerfish")
    ]


@pytest.mark.parametrize("name", COMMANDS)
@pytest.mark.parametrize("flag", ["--help", "-h"])
def test_help(output, name, flag):
    text = output(*name, flag)
    assert text.startswith(f"Usage: {' '.join(('archerfish', *name))} [OPTIONS]")
    assert len(examples(text)) >= 3
    assert max(map(len, text.splitlines())) <= 100


def test_no_command_is_a_call_for_help(output):
    assert output() == output("--help")


def test_version(output):
    assert output("--version") == f"archerfish, version {archerfish.__version__}\n"


@pytest.mark.parametrize("name", COMMANDS)
def test_every_example_runs(output, name):
    for arguments in examples(output(*name, "--help")):
        assert output(*arguments)


def test_every_flag_of_the_locus_names_its_unit_or_its_choices(output):
    text = output("locus", "--help")
    for flag, words in {
        "--speed": "m/s",
        "--gravity": "m/s²",
        "--drag-rate": "1/s",
        "--terminal-speed": "m/s",
        "--points": "degrees",
    }.items():
        assert re.search(rf"{flag}\b[^\n]*(\n {{20,}}[^\n]*)*{words}", text), flag

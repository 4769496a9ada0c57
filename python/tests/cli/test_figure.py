"""`archerfish figure N`."""

import pytest

from archerfish.figures import FIGURES


@pytest.mark.parametrize("number", sorted(FIGURES))
def test_every_figure_is_drawn_under_its_own_name(output, tmp_path, number):
    assert output("figure", number) == f"wrote figure{number}.svg\n"
    assert (tmp_path / f"figure{number}.svg").read_bytes().startswith(b"<?xml")


def test_every_figure_stands_in_the_help(output):
    text = output("figure", "--help")
    assert [f"\n    {number}  " in text for number in sorted(FIGURES)] == [True] * len(FIGURES)
    assert f"\n    {len(FIGURES) + 1}  " not in text


def test_files_drags_and_dots_are_chosen(output, tmp_path):
    output("figure", 2, "--epsilon", 0.5, "--output", "a.png", "--output", "a.svg", "--dpi", 50)
    output("figure", 2, "--output", "b.png", "--dpi", 50)
    assert (tmp_path / "a.svg").exists()
    assert (tmp_path / "a.png").read_bytes() != (tmp_path / "b.png").read_bytes()


def test_figure_1_takes_one_drag(command, output, tmp_path):
    output("figure", 1, "--epsilon", 2)
    assert (tmp_path / "figure1.svg").exists()
    refused = command("figure", 1, "--epsilon", 2, "--epsilon", 3)
    assert refused.stderr == "archerfish figure: figure 1 shows one epsilon, got 2\n"
    assert refused.returncode == 2

"""What the prose says is there, is there, and the other way round."""

import re
from pathlib import Path

import numpy as np
import pytest

import archerfish

ROOT = Path(__file__).parents[2]


def test_every_ufunc_stands_in_the_table_of_the_readme():
    ufuncs = {
        name for name in archerfish.__all__ if isinstance(getattr(archerfish, name), np.ufunc)
    }
    rows = [
        line for line in (ROOT / "README.md").read_text("utf-8").splitlines() if line[:2] == "| "
    ]
    named = {name for row in rows for name in re.findall(r"`(\w+)(?:\([a-z, ]*\))?`", row)}
    assert len(ufuncs) > 10
    assert ufuncs - named == set()
    assert {name for name in named if "." not in name} - ufuncs <= {"exact_series"}


def test_the_two_commands_stand_first():
    first = (ROOT / "README.md").read_text("utf-8").split("```")[1]
    assert [line.split("#")[0].strip() for line in first.splitlines()[1:]] == [
        "$ make demo",
        "$ make test",
    ]


@pytest.mark.parametrize("page", ["README.md", "DESIGN.md", "CONTRIBUTING.md", "docs/model.md"])
def test_links_to_files_lead_somewhere(page):
    text = (ROOT / page).read_text("utf-8")
    for target in re.findall(r"\]\(([^)#]+)\)", text):
        if not target.startswith("https://"):
            assert ((ROOT / page).parent / target).exists(), target


def test_version_is_one():
    for page, pattern in (
        ("CITATION.cff", r"^version: (\S+)$"),
        ("CHANGELOG.md", r"^## ([\d.]+),"),
    ):
        found = re.search(pattern, (ROOT / page).read_text("utf-8"), re.MULTILINE)
        assert found is not None
        assert found[1] == archerfish.__version__, page

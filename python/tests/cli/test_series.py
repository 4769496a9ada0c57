"""`archerfish series`: printed in three ways, and compared with the truth."""

import json
from fractions import Fraction

import numpy as np
import pytest

from archerfish import locus_launch_angle
from archerfish.series import exact_series, paper_series, radius


def test_the_papers_equation_17_as_printed(output):
    text = output("series", "--of", "paper", "--order", "4")
    assert [line.strip() for line in text.splitlines()[3:]] == [
        "a₂  = −ε/3",
        "a₃  = 2ε²/9",
        "a₄  = (27ε − 10ε³)/54",
    ]


def test_both_series_to_order_18_unless_asked_otherwise(output):
    text = output("series")
    assert text.count("a₁₈ = ") == 2
    assert "the paper's series (17)" in text
    assert "the exact series" in text


def test_json_gives_back_the_exact_coefficients(output):
    for document, series in zip(
        json.loads(output("series", "--format", "json")),
        (paper_series(), exact_series()),
        strict=True,
    ):
        assert (document["of"], document["order"]) == (series.of, 18)
        for k, row in enumerate(series.coefficients):
            found = document["coefficients"].get(str(k), {})
            assert {int(j): Fraction(number) for j, number in found.items()} == {
                j: number for j, number in enumerate(row) if number
            }


def test_latex(output, tmp_path):
    assert output("series", "--of", "exact", "--order", "4", "--format", "latex").splitlines() == [
        "% the exact series: reversion of (10)",
        r"\begin{align*}",
        r"\alpha(\theta) &= \arctan T",
        r"  \\ &\quad - \frac{\varepsilon}{3}\,T^{2}",
        r"  \\ &\quad + \frac{7\varepsilon^{2}}{18}\,T^{3}",
        r"  \\ &\quad + \frac{135\varepsilon - 152\varepsilon^{3}}{270}\,T^{4}",
        r"  + \cdots, \qquad T = 2\tan\theta",
        r"\end{align*}",
    ]
    assert output("series", "--output", "series.json") == "wrote series.json\n"
    assert json.loads((tmp_path / "series.json").read_text())[1]["of"] == "exact"


def test_comparison_in_json(output):
    rows = json.loads(
        output(
            "series",
            "--compare",
            "--format",
            "json",
            "--epsilon",
            0.5,
            "--elevation",
            5,
            "--elevation",
            30,
            "--order",
            9,
        )
    )
    assert [(row["of"], row["elevation_deg"]) for row in rows] == [
        ("paper", 5),
        ("paper", pytest.approx(30)),
        ("exact", 5),
        ("exact", pytest.approx(30)),
    ]
    for row in rows:
        theta = np.radians(row["elevation_deg"])
        series = {"paper": paper_series, "exact": exact_series}[row["of"]](9)
        truth = locus_launch_angle(theta, 0.5)
        assert row["launch_angle_deg"] == pytest.approx(np.degrees(truth), rel=1e-15, abs=0)
        assert row["radius"] == radius(row["of"], 0.5)
        assert row["converges"] == (row["elevation_deg"] < 10)
        assert list(row["error_deg"]) == ["6", "9"]
        error = np.degrees(series.launch_angle(theta, 0.5) - truth)
        assert row["error_deg"]["9"] == pytest.approx(error, rel=1e-6, abs=1e-13)


def test_comparison_as_a_table(output):
    text = output("series", "--compare", "--of", "exact", "--epsilon", 0.1)
    reach = radius("exact", 0.1)
    limit = np.degrees(np.arctan(reach / 2))
    assert f"ε = 0.1: converges for T below {reach:.6f}, θ below {limit:.4f}°" in text
    rows = [line.split() for line in text.splitlines() if "verges" in line and "ε" not in line]
    assert [row[0] for row in rows] == ["1", "2", "5", "10", "15", "20", "25", "30"]
    assert [row[2] for row in rows] == ["converges"] * 7 + ["diverges"]
    assert abs(float(rows[0][-1])) < 1e-13 < abs(float(rows[0][-3]))


def test_without_drag_the_series_is_finished_before_it_begins(output):
    text = output("series", "--compare", "--epsilon", 0)
    assert "converges for every θ" in text
    assert "diverges" not in text

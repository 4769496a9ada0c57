"""COMPARE.md quotes what the command measured, and the command compares like with like."""

import tomllib

import numpy as np
import pytest

import archerfish
from bench import accuracy, compare, contenders, scaling, speed, textbook

OURS = ("apex_y", "locus_radius", "locus_launch_angle", "apex_curvature")


@pytest.fixture(scope="module")
def formulas():
    with np.errstate(all="ignore"):
        return accuracy.formulas(12)


@pytest.mark.parametrize(("page", "names"), compare.DOCUMENTS.items(), ids=str)
def test_the_document_holds_the_newest_record_and_nothing_else(page, names):
    document = page.read_text(encoding="utf-8")
    assert compare.updated(document, compare.latest(), names) == document


def test_a_document_without_markers_is_refused():
    with pytest.raises(ValueError, match="one pair of markers for formulas"):
        compare.updated("", compare.latest(), ("formulas",))


def test_bars_that_are_missed_are_told():
    record = compare.latest()
    record["about"]["instruction_set"] = "avx512"
    record["speed"]["lambertw0: archerfish"]["logarithms"] = 4.01
    record["calls"]["apex_y"], record["starts"]["import archerfish"] = 1.51, 1.29
    record["threads"] |= {"apex_y": 1.79, "lambertw0": 1.8}
    told = "\n".join(compare.missed(record))
    assert "lambertw0, in logarithms: 4.01, at most 4" in told
    assert "call on one element, apex_y, in np.arctan2's: 1.51, at most 1.5" in told
    assert "two threads, apex_y: 1.79 times as fast, at least 1.8" in told
    assert "two threads, lambertw0" not in told
    assert "import" not in told


def test_the_start_is_as_quick_as_it_should_be():
    """Processor time, the least of turns: what the machine does besides hardly shows."""
    found = scaling.starts()
    for name, bar in compare.STARTS:
        assert found[name] <= bar, (name, found)


def test_a_call_on_one_element_costs_little_more_than_numpys():
    """Kernels far below the bar; those next to it are told of by `make bench`."""
    names = ("log1pmx", "lambertw0", "apex_y", "flight_range", "arctan2")
    # half a second of turns: a slow spell of the machine must not cover all of one function's
    found = scaling.calls(rounds=300, names=names)
    assert max(found.values()) <= 1.5, found


def test_a_record_survives_the_file():
    record = compare.latest()
    assert repr(tomllib.loads(compare.toml(record))) == repr(record)


@pytest.mark.parametrize("row", OURS)
def test_ours_keep_every_digit_at_every_drag(formulas, row):
    assert set(formulas[row]) == {f"{eps:g}" for eps in accuracy.EPSILONS}
    assert max(formulas[row].values()) < 5e-16


def test_range_by_the_offset_keeps_its_digits(formulas):
    assert max(formulas["range, lambertw0_offset"].values()) < 3e-15


@pytest.mark.parametrize(
    ("row", "eps", "loss"),
    [
        ("y = (u − log1p(u))/ε²", "1e-12", 1e-5),
        ("r by (13), principal W", "3", 0.1),
        ("r by (13), principal W", "10", 0.5),
        ("α(θ), np.interp on 10⁴", "1", 1e-9),
        ("ρK, differences on 10⁴", "1", 1e-9),
    ],
)
def test_what_theirs_lose(formulas, row, eps, loss):
    assert formulas[row][eps] > loss


def test_textbook_range_has_no_digits_at_weak_drag(formulas):
    assert not formulas["range, textbook W₀"]["1e-08"] < 0.1


@pytest.mark.parametrize("row", ["y = (u − log1p(u))/ε²", "range, textbook W₀"])
def test_what_theirs_do_not_lose(formulas, row):
    assert formulas[row]["10000"] < 1e-14


def test_lambert_next_to_the_branch_point():
    with np.errstate(all="ignore"):
        table = accuracy.lambert(25)
    assert max(table["archerfish"].values()) <= 1.0
    assert table["SciPy"]["W₀, next to −1/e"] > 1e3
    assert table["SciPy"]["W₀, 10^[−8, 300]"] < 3.0
    assert table["SciPy"]["W₋₁, −10^[−300, −1]"] < 3.0


def test_timed_contenders_compute_the_same():
    eps = 0.1
    alpha = np.linspace(0.05, 1.5, 50)
    theta = archerfish.apex_elevation(alpha, eps)
    near = {"rtol": 1e-6}
    np.testing.assert_allclose(textbook.height(alpha, eps), archerfish.apex_y(alpha, eps), **near)
    np.testing.assert_allclose(textbook.elevation(alpha, eps), theta, **near)
    np.testing.assert_allclose(textbook.launch_angle(theta, eps), alpha, **near)
    np.testing.assert_allclose(textbook.launch_angle_by_root(theta, eps), alpha, **near)
    radius = archerfish.locus_radius(theta, eps)
    np.testing.assert_allclose(textbook.radius(theta, alpha, eps), radius, **near)


def test_every_kernel_is_timed_and_most_have_company():
    rows = speed.times(640, 1)
    kernels = [speed.kernel_and_name(name) for name in rows]
    ufuncs = {n for n in archerfish.__all__ if isinstance(getattr(archerfish, n), np.ufunc)}
    assert {kernel for kernel, name in kernels if name == "archerfish"} == ufuncs
    assert {kernel for kernel, name in kernels if name != "archerfish"} >= {*OURS, "lambertw0"}
    assert all(row["nanoseconds"] > 0.0 for row in rows.values())
    assert rows[speed.UNIT]["logarithms"] == 1.0


@pytest.mark.parametrize("answer", [1.1, np.nan])
def test_a_wrong_answer_is_not_timed(answer):
    right = np.ones(10)
    contenders.Contender("tree", "somebody", lambda: right, right, 1e-6).check()
    with pytest.raises(ValueError, match="somebody for tree must be within 1e-06"):
        contenders.Contender("tree", "somebody", lambda: right * answer, right, 1e-6).check()


def test_cost_is_measured_at_every_length():
    for row in scaling.by_length(10).values():
        assert set(row) == {"1", "10"}
        assert row["1"] > row["10"] > 0.0


def test_pictures_show_the_record():
    pictures = compare.drawn(compare.latest())
    assert set(pictures) == {"speed.svg", "scaling.svg"}
    assert all(b"<svg" in picture for picture in pictures.values())

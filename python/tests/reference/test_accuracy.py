"""The record of worst errors: complete, within the bounds, true of the kernels, and a ratchet."""

import secrets

import numpy as np
import pytest

from reference import accuracy, compare, kernels, oracle
from reference.accuracy import Worst

RECORD = accuracy.read_record()


def through_cargo(name):
    return lambda *arguments: kernels.evaluate(name, *arguments)


def test_every_function_is_recorded():
    assert list(RECORD) == list(oracle.FUNCTIONS)


@pytest.mark.parametrize("name", oracle.FUNCTIONS)
def test_record_is_of_enough_inputs_and_within_its_bound(name):
    row = RECORD[name]
    assert row["inputs"] >= 100_000
    assert row["demanded_ulp"] == oracle.FUNCTIONS[name].bound
    assert row["worst_ulp"] <= accuracy.demanded(name, RECORD)


@pytest.mark.parametrize("name", oracle.FUNCTIONS)
def test_recorded_input_still_has_the_recorded_error(name):
    """Worse fails, and so does clearly better until the record is tightened."""
    (row,) = accuracy.recorded_inputs(RECORD, [name])
    arguments = tuple(np.array([v]) for v in row)
    (error,) = compare.ulp_errors(
        kernels.evaluate(name, *arguments), *oracle.values(name, *arguments)
    )
    assert accuracy.faults(name, Worst(float(error), row, 1), RECORD, fresh=False) == []


@pytest.mark.parametrize("name", oracle.FUNCTIONS)
def test_fresh_inputs_stay_within_the_bound(name):
    compared = compare.with_oracle(name, through_cargo(name), 1500, secrets.randbits(32))
    assert compared.errors.size >= 1500
    compared.assert_within(accuracy.demanded(name, RECORD))


def test_ratchet_holds_in_both_directions():
    record = {"apex_x": {"worst_ulp": 0.7, "at": ["0x1.0p+0", "0x1.0p+0"]}}

    def faults(error, fresh=False):
        return accuracy.faults("apex_x", Worst(error, (1.0, 1.0), 1), record, fresh)

    assert faults(0.7) == []
    assert "worse than the recorded 0.7" in faults(0.8)[0]
    assert "tighten the record" in faults(0.5)[0]
    assert faults(0.8, fresh=True) == []
    assert "demanded 2" in faults(2.1, fresh=True)[0]
    assert "demanded 2" in faults(float("nan"), fresh=True)[0]
    assert "--record" in accuracy.faults("apex_y", Worst(0.5, (1.0, 1.0), 1), record, False)[0]


def test_a_higher_bound_needs_a_reason():
    assert accuracy.demanded("apex_x", {"apex_x": {"allowed_ulp": 3.0}}) == 2.0
    assert accuracy.demanded("apex_x", {"apex_x": {"allowed_ulp": 3.0, "why": "measured"}}) == 3.0

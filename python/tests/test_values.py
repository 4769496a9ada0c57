"""Frozen values: what is taken, what is refused and in which words."""

import decimal
import fractions

import numpy as np
import pytest

from archerfish.values import not_negative, positive, positive_or_infinite, real


@pytest.mark.parametrize(
    "value", [2, 2.0, np.float32(2), np.int8(2), fractions.Fraction(2), decimal.Decimal(2)]
)
def test_every_kind_of_real_number_becomes_a_float(value):
    number = real("speed", value)
    assert number == 2.0
    assert type(number) is float


@pytest.mark.parametrize("value", ["10", "fast", None, 1j, [1.0, "x"], [[1.0], [1.0, 2.0]], True])
def test_what_is_not_a_real_number_is_a_type_error(value):
    with pytest.raises(TypeError, match=r"^speed must be a real number or an array of them, got "):
        real("speed", value)


def test_arrays_are_copied_and_read_only():
    given = np.array([1.0, 2.0])
    kept = real("speed", given)
    given[0] = 9.0
    assert kept.tolist() == [1.0, 2.0]
    with pytest.raises(ValueError, match="read-only"):
        kept[0] = 9.0


@pytest.mark.parametrize(
    ("check", "bad", "bound"),
    [
        (positive, [0.0, -1.0, np.nan, np.inf], "above 0 and finite"),
        (not_negative, [-5e-324, np.nan, np.inf], "at least 0 and finite"),
        (positive_or_infinite, [0.0, -1.0, np.nan, -np.inf], "above 0"),
    ],
)
def test_the_message_names_value_and_bound(check, bad, bound):
    for value in bad:
        with pytest.raises(ValueError, match=f"^name must be {bound}, got {value}$"):
            check("name", value)
        with pytest.raises(ValueError, match=f"^name must be {bound}, got {value} among 3 values$"):
            check("name", [1.0, value, 2.0])


def test_minus_zero_is_zero():
    assert str(real("epsilon", -0.0)) == "0.0"
    assert not np.signbit(real("epsilon", [-0.0, 0.0])).any()


def test_the_bounds_themselves():
    assert positive("x", 5e-324) == 5e-324
    assert not_negative("x", 0.0) == 0.0
    assert positive_or_infinite("x", np.inf) == np.inf

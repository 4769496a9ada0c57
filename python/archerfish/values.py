"""Frozen values: what every object of the package is made of, and what it refuses.

A value's fields are real numbers or read-only arrays of them. Two values are equal when their
fields are.
"""

from __future__ import annotations

import dataclasses
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

#: A real number or an array of them.
Quantity: TypeAlias = "float | npt.NDArray[np.float64]"


class Value:
    """Equality and hash of a frozen dataclass whose fields may be arrays."""

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        return all(
            np.array_equal(mine, theirs)
            for mine, theirs in zip(_fields(self), _fields(other), strict=True)
        )

    def __hash__(self) -> int:
        return hash(tuple(tuple(np.ravel(field).tolist()) for field in _fields(self)))


def _fields(value: Any) -> tuple[Any, ...]:
    return tuple(getattr(value, field.name) for field in dataclasses.fields(value))


def is_quantity(value: Any) -> bool:
    """Whether `value` is a quantity of pint, or looks like one."""
    return hasattr(value, "dimensionality") and hasattr(value, "magnitude")


def without_unit(value: Any, name: str = "a value") -> Any:
    """`value`, which must not be a quantity: NumPy would drop its unit, not convert it."""
    if is_quantity(value) or (isinstance(value, list | tuple) and _holds_quantity(value)):
        raise TypeError(
            f"{name} must be plain numbers in SI units, got {value!s}: quantities go to a "
            "launcher whose speed is one, such as Launcher(10 * ureg.m / ureg.s, epsilon=0.1)"
        )
    return value


def _holds_quantity(values: list[Any] | tuple[Any, ...]) -> bool:
    # Of a long list the types are looked at, which are few.
    kinds = set(map(type, values))
    if any(map(is_quantity, kinds)):
        return True
    nested = (each for each in values if isinstance(each, list | tuple))
    return not kinds.isdisjoint((list, tuple)) and any(map(_holds_quantity, nested))


def real(name: str, value: object) -> Quantity:
    """`value` as a float, or as a read-only array of floats of its own."""
    without_unit(value, name)
    refusal = TypeError(f"{name} must be a real number or an array of them, got {value!r}")
    try:
        array = np.array(value)
        # Strings, complex numbers and None would convert, with a warning or without.
        if array.dtype.kind not in "iufO":
            raise refusal
        if array.dtype.kind == "O":
            array = np.vectorize(float, otypes=[np.float64])(array)
        # Minus zero is zero: as a drag it must not lead to a terminal speed of −∞.
        array = array.astype(np.float64) + 0.0
    except (TypeError, ValueError):
        raise refusal from None
    return frozen(array)


def frozen(array: npt.NDArray[np.float64]) -> Quantity:
    """A plain float for shape (); else the array, from now on read-only."""
    if array.ndim == 0:
        return float(array)
    array.flags.writeable = False
    return array


def product(first: Quantity, second: Quantity) -> Quantity:
    """first × second, infinite when it overflows."""
    with np.errstate(all="ignore"):
        return frozen(np.asarray(np.multiply(first, second)))


def quotient(numerator: Quantity, denominator: Quantity) -> Quantity:
    """numerator ÷ denominator, infinite when it overflows or the denominator is 0."""
    with np.errstate(all="ignore"):
        return frozen(np.asarray(np.divide(numerator, denominator)))


def positive(name: str, value: object) -> Quantity:
    """`value` if it is above 0 and finite throughout."""
    numbers = real(name, value)
    _require(name, numbers, (numbers > 0) & np.isfinite(numbers), "above 0 and finite")
    return numbers


def positive_or_infinite(name: str, value: object) -> Quantity:
    """`value` if it is above 0 throughout; infinity is welcome."""
    numbers = real(name, value)
    _require(name, numbers, numbers > 0, "above 0")
    return numbers


def not_negative(name: str, value: object) -> Quantity:
    """`value` if it is at least 0 and finite throughout."""
    numbers = real(name, value)
    _require(name, numbers, (numbers >= 0) & np.isfinite(numbers), "at least 0 and finite")
    return numbers


def finite(name: str, value: object) -> Quantity:
    """`value` if it is finite throughout."""
    numbers = real(name, value)
    _require(name, numbers, np.isfinite(numbers), "finite")
    return numbers


def _require(name: str, numbers: Quantity, good: Any, bound: str) -> None:
    good = np.asarray(good)
    if good.all():
        return
    bad = np.asarray(numbers)[~good]
    among = "" if good.ndim == 0 else f" among {good.size} values"
    raise ValueError(f"{name} must be {bound}, got {bad.flat[0]!s}{among}")

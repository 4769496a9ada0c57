"""Errors of an implementation in ulp, against the tables and against fresh exact values."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from reference import inputs, oracle, tables
from reference.ball import ulp_errors

Implementation = Callable[..., np.ndarray]


class Comparison(NamedTuple):
    """One error for each input."""

    errors: np.ndarray
    arguments: tuple[np.ndarray, ...]
    note: str

    def assert_within(self, bound: float) -> None:
        worst = int(np.argmax(self.errors))
        at = tuple(float(a[worst]) for a in self.arguments)
        assert self.errors[worst] <= bound, (
            f"{self.errors[worst]:.5g} ulp at {at}, demanded {bound:g} ({self.note})"
        )


def with_table(name: str, function: Implementation) -> Comparison:
    """Every row of reference/tables/NAME.csv."""
    *arguments, value, rest, ulp = tables.read(name)
    with np.errstate(all="ignore"):
        got = function(*arguments)
    return Comparison(
        ulp_errors(got, value, rest, ulp), tuple(arguments), f"reference/tables/{name}.csv"
    )


def with_oracle(name: str, function: Implementation, count: int, seed: int) -> Comparison:
    """The adversarial corners, the hard cases and `count` random inputs."""
    arguments = oracle.sample(name, count, seed)
    if name in inputs.HARD:
        hard = (np.array(column) for column in zip(*inputs.HARD[name], strict=True))
        arguments = tuple(np.concatenate(pair) for pair in zip(arguments, hard, strict=True))
    with np.errstate(all="ignore"):
        got = function(*arguments)
    return Comparison(
        ulp_errors(got, *oracle.values(name, *arguments)), arguments, f"{name}, seed {seed}"
    )

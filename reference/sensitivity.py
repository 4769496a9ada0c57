"""Derivatives of shots and aims, from the solution of the equation of motion alone.

What is asked of a shot is a root: of y(t) = ground, of ẏ(t) = 0, of r(t, angles) = target. Each
function is written down as it stands, and differentiated by power series in ball arithmetic;
the root's own derivatives follow from the implicit function theorem. Nothing is simplified, and
nothing differenced, save that the condition of a derivative (how much it feels a change of its
inputs) comes from the same derivative at inputs changed in the 24th digit.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from flint import arb, arb_mat, arb_series

from reference.ball import precision

Number = arb | arb_series
BITS = 256
#: Terms of E₁ and E₂ where their closed forms would be 0/0.
TERMS = 60
#: What is left of a condition at its root.
SMALL = arb(2) ** -200
CHANGE = arb(2) ** -80


class Case(NamedTuple):
    """A shot and what is asked of it, in any one system of units."""

    speed: Number
    angle: Number
    drag_rate: Number
    gravity: Number
    azimuth: Number = arb(0)
    height: Number = arb(0)
    wind: tuple[Number, Number, Number] = (arb(0), arb(0), arb(0))
    time: Number = arb(0)
    #: The target, or the ground.
    x: Number = arb(0)
    y: Number = arb(0)
    z: Number = arb(0)


def constant(number: Number) -> arb:
    return number[0] if isinstance(number, arb_series) else number


def drift_and_fall(t: Number, b: Number) -> tuple[Number, Number]:
    """∫₀ᵗ e^{−bτ} dτ and ∫₀ᵗ (t − τ) e^{−bτ} dτ."""
    w = b * t
    if abs(constant(w)) > 1:
        drift = (1 - (-w).exp()) / b
        return drift, (t - drift) / b
    term = 1 + 0 * w
    first, second = term, term / 2
    for k in range(2, TERMS):
        term = -term * w / k
        first, second = first + term, second + term / (k + 1)
    return t * first, t * t * second


def place(case: Case) -> tuple[Number, Number, Number]:
    """x, y and z: in the medium's frame the wind is at rest and the launch slower by it."""
    drift, fall = drift_and_fall(case.time, case.drag_rate)
    level = case.speed * case.angle.cos()
    launch = (
        level * case.azimuth.cos(),
        case.speed * case.angle.sin(),
        level * case.azimuth.sin(),
    )
    x, y, z = ((v - w) * drift + w * case.time for v, w in zip(launch, case.wind, strict=True))
    return x, y + case.height - case.gravity * fall, z


def climb(case: Case) -> Number:
    """ẏ."""
    drift, _ = drift_and_fall(case.time, case.drag_rate)
    air = case.wind[1]
    up = case.speed * case.angle.sin() - air
    return up * (-case.drag_rate * case.time).exp() + air - case.gravity * drift


Function = Callable[[Case], Number]


def partial(function: Function, case: Case, name: str) -> arb:
    """The derivative of `function` by one input, the others as they are."""
    value = function(case._replace(**{name: arb_series([getattr(case, name), 1])}))
    return arb(value[1]) if isinstance(value, arb_series) else arb(0)


def solved(conditions: Sequence[Function], case: Case, unknowns: Sequence[str]) -> Case:
    """The case with these unknowns such that each condition is 0, next to where they are."""
    for _ in range(9):
        missing = [function(case) for function in conditions]
        if all(abs(each) < SMALL for each in missing):
            return case
        step = jacobian(conditions, case, unknowns).solve(arb_mat([[each] for each in missing]))
        case = case._replace(
            **{name: (getattr(case, name) - step[k, 0]).mid() for k, name in enumerate(unknowns)}
        )
    raise ValueError(f"no root next to {unknowns} of {case}")


def jacobian(functions: Sequence[Function], case: Case, names: Sequence[str]) -> arb_mat:
    return arb_mat([[partial(function, case, name) for name in names] for function in functions])


class Slope(NamedTuple):
    """A derivative, and its condition: how many ulp it changes for an ulp in each of its inputs."""

    value: float
    condition: float


class Quantity(NamedTuple):
    """A number that a case has, where some unknowns make some conditions 0."""

    function: Function
    conditions: tuple[Function, ...]
    unknowns: tuple[str, ...]

    def slopes(self, case: Case, names: Sequence[str], inputs: Sequence[str]) -> dict[str, Slope]:
        """The derivatives by each name at the root next to this case."""
        with precision(BITS):
            root = solved(self.conditions, case, self.unknowns)
            values = self.implicit(root, names)
            conditions = [arb(0)] * len(names)
            for each in inputs:
                changed = root._replace(**{each: getattr(root, each) * (1 + CHANGE)})
                there = self.implicit(solved(self.conditions, changed, self.unknowns), names)
                for k, value in enumerate(values):
                    conditions[k] += abs(there[k] - value) / CHANGE
            return {
                name: Slope(float(value.mid()), float((conditions[k] / abs(value)).mid()))
                for k, (name, value) in enumerate(zip(names, values, strict=True))
            }

    def implicit(self, case: Case, names: Sequence[str]) -> list[arb]:
        """The derivatives of the function where the conditions hold, by each name."""
        follow = jacobian(self.conditions, case, self.unknowns).solve(
            jacobian(self.conditions, case, names)
        )
        own = jacobian([self.function], case, self.unknowns) * follow
        plain = jacobian([self.function], case, names)
        return [plain[0, k] - own[0, k] for k in range(len(names))]


def at(axis: int) -> Function:
    """How far beyond the target or the ground the projectile is, along one axis."""
    return lambda case: place(case)[axis] - (case.x, case.y, case.z)[axis]


LANDED, AT_APEX = ((at(1),), ("time",)), ((climb,), ("time",))
QUANTITIES = {
    "range": Quantity(at(0), *LANDED),
    "flight_time": Quantity(lambda case: case.time, *LANDED),
    "landing_z": Quantity(at(2), *LANDED),
    "apex_x": Quantity(at(0), *AT_APEX),
    "apex_y": Quantity(at(1), *AT_APEX),
    "apex_z": Quantity(at(2), *AT_APEX),
    "apex_time": Quantity(lambda case: case.time, *AT_APEX),
    "aim": Quantity(lambda case: case.angle, (at(0), at(1)), ("time", "angle")),
    "aim in space": Quantity(
        lambda case: case.angle, (at(0), at(1), at(2)), ("time", "angle", "azimuth")
    ),
}
"""Angles that hit a target hold x, y (and z); the others hold y, the ground; the rest is 0."""

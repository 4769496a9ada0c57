"""The words about every ufunc, as data: the Rust side registers the names, this gives them a page.

The examples print eight digits of values known to forty, so that no last digit can flip them.
"""

import inspect
from types import ModuleType
from typing import NamedTuple


class UfuncDoc(NamedTuple):
    """What is said of one ufunc."""

    arguments: dict[str, str]
    summary: str
    returns: str
    source: str
    example: str


ALPHA = {"alpha": "Launch angle α in radians, in [0, π]; above π/2 the mirror image is meant."}
THETA = {"theta": "Polar angle θ of the apex seen from the launch point, in radians, in [0, π]."}
EPS = {
    "eps": "Drag parameter ε = b V₀ / g, without unit, at least 0 and finite; accurate to 1e300."
}
DIRECTION = {"alpha": "Launch angle α in radians, in [−2π, 2π]: any direction, downwards too."}
TIME = {"t": "Time since the launch in V₀/g, at least 0 and finite."}
TARGET = {"x": "Abscissa of the target in V₀²/g.", "y": "Height of the target in V₀²/g."}
BY_LAUNCH_ANGLE = ALPHA | EPS
BY_ELEVATION = THETA | EPS

PAPER = "H. Hernández-Saldaña, Eur. J. Phys. (2010)"
CORLESS = 'R. M. Corless et al., "On the Lambert W function", Adv. Comput. Math. 5 (1996)'

DOCS: dict[str, UfuncDoc] = {
    "lambertw0": UfuncDoc(
        {"z": "Argument, at least -1/e; the double nearest to -1/e counts as -1/e."},
        "Principal real branch W₀ of the Lambert W function.",
        "The w ≥ -1 with w eʷ = z. W₀(-1/e) is -1 and W₀(∞) is ∞.",
        f"{CORLESS}; equation (13) of {PAPER}.",
        """\
>>> archerfish.lambertw0([-0.3, 1.0, 10.0])
array([-0.48940223,  0.56714329,  1.745528  ])
""",
    ),
    "lambertwm1": UfuncDoc(
        {"z": "Argument, in [-1/e, 0]; the double nearest to -1/e counts as -1/e."},
        "Lower real branch W₋₁ of the Lambert W function.",
        "The w ≤ -1 with w eʷ = z. W₋₁(-1/e) is -1 and W₋₁(0) is -∞.",
        f"{CORLESS}; equation (13) of {PAPER} needs it where ε sin α > 2.1461932…",
        """\
>>> archerfish.lambertwm1([-0.3, -0.1, -1e-20])
array([ -1.78133702,  -3.57715206, -49.96298428])
""",
    ),
    "lambertw0_offset": UfuncDoc(
        {"d": "Distance from the branch point, z = -1/e + d, at least 0."},
        "1 + W₀(-1/e + d), with all its digits next to the branch point.",
        "The principal branch, counted from the branch point: like √(2 e d) for small d.",
        f"{CORLESS}, section 4 (series at the branch point).",
        """\
>>> archerfish.lambertw0_offset([1e-6, 0.1])
array([0.00232983, 0.60061755])
""",
    ),
    "lambertwm1_offset": UfuncDoc(
        {"d": "Distance from the branch point, z = -1/e + d, in [0, 1/e]."},
        "1 + W₋₁(-1/e + d), with all its digits next to the branch point.",
        "The lower branch, counted from the branch point: like -√(2 e d) for small d.",
        f"{CORLESS}, section 4 (series at the branch point).",
        """\
>>> archerfish.lambertwm1_offset([1e-6, 0.1])
array([-0.00233346, -1.02062523])
""",
    ),
    "tree": UfuncDoc(
        {"z": "Argument, at most 1/e."},
        "The tree function T(z) = -W₀(-z).",
        "The t ≤ 1 with t e⁻ᵗ = z.",
        f"{CORLESS}; equation (14) of {PAPER}.",
        """\
>>> archerfish.tree([0.1, 0.2, 0.3])
array([0.11183256, 0.2591711 , 0.48940223])
""",
    ),
    "log1pmx": UfuncDoc(
        {"x": "Argument, at least -1."},
        "ln(1 + x) - x, without the cancellation near x = 0.",
        "At most 0: like -x²/2 for small x, and -∞ at x = -1.",
        f"The numerator of equation (8) of {PAPER}, with the sign turned.",
        """\
>>> archerfish.log1pmx([-0.5, 1.0])
array([-0.19314718, -0.30685282])
""",
    ),
    "apex_x": UfuncDoc(
        BY_LAUNCH_ANGLE,
        "Horizontal distance of the apex from the launch point.",
        "x = sin α cos α / (1 + ε sin α), in V₀²/g; negative for α > π/2.",
        f"Equation (7) of {PAPER}.",
        """\
>>> archerfish.apex_x(np.radians([30.0, 45.0, 60.0]), 0.1)
array([0.41239305, 0.46697956, 0.39850146])
""",
    ),
    "apex_y": UfuncDoc(
        BY_LAUNCH_ANGLE,
        "Height of the apex above the launch point.",
        "y = (u - ln(1 + u)) / ε² with u = ε sin α, in V₀²/g; sin²α / 2 at ε = 0.",
        f"Equation (8) of {PAPER}.",
        """\
>>> archerfish.apex_y(np.radians([30.0, 45.0, 60.0]), 0.1)
array([0.12098358, 0.2388065 , 0.35466473])
""",
    ),
    "apex_time": UfuncDoc(
        BY_LAUNCH_ANGLE,
        "Time from launch to the apex.",
        "t = ln(1 + ε sin α) / ε, in V₀/g; sin α at ε = 0.",
        f"The zero of the vertical velocity, from which (7) and (8) of {PAPER} follow.",
        """\
>>> archerfish.apex_time(np.radians([30.0, 45.0, 60.0]), 0.1)
array([0.48790164, 0.68322613, 0.83055893])
""",
    ),
    "apex_distance": UfuncDoc(
        BY_LAUNCH_ANGLE,
        "Straight distance of the apex from the launch point.",
        "r = √(x² + y²), in V₀²/g.",
        f"Equations (7) and (8) of {PAPER}.",
        """\
>>> archerfish.apex_distance(np.radians([30.0, 45.0, 60.0]), 0.1)
array([0.42977326, 0.52449828, 0.53347023])
""",
    ),
    "apex_elevation": UfuncDoc(
        BY_LAUNCH_ANGLE,
        "Polar angle θ of the apex seen from the launch point.",
        "θ in radians, in [0, π], rising with α; θ < α < arctan(2 tan θ) for 0 < α < π/2.",
        f"Equation (10) of {PAPER}.",
        """\
>>> np.degrees(archerfish.apex_elevation(np.radians([30.0, 45.0, 60.0]), 0.1))
array([16.35008471, 27.08453619, 41.66895675])
""",
    ),
    "apex_curvature": UfuncDoc(
        BY_LAUNCH_ANGLE,
        "Curvature of the locus of apexes, at the apex of the shot at launch angle α.",
        "ρK with ρ = V₀²/g: 1 at α = 0, 1 + ε at α = π/2, positive throughout.",
        f"Section IV of {PAPER}, by launch angle.",
        """\
>>> archerfish.apex_curvature(np.radians([0.0, 45.0, 90.0]), 0.0)
array([1., 8., 1.])
""",
    ),
    "locus_launch_angle": UfuncDoc(
        BY_ELEVATION,
        "Launch angle α whose apex is seen under the polar angle θ.",
        "α in radians, in [0, π]: the inverse of `apex_elevation`.",
        f"Equation (10) of {PAPER}, solved for α.",
        """\
>>> np.degrees(archerfish.locus_launch_angle(np.radians([10.0, 30.0, 60.0]), 0.1))
array([19.23311034, 48.43179354, 73.4333067 ])
""",
    ),
    "locus_launch_angle_d1": UfuncDoc(
        BY_ELEVATION,
        "First derivative dα/dθ of the launch angle by the polar angle.",
        "dα/dθ, without unit: 2 at θ = 0 for every ε.",
        f"Equation (18) of {PAPER}.",
        """\
>>> archerfish.locus_launch_angle_d1(np.radians([10.0, 30.0, 60.0]), 0.1)
array([1.80187014, 1.13510838, 0.62970059])
""",
    ),
    "locus_launch_angle_d2": UfuncDoc(
        BY_ELEVATION,
        "Second derivative d²α/dθ² of the launch angle by the polar angle.",
        "d²α/dθ², in 1/radian.",
        f"Figure 3(b) of {PAPER}, from the closed form of (10) instead of differences.",
        """\
>>> archerfish.locus_launch_angle_d2(np.radians([10.0, 30.0, 60.0]), 0.1)
array([-1.78960123, -1.60243699, -0.48199183])
""",
    ),
    "locus_radius": UfuncDoc(
        BY_ELEVATION,
        "Distance r̃ of the locus of apexes from the launch point, by polar angle.",
        "r̃ = r/ρ with ρ = V₀²/g: 2 sin θ / (1 + 3 sin²θ) at ε = 0.",
        f"Equation (13) of {PAPER}, with the right branch for every ε; (15) at ε = 0.",
        """\
>>> archerfish.locus_radius(np.radians([10.0, 30.0, 60.0]), 0.1)
array([0.30575278, 0.53331207, 0.4987823 ])
""",
    ),
    "locus_curvature": UfuncDoc(
        BY_ELEVATION,
        "Curvature of the locus of apexes, by polar angle.",
        "ρK with ρ = V₀²/g: 1 at θ = 0, 1 + ε at θ = π/2, positive throughout.",
        f"Equation (19) of {PAPER}.",
        """\
>>> archerfish.locus_curvature(np.radians([0.0, 12.2048522798, 90.0]), 10.0)
array([ 1.        , 59.28157766, 11.        ])
""",
    ),
    "flight_time": UfuncDoc(
        BY_LAUNCH_ANGLE,
        "Time of flight over level ground.",
        "The T > 0 with y(T) = 0, in V₀/g: 2 sin α at ε = 0, near sin α + 1/ε for strong drag.",
        f"The equation of motion, from which (7) and (8) of {PAPER} follow, at y = 0.",
        """\
>>> archerfish.flight_time(np.radians([30.0, 45.0, 60.0]), 0.1)
array([0.98386929, 1.38237439, 1.6847659 ])
""",
    ),
    "flight_range": UfuncDoc(
        BY_LAUNCH_ANGLE,
        "Range over level ground.",
        "x(T), in V₀²/g: sin 2α at ε = 0; negative for α > π/2.",
        f"The equation of motion, from which (7) and (8) of {PAPER} follow, at y = 0.",
        """\
>>> archerfish.flight_range(np.radians([30.0, 45.0, 60.0]), 0.1)
array([0.81148171, 0.91293224, 0.77524478])
""",
    ),
    "flight_x": UfuncDoc(
        TIME | DIRECTION | EPS,
        "Abscissa of the projectile at time t.",
        "x = cos α (1 - e^(-εt)) / ε, in V₀²/g; t cos α at ε = 0.",
        f"The equation of motion, before (7) of {PAPER}.",
        """\
>>> archerfish.flight_x([0.0, 0.5, 1.0], np.pi / 3, 0.1)
array([0.        , 0.24385288, 0.47581291])
""",
    ),
    "flight_y": UfuncDoc(
        TIME | DIRECTION | EPS,
        "Height of the projectile at time t.",
        "y = sin α (1 - e^(-εt)) / ε - (εt - 1 + e^(-εt)) / ε², in V₀²/g; t sin α - t²/2 at "
        "ε = 0.\n    Exact beside the greater of the two terms; below the launch point negative.",
        f"The equation of motion, before (7) of {PAPER}.",
        """\
>>> archerfish.flight_y([0.0, 0.5, 1.0], np.pi / 3, 0.1)
array([0.        , 0.29942312, 0.34039033])
""",
    ),
    "trajectory_height": UfuncDoc(
        {"x": "Abscissa in V₀²/g, on the side the shot goes to, nearer than cos α/ε."}
        | DIRECTION
        | EPS,
        "Height of the trajectory at the abscissa x.",
        "y = x tan α + ln(1 - v)/ε² + v/ε² with v = εx / cos α, in V₀²/g; x tan α - x²/(2 cos²α)\n"
        "    at ε = 0. NaN from the wall cos α/ε on, which the shot never reaches.",
        f"Equations (7) and (8) of {PAPER} before the apex is put in.",
        """\
>>> archerfish.trajectory_height([0.0, 0.25, 0.5], np.pi / 3, 0.1)
array([0.        , 0.30368326, 0.32997384])
""",
    ),
    "optimal_angle": UfuncDoc(
        EPS,
        "Launch angle of the greatest range over level ground.",
        "α in radians: π/4 at ε = 0, falling to 0; launch and landing are perpendicular there.",
        "sin α = ε/(eᵛ - 1) with v eᵛ - (eᵛ - 1) = ε².",
        """\
>>> np.degrees(archerfish.optimal_angle([0.0, 0.1, 1.0, 10.0]))
array([45.        , 43.70969218, 35.58969411, 15.82872145])
""",
    ),
    "envelope_height": UfuncDoc(
        {"x": "Abscissa in V₀²/g, in [-1/ε, 1/ε]."} | EPS,
        "Height of the envelope of all trajectories at the abscissa x.",
        "In V₀²/g: (1 - x²)/2 at ε = 0, -∞ at x = ±1/ε. A target is within reach exactly when it\n"
        "    lies on or under the envelope.",
        "The highest of all shots at x has 1 - ε|x|/cos α = sin α/(sin α + ε).",
        """\
>>> archerfish.envelope_height([0.0, 0.5, 1.0], 0.1)
array([ 0.46898202,  0.33056445, -0.09470809])
""",
    ),
    "aim_low": UfuncDoc(
        TARGET | EPS,
        "Launch angle of the lower, faster arc through the target (x, y).",
        "Radians, in [-π/2, π/2] for x ≥ 0, in (π/2, 3π/2] for x < 0. NaN where the target lies\n"
        "    above `envelope_height(x, eps)`; on it, to two or three units in the last place,\n"
        "    both arcs are one. The launch point itself counts as straight ahead.",
        "The angle at which the circle of all shots of one instant passes through the target.",
        """\
>>> np.degrees(archerfish.aim_low([0.5, -0.5, 0.5], [0.0, 0.0, -1.0], 0.1))
array([ 15.59933028, 164.40066972, -52.28502372])
""",
    ),
    "aim_high": UfuncDoc(
        TARGET | EPS,
        "Launch angle of the higher, slower arc through the target (x, y).",
        "As `aim_low`. Straight up for a target right above, which is met on the way down.",
        "The angle at which the circle of all shots of one instant passes through the target.",
        """\
>>> np.degrees(archerfish.aim_high([0.5, -0.5, 0.5], [0.0, 0.0, -1.0], 0.1))
array([ 72.81004359, 107.18995641,  77.73680911])
""",
    ),
}

_POSITIONAL = inspect.Parameter.POSITIONAL_ONLY
_KEYWORD = inspect.Parameter.KEYWORD_ONLY
_OPTIONS = [
    inspect.Parameter("out", inspect.Parameter.POSITIONAL_OR_KEYWORD, default=None),
    inspect.Parameter("where", _KEYWORD, default=True),
    inspect.Parameter("casting", _KEYWORD, default="same_kind"),
    inspect.Parameter("order", _KEYWORD, default="K"),
    inspect.Parameter("dtype", _KEYWORD, default=None),
    inspect.Parameter("subok", _KEYWORD, default=True),
    inspect.Parameter("signature", _KEYWORD, default=None),
]


def signature(doc: UfuncDoc) -> inspect.Signature:
    """The call signature: the named inputs, then what every NumPy ufunc takes."""
    inputs = [inspect.Parameter(name, _POSITIONAL) for name in doc.arguments]
    return inspect.Signature(inputs + _OPTIONS)


def docstring(name: str, doc: UfuncDoc) -> str:
    """The page of one ufunc, in NumPy's layout."""
    arguments = "\n".join(f"{key} : array_like\n    {text}" for key, text in doc.arguments.items())
    return f"""{name}{signature(doc)}

{doc.summary}

Parameters
----------
{arguments}
out, where, casting, order, dtype, subok, signature
    As for every NumPy ufunc.

Returns
-------
ndarray or scalar
    {doc.returns}
    The shape is that of the inputs, broadcast together; float32 if every input is
    float32 or narrower (computed in double precision, then rounded), else float64.
    NaN, with NumPy's `invalid` warning, outside the domain; a NaN passes quietly.
    A float32 is the number it is: the one nearest π lies above π, the one nearest -1/e
    below -1/e, outside the domain both.

Source
------
{doc.source}

Examples
--------
>>> import numpy as np, archerfish
{doc.example}"""


def attach(module: ModuleType) -> None:
    """Give the ufuncs of `module` their pages, signatures and the place they are imported from."""
    for name, doc in DOCS.items():
        ufunc = getattr(module, name)
        ufunc.__doc__ = docstring(name, doc)
        ufunc.__signature__ = signature(doc)
        ufunc.__module__ = "archerfish"

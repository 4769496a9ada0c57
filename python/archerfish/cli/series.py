"""`archerfish series`: equations (16) and (17), printed and compared with the truth."""

from __future__ import annotations

import json
from fractions import Fraction
from math import lcm
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from archerfish.cli.errors import reported
from archerfish.cli.options import OUTPUT_PATH, file_format
from archerfish.files import write_whole

if TYPE_CHECKING:
    from archerfish.series import ConvergenceData, LaunchAngleSeries, Of

FORMATS = ("table", "json", "latex")
TITLES = {
    "paper": "the paper's series (17): reversion of (16), which is (10) cut at first order in ε",
    "exact": "the exact series: reversion of (10)",
}
SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
#: Errors are told at these orders, as far as --order goes.
COMPARED_ORDERS = (6, 12, 18)


@click.command(
    epilog="""\b
Examples:
  archerfish series
      both series to order 18
  archerfish series --of exact --order 6 --format latex
  archerfish series --compare
      errors against the true launch angle, and where each series converges
  archerfish series --compare --epsilon 0.5 --elevation 10 --elevation 20
""",
)
@click.option(
    "--of",
    "which",
    type=click.Choice(["paper", "exact", "both"]),
    default="both",
    show_default=True,
    help="The paper's reversion of (16), or that of (10) itself.",
)
@click.option("--order", type=int, default=18, show_default=True, help="Highest power of T.")
@click.option(
    "--format",
    "chosen_format",
    type=click.Choice(FORMATS),
    help="What to write.  [default: json if --output ends in it, else table]",
)
@click.option("--output", type=OUTPUT_PATH, help="Write there instead of to the terminal.")
@click.option("--compare", is_flag=True, help="Compare with the true α(θ) instead of printing.")
@click.option(
    "--epsilon",
    "epsilons",
    type=float,
    multiple=True,
    help="With --compare: drag parameter, may be repeated.  [default: 0.1, 1, 10]",
)
@click.option(
    "--elevation",
    "elevations",
    type=click.FloatRange(0, 90, max_open=True),
    multiple=True,
    help="With --compare: θ in degrees, may be repeated.  [default: 1, 2, 5, 10, 15, 20, 25, 30]",
)
def series(
    which: str,
    order: int,
    chosen_format: str | None,
    output: Path | None,
    compare: bool,
    epsilons: tuple[float, ...],
    elevations: tuple[float, ...],
) -> None:
    """The series for the launch angle α at elevation θ of the apex.

    α(θ) = arctan T + Σ aₖ(ε) Tᵏ with T = 2 tan θ: exact rational coefficients, evaluated and
    compared with the true α(θ). Elevations are in degrees.
    """
    from archerfish.series import convergence_data, exact_series, paper_series

    makers = {"paper": paper_series, "exact": exact_series}
    chosen = file_format(chosen_format, output, FORMATS)
    if not compare and (epsilons or elevations):
        raise click.UsageError("--epsilon and --elevation go with --compare")
    if compare and chosen == "latex":
        raise click.UsageError("--compare writes table or json, got latex")
    with reported():
        wanted = [makers[name](order) for name in ("paper", "exact") if which in (name, "both")]
        if compare:
            data = convergence_data(
                epsilons or (0.1, 1.0, 10.0),
                elevation=np.radians(elevations or (1, 2, 5, 10, 15, 20, 25, 30)),
                orders=[*(n for n in COMPARED_ORDERS if n < order), order],
            )
            write = _comparison_json if chosen == "json" else _comparison_table
            text = write(data, [each.of for each in wanted])
        else:
            text = {"table": _plain, "json": _json, "latex": _latex}[chosen](wanted)
    if output is None:
        click.echo(text, nl=False)
    else:
        write_whole(output, text.encode())
        click.echo(f"wrote {output}")


def _plain(wanted: list[LaunchAngleSeries]) -> str:
    lines = ["α(θ) = arctan T + Σ aₖ Tᵏ,  T = 2 tan θ"]
    for each in wanted:
        lines += ["", TITLES[each.of]]
        for k, polynomial in enumerate(each.coefficients):
            if polynomial:
                numerator, denominator = _over_common_denominator(polynomial, "ε", _superscript)
                if " " in numerator:
                    numerator = f"({numerator})"
                name = f"a{str(k).translate(SUBSCRIPTS)}"
                lines.append(f"  {name:<4}= {numerator}/{denominator}")
    return "\n".join(lines) + "\n"


def _latex(wanted: list[LaunchAngleSeries]) -> str:
    lines = []
    for each in wanted:
        lines += [f"% {TITLES[each.of]}", r"\begin{align*}", r"\alpha(\theta) &= \arctan T"]
        for k, polynomial in enumerate(each.coefficients):
            if polynomial:
                numerator, denominator = _over_common_denominator(
                    polynomial, r"\varepsilon", lambda power: f"^{{{power}}}"
                )
                # The sign of a single term stands before its fraction.
                sign = "-" if numerator.startswith("−") and " " not in numerator else "+"
                numerator = numerator.removeprefix("−") if sign == "-" else numerator
                lines.append(
                    rf"  \\ &\quad {sign} \frac{{{numerator}}}{{{denominator}}}\,T^{{{k}}}"
                )
        lines += [r"  + \cdots, \qquad T = 2\tan\theta", r"\end{align*}"]
    return "\n".join(lines).replace("−", "-") + "\n"


def _json(wanted: list[LaunchAngleSeries]) -> str:
    """Powers of T, then powers of ε, to rational numbers as text."""
    document = [
        {
            "of": each.of,
            "order": each.order,
            "coefficients": {
                str(k): {str(j): str(number) for j, number in enumerate(polynomial) if number}
                for k, polynomial in enumerate(each.coefficients)
                if polynomial
            },
        }
        for each in wanted
    ]
    return json.dumps(document, indent=2) + "\n"


def _superscript(power: int) -> str:
    return str(power).translate(SUPERSCRIPTS)


def _over_common_denominator(
    polynomial: tuple[Fraction, ...], symbol: str, power: Any
) -> tuple[str, int]:
    denominator = lcm(*(number.denominator for number in polynomial))
    text = ""
    for j, number in enumerate(polynomial):
        if not number:
            continue
        whole = int(number * denominator)
        sign = ("−" if whole < 0 else "") if not text else (" − " if whole < 0 else " + ")
        size = "" if abs(whole) == 1 and j > 0 else str(abs(whole))
        text += sign + size + ("" if j == 0 else symbol if j == 1 else symbol + power(j))
    return text, denominator


def _comparison_table(data: ConvergenceData, wanted: list[Of]) -> str:
    from archerfish.cli.terminal import grid_table

    headings = ["θ (°)", "T", "", "α (°)", *(f"order {order}" for order in data.orders)]
    text = "Error of the series in degrees: cut after that order, less the true α(θ).\n\n"
    for of in wanted:
        text += f"{TITLES[of]}\n\n"
        for i, eps in enumerate(data.epsilon):
            reach, limit = data.radius[of][i], np.degrees(data.limit(of)[i])
            rows = []
            for p, theta in enumerate(data.elevation):
                doubled = 2 * np.tan(theta)
                rows.append(
                    [
                        f"{np.degrees(theta):g}",
                        f"{doubled:.4f}",
                        "converges" if doubled < reach else "diverges",
                        f"{np.degrees(data.launch_angle[i, p]):.6f}",
                        *(f"{error:.1e}" for error in np.degrees(data.error[of][i, :, p])),
                    ]
                )
            bounds = f"T below {reach:.6f}, θ below {limit:.4f}°" if eps > 0 else "every θ"
            title = f"ε = {eps:g}: converges for {bounds}"
            text += grid_table(title, headings, rows)
    return text


def _comparison_json(data: ConvergenceData, wanted: list[Of]) -> str:
    document = [
        {
            "of": of,
            "epsilon": float(eps),
            "elevation_deg": float(np.degrees(theta)),
            "launch_angle_deg": float(np.degrees(data.launch_angle[i, p])),
            "radius": float(data.radius[of][i]) if np.isfinite(data.radius[of][i]) else None,
            "converges": bool(2 * np.tan(theta) < data.radius[of][i]),
            "error_deg": {
                str(order): float(np.degrees(data.error[of][i, m, p]))
                for m, order in enumerate(data.orders)
            },
        }
        for of in wanted
        for i, eps in enumerate(data.epsilon)
        for p, theta in enumerate(data.elevation)
    ]
    return json.dumps(document, indent=2) + "\n"

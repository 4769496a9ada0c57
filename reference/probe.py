"""Measure one function of the crate against its exact values and print its worst inputs.

python -m reference.probe log1pmx --count 20000 --seed 7 --worst 5
python -m reference.probe apex_x --at=0x1.8p+0,0.1
"""

import argparse

import numpy as np

from reference import kernels, oracle
from reference.ball import ulp_errors


def numbers(text: str) -> list[float]:
    """Numbers between commas, decimal or hexadecimal."""
    return [float.fromhex(v) if "0x" in v else float(v) for v in text.split(",")]


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "name", choices=list(oracle.FUNCTIONS), metavar="NAME", help="a public function"
    )
    parser.add_argument(
        "--count", type=int, default=5000, help="random inputs, after the adversarial corners"
    )
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--worst", type=int, default=8, help="how many of the worst to print")
    parser.add_argument("--at", type=numbers, help="one input instead, as NUMBER or NUMBER,NUMBER")
    options = parser.parse_args()

    if options.at:
        arguments = tuple(np.array([v]) for v in options.at)
    else:
        arguments = oracle.sample(options.name, options.count, options.seed)
    got = kernels.evaluate(options.name, *arguments)
    hi, rest, ulp = oracle.values(options.name, *arguments)
    errors = ulp_errors(got, hi, rest, ulp)
    bound = oracle.FUNCTIONS[options.name].bound
    print(
        f"{options.name}: {errors.size} inputs, worst {errors.max():.5g} ulp, "
        f"{(errors > bound).sum()} above {bound:g}"
    )
    for i in np.argsort(-errors, kind="stable")[: options.worst]:
        at = ", ".join(f"{float(a[i])!r} ({float(a[i]).hex()})" for a in arguments)
        print(f"  {errors[i]:10.5g} ulp at {at}: got {float(got[i])!r}, exact {float(hi[i])!r}")


if __name__ == "__main__":
    main()

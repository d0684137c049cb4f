"""Measure `testbed.failure_probability` and `smallest_failure` on known limit states. Writes docs/results/rare_failures.md.

python benchmarks/rare_failures.py             # 100 seeds, some ten minutes
python benchmarks/rare_failures.py --seeds 10
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np
from aside import aside
from limit_states import (
    FOUR_BRANCH_1E5,
    Case,
    four_branch,
    linear,
    parallel,
    quadratic,
    series,
    sphere,
    two_sided,
)

from testbed.reliability import FailureProbability, failure_probability, smallest_failure

PAGE = Path(__file__).parents[1] / "docs" / "results" / "rare_failures.md"
BUDGET = 4000
METHODS = ("importance", "adaptive", "subset")
CASES: Mapping[str, Case] = {
    "half space, d = 2": linear(2, 1e-5),
    "half space, d = 20": linear(20, 1e-5),
    "half space, d = 100": linear(100, 1e-5),
    "half space, d = 20, 1e-2": linear(20, 1e-2),
    "half space, d = 20, 1e-7": linear(20, 1e-7),
    "four branches": four_branch(),
    "four branches, moved out to 1e-5": four_branch(2, FOUR_BRANCH_1E5),
    "four branches, d = 20": four_branch(20),
    "two regions, d = 10": two_sided(10, 4.265, 4.5),
    "ten in series, d = 20": series(20, 10, 4.5),
    "two in parallel, d = 10": parallel(10, 2, 2.7),
    "five in parallel, d = 20": parallel(20, 5, 1.3),
    "curved, d = 20": quadratic(20, 4.0, 0.3),
    "sphere, d = 5": sphere(5, 5.6),
    "sphere, d = 20": sphere(20, 7.6),
}
SMALLEST: Mapping[str, Case] = {
    **CASES,
    "sum of moduli, d = 10": Case(lambda u: 6 - abs(u[:, :2]).sum(axis=1), 10, np.nan, 6 / np.sqrt(2)),
    "stairs, d = 10": Case(lambda u: np.ceil(2 * (4.25 - u[:, 0])), 10, np.nan, 4.25),
    "jump, d = 10": Case(lambda u: np.where(u[:, 0] > 4, -3.0, 8 - u[:, 0]), 10, np.nan, 4.0),
    "rippled, d = 6": Case(
        lambda u: 4 - u[:, 0] + 0.3 * np.sin(8 * u[:, 1]) + 0.3 * np.sin(7 * u[:, 0]), 6, np.nan, np.nan
    ),
}
TEXT = """# Rare and smallest failures of known limit states

This page says how well `testbed.failure_probability` and `testbed.reliability.smallest_failure` find what is known.
[What they compute](../explanation/rare_failures.md).

Everything is measured by `python benchmarks/rare_failures.py`, with {seeds} seeds of each case, a budget of {budget}
evaluations and an asked coefficient of variation of 0.3.

## Probabilities

*Within 2*: share of the seeds whose estimate is between half and twice the known probability. *Covers*: share whose
95 % interval contains it. *Width*: median ratio of the interval's ends. *Evaluations*: mean, and the most of any seed.
*Converged*: share of the seeds that say that they know it as well as asked.

{probabilities}

Plain sampling needs 1.1 million evaluations for a probability of 1e-5 and a coefficient of variation of 0.3.

## Limit states that lie

One seed of each, with the default method. No interval excludes the truth.

{lies}

## Smallest failures

Ratio of the distance found, with a budget of 2000, to the known one (if none is known, to the nearest found by any seed, also
with a budget of 20 000); {few} seeds.

{smallest}
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=100)
    seeds = parser.parse_args().seeds
    few = max(2, seeds // 10)
    PAGE.write_text(
        TEXT.format(
            seeds=seeds,
            few=few,
            budget=BUDGET,
            probabilities="\n".join(aside(probabilities(seeds).split("\n"), PAGE.with_suffix(".csv"))),
            lies=lies(),
            smallest=smallest(few),
        ),
        encoding="utf-8",
    )


def probabilities(seeds: int) -> str:
    """The table of known probabilities, a row for each case and method."""
    head = (
        "limit state",
        "probability",
        "method",
        "within 2",
        "covers",
        "width",
        "evaluations",
        "converged",
    )
    rows = []
    for name, case in CASES.items():
        for method in METHODS:
            found = [
                failure_probability(
                    case.limit_state, case.dimensions, seed=seed, budget=BUDGET, method=method
                )
                for seed in range(seeds)
            ]
            rows.append((name, f"{case.probability:.2e}", f"`{method}`", *measured(found, case, method)))
            print(*rows[-1], flush=True)
    return table(head, rows)


def measured(found: Sequence[FailureProbability], case: Case, method: str) -> tuple[str, ...]:
    """The columns of one case and method."""
    ratios = np.array([one.probability for one in found]) / case.probability
    covers = [one.interval[0] <= case.probability <= one.interval[1] for one in found]
    widths = [one.interval[1] / max(one.interval[0], 1e-300) for one in found]
    evaluations = [one.evaluations for one in found]
    return (
        share((ratios > 0.5) & (ratios < 2)),
        share(covers),
        f"{np.median(widths):.1f}",
        f"{np.mean(evaluations):.0f} ({max(evaluations)})",
        share([one.converged for one in found]),
    )


def share(which: Sequence[bool] | np.ndarray) -> str:
    return f"{100 * np.mean(which):.0f} %"


def lies() -> str:
    """What is said of limit states that mislead."""
    rows = []
    for name, (limit_state, truth) in LIES.items():
        found = failure_probability(limit_state, 3)
        low, high = found.interval
        assert low <= truth <= high, name
        rows.append((name, f"{truth:.2g}", f"{low:.2g} to {high:.2g}", found.reason))
    return table(("limit state, d = 3", "probability", "interval", "what is said"), rows)


def _noise(u: np.ndarray) -> np.ndarray:
    """A number of each point's own between 0 and 1, unrelated to its neighbours'."""
    mixed = np.sin(u @ np.array([12345.6789, 98765.4321, 31415.9265])) * 43758.5453
    return mixed - np.floor(mixed)


LIES: Mapping[str, tuple[Callable[[np.ndarray], np.ndarray], float]] = {
    "1 or -1, by u_1 > 3.5": (lambda u: np.where(u[:, 0] > 3.5, -1.0, 1.0), 2.326e-4),
    "always 1": (lambda u: np.ones(len(u)), 0.0),
    "falls to 0.5, no further": (lambda u: np.maximum(2.0 - u[:, 0], 0.5), 0.0),
    "exp(-u_1), never 0": (lambda u: np.exp(-u[:, 0]), 0.0),
    "noise, of which 1e-4 fails": (lambda u: _noise(u) - 1e-4, 1e-4),
    "not a number for u_2 > 2": (lambda u: np.where(u[:, 1] > 2, np.nan, 4.0 - u[:, 0]), 3.167e-5),
    "never a number": (lambda u: np.full(len(u), np.nan), 0.0),
}


def smallest(seeds: int) -> str:
    """The table of smallest failures."""
    rows = []
    for name, case in SMALLEST.items():
        found, longer = (
            np.array(
                [
                    smallest_failure(case.limit_state, case.dimensions, seed=seed, budget=budget).distance
                    for seed in range(seeds)
                ]
            )
            for budget in (2000, 20_000)
        )
        known = case.distance if np.isfinite(case.distance) else min(found.min(), longer.min())
        rows.append((name, f"{known:.3f}", *spread(found / known)))
        print(*rows[-1], flush=True)
    head = ("limit state", "distance", "median", "worst")
    return table(head, rows)


def spread(ratios: np.ndarray) -> tuple[str, str]:
    return f"{np.median(ratios):.3f}", f"{ratios.max():.3f}"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


if __name__ == "__main__":
    main()

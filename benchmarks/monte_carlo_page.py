"""The tables of docs/results/monte_carlo.md: the shipped sweeps, flown by every controller that they compare.

python benchmarks/monte_carlo_page.py [--runs 200] [--jobs 1]
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import pandas as pd
from blocks import write

from testbed.common.statistics import paired, proportion

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "results" / "monte_carlo.md"
SWEEPS = {
    "any failure": ("any_failure_in_turbulence.yaml",),
    "weak tail": ("left_tail_monte_carlo.yaml",),
    "weak tail, roll released": ("left_tail_monte_carlo.yaml", "--set", "controller.released=[p_dot]"),
}
"""Blocks of the page: a sweep below scenarios/sweeps, and what is changed of it."""


def flown(sweep: Sequence[str], runs: int, jobs: int) -> pd.DataFrame:
    """The table of a sweep; exits if it could not be flown."""
    with tempfile.TemporaryDirectory() as folder:
        words = [
            str(ROOT / "scenarios" / "sweeps" / sweep[0]),
            *sweep[1:],
            "--runs",
            str(runs),
            "--jobs",
            str(jobs),
        ]
        run = [
            sys.executable,
            "-m",
            "testbed",
            "sweep",
            *words,
            "--out",
            folder,
            "--save-logs",
            "none",
            "--no-plots",
        ]
        if subprocess.run(run, cwd=ROOT, check=False, stdout=subprocess.DEVNULL).returncode not in (0, 1):
            sys.exit(f"{sweep[0]} could not be flown")
        return pd.read_csv(Path(folder) / "results.csv")


def table(flights: pd.DataFrame) -> str:
    """Markdown: a row for each controller, with intervals of 95 %; differences are paired, of the first less the other."""
    controllers = list(dict.fromkeys(flights["controller.type"]))
    of = {name: flights[flights["controller.type"] == name].sort_values("run") for name in controllers}
    first = list(of[controllers[0]]["passed"])
    lines = [
        f"| {len(first)} flights each | survived | all requirements | {controllers[0]} meets them more by |",
        "| --- | --- | --- | --- |",
    ]
    for name, own in of.items():
        passed, survived = list(own["passed"]), int((own["outcome"] == "completed").sum())
        share = proportion(sum(passed), len(passed))
        d = paired(first, passed)
        more = f"{d.difference:+.3f} ({d.low:+.3f} to {d.high:+.3f})" if name != controllers[0] else ""
        lines.append(
            f"| `{name}` | {survived} | {share.estimate:.3f} ({share.low:.3f} to {share.high:.3f}) | {more} |"
        )
    return "\n".join(lines)


def by_failure(flights: pd.DataFrame) -> str:
    """Markdown: flights that met all requirements, by what failed and controller."""
    what = flights["failures.0"].map(_words)
    counted = flights.groupby([what, "controller.type"], sort=False)["passed"].agg(["sum", "count"])
    controllers = list(dict.fromkeys(flights["controller.type"]))
    lines = [f"| failure | {' | '.join(controllers)} |", f"| --- |{' --- |' * len(controllers)}"]
    for failure in sorted(set(what)):
        cells = [counted.loc[(failure, name)] for name in controllers]
        lines.append(f"| {failure} | {' | '.join('{}/{}'.format(*cell) for cell in cells)} |")
    return "\n".join(lines)


def _words(failure: str) -> str:
    fields = json.loads(failure)
    kind = "surface" if fields["actuator"].endswith("ruddervator") else "propeller"
    value = f" {fields['value']:g}" if "value" in fields else ""
    return f"{kind}, {fields['type']}{value}"


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--runs", type=int, default=200)
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    for name, sweep in SWEEPS.items():
        flights = flown(sweep, options.runs, options.jobs)
        body = table(flights)
        if "failures.0" in flights:
            body += f"\n\n{by_failure(flights)}"
        write(PAGE, name, body)


if __name__ == "__main__":
    main()

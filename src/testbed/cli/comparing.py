"""`testbed compare`: flights that were flown already, side by side in one page."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from testbed.cli.checked import collect
from testbed.cli.interrupts import tidily
from testbed.cli.status import MET
from testbed.inputs.problems import BadInput, Problem
from testbed.loading import load_flight
from testbed.reporting.comparison import MOST, Comparison


def compare(runs: Sequence[Path], out: Path) -> int:
    """Print what differs between flights, and write their page; returns the exit status. Raises BadInput."""
    problems: list[Problem] = []
    if not 2 <= len(runs) <= MOST:
        problems.append(Problem(f"compares {len(runs)}", "compare", expected=f"from 2 to {MOST} flights"))
    flights = [collect(problems, lambda run=run: load_flight(run)) for run in runs]  # type: ignore[misc]
    if problems:
        raise BadInput(problems)
    comparison = Comparison([flight for flight in flights if flight is not None])
    file = out if out.suffix == ".html" else out / "comparison.html"
    with tidily():
        comparison.write(file)
    print(comparison)
    print(f"wrote {file}")
    return MET

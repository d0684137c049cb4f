"""`testbed compare`: flights that were flown already, side by side in one page."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from testbed.cli.checked import collect
from testbed.cli.interrupts import tidily
from testbed.cli.status import MET
from testbed.inputs.output_file import refuse_unwritable
from testbed.inputs.problems import BadInput, Problem
from testbed.loading import load_flight
from testbed.reporting.comparison.compare import MOST, Comparison
from testbed.reporting.html import is_page


def compare(runs: Sequence[Path], out: Path) -> int:
    """Print what differs between flights, and write their page; returns the exit status. Raises BadInput."""
    problems: list[Problem] = []
    if not 2 <= len(runs) <= MOST:
        what = f"is given {len(runs)} flight{'s' if len(runs) > 1 else ''}"
        problems.append(Problem(what, "compare", expected=f"from 2 to {MOST} flights"))
    file = out if out.suffix == ".html" else out / "comparison.html"
    collect(problems, lambda: refuse_unwritable(file, is_page))
    flights = [collect(problems, lambda run=run: load_flight(run)) for run in runs]  # type: ignore[misc]
    if problems:
        raise BadInput(problems)
    comparison = Comparison([flight for flight in flights if flight is not None])
    with tidily():
        comparison.write(file)
    print(comparison)
    print(f"wrote {file}")
    return MET

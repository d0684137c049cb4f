"""`testbed compare`: flights that were flown already, side by side in one page; or two sweeps, flight by flight."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from testbed.cli.command import add_out
from testbed.cli.ending import MET, NOT_MET, tidily
from testbed.cli.terminal import working
from testbed.inputs.output_file import refuse_unwritable
from testbed.inputs.problems import BadInput, Problem, collect

PURPOSE = "flights side by side, or two sweeps with the same draws, in one page"
EXAMPLES = (
    "testbed compare runs/adaptive runs/pid",
    "testbed compare runs/yesterday runs/today",
    "testbed compare runs/my-sweep/17 runs/my-sweep/18 --out page.html",
)


def arguments(command: ArgumentParser) -> None:
    runs = "run folder, or a flight of a sweep: SWEEP/17; or two sweep folders, the earlier one first"
    command.add_argument("runs", type=Path, nargs="+", metavar="RUN", help=runs)
    page = "page to write, or folder to write comparison.html into (default: %(default)s)"
    add_out(command, "FILE", page, default=Path("runs/comparison.html"))


def run(options: Namespace) -> int:
    """Print what differs between flights or two sweeps, and write their page. Raises BadInput."""
    file = options.out if options.out.suffix == ".html" else options.out / "comparison.html"
    if len(options.runs) == 2 and all((folder / "sweep.yaml").is_file() for folder in options.runs):
        return _sweeps(options.runs[0], options.runs[1], file)
    from testbed.api.load import load_flight
    from testbed.reporting.comparison.compare import MOST, Comparison

    problems: list[Problem] = []
    runs = options.runs
    if not 2 <= len(runs) <= MOST:
        what = f"is given {len(runs)} flight{'s' if len(runs) > 1 else ''}"
        problems.append(Problem(what, "compare", expected=f"from 2 to {MOST} flights"))
    collect(problems, lambda: refuse_unwritable(file, _is_comparison))
    flights = [collect(problems, lambda run=run: load_flight(run)) for run in runs]  # type: ignore[misc]
    if problems:
        raise BadInput(problems)
    comparison = Comparison(list(filter(None, flights)), folders=list(map(str, runs)))
    with tidily():
        comparison.write(file)
    print(comparison)
    print(f"wrote {file}")
    return MET


def _is_comparison(file: Path) -> bool:
    """Whether a page that is there may be replaced; the one of a run or a study is called report.html."""
    from testbed.reporting.html import is_page

    return file.name != "report.html" and is_page(file)


def _sweeps(first: Path, second: Path, file: Path) -> int:
    """Compare two sweeps, and return the exit status: NOT_MET where the second passes less often, beyond chance."""
    from testbed.study_reports.sweep import comparison

    refuse_unwritable(file, _is_comparison)
    with working("comparing"):
        changes = comparison.compared(first, second)
    with tidily():
        comparison.write_page(changes, first, second, file)
    for line in comparison.sentences(changes, second):
        print(line)
    print(f"wrote {file}")
    return NOT_MET if any(change.is_worse for change in changes) else MET

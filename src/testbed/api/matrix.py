"""Failure matrices: `matrix` does everything from Python; the other functions are those of a kind of study."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.api.load import refuse_unfinished
from testbed.api.study import changes, folder_of, write_summary
from testbed.common.text import cell
from testbed.common.writing import write
from testbed.controllers.config import TABLE as CONTROLLERS
from testbed.controllers.user.own import own_controllers
from testbed.inputs.received import believed, refuse_links
from testbed.reporting.attempt import attempt
from testbed.reporting.words import count
from testbed.studies.checks import check
from testbed.studies.drawing.builder import TYPE
from testbed.studies.flying.flight import Fly
from testbed.studies.folder.begin import refuse_blocked
from testbed.studies.folder.table import TABLE as FLIGHTS
from testbed.studies.folder.table import finished
from testbed.studies.matrix import MatrixPlan, load_matrix, read_baseline, summarize
from testbed.studies.run import Flights, Options, fly_sweep
from testbed.study_reports.matrix import tests_of_matrix, write_matrix_page
from testbed.study_reports.sweep.flight_page import write_page_if_kept

if TYPE_CHECKING:
    import pandas as pd

TABLE = "matrix.csv"


def matrix(
    scenario: str | Path,
    out: str | Path | None = None,
    *,
    failures: Sequence[str | Mapping[str, Any]] | None = None,
    severities: Sequence[float] | None = None,
    weather: Sequence[str | float] | None = None,
    seeds: int | None = None,
    at_s: float | None = None,
    baseline: str | Path | None = None,
    controllers: Sequence[str] = (),
    seed: int | None = None,
    settings: Sequence[str] = (),
    set: Mapping[str, Any] | None = None,
    jobs: int | None = None,
    cluster: str | None = None,
    resume: bool = False,
    mixed: bool = False,
    save_logs: str = "all",
    fly: Fly | None = None,
    figures: bool = True,
) -> pd.DataFrame:
    """Break each actuator alone in each way, write the folder, and return a table with a row for each cell (matrix.csv).

    Args:
        scenario: a scenario's file or a matrix file, or the name or folder of an aircraft.
        out: the folder to make, `runs/<name>` by default.
        failures: types, or failures with values of their own such as {"type": "effectiveness", "value": 0}; every type by default.
        severities: 1 are the values of `failures` or the catalogue, 0 is without effect; 0.5 and 1 by default.
        weather: `calm`, `light`, `moderate`, `severe`, or W20 [m/s]; the scenario's by default.
        seeds: flights of each cell, of which the worst counts; 1 by default.
        at_s: when each failure starts [s].
        baseline: a YAML or CSV file with what is expected of the cells; each is expected to be held by default.
        controllers: types of shipped controllers, and classes of your own, each NAME=FILE.py:CLASS.
        save_logs: which flights' logs to keep, each for a page of its own: `none`, `failed` or `all`.
        figures: whether to write the report and the pages of flights.

    `seed`, `settings`, `set`, `jobs`, `cluster`, `resume`, `mixed` and `fly` are as of `sweep`.
    Raises BadInput when nothing can be flown, Stopped when it ended early; the finished flights are then kept.
    """
    import pandas as pd

    how = Options(jobs, cluster, save_logs, fly, mixed=mixed)
    plan, folder = prepare(
        scenario, out, changes(settings, set), seed=seed, controllers=controllers, failures=failures,
        severities=severities, weather=weather, seeds=seeds, at_s=at_s, baseline=baseline,
    )  # fmt: skip
    finish(plan, folder, fly_sweep(plan, folder, how, resume=resume), figures=figures)
    return pd.read_csv(folder / TABLE, keep_default_na=False)


def prepare(
    file: str | Path,
    out: str | Path | None = None,
    settings: Sequence[str] = (),
    *,
    seed: int | None = None,
    resume: bool = False,
    controllers: Sequence[str] = (),
    baseline: str | Path | None = None,
    **keys: Any,
) -> tuple[MatrixPlan, Path]:
    """Read and check a matrix; returns the plan and its folder. Raises BadInput with every problem found.

    `keys` are others of a matrix file, in place of what it says; those that are None are left out.
    """
    given = {key: value for key, value in keys.items() if value is not None}
    given |= {} if baseline is None else {"baseline": read_baseline(baseline)}
    shipped = [name for name in controllers if name in CONTROLLERS]
    given |= {"compare": {TYPE: shipped}} if shipped else {}
    own = own_controllers(name for name in controllers if name not in CONTROLLERS)
    plan = load_matrix(file, changes(settings, seed=seed), own, given)
    check(plan)
    return plan, folder_of(plan, out)


fly, tests = fly_sweep, tests_of_matrix


def finish(
    plan: MatrixPlan, folder: Path, flights: Flights | None = None, *, figures: bool = True
) -> dict[str, Any]:
    """As `Kind.finish`; also writes matrix.csv, and the page of each cell's worst flight whose log was kept."""
    import pandas as pd

    with believed(folder / FLIGHTS, "the table of a matrix"):
        found = summarize(plan, finished(plan, folder))
    cells = pd.DataFrame(found["cells"]).astype({"run": "Int64"})
    cells = cells.map(lambda value: cell(value) if isinstance(value, str) else value)
    write(folder / TABLE, cells.to_csv(index=False, lineterminator="\n"))
    write_summary(found, folder)
    if figures:
        attempt("the pages of the flights", lambda: _write_pages(plan, found, folder))
        attempt("the report", lambda: write_matrix_page(plan, found, folder))
    return found


def _write_pages(plan: MatrixPlan, found: Mapping[str, Any], folder: Path) -> None:
    for one in found["cells"]:
        if one["run"] is not None:
            write_page_if_kept(folder, one["run"], plan.variant_of(one["controller"]))


def rebuild(folder: Path) -> dict[str, Any]:
    """As `Kind.rebuild`."""
    refuse_blocked(folder)
    refuse_unfinished(folder)
    refuse_links(folder)
    return finish(plan_of(folder), folder)


def plan_of(folder: Path) -> MatrixPlan:
    """The plan of a matrix folder, as its file has it."""
    return load_matrix(folder / "matrix.yaml")


def answer(summary: Mapping[str, Any]) -> Sequence[str]:
    """As `Kind.answer`: how many cells came out how, and each that is not as expected."""
    counts = ", ".join(f"{number} {result}" for result, number in summary["counts"].items())
    lines = [f"{count(len(summary['cells']), 'cell')}: {counts}"]
    for against in ("worse", "better"):
        unexpected = [one for one in summary["cells"] if one["against"] == against]
        lines += [f"{against} than expected: {_said(one)}" for one in unexpected]
    return lines


def _said(one: Mapping[str, Any]) -> str:
    """A cell in a line: `elevator stuck 1, calm, pid: lost, expected held (missed ...)`."""
    where = ", ".join(filter(None, [one["weather"], one["controller"]]))
    why = f" ({one['why']})" if one["why"] else ""
    return (f"{one['actuator']} {one['failure']} {one['severity']:g}, {where}: "
            f"{one['result']}, expected {one['expected']}{why}")  # fmt: skip


def met(summary: Mapping[str, Any]) -> bool:
    """As `Kind.met`: whether every cell is as expected; a better one, too, is to be written into the baseline."""
    return not summary["better"] and not summary["worse"]

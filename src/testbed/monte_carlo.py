"""Sweeps from Python: fly one, and finish a folder with what its table says."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.inputs.problems import BadInput, Problem
from testbed.sweeps import summary
from testbed.sweeps.checks import check
from testbed.sweeps.folder import reading, results
from testbed.sweeps.folder.store import runs_of
from testbed.sweeps.plan import Plan, load_sweep
from testbed.sweeps.run import Options, fly_sweep
from testbed.sweeps.workers.flying import SAVE_LOGS, Fly

if TYPE_CHECKING:
    import pandas as pd


def sweep(
    sweep: str | Path,
    out: str | Path | None = None,
    *,
    runs: int | None = None,
    seed: int | None = None,
    settings: Sequence[str] = (),
    jobs: int | None = None,
    cluster: str | None = None,
    resume: bool = False,
    save_logs: str = "failed",
    fly: Fly | None = None,
    figures: bool = True,
) -> pd.DataFrame:
    """Fly a sweep file into a folder and return its table; see `testbed.load` for the table.

    `out` is runs/<name> by default; `settings` are KEY=VALUE as of --set; `jobs` processes (default: one a
    core), or the `cluster` at an address; `save_logs` none, failed or all. `fly(scenario) -> Flight`, a
    function at the top of a module, replaces the simulator. Raises BadInput when nothing can be flown,
    Stopped when it ended before its time.
    """
    plan, folder = prepare(sweep, out, settings, runs=runs, seed=seed, resume=resume)
    fly_sweep(plan, folder, options(jobs, cluster, save_logs, fly), resume=resume)
    finish(plan, folder, figures=figures)
    return reading.load(folder)


def default_folder(plan: Plan) -> Path:
    """runs/<name>."""
    return Path("runs") / (re.sub(r"[^a-z0-9]+", "-", plan.name.lower()).strip("-") or "sweep")


def options(jobs: int | None, cluster: str | None, save_logs: str, fly: Fly | None = None) -> Options:
    """How to fly, checked."""
    problems = []
    if jobs is not None and jobs < 1:
        problems.append(Problem(f"is {jobs}", "--jobs", expected="at least 1"))
    if save_logs not in SAVE_LOGS:
        problems.append(Problem(f"is {save_logs!r}", "--save-logs", expected="none, failed or all"))
    if problems:
        raise BadInput(problems)
    return Options(jobs, cluster, save_logs, fly)


def prepare(
    file: str | Path,
    out: str | Path | None = None,
    settings: Sequence[str] = (),
    *,
    runs: int | None = None,
    seed: int | None = None,
    resume: bool = False,
) -> tuple[Plan, Path]:
    """Read and check a sweep; it and its folder. One that is resumed without a number of runs is as long as
    before.
    """
    given = [f"{name}={value}" for name, value in (("runs", runs), ("seed", seed)) if value is not None]
    plan = load_sweep(file, [*settings, *given])
    folder = Path(out) if out is not None else default_folder(plan)
    before = runs_of(folder) if resume and runs is None else None
    if before is not None and before > plan.runs:
        plan = load_sweep(file, [*settings, *given, f"runs={before}"])
    check(plan)
    return plan, folder


def finish(plan: Plan, folder: Path, *, figures: bool = True) -> dict[str, Any]:
    """Write what a folder's table says: summary.json, figures, report.html; returns the summary."""
    frame = reading.load(folder)
    found = summary.summarize(plan, frame)
    summary.write(found, folder)
    if figures and len(frame):
        from testbed.reporting.sweep_figures import draw_sweep
        from testbed.reporting.sweep_report import write_sweep_report

        draw_sweep(plan, frame, folder)
        write_sweep_report(folder)
    return found


def rebuild(folder: Path) -> dict[str, Any]:
    """Table, summary, figures and report of a folder, of what has finished in it, without flying."""
    plan = reading.load_plan(folder)
    stopped = (folder / "results.parquet").is_file() and plan.sweep.stop_when is not None
    if not stopped:  # of a sweep that stopped by itself the table is shorter than the journal
        kept = reading.finished(plan, folder)
        results.write(plan, lambda: iter(kept), folder)
    return finish(plan, folder)

"""Sweeps: `sweep` does everything from Python; the other functions are those of a kind of study, and of single runs."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.api.study import changes, folder_of, write_summary
from testbed.controllers.user.own import own_controllers
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.inputs.received import refuse_links
from testbed.reporting.attempt import add_report, attempt
from testbed.reporting.words import count, interval, number, passing
from testbed.studies import summary
from testbed.studies.checks import check
from testbed.studies.flying.flight import Fly, Job, flight_of
from testbed.studies.folder import logs, store, table
from testbed.studies.folder.begin import begun_with, refuse_blocked, refuse_changed
from testbed.studies.folder.logs import file_of, flight_label, in_file_names, runs_of
from testbed.studies.load import load_sweep
from testbed.studies.plan import Plan
from testbed.studies.record import NO_RESULT
from testbed.studies.run import Flights, Options, fly_only, fly_sweep
from testbed.study_reports.sweep.flight_page import tests_of_sweep, write_kept_page, write_page_if_kept
from testbed.study_reports.sweep.report import write_sweep_report

if TYPE_CHECKING:
    import pandas as pd

    from testbed.flight.flight import Flight

WORST_PAGES = 3
"""Flights of each variant whose pages are written with the sweep's report, the worst ones."""


def sweep(
    sweep: str | Path,
    out: str | Path | None = None,
    *,
    runs: int | None = None,
    seed: int | None = None,
    settings: Sequence[str] = (),
    set: Mapping[str, Any] | None = None,
    jobs: int | None = None,
    cluster: str | None = None,
    resume: bool = False,
    mixed: bool = False,
    save_logs: str = "failed",
    fly: Fly | None = None,
    figures: bool = True,
    controllers: Sequence[str] = (),
) -> pd.DataFrame:
    """Fly the sweep of a file, write its folder, and return its table with a row for each flight (see `testbed.load`).

    Args:
        sweep: the sweep's YAML file; a shipped one is found from any folder.
        out: the sweep folder to make, `runs/<name>` by default.
        runs: number of runs, in place of the file's.
        seed: seed of everything random, in place of the file's.
        settings: changes as with `--set`, each KEY=VALUE.
        set: the same as a mapping from dotted paths, as `fly` takes it: {"sensors": "mems", "runs": 50}.
        jobs: number of processes; one for each core by default.
        cluster: address of a Dask cluster to fly on instead.
        resume: go on with an existing folder, and fly only the missing flights.
        mixed: fly on where versions or processors are others than at the beginning, and mark those flights in the table.
        save_logs: which flights' logs to keep: `none`, `failed` or `all`.
        fly: `fly(scenario) -> Flight`, a function at the top of a module, in place of the simulator.
        figures: whether to draw figures and write the report.
        controllers: classes of your own to compare with the sweep's controllers, each NAME=FILE.py:CLASS.

    Raises BadInput when nothing can be flown, Stopped when the sweep ended early; the finished flights are then kept.
    """
    how = Options(jobs, cluster, save_logs, fly, mixed=mixed)
    changed = changes(settings, set)
    plan, folder = prepare(sweep, out, changed, runs=runs, seed=seed, resume=resume, controllers=controllers)
    flights = fly_sweep(plan, folder, how, resume=resume)
    finish(plan, folder, flights, figures=figures)
    from testbed.study_reports.sweep.table import table_of  # with pandas

    return table_of(table.load(folder))


def prepare(
    file: str | Path,
    out: str | Path | None = None,
    settings: Sequence[str] = (),
    *,
    runs: int | None = None,
    seed: int | None = None,
    resume: bool = False,
    controllers: Sequence[str] = (),
) -> tuple[Plan, Path]:
    """Read and check a sweep; returns the plan and the sweep folder. Raises BadInput with every problem found.

    A sweep that is resumed without `runs` has at least as many runs as the folder's sweep.yaml says.
    """
    if runs is not None and runs < 1:
        raise BadInput([Problem(f"is {runs}", "--runs", expected="at least 1")])
    own = own_controllers(controllers)
    plan = load_sweep(file, changes(settings, runs=runs, seed=seed), own)
    folder = folder_of(plan, out)
    before = runs_of(folder) if resume and runs is None else None
    if before is not None and before > plan.runs:
        plan = load_sweep(file, changes(settings, runs=before, seed=seed), own)
    check(plan)
    return plan, folder


fly, plan_of, tests = fly_sweep, table.load_plan, tests_of_sweep


def finish(
    plan: Plan, folder: Path, flights: Flights | None = None, *, figures: bool = True
) -> dict[str, Any]:
    """As `Kind.finish`, from the folder's table."""
    frame = table.load(folder)
    found = summary.summarize(plan, frame) | _controllers(folder)
    write_summary(found, folder)
    if figures and len(frame):
        from testbed.study_reports.sweep.figures import draw_sweep  # with matplotlib

        attempt("the figures", lambda: draw_sweep(plan, frame, folder))
        attempt("the pages of the worst flights", lambda: _write_worst_pages(found, folder))
        attempt("the report", lambda: write_sweep_report(folder))
    return found


def _controllers(folder: Path) -> dict[str, Any]:
    """The digests of the controllers of one's own with which a folder was begun, if there are any."""
    if not store.exists(folder):
        return {}
    with store.reading(folder) as stored:
        digests = stored.inputs.get("controllers_sha256")
    return {"controllers_sha256": digests} if digests else {}


def _write_worst_pages(found: dict[str, Any], folder: Path) -> None:
    """Write the pages of the worst flights of each variant, those whose logs were kept."""
    for variant in found["variants"]:
        for worst in variant["worst"][:WORST_PAGES]:
            write_page_if_kept(folder, worst["run"], variant["label"])


def answer(summary: Mapping[str, Any]) -> Sequence[str]:
    """As `Kind.answer`: P(all requirements met) and P(each met) for every variant, and the differences."""
    from testbed.study_reports.sweep.answer import answer as sentences

    return [*sentences(summary), *_shares(summary), *_differences(summary)]


def _shares(summary: Mapping[str, Any]) -> Iterator[str]:
    for variant in summary["variants"]:
        total = variant["all_requirements"]
        if flown := total["n"] + total.get("not_judged", 0):
            yield f"{variant['label'] or summary['sweep']}: {count(flown, 'run')}"
            yield f"  {interval(total)}  {passing(variant['requirements'])}"
            yield from (f"  {interval(each)}  {each['name']}" for each in variant["requirements"])


def _differences(summary: Mapping[str, Any]) -> Iterator[str]:
    for pair in summary["pairs"]:
        if pair["difference"] is not None:
            known, chance = interval(pair, "difference", "+.3f"), number(pair["p_value"], ".2g")
            yield f"{pair['first']} minus {pair['second']}: {known}, p = {chance}"


def met(summary: Mapping[str, Any]) -> bool:
    """As `Kind.met`: whether every flight passed."""
    shares = [variant["all_requirements"] for variant in summary["variants"]]
    return all(share["successes"] == share["n"] and not share.get("not_judged") for share in shares)


def rebuild(folder: Path) -> dict[str, Any]:
    """Write table, summary, figures and report of a sweep folder again, without flying; returns the summary.

    For an unfinished sweep they cover the flights that have finished. Raises BadInput when there are none.
    """
    plan = table.load_plan(folder)
    refuse_blocked(folder)
    # After `stop_when` more runs may be stored than the table has, because others were still flying. The table stays. So does
    # that of a folder which an earlier version has flown.
    if not table.is_finished(folder) or (store.exists(folder) and plan.stop_when is None):
        with store.reading(folder) as stored:
            if not len(stored):
                raise BadInput([Problem("no flight has finished in this sweep folder", str(folder))])
            table.write(plan, lambda: table.records(plan, stored), folder)
    return finish(plan, folder)


def fly_run(
    plan: Plan, run: int, folder: Path, how: Options, *, variant: str | None = None, figures: bool = True
) -> tuple[bool, list[Flight]]:
    """Fly one run alone into a new folder: its rows in results.csv, and a run folder for each variant's flight.

    With `variant`, the label of one of those compared, only that is flown, and the new folder itself is its run folder.
    Returns whether every flight passed, and those flights that have a result. Raises BadInput when there is no such run, or when
    the plan is of a folder that was begun with other inputs: the flight would be another one than the folder's.
    """
    job = _job_of_folder(plan, how)
    records = fly_only(plan, run, job, how.jobs, None if variant is None else _numbered(plan, variant))
    # Flown again, because the worker has sent a record and not the whole log; but not what would hang or end this process.
    flights = {one.variant: flight_of(job, one) for one in records if one.outcome not in NO_RESULT}
    unflown = [f"run {run} has no result: {one.reason}" for one in records if one.outcome in NO_RESULT]
    if variant is not None and unflown:
        raise BadInput([Problem(unflown[0], "--only")])
    for words in unflown:
        warnings.warn(words, stacklevel=2)
    if variant is None:
        folder.mkdir(parents=True)
        table.write(plan, lambda: records, folder)
    for which, flight in flights.items():
        name = flight_label(run, plan.variants[which].label)
        add = partial(add_report, flight, figures=figures)
        write_run_folder(flight, folder if variant is not None else folder / name, add)
    return all(record.passed for record in records), list(flights.values())


def _job_of_folder(plan: Plan, how: Options) -> Job:
    """The job that flies a plan as the folder was flown that it is from; as `how` says if it is from none."""
    job, folder = how.job(plan), Path(plan.builder.base.file).parent
    if not store.exists(folder):
        return job
    with store.reading(folder) as stored:
        refuse_changed(stored.inputs, begun_with(plan, job.fly), folder, mixed=how.mixed)
        return replace(job, environment=stored.inputs)


def _numbered(plan: Plan, label: str) -> int:
    """The number of a variant, by its label or by what file names have of it; raises BadInput when there is none."""
    labels = [variant.label for variant in plan.variants]
    for names in ([in_file_names(known) for known in labels], labels):
        if label in names:
            return names.index(label)
    raise BadInput([Problem(f"there is no variant {label!r}", "--variant", None, "", *guess(label, labels))])


def report_run(path: Path) -> list[tuple[Flight, Path]]:
    """Write the pages of a run in a sweep, `SWEEP/17`, from its kept logs; returns each flight with its page.

    The pages are SWEEP/flights/<name of the log>.html. The sweep's report is written again, if there is one, with links to
    them. Raises BadInput when no log was kept.
    """
    made, found = [], logs.logs_of(path)
    refuse_links(found[0].parent.parent)
    for log in found:
        flight = logs.read(log)
        made.append((flight, write_kept_page(flight, log)))
    sweep = made[0][1].parent.parent
    has_report = all((sweep / name).is_file() for name in ("report.html", "summary.json"))
    if has_report and file_of(sweep).stem == "sweep":
        attempt("the report", lambda: write_sweep_report(sweep))
    return made

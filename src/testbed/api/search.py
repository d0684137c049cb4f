"""Searches from Python. `search` does everything; the other functions are its steps, which the command line uses too."""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from testbed.api.options import changes, checked_options, own_options
from testbed.common.files import slug
from testbed.common.writing import write
from testbed.controllers.user.own import own_controllers
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.received import read_json, refuse_links
from testbed.reporting.attempt import add_report, attempt
from testbed.studies import summary as sweep_summary
from testbed.studies.checks import check
from testbed.studies.flying.flight import Fly, Job, flight_of
from testbed.studies.folder.names import in_file_names
from testbed.studies.model import GOALS, Goal
from testbed.studies.search.load import load_search
from testbed.studies.search.plan import SearchPlan
from testbed.studies.search.run import Found, run_search
from testbed.studies.search.summary import nearest, summarize
from testbed.study_reports.search.report import write_search_page
from testbed.study_reports.search.words import answer, settings_of

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True)
class SearchResult:
    """What a search found. `summary` has the contents of summary.json, which docs/reference/search.md explains."""

    folder: Path
    summary: dict[str, Any]

    @property
    def found(self) -> bool:
        """Whether a failure was found, with the first of the compared variants."""
        return bool(self.summary["found"])

    @property
    def distance(self) -> float | None:
        """Distance of the nearest failure from the origin, in standard deviations; None if none was found."""
        distance: float | None = self.summary["distance"]
        return distance

    @property
    def probability(self) -> dict[str, Any] | None:
        """{estimate, low, high, coefficient_of_variation, ...} of a search for a probability."""
        probability: dict[str, Any] | None = self.summary["probability"]
        return probability

    @property
    def table(self) -> pd.DataFrame:
        """Every flight that was made, in the order in which the search asked for it."""
        import pandas as pd

        return pd.read_parquet(self.folder / "results.parquet")

    def __repr__(self) -> str:
        return "\n".join(answer(self.summary))


def search(
    search: str | Path,
    out: str | Path | None = None,
    *,
    goal: Goal | None = None,
    budget: int | None = None,
    seed: int | None = None,
    settings: Sequence[str] = (),
    set: Mapping[str, Any] | None = None,
    jobs: int | None = None,
    cluster: str | None = None,
    resume: bool = False,
    fly: Fly | None = None,
    figures: bool = True,
    controllers: Sequence[str] = (),
) -> SearchResult:
    """Search for the smallest failure, or for the probability of one, and write the search folder.

    Args:
        search: the search's YAML file, or with `goal` a sweep's; a shipped one is found from any folder.
        out: the folder to make, `runs/<name>` by default.
        goal: `smallest` or `probability`, in place of the file's.
        budget: most flights of each part, in place of the file's.
        seed: seed of everything random, in place of the file's.
        settings: changes as with `--set`, each KEY=VALUE.
        set: the same as a mapping from dotted paths, as `fly` takes it: {"sensors": "mems", "budget": 50}.
        jobs: number of processes; one for each core by default.
        cluster: address of a Dask cluster to fly on instead.
        resume: go on with an existing folder, with the flights that it has.
        fly: `fly(scenario) -> Flight`, a function at the top of a module, in place of the simulator.
        figures: whether to draw figures and write the report.
        controllers: classes of your own to compare with the file's controllers, each NAME=FILE.py:CLASS.

    Raises BadInput when nothing can be searched, Stopped when the search ended early; the finished flights are then kept.
    """
    how = checked_options(jobs, cluster, fly=fly)
    settings = changes(settings, set)
    plan, folder = prepare(
        search, out, settings, goal=goal, budget=budget, seed=seed, controllers=controllers
    )
    found = run_search(plan, folder, how, resume=resume)
    return SearchResult(folder, finish(plan, folder, found, how.job(plan.plan), figures=figures))


def prepare(
    file: str | Path,
    out: str | Path | None = None,
    settings: Sequence[str] = (),
    *,
    goal: Goal | None = None,
    budget: int | None = None,
    seed: int | None = None,
    controllers: Sequence[str] = (),
) -> tuple[SearchPlan, Path]:
    """Read and check a search; returns the plan and the search folder. Raises BadInput with every problem found."""
    if goal is not None and goal not in GOALS:
        raise BadInput([Problem(f"is {goal!r}", "--goal", expected=" or ".join(GOALS))])
    given = own_options(budget=budget, seed=seed)
    plan = load_search(file, [*settings, *given], own_controllers(controllers), goal)
    check(plan.plan)
    return plan, Path(out) if out is not None else Path("runs") / slug(plan.name, otherwise="search")


def finish(
    plan: SearchPlan, folder: Path, found: Sequence[Found], job: Job, *, figures: bool = True
) -> dict[str, Any]:
    """Write summary.json, the scenarios and flights that were found, and the report; returns the summary.

    Figures or a report that cannot be made are a warning, `reporting.attempt.NotShown`.
    """
    said = summarize(plan, found)
    for each, part in zip(found, said["parts"], strict=True):
        if each.answer.design_point is not None:
            part["folder"], part["words"] = _write_found(plan, folder, each, job, figures)
    first = nearest([part for part in said["parts"] if part["variant"] == 0])
    if first is not None:
        write(folder / "found.yaml", (folder / first["folder"] / "scenario.yaml").read_bytes())
    sweep_summary.write(said, folder)
    if figures:
        write_report(folder)
    return said


def _write_found(
    plan: SearchPlan, folder: Path, found: Found, job: Job, figures: bool
) -> tuple[str, list[str]]:
    """Fly the flights at the origin and at the design point again, into run folders.

    Returns the name of the second one's folder, and what was broken in it, in words.
    """
    label = in_file_names(plan.label(found.part))
    origin = np.zeros(len(found.part.space))
    for kind, point in (("origin", origin), ("found", found.answer.design_point)):
        target = folder / (f"{kind}-{label}" if label else kind)
        # Flown again, because a worker has sent a record and not the whole log.
        flight = flight_of(job, plan.tasks(found.part, np.array([point]), 0)[0])
        shutil.rmtree(target, ignore_errors=True)  # of a search that has gone on
        add = partial(add_report, flight, figures=figures)
        write_run_folder(flight, target, add if figures and flight.actuators else lambda _: None)
    return target.name, settings_of(flight, [each.path for each in found.part.space.coordinates])


def write_report(folder: Path) -> None:
    """Draw the figures and write the page of a search folder, from its files."""
    attempt("the report", lambda: write_search_page(folder))


def rebuild(folder: Path) -> dict[str, Any]:
    """Write figures and report of a finished search again; returns the summary. Raises BadInput when that is damaged."""
    refuse_links(folder)
    summary: dict[str, Any] = read_json(
        folder / "summary.json", "`testbed search --resume`, which writes it anew without flying"
    )
    write_report(folder)
    return summary

"""Searches: `search` does everything from Python; the other functions are those of a kind of study."""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from testbed.api.load import refuse_unfinished
from testbed.api.study import changes, folder_of, write_summary
from testbed.common.text import printable
from testbed.common.writing import write
from testbed.controllers.user.own import own_controllers
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.received import believed, read_frame, read_json, refuse_links
from testbed.reporting.attempt import add_report, attempt
from testbed.reporting.words import count
from testbed.studies.checks import check
from testbed.studies.flying.flight import Fly, Job, flight_of
from testbed.studies.folder.begin import refuse_blocked
from testbed.studies.folder.logs import in_file_names
from testbed.studies.model import GOALS, Goal
from testbed.studies.run import Flights, Options
from testbed.studies.search.plan import SearchPlan, load_search
from testbed.studies.search.run import Found, nearest, run_search, summarize
from testbed.study_reports.search.report import write_search_page
from testbed.study_reports.search.words import answer as sentences
from testbed.study_reports.search.words import settings_of

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
        return self.summary["distance"]

    @property
    def probability(self) -> dict[str, Any] | None:
        """{estimate, low, high, coefficient_of_variation, ...} of a search for a probability."""
        return self.summary["probability"]

    @property
    def table(self) -> pd.DataFrame:
        """Every flight that was made, in the order in which the search asked for it."""
        return read_frame(self.folder / "results.parquet", ("run", "outcome"), "the table of a search")

    def __repr__(self) -> str:
        return printable("\n".join(sentences(self.summary)))


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
    mixed: bool = False,
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
        resume: go on with an existing folder, with the flights that it has.

    `seed`, `settings`, `set`, `jobs`, `cluster`, `mixed`, `fly`, `figures` and `controllers` are as of `sweep`.
    Raises BadInput when nothing can be searched, Stopped when the search ended early; the finished flights are then kept.
    """
    how = Options(jobs, cluster, "none", fly, mixed=mixed)
    changed = changes(settings, set)
    plan, folder = prepare(search, out, changed, goal=goal, budget=budget, seed=seed, controllers=controllers)
    flights = run_search(plan, folder, how, resume=resume)
    return SearchResult(folder, finish(plan, folder, flights, figures=figures))


def prepare(
    file: str | Path,
    out: str | Path | None = None,
    settings: Sequence[str] = (),
    *,
    goal: Goal | None = None,
    budget: int | None = None,
    seed: int | None = None,
    resume: bool = False,
    controllers: Sequence[str] = (),
) -> tuple[SearchPlan, Path]:
    """Read and check a search; returns the plan and the search folder. Raises BadInput with every problem found."""
    if goal is not None and goal not in GOALS:
        raise BadInput([Problem(f"is {goal!r}", "--goal", expected=" or ".join(GOALS))])
    changed = changes(settings, budget=budget, seed=seed)
    plan = load_search(file, changed, own_controllers(controllers), goal)
    check(plan)
    return plan, folder_of(plan, out)


fly = run_search


def plan_of(folder: Path) -> SearchPlan:
    """The plan of a search's folder, as its file has it, and of the user's controllers without their code."""
    return load_search(folder / "search.yaml")


def finish(plan: SearchPlan, folder: Path, flights: Flights, *, figures: bool = True) -> dict[str, Any]:
    """As `Kind.finish`; also writes the scenarios and the flights that were found."""
    said = summarize(plan, flights.found)
    for each, part in zip(flights.found, said["parts"], strict=True):
        if each.answer.design_point is not None:
            part["folder"], part["words"] = _write_found(plan, folder, each, flights.job, figures)
    first = nearest([part for part in said["parts"] if part["variant"] == 0])
    if first is not None:
        write(folder / "found.yaml", (folder / first["folder"] / "scenario.yaml").read_bytes())
    write_summary(said, folder)
    if figures:
        attempt("the report", lambda: write_search_page(folder))
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


def rebuild(folder: Path) -> dict[str, Any]:
    """As `Kind.rebuild`: figures and report alone. Raises BadInput when the search has not finished, or is damaged."""
    refuse_blocked(folder)
    refuse_unfinished(folder)
    refuse_links(folder)
    file, expected = folder / "summary.json", "`testbed search --resume`, which writes it anew without flying"
    summary: dict[str, Any] = read_json(file, expected)
    with believed(file, expected):
        answer(summary)
        met(summary)
    attempt("the report", lambda: write_search_page(folder))
    return summary


def answer(summary: Mapping[str, Any]) -> Sequence[str]:
    """As `Kind.answer`."""
    return [*sentences(summary), count(summary["flights"], "flight")]


def met(summary: Mapping[str, Any]) -> bool:
    """As `Kind.met`: whether no smallest failure was found; what a probability is, is no verdict."""
    return summary["goal"] != "smallest" or not any(part["found"] for part in summary["parts"])

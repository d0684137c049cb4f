"""Run a search into its folder: the flight at the origin of every part, then each part's search, then the table."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from testbed.inputs.problems import BadInput, Problem
from testbed.reliability import (
    FailureProbability,
    SmallestFailure,
    Step,
    failure_probability,
    smallest_failure,
)
from testbed.searches.flying import Flying, workers
from testbed.searches.folder import Store, write_table
from testbed.searches.limit_state import LimitState, failed, robustness
from testbed.searches.plan import Part, SearchPlan
from testbed.searches.progress import Progress
from testbed.sweeps.run import Options, Stopped
from testbed.sweeps.workers import cluster

Answer = SmallestFailure | FailureProbability


@dataclass(frozen=True)
class Found:
    """What the search of one part found.

    Attributes:
        flights: number of flights made for it.
        without_result: how many of them gave no result.
        record: that of the flight at the design point (see `sweeps.workers.flying`); None if nothing failed.
    """

    part: Part
    answer: Answer
    flights: int
    without_result: int
    record: dict[str, Any] | None


def run_search(plan: SearchPlan, folder: Path, options: Options, *, resume: bool = False) -> list[Found]:
    """Search every part, and write the table of flights; returns what was found, in the order of the parts.

    Raises BadInput when it cannot begin, or when every flight at the origin fails already; Stopped when it ended early.
    """
    job = options.job(plan.plan)
    if options.cluster is not None:
        cluster.refuse_dead(options.cluster)  # before the folder is made
    store = _store(folder, plan, job.fly, resume)
    try:
        with workers(job, options) as flying:
            return search_in(plan, store, flying)
    except KeyboardInterrupt:
        raise Stopped(_kept(store, "interrupted")) from None
    except OSError as error:
        raise Stopped(_kept(store, f"cannot write: {error.strerror or error}")) from None
    except Refused:
        store.remove()
        raise
    except BadInput as error:
        raise Stopped(_kept(store, str(error))) from None
    finally:
        with suppress(OSError):  # a full disk has been reported above
            store.close()


def search_in(plan: SearchPlan, store: Store, flying: Flying) -> list[Found]:
    """As `run_search`, in an open folder, and with anything that flies batches. Raises Refused for what needs no search."""
    with Progress(plan) as progress:
        states = [LimitState(plan, part, store, flying, progress) for part in plan.parts]
        _refuse_broken(plan, states)
        found = [_found(plan, state) for state in states]
    write_table(plan, store, [(state.part, state.points) for state in states])
    return found


class Refused(BadInput):
    """The flights at the origin fail already, or have no result: there is nothing to search."""


def _store(folder: Path, plan: SearchPlan, fly: str, resume: bool) -> Store:
    try:
        return Store(folder, plan, fly, resume=resume)
    except OSError as error:
        raise BadInput([Problem(f"cannot be written: {error.strerror or error}", str(folder))]) from None


def _kept(store: Store, why: str) -> str:
    return f"{store.folder}: {why}; {len(store)} flights are kept, --resume goes on"


def _refuse_broken(plan: SearchPlan, states: Sequence[LimitState]) -> None:
    """Raise Refused when a flight at the origin has no result, or when each of them breaks a requirement already."""
    broken, problems = 0, []
    for state in states:
        origin = np.zeros((1, len(state.part.space)))
        value = float(state(origin)[0])
        record = state.record(tuple(origin[0]))
        label = plan.label(state.part)
        whose = f"the flight at the origin of the search{f' ({label})' if label else ''}"
        if np.isnan(value):
            problems.append(Problem(f"{whose} has no result: {record['reason']}", plan.name))
        broken += value <= 0.0
    if broken == len(states):
        what = f"{whose} breaks {' and '.join(broken_names(plan, record))} already"
        expected = "a scenario that meets its requirements where distance is 0 (`testbed sweep` counts how often it does)"
        problems.append(Problem(what, plan.name, expected=expected))
    if problems:
        raise Refused(problems)


def broken_names(plan: SearchPlan, record: dict[str, Any]) -> list[str]:
    """What a flight did not meet, by the requirements' names; that the aircraft was lost, if each was met until then."""
    part = plan.parts[record["part"]]
    scenario = plan.plan.builder.scenario(plan.tasks(part, np.array([record["u"]]), 0)[0])
    verdicts = zip(scenario.requirements, record.get("requirements", ()), strict=False)
    names = [repr(requirement.title) for requirement, verdict in verdicts if not verdict[0]]
    return names or [f"no requirement, but the flight ended early ({record['outcome']})"]


def _found(plan: SearchPlan, state: LimitState) -> Found:
    answer = _answer(plan, state)
    point = answer.design_point
    record = None if point is None else state.record(tuple(map(float, point)))
    records = [state.record(each) for each in state.points]
    unknown = sum(bool(np.isnan(robustness(each))) for each in records)
    return Found(state.part, answer, len(records), unknown, record)


def _answer(plan: SearchPlan, state: LimitState) -> Answer:
    search, dimensions = plan.search, len(state.part.space)
    shared = {"seed": plan.seed(state.part), "budget": search.budget}
    if search.goal == "probability":
        return failure_probability(state, dimensions, cov=search.cov, method=search.method, **shared)
    origin = np.zeros(dimensions)
    if failed(state.record(tuple(origin))):
        return _at_origin(origin)
    return smallest_failure(
        state, dimensions, starts=search.starts, mirrored=state.part.space.mirrored, **shared
    )


def _at_origin(origin: np.ndarray) -> SmallestFailure:
    """What is found where the flight at the origin fails already: nothing has to break for it."""
    return SmallestFailure(True, origin, 0.0, 0.0, 1, (Step(1, 0.0, origin),), 0, 1.0,
                           "The flight at the origin fails already.")  # fmt: skip

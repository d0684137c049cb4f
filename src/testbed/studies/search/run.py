"""Run a search into its folder: the flight at the origin of every part, then each part's search, then the table.

A flight is a limit state: its robustness is a function of the coordinates of what varies, and at or below 0 it fails.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from testbed.inputs.problems import BadInput, Problem
from testbed.reliability import (
    FailureProbability,
    SmallestFailure,
    Step,
    failure_probability,
    smallest_failure,
)
from testbed.studies.drawing.builder import Task
from testbed.studies.folder import table
from testbed.studies.folder.store import Store
from testbed.studies.record import Flown, Record
from testbed.studies.run import Flights, Options, Refused, fly_into
from testbed.studies.search.plan import Part, Point, SearchPlan, key_of

Answer = SmallestFailure | FailureProbability
_LEAST = 1e-12
"""What a requirement that is met exactly at its limit counts as."""


class LimitState:
    """The limit state of one part of a search. It flies what the store does not have, and keeps the order of points.

    Attributes:
        points: every point that was asked for, with its number, in the order of its first time.
    """

    def __init__(self, plan: SearchPlan, part: Part, flights: Flights) -> None:
        self.part = part
        self.points: dict[Point, int] = {}
        self._plan, self._flights = plan, flights
        self._nearest = math.inf

    def __call__(self, u: np.ndarray) -> np.ndarray:
        """[n] robustness of the flights at points [n, dimensions]; NaN for a flight without a result."""
        rows = [tuple(map(float, row)) for row in np.atleast_2d(u)]
        new = [row for row in dict.fromkeys(rows) if row not in self.points]
        if new:
            self._fly(new)
        return np.array([robustness(self.record(row)) for row in rows])

    def record(self, point: Point) -> Record:
        """The record of the flight at a point that was asked for, whose number is its run."""
        record = self._flights.store.record(key_of(self.part, point))
        if record.variant != self.part.variant:
            what = f"has variant {record.variant} in place of {self.part.variant}"
            raise BadInput([Problem(what, str(self._flights.store.folder))])
        return replace(record, run=self.points[point])

    def _fly(self, points: list[Point]) -> None:
        tasks = self._plan.tasks(self.part, np.array(points), len(self.points))
        for task, point in zip(tasks, points, strict=True):
            self.points[point] = task.run
        at = {task.run: point for task, point in zip(tasks, points, strict=True)}
        self._flights.words = self._words
        for record in self._flights.fly(tasks, lambda task: key_of(self.part, at[task.run])):
            if failed(record):
                self._nearest = min(self._nearest, math.hypot(*at[record.run]))

    def _words(self) -> str:
        """`ACTUATOR: nearest failure at distance 2.31`, of the flights that have been flown."""
        label, distance = self._plan.label(self.part), self._nearest
        found = "no failure yet" if distance == math.inf else f"nearest failure at distance {distance:.2f}"
        return f"{label}: {found}" if label else found


def robustness(record: Record) -> float:
    """The robustness in a flight's record, with the sign of its verdict: above 0 exactly if it passed; NaN without a result, or
    where nothing was judged."""
    if record.passed is None:
        return math.nan
    return max(record.robustness, _LEAST) if record.passed else min(record.robustness, 0.0)


def failed(record: Record) -> bool:
    """Whether a flight has a result, and a requirement was not met."""
    return robustness(record) <= 0.0


@dataclass(frozen=True)
class Found:
    """What the search of one part found.

    Attributes:
        flights: number of flights made for it.
        without_result: how many of them gave no result.
        record: that of the flight at the design point; None if nothing failed.
    """

    part: Part
    answer: Answer
    flights: int
    without_result: int
    record: Record | None


def run_search(plan: SearchPlan, folder: Path, options: Options, *, resume: bool = False) -> Flights:
    """Search every part, and write the table of flights; `found` is what was found, in the order of the parts.

    With `options.shard` it searches every n-th part and writes no table: the folder is that of an unfinished search, which
    `testbed.merge` joins with the others. Raises BadInput and Stopped as `studies.run.fly_into`, and Refused when every flight
    at the origin fails already.
    """
    k, n = options.part
    if n > len(plan.parts):
        what = f"is {options.shard}, and a search of one variant and option is not divided"
        raise BadInput([Problem(what, "--shard", expected=f"at most {len(plan.parts)} shards")])

    def search(flights: Flights) -> list[Found]:
        states = [LimitState(plan, part, flights) for part in plan.parts]
        _refuse_broken(plan, states)  # by the origins of all parts: every shard flies them
        found = [_found(plan, state) for state in states[k::n]]
        if options.shard is None:
            table.write(plan, lambda: _rows(states), flights.store.folder)
        return found

    return fly_into(plan, folder, options, search, resume=resume)


def unsearched(plan: SearchPlan, store: Store) -> list[str]:
    """The labels of the parts whose search needs flights that the store does not have."""
    flights = Flights(plan, Options().job(plan), store, _fly_none)
    missing = []
    for part in plan.parts:
        state = LimitState(plan, part, flights)
        try:
            state(np.zeros((1, len(part.space))))
            _answer(plan, state)
        except _Unflown:
            missing.append(plan.label(part))
    return missing


class _Unflown(Exception):
    """A flight is asked for that the store does not have."""


def _fly_none(tasks: Iterable[Task]) -> Iterator[Flown]:
    for _ in tasks:
        raise _Unflown
    yield from ()


def _rows(states: Sequence[LimitState]) -> Iterator[Record]:
    """The records as the table has them: each part's in the order asked for, with distance and coordinates."""
    for state in states:
        for point in state.points:
            record = state.record(point)
            named = {f"u.{each.path}": u for each, u in zip(state.part.space.coordinates, point, strict=True)}
            distance = sum(u * u for u in point) ** 0.5
            yield replace(record, metrics={"distance": distance, **named, **record.metrics})


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
            why = record.reason or "its controller says nothing of what is required"
            problems.append(Problem(f"{whose} has no result: {why}", plan.name))
        broken += value <= 0.0
    if broken == len(states):
        what = f"{whose} breaks {' and '.join(broken_names(plan, record))} already"
        expected = "a scenario that meets its requirements where distance is 0 (`testbed sweep` counts how often it does)"
        problems.append(Problem(what, plan.name, expected=expected))
    if problems:
        raise Refused(problems)


def broken_names(plan: SearchPlan, record: Record) -> list[str]:
    """What a flight did not meet, by the requirements' names; that the aircraft was lost, if each was met until then."""
    verdicts = zip(plan.builder.scenario(record).requirements, record.requirements, strict=False)
    names = [repr(requirement.title) for requirement, (passed, *_) in verdicts if passed is False]
    return names or [f"no requirement, but the flight ended early ({record.outcome})"]


def _found(plan: SearchPlan, state: LimitState) -> Found:
    answer = _answer(plan, state)
    point = answer.design_point
    record = None if point is None else state.record(tuple(map(float, point)))
    unknown = sum(bool(np.isnan(robustness(state.record(each)))) for each in state.points)
    return Found(state.part, answer, len(state.points), unknown, record)


def _answer(plan: SearchPlan, state: LimitState) -> Answer:
    search, dimensions = plan.study, len(state.part.space)
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

"""Run a search into its folder: the flight at the origin of every part, then each part's search, then the table; its summary.

A flight is a limit state: its robustness is a function of the coordinates of what varies, and at or below 0 it fails. What
summary.json says does not depend on the clock or the machine, nor on how often the search was interrupted.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from testbed.common.files import plain
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
    if failed(state.record(tuple(origin))):  # nothing has to break for it
        why = "The flight at the origin fails already."
        return SmallestFailure(True, origin, 0.0, 0.0, 1, (Step(1, 0.0, origin),), 0, 1.0, why)
    return smallest_failure(
        state, dimensions, starts=search.starts, mirrored=state.part.space.mirrored, **shared
    )


Summary = dict[str, Any]


def summarize(plan: SearchPlan, found: Sequence[Found]) -> Summary:
    """Contents of summary.json; a number that is not finite is None.

    `found`, `distance` and `probability` are those of the first variant: its nearest failure, and its probability.
    """
    parts = [_part(plan, each) for each in found]
    variants = [_variant(plan, number, found) for number in range(len(plan.variants))]
    first = nearest([part for part in parts if part["variant"] == 0])
    return plain(
        {
            "search": plan.name,
            "goal": plan.study.goal,
            "requirement": plan.study.requirement,
            "seed": plan.study.seed,
            "budget": plan.study.budget,
            "cov": plan.study.cov,
            "method": plan.study.method,
            "varied": [each.path for each in plan.parts[0].space.coordinates],
            "found": first is not None,
            "distance": None if first is None else first["distance"],
            "probability": variants[0]["probability"],
            "flights": sum(each.flights for each in found),
            "variants": variants,
            "parts": parts,
        }
    )


def nearest(parts: Sequence[Summary]) -> Summary | None:
    """The part that found the nearest failure; None if none did."""
    return min((part for part in parts if part["found"]), key=lambda part: part["distance"], default=None)


def _part(plan: SearchPlan, found: Found) -> Summary:
    part, answer, record = found.part, found.answer, found.record
    said: Summary = {
        "label": plan.label(part),
        "variant": part.variant,
        "options": dict(part.options),
        "weight": part.weight,
        "flights": found.flights,
        "without_result": found.without_result,
        "found": record is not None,
        "distance": answer.distance,
        "reason": answer.reason,
    }
    if record is not None and answer.design_point is not None:
        said |= {
            "run": record.run,
            "seed": record.seed,
            "outcome": record.outcome,
            "robustness": record.robustness,
            "broken": broken_names(plan, record),
            "beyond": part.space.beyond(answer.design_point),
            "point": _point(part, answer.design_point),
        }
        own = plan.builder.own_controller(Task(0, part.variant, 0, {}))
        said |= {} if own is None else {"own_controller": own.reference}
    if isinstance(answer, SmallestFailure):
        said |= {
            "path": [_step(part, step) for step in answer.path],
            "independent": answer.independent,
            "upper_bound": answer.upper_bound,
        }
    else:
        said |= {
            "probability": _probability([(answer, 1.0)]),
            "levels": [vars(level) for level in answer.levels],
        }
    return said


def _step(part: Part, step: Step) -> Summary:
    coordinates = _coordinates(part, step.point)
    return {"flights": step.evaluations, "distance": step.distance, "coordinates": coordinates}


def _coordinates(part: Part, u: np.ndarray) -> dict[str, float]:
    return {each.path: each.distance(float(x)) for each, x in zip(part.space.coordinates, u, strict=True)}


def _point(part: Part, u: np.ndarray) -> dict[str, Summary]:
    """The design point: value, coordinate, share of the squared distance, and how likely a value at least this far is."""
    coordinates = _coordinates(part, u)
    total, values = float(u @ u), part.space.values(np.array([u]))[0]
    return {
        each.path: {
            "value": values[each.path],
            "nominal": each.nominal,
            "origin": each.origin,
            "coordinate": coordinates[each.path],
            "share": coordinates[each.path] ** 2 / total if total else 0.0,
            "beyond": each.beyond(coordinates[each.path]),
        }
        for each in part.space.coordinates
    }


def _variant(plan: SearchPlan, number: int, found: Sequence[Found]) -> Summary:
    """A variant: the nearest failure of its parts, and by the law of total probability how likely one is."""
    own = [each for each in found if each.part.variant == number]
    distance = min((each.answer.distance for each in own if each.record is not None), default=math.inf)
    answers = [(each.answer, each.part.weight) for each in own if isinstance(each.answer, FailureProbability)]
    return {
        "label": plan.variants[number].label,
        "found": math.isfinite(distance),
        "distance": distance,
        "flights": sum(each.flights for each in own),
        "probability": _probability(answers) if answers else None,
    }


def _probability(answers: Sequence[tuple[FailureProbability, float]]) -> Summary:
    """Estimate, interval and coefficient of variation of sum(weight * P); the ends of the interval are the sums of the ends.

    `plain_flights` are those that plain sampling needs for the same coefficient of variation, (1 - P) / (P cov^2).
    """
    estimate = sum(weight * answer.probability for answer, weight in answers)
    variance = sum(
        (weight * answer.probability * answer.cov) ** 2 for answer, weight in answers if answer.probability
    )
    cov = math.sqrt(variance) / estimate if estimate else math.inf
    return {
        "estimate": estimate,
        "low": sum(weight * answer.interval[0] for answer, weight in answers),
        "high": sum(weight * answer.interval[1] for answer, weight in answers),
        "coefficient_of_variation": cov,
        "converged": all(answer.converged for answer, _ in answers),
        "flights": sum(answer.evaluations for answer, _ in answers),
        "plain_flights": (1.0 - estimate) / (estimate * cov**2)
        if estimate and 0.0 < cov < math.inf
        else math.inf,
    }

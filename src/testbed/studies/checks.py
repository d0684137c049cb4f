"""Checks before a sweep is flown: the ends of every range and the first draws must make valid scenarios."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import islice
from typing import Any

from testbed.aircraft.changes import load_with_changes
from testbed.controllers.config import ESTIMATES, FLAGS, says
from testbed.controllers.user.loader import undeclared
from testbed.controllers.user.own import not_given, unused_parameters
from testbed.flight.requirements import about
from testbed.inputs.problems import BadInput, Problem
from testbed.metrics import metrics_of
from testbed.scenario.model import Scenario
from testbed.simulation.check import name_problems
from testbed.studies.drawing.builder import Task
from testbed.studies.plan import Plan

_DRAWS = 16
"""Number of runs whose scenarios are checked before the sweep; the others are checked when they are flown."""
_COMPANIONS = 3
"""The end of a range is refused if it is invalid with each of this many draws of the other values."""
_MOST_CHECKED = 2000
"""Most scenarios that are checked for each of the two, ends and draws: some seconds of computing."""
_SAID = {ESTIMATES: (f"_{ESTIMATES}",), FLAGS: (f"_{FLAGS}", "_belief", "_believed_position")}
"""The ends of the log's columns that a controller fills which says that."""
_WORDS = ("type", "actuator", "aircraft")
_MOST = 20
"""Number of problems after which no further ends or draws are checked."""


def check(plan: Plan) -> None:
    """Raise BadInput with everything that is wrong with the scenarios of a study."""
    found = [not_given(name) for name, own in plan.builder.own.items() if not own.code]
    found = found or list(_drawn_words(plan))
    # The ends come before the draws, because their messages show the value that the user wrote.
    found = found or list(dict.fromkeys(islice(_ends(plan), _MOST)))
    found = found or _once(islice(_draws(plan), _MOST))
    if found:
        raise BadInput(found)


def _drawn_words(plan: Plan) -> Iterator[Problem]:
    """Words, such as the type of a controller, for which numbers are drawn."""
    for path, distribution in plan.study.vary.items():
        if path.rpartition(".")[2] in _WORDS and distribution.name != "choice":
            what, expected = f"is a word, and {distribution.name} draws numbers", "{choice: [...]}"
            yield Problem(what, path=f"vary.{path}", expected=expected)


def _once(problems: Iterable[Problem]) -> list[Problem]:
    """Of the problems that differ in the drawn value alone, the first."""
    found: dict[tuple[object, ...], Problem] = {}
    for problem in problems:
        found.setdefault((problem.file, problem.line, problem.path, problem.expected), problem)
    return list(found.values())


def _ends(plan: Plan) -> Iterator[Problem]:
    """Problems of the lowest and highest value of every bounded range, and of every option of every choice."""
    ends = (
        (path, value, variant)
        for path, distribution in plan.study.vary.items()
        for value in distribution.bounds
        for variant in range(len(plan.variants))
    )
    for end in islice(ends, _MOST_CHECKED):
        yield from _always(plan, *end)


def _always(plan: Plan, path: str, value: Any, variant: int) -> list[Problem]:
    """Problems of a value that occur with each of the first _COMPANIONS draws of the others; none if one draw is valid."""
    found: list[Problem] = []
    for run in range(min(plan.runs, _COMPANIONS)):
        task = plan.task(run * len(plan.variants) + variant)
        found = _problems(plan, replace(task, values={**task.values, path: value}))
        if not found:
            return []
    return found


def _draws(plan: Plan) -> Iterator[Problem]:
    """Problems of the first runs; with a table of cases, of all runs up to _MOST_CHECKED scenarios."""
    variants = min(len(plan.variants), _MOST_CHECKED)
    most = max(_MOST_CHECKED // variants, 1)
    for run in range(min(plan.runs, most if plan.cases is not None else min(most, _DRAWS))):
        which = f" (run {run})" if plan.cases is not None else ""
        for variant in range(variants):
            problems = _problems(plan, plan.task(run * len(plan.variants) + variant))
            yield from (replace(problem, what=f"{problem.what}{which}") for problem in problems)


def _problems(plan: Plan, task: Task) -> list[Problem]:
    """Everything wrong with one flight's scenario."""
    try:
        scenario = plan.builder.scenario(task)
        aircraft = load_with_changes(scenario.aircraft)
        own = plan.builder.own_controller(task)
        if own is not None:
            unknown = undeclared(own.load(), scenario.controller.parameters)
        else:
            unknown = unused_parameters(scenario.controller)
        return unknown or name_problems(scenario, aircraft) or _unjudged(plan, scenario, own is not None)
    except BadInput as error:
        return list(error.problems)


def _unjudged(plan: Plan, scenario: Scenario, flown_by_own: bool) -> list[Problem]:
    """The problem of a search for what breaks a requirement, where the controller says nothing of any of them."""
    if flown_by_own or plan.study.word != "search":
        return []
    unsaid = tuple(end for what in _SAID.keys() - says(scenario.controller) for end in _SAID[what])
    metrics = metrics_of(unsaid)
    for requirement in scenario.requirements:
        if not any(name in metrics or name.endswith(unsaid) for name in about(requirement)):
            return []
    what = f"cannot be judged: {scenario.controller.type} says nothing of what they limit"
    return [Problem(what, path="requirements", expected="a requirement on what the aircraft does")]

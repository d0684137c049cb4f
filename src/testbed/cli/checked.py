"""Read and check all input before anything flies: this is `testbed validate`, and the first step of `testbed run`."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from typing import TYPE_CHECKING, TypeVar

from testbed.inputs.problems import BadInput, Problem

if TYPE_CHECKING:
    from testbed.scenario.load import Scenario

Result = TypeVar("Result")


def validate(files: Iterable[str]) -> None:
    """Check scenario, sweep and search files, and print the valid ones; raises BadInput with all problems of the others."""
    problems: list[Problem] = []
    for file in files:
        if collect(problems, partial(_valid, file)) is not None:
            print(f"{file}: ok")
    if problems:
        raise BadInput(problems)


def collect(problems: list[Problem], function: Callable[[], Result]) -> Result | None:
    """Result of a function. If it raises BadInput, its problems are added to `problems`, and the result is None."""
    try:
        return function()
    except BadInput as error:
        problems += error.problems
        return None


def checked(file: str, settings: Sequence[str] = ()) -> Scenario:
    """The scenario in a file, also checked against the log's columns, the metrics, the JSBSim model and its trimmed start.

    Conditions that its controller is not made for are printed on stderr.
    """
    from testbed.aircraft.changes import chosen
    from testbed.flight.columns import all_columns
    from testbed.metrics import TABLE as METRICS
    from testbed.plant.rehearsal import rehearse
    from testbed.scenario import conditions
    from testbed.scenario.checks import unknown_names
    from testbed.scenario.load import load_scenario

    scenario = load_scenario(file, settings)
    aircraft = chosen(scenario.aircraft)
    found: list[Problem] = []
    at, initial = scenario.initial, ("initial",)
    properties = collect(
        found,
        lambda: rehearse(
            aircraft, scenario.physics_hz, at.airspeed_m_s, at.altitude_m, math.radians(at.heading_deg)
        ),
    )
    checkable = scenario if properties is not None else scenario.model_copy(update={"failures": ()})
    names = unknown_names(checkable, aircraft, all_columns(aircraft, scenario), METRICS, properties or {})
    # A problem without a file is that there is no trimmed flight to begin with.
    problems = [*names, *(p if p.file else scenario.source.problem(initial, p.what) for p in found)]
    if problems:
        raise BadInput(problems)
    for warning in conditions.warnings(scenario):
        print(f"WARNING: {warning}", file=sys.stderr)
    return scenario


def _valid(file: str) -> object:
    """The scenario, the sweep or the search in a file, checked."""
    from testbed.aircraft.shipped import find_scenario
    from testbed.inputs import yaml_source
    from testbed.inputs.kinds import is_search, is_sweep

    tree = yaml_source.read(find_scenario(file)).tree
    if is_search(tree):
        from testbed.api import search

        return search.prepare(file)
    if not is_sweep(tree):
        return checked(file)
    from testbed.api import sweep

    return sweep.prepare(file)

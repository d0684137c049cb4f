"""Read and check a scenario before anything flies: the first step of `testbed run`, and of `testbed validate`."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeVar

from testbed.inputs.problems import BadInput, Problem

if TYPE_CHECKING:
    from testbed.scenario.load import Scenario

Result = TypeVar("Result")


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

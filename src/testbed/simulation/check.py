"""The complete check of a scenario before it is flown. `run`, `validate`, `fly` and `Session` all make this one.

The scenario is valid by itself already (see `scenario.load`). Here it meets the log's columns, the metrics, the aircraft's JSBSim
model and the trimmed flight in which it begins. Importing this module imports no simulator.
"""

from __future__ import annotations

import math

from testbed.aircraft.changes import load_with_changes
from testbed.aircraft.description import Aircraft
from testbed.common.cache import Cache
from testbed.flight.columns import all_columns, columns
from testbed.inputs.problems import BadInput, Problem
from testbed.metrics import TABLE as METRICS
from testbed.plant.first_load import property_catalog
from testbed.plant.start_check import check_start
from testbed.scenario.checks import unknown_names
from testbed.scenario.model import Scenario

_sound: Cache[Scenario] = Cache(1)
"""The scenario that was found sound last. It is kept, so that no other can have its `id`."""


def check(scenario: Scenario, *, remembered: bool = True) -> Aircraft:
    """The scenario's aircraft, if it can be flown; the scenario that was checked last is not checked again.

    Args:
        remembered: whether to look for a start that was found before, and to keep this one, in the user's cache folder. Then a
            known start needs no simulator. A flight that begins at once finds its start itself, and keeps no record.

    Raises:
        BadInput: with every problem: unknown names, a model that cannot be loaded, no trimmed flight to begin with.
    """
    aircraft = load_with_changes(scenario.aircraft)
    _sound.get((id(scenario), aircraft.fingerprint()), lambda: _checked(scenario, aircraft, remembered))
    return aircraft


def name_problems(scenario: Scenario, aircraft: Aircraft) -> list[Problem]:
    """Unknown names of properties, signals and metrics in a scenario; raises BadInput if the model cannot be loaded.

    Before a sweep, its flights get only this check: to trim each would take too long.
    """
    return _unknown(scenario, aircraft, property_catalog(aircraft) if scenario.failures else {})


def _checked(scenario: Scenario, aircraft: Aircraft, remembered: bool) -> Scenario:
    """The scenario, or BadInput. Where the model cannot be loaded, names of its properties cannot be checked."""
    at, found = scenario.initial, list[Problem]()
    start = (scenario.physics_hz, at.airspeed_m_s, at.altitude_m, math.radians(at.heading_deg))
    named = scenario
    try:
        properties = check_start(aircraft, *start, remembered=remembered)
    except BadInput as error:
        found += error.problems
        named, properties = scenario.model_copy(update={"failures": ()}), {}
    # A problem without a file is that there is no trimmed flight to begin with.
    placed = [p if p.file else scenario.source.problem(("initial",), p.what, p.expected) for p in found]
    if problems := [*_unknown(named, aircraft, properties), *placed]:
        raise BadInput(problems)
    return scenario


def _unknown(scenario: Scenario, aircraft: Aircraft, properties: dict[str, bool]) -> list[Problem]:
    every, in_flight = all_columns(aircraft, scenario), columns(aircraft)
    return unknown_names(scenario, aircraft, every, METRICS, properties, in_flight)

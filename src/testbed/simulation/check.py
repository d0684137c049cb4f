"""The complete check of a scenario before it is flown. `run`, `validate`, `fly` and `Session` all make this one.

The scenario is valid by itself already (see `scenario.load`). Here it meets the log's columns, the metrics, the aircraft's JSBSim
model and the trimmed flight in which it begins. That a start was found is recorded in the user's cache folder: a
scenario that was checked before is checked again without JSBSim and scipy, which importing this module does not import.
"""

from __future__ import annotations

import hashlib
import math

from testbed.aircraft.changes import load_with_changes
from testbed.aircraft.description import Aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model
from testbed.aircraft.model_files.safe_xml import read_bytes
from testbed.common.cache import Cache
from testbed.flight.columns import all_columns, columns
from testbed.inputs.problems import BadInput, Problem
from testbed.metrics import TABLE as METRICS
from testbed.plant.first_load import has_record, property_catalog, write_record
from testbed.scenario.consistency import unknown_names
from testbed.scenario.model import Scenario

Start = tuple[float, float, float, float]
"""Steps of the plant a second [Hz], and airspeed [m/s], altitude [m] and heading [rad] at which a flight begins."""
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
    properties = property_catalog(aircraft) if scenario.failures else {}
    every, in_flight = all_columns(aircraft, scenario), columns(aircraft)
    return unknown_names(scenario, aircraft, every, METRICS, properties, in_flight)


def _checked(scenario: Scenario, aircraft: Aircraft, remembered: bool) -> Scenario:
    """The scenario, or BadInput. Where the model cannot be loaded, names of its properties cannot be checked."""
    found, named = list[Problem](), scenario
    try:
        check_start(aircraft, start_of(scenario), remembered=remembered)
    except BadInput as error:
        found += error.problems
        named = scenario.model_copy(update={"failures": ()})
    # A problem without a file is that there is no trimmed flight to begin with.
    placed = [p if p.file else scenario.source.problem(("initial",), p.what, p.expected) for p in found]
    if problems := [*name_problems(named, aircraft), *placed]:
        raise BadInput(problems)
    return scenario


def start_of(scenario: Scenario) -> Start:
    """That of the flight of a scenario."""
    at = scenario.initial
    return scenario.physics_hz, at.airspeed_m_s, at.altitude_m, math.radians(at.heading_deg)


def check_start(aircraft: Aircraft, start: Start, *, remembered: bool = True) -> None:
    """Find what a flight begins with.

    Args:
        remembered: whether to look for a record, and to keep one. The flights of a sweep would fill the folder with them.

    Raises:
        BadInput: the model cannot be loaded, or the stored design model is none.
        NoTrim: there is no level flight at the initial condition, or none from which to identify a missing design model.
    """
    property_catalog(aircraft)
    record = _record(aircraft, start) if remembered else ""
    if record and has_record(record):
        return
    from testbed.plant.identification import stored
    from testbed.plant.trim import trimmed_start

    trimmed_start(aircraft, *start)
    trimmed_start(aircraft.nominal, *start)
    stored(aircraft.nominal)
    if record:
        write_record(record, {})


def _record(aircraft: Aircraft, start: Start) -> str:
    """The name of a start in the cache folder, from all that it depends on; raises BadInput for a bad stored design model."""
    file, design = aircraft.folder / DESIGN_MODEL, b""
    if file.exists():
        design = read_bytes(file)
        load_design_model(file)
    return f"{aircraft.fingerprint()}-{hashlib.sha256(repr((start, design)).encode()).hexdigest()[:16]}"

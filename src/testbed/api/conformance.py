"""Whether parts of the user's own keep the contract of the shipped ones: each is flown for seconds, as the tests fly those."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.common.docstrings import first_line
from testbed.common.units import unit
from testbed.controllers.user.loader import in_words
from testbed.failures import ActuatorFailure, Failure
from testbed.inputs.problems import BadInput
from testbed.inputs.yaml_source import Source
from testbed.metrics import readings
from testbed.parts.files import KINDS, loaded
from testbed.parts.registry import use
from testbed.reporting.flight import ReportedFlight
from testbed.reporting.panels import Group, Panel
from testbed.scenario.load import scenario_from
from testbed.sensors.channels import PER_SECOND, unit_of
from testbed.sensors.faults import SensorFault
from testbed.simulation import fly

_END_S, _FROM_S, _UNTIL_S = 3.0, 1.0, 2.0
_SENSORS = ("gyro_q", "altitude", "airspeed")
"""Sensors on which a fault is tried."""


@dataclass(frozen=True)
class Finding:
    """What was found of one part: what was flown, and what is wrong; nothing is if it keeps the contract."""

    part: str
    tried: tuple[str, ...]
    wrong: tuple[str, ...]

    def __str__(self) -> str:
        flown = f" ({', '.join(self.tried)})" if self.tried else ""
        return f"{self.part}: {'; '.join(self.wrong)}" if self.wrong else f"{self.part}: ok{flown}"


def conformance(file: str | Path, aircraft: str = "vtail") -> Iterator[Finding]:
    """Test each part in a file on an aircraft. Raises BadInput when the file cannot be used at all."""
    with use(file) as used:
        tables = used.parts[0].tables if used.parts else loaded(file).tables
        trial = _Trial(aircraft, str(file))
        for kind, parts in tables.items():
            for name, part in parts.items():
                tried, wrong = list[str](), list[str]()
                try:
                    with in_words(str(file), f"in {name}"):
                        for said in _TESTS[kind](trial, name, part, tried):
                            wrong.append(said)
                except BadInput as error:
                    wrong += map(str, error.problems)
                yield Finding(f"{KINDS[kind].word} {name}", tuple(tried), tuple(wrong))


class _Trial:
    """Short flights of one aircraft."""

    def __init__(self, aircraft: str, file: str) -> None:
        self.name, self.aircraft, self.file = aircraft, load_aircraft(aircraft), file

    def fly(self, **keys: Any) -> ReportedFlight:
        tree = {"name": "conformance", "aircraft": self.name, "duration_s": _END_S, **keys}
        return fly(scenario_from(Source(self.file, tree)))

    def twice(self, **keys: Any) -> tuple[ReportedFlight, list[str]]:
        """A flight, and what is wrong if a second one differs."""
        one, other = self.fly(**keys), self.fly(**keys)
        same = np.array_equal(one.data, other.data, equal_nan=True) and one.summary == other.summary
        return one, [] if same else ["two flights of it differ: it depends on more than its arguments"]

    @cached_property
    def healthy(self) -> ReportedFlight:
        return self.fly()

    @cached_property
    def broken(self) -> ReportedFlight:
        first = next(iter(self.aircraft.actuators))
        return self.fly(failures=[{"type": "stuck", "actuator": first, "at_s": _FROM_S}])


def _failure(trial: _Trial, name: str, part: type[Failure], tried: list[str]) -> Iterator[str]:
    """Each kind of actuator that it can break: flown, verified, undone, and without effect where it says so."""
    if not part.examples:
        yield "has no `examples`: no matrix can have it, and nothing can be flown here"
    until = {"until_s": _UNTIL_S} if part.undone else {}
    for kind, fields in part.examples.items():
        whose = _actuator(part, kind, trial.aircraft)
        if whose is None:
            tried.append(f"no {kind} on {trial.name}, not flown")
            continue
        broken = {"type": name, **whose, "at_s": _FROM_S, **until, **fields}
        flight, differs = trial.twice(failures=[broken])
        yield from differs
        yield from _receipts(flight)
        neutral = part.neutral(trial.aircraft.actuators[whose["actuator"]]) if whose else None
        if neutral is not None:
            none = trial.fly(failures=[{**broken, **neutral}])
            if not np.array_equal(none.data, trial.healthy.data, equal_nan=True):
                yield f"with {dict(neutral)}, which `harmless` or `neutral` names, it has an effect"
        tried.append(" ".join([*whose.values(), flight.scenario.failures[0].words(kind, "")]))


def _actuator(part: type[Failure], kind: str, aircraft: Aircraft) -> dict[str, str] | None:
    """The actuator to break, of this kind; {} for a failure without one, None where the aircraft has none."""
    if not issubclass(part, ActuatorFailure):
        return {}
    found = [name for name, actuator in aircraft.actuators.items() if actuator.kind == kind]
    return {"actuator": found[0]} if found else None


def _receipts(flight: ReportedFlight) -> Iterator[str]:
    """Whether its start was seen to act, and its end to be undone."""
    for event in flight.events:
        if event["kind"] == "injection" and event["verified"] is not True:
            yield f"its {'start' if event['active'] else 'end'} was not verified: {'; '.join(flight.warnings)}"


def _sensor_fault(trial: _Trial, name: str, part: type[SensorFault], tried: list[str]) -> Iterator[str]:
    """On some sensors: it changes a reading."""
    for sensor in _SENSORS:
        key = part.key.format(unit_of(sensor), per_second=PER_SECOND[unit_of(sensor)])
        fault = {"type": name, "sensor": sensor, "at_s": _FROM_S, "until_s": _UNTIL_S}
        flight, differs = trial.twice(sensors={"faults": [fault | ({key: 1.0} if key else {})]})
        yield from differs
        begun = [event for event in flight.events if event["kind"] == "sensor_fault" and event["active"]]
        if not begun[0]["verified"]:
            yield f"{sensor} reads as without it"
        tried.append(sensor)


def _preset(trial: _Trial, name: str, part: Any, tried: list[str]) -> Iterator[str]:
    flight, differs = trial.twice(sensors=name)
    yield from differs
    if flight.scenario.sensors.is_ideal:
        yield "has no errors: it is ideal"
    tried.append(f"{len(part)} sensors")


def _metric(trial: _Trial, name: str, part: Callable[..., float], tried: list[str]) -> Iterator[str]:
    """A number of each flight, or NaN, without a change of the flight; with its unit in name and docstring."""
    said = re.search(r"\[(.+?)\]", first_line(part))
    if said is None or (unit(name) and said[1] != unit(name)):
        yield f"the first line of its docstring does not have its unit [{unit(name) or '-'}], as its name has"
    for flight in (trial.healthy, trial.broken):
        view = readings(flight)
        before = {column: values.copy() for column, values in view.log.items()}
        first, second = part(view), part(view)
        if not np.array_equal(first, second, equal_nan=True):
            yield f"gives {first!r} and then {second!r} of one flight"
        if any(not np.array_equal(view.log[c], before[c], equal_nan=True) for c in before):
            yield "changes the log"
        tried.append(f"{first:g}")


def _panel(trial: _Trial, name: str, part: Callable[..., Any], tried: list[str]) -> Iterator[str]:
    """Panels of columns that the log has."""
    made = list(part(trial.broken))
    if not all(isinstance(panel, Panel) for panel in made):
        yield "gives something that is no Panel"
        return
    shown = Group("", (part,)).of(trial.broken)
    for panel in made:
        if panel not in shown:
            yield f"{panel.title}: a column of {[series.column for series in panel.series]} is not in the log"
    tried += [panel.heading for panel in shown]


def _reference(trial: _Trial, name: str, part: Any, tried: list[str]) -> Iterator[str]:
    flight, differs = trial.twice(reference=name)
    yield from differs
    tried.append(f"flown for {flight.end_time_s:g} s")


_TESTS: dict[str, Callable[..., Iterator[str]]] = {
    "FAILURES": _failure, "SENSOR_FAULTS": _sensor_fault, "SENSORS": _preset, "METRICS": _metric, "PANELS": _panel,
    "REFERENCES": _reference,
}  # fmt: skip

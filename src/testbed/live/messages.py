"""All that a page may ask for: a closed vocabulary, each message checked before anything is done. And what a page is told of a
flight: numbers of the present, often; and in words what is broken and what has happened.

What is to break, to be flown or to blow is written as in a scenario, and is checked by `Session` as a scenario is.
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, Field, StrictBool, TypeAdapter, ValidationError

from testbed.air.config import COLUMNS as WIND
from testbed.common.signals import RATES, Belief
from testbed.common.units import worded
from testbed.failures import TABLE as FAILURES
from testbed.failures import Failure
from testbed.flight.breakage import failures_of, response
from testbed.flight.columns import Recorded, columns, table
from testbed.flight.flight import Flight
from testbed.inputs.base import NonNegative, Number, Settings, Text, Whole
from testbed.inputs.problems import BadInput, Problem
from testbed.reporting.panels import error_columns, response_of
from testbed.reporting.story import diagnoses, story
from testbed.reporting.words import describe, title
from testbed.scenario.model import Scenario
from testbed.sensors.channels import CHANNELS, SI, channels_of
from testbed.sensors.faults import TABLE as FAULTS
from testbed.sensors.faults import SensorFault, value_name
from testbed.sensors.settings import SENSORS
from testbed.simulation.assembly import Assembly
from testbed.simulation.session import Session

MOST_BYTES = 4096
"""Longest message of a page."""
AS_GIVEN = "as given"
"""The controller or the sensors that the command or the scenario names."""
_MOST_SAID = 3  # problems that are named


class _Message(Settings):
    id: Whole
    """Number with which the answer names the message."""


class Pause(_Message):
    """Stop the time, or let it run again."""

    do: Literal["pause"]
    on: StrictBool


class Speed(_Message):
    """Fly this many times as fast as real time."""

    do: Literal["speed"]
    times: Annotated[Number, Field(ge=0.25, le=16.0)]


class Break(_Message):
    """Break something now; `failure` is one of a scenario's `failures` or `sensors.faults`, without a time."""

    do: Literal["break"]
    failure: dict[str, Any]


class Mend(_Message):
    """End every failure of an actuator, or every fault of a sensor."""

    do: Literal["mend"]
    actuator: Text


class Order(_Message):
    """Command something now; `command` is one of a scenario's `commands`, without a time."""

    do: Literal["order"]
    command: dict[str, Any]


class Blow(_Message):
    """Blow a gust, or change the wind; `air` as of `Session.blow`."""

    do: Literal["blow"]
    air: dict[str, Any]


class Save(_Message):
    """Write a run folder of the flight so far."""

    do: Literal["save"]


class Rewind(_Message):
    """Go back to this time [s]: what was done by hand from then on is gone."""

    do: Literal["rewind"]
    time_s: NonNegative


class Restart(_Message):
    """Begin again, with all that was done by hand gone."""

    do: Literal["restart"]


class Ghosts(_Message):
    """Let these types of controllers, and no others, fly the same past and present beside the flight."""

    do: Literal["ghosts"]
    controllers: tuple[Text, ...]


class Choose(_Message):
    """Fly something else: a scenario or an aircraft, a controller, and sensors, each one of those that `choices` of the page's
    facts has."""

    do: Literal["choose"]
    flight: Text
    controller: Text
    sensors: Text = AS_GIVEN


Act = Break | Mend | Order | Blow
"""What changes a flight."""
Message = Annotated[
    Act | Pause | Speed | Save | Rewind | Restart | Ghosts | Choose, Field(discriminator="do")
]
_MESSAGE: TypeAdapter[Any] = TypeAdapter(Message)


def read(text: str | bytes) -> Any:
    """The message in a text of JSON; raises BadInput for anything that is not one."""
    try:
        return _MESSAGE.validate_json(text)
    except ValidationError as error:
        found = error.errors(include_url=False, include_input=False, include_context=False)
        places = [(".".join(map(str, each["loc"])), each["msg"]) for each in found[:_MOST_SAID]]
        raise BadInput([Problem(what, "message", path=place) for place, what in places]) from None


_MOST_EVENTS = 200
"""Events that a page is shown, the last ones."""
_SIZES = {"deg_s": 5.0, "deg": 3.0, "m_s2": 1.0, "m_s": 2.0, "m": 5.0}
_SHARE = {"drift": 0.1, "noise": 0.1}
"""What a page suggests for a fault of a sensor: its size by the sensor's unit, and the share of it for some types."""


def numbers(session: Session) -> dict[str, np.ndarray]:
    """The last control step by the names of the log's columns, and of those that reports add; each [1]."""
    parts, loop = session.parts, session.loop
    last = slice(loop.done - 1, loop.done)
    rate_hz = parts.scenario.rate_hz
    row = table(parts.aircraft, rate_hz, Recorded(*(rows[last] for rows in loop.rows)))
    log = dict(zip(columns(parts.aircraft), row, strict=True))
    log["time_s"] = np.array([last.start / rate_hz])
    active, failures = failures_of(parts.injector.receipts), parts.injector.failures
    for name in parts.aircraft.actuators:
        log[response_of(name)] = response(log, name, active, failures)
    wind = parts.weather.wind[last] if len(parts.weather.wind) else np.zeros((1, 3))
    return log | error_columns(log) | dict(zip(WIND, wind.T, strict=True))


def frame(*sessions: Session) -> bytes:
    """The last control step of each flight as 32-bit numbers in the order of `columns` of `facts`, one flight after the other."""
    rows = [np.concatenate(list(numbers(session).values())) for session in sessions]
    return np.concatenate(rows).astype("<f4").tobytes()


def broken(session: Session) -> dict[str, list[str]]:
    """What each actuator or sensor has now: {name: the failures in words}."""
    found: dict[str, list[str]] = {}
    step, rate_hz = session.loop.done, session.parts.scenario.rate_hz
    for fault in session.parts.scenario.sensors.faults:
        start, end = fault.window(rate_hz)
        if start <= step < end:
            sensor = CHANNELS[channels_of(fault.sensor)[0]].sensor  # a fault may name a channel of it
            found.setdefault(sensor, []).append(fault.words())
    for injection in session.parts.injector.active:
        if injection.actuator is not None:
            found.setdefault(injection.actuator, []).append(_words(injection.failure, session.parts))
    return found


def _words(failure: Failure, parts: Assembly) -> str:
    if failure.actuator is None:
        return failure.type
    actuator = parts.aircraft.actuators[failure.actuator]
    return failure.words(actuator.kind, actuator.unit if actuator.kind == "servo" else "of throttle")


def told(flight: Flight) -> dict[str, Any]:
    """The story of a flight so far, and its events in words."""
    events = [
        {"time_s": event["time_s"], "kind": event["kind"], "text": describe(event, flight)}
        for event in flight.events[-_MOST_EVENTS:]
    ]
    return {"story": [*story(flight), *diagnoses(flight)], "events": events}


def facts(session: Session) -> dict[str, Any]:
    """What a page has to know of a flight before its first frame."""
    parts, scenario, last = session.parts, session.parts.scenario, numbers(session)
    actuators = {
        name: {
            **actuator.model_dump(include={"kind", "unit", "limits", "scale"}),
            "title": title(name),
            "failures": _failures(actuator.kind),
        }
        for name, actuator in parts.aircraft.actuators.items()
    }
    return {
        "name": scenario.name,
        "aircraft": Path(str(scenario.aircraft)).name,
        "controller": parts.flown_by or scenario.controller.type,
        "columns": list(last),
        "actuators": actuators,
        "sensors": {} if scenario.sensors.is_ideal else {name: _sensor(name) for name in SENSORS},
        "never": [axis for axis in RATES if last[f"{axis}_released"][0] > 0.0],
        "beliefs": {belief.value: belief.name for belief in Belief},
        "limits": _limits(scenario),
        "shape": parts.shape.model_dump(),
        "estimates": any(np.isfinite(last[f"{name}_effectiveness_estimate"][0]) for name in actuators),
    }


def _failures(kind: str) -> list[dict[str, Any]]:
    """The types of failure that an actuator of this kind can have, each with its settings as a JSON schema."""
    base = set(Failure.model_fields)
    found = []
    for name, failure in FAILURES.items():
        if kind not in failure.kinds or "actuator" not in failure.model_fields or name == "property":
            continue
        example = failure.examples.get("motor" if kind == "engine" else kind, {})
        found.append(_offer(name, failure, base, example))
    return found


def _sensor(name: str) -> dict[str, Any]:
    """The types of fault that a sensor can have, as those of an actuator."""
    own, found = CHANNELS[channels_of(name)[0]].unit, []
    for kind, fault in FAULTS.items():
        values = {unit: value_name(fault.key, unit) for unit in SI} if fault.key else {}
        others = {key for unit, key in values.items() if unit != own}
        suggested = {values[own]: _SIZES[own] * _SHARE.get(kind, 1.0)} if values and fault.needs_value else {}
        found.append(_offer(kind, fault, others.union(SensorFault.model_fields), suggested))
    return {"title": title(name), "failures": found}


def _offer(
    name: str, part: type[BaseModel], leave: Container[str], example: Mapping[str, Any]
) -> dict[str, Any]:
    """A type of failure or fault, with its settings but for some as a JSON schema."""
    schema = part.model_json_schema()
    about = str(schema.get("description", "")).partition("\n")[0].replace("`", "")
    settings = {
        key: {**setting, "title": worded(key)}
        for key, setting in schema["properties"].items()
        if key not in leave
    }
    return {"type": name, "about": about, "settings": settings, "example": dict(example)}


def _limits(scenario: Scenario) -> dict[str, float]:
    """The widest limit that a requirement sets on how far a quantity is from its reference, by the reference's column."""
    found: dict[str, float] = {}
    for requirement in scenario.requirements:
        if requirement.within is not None and isinstance(requirement.of, str):
            found[requirement.of] = max(requirement.within, found.get(requirement.of, 0.0))
    return found

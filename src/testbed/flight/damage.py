"""What a run folder must hold to be believed, for it may come from anybody, edited or cut: said with its place, before anything is
drawn or compared.

Each part of summary.json is a model of the keys that are read; further keys are kept as they are. Folders of earlier versions lack
some keys, which have a value here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import islice
from typing import Annotated, Any, Literal, Union

import numpy as np
from pydantic import AfterValidator, BaseModel, ConfigDict, Discriminator, Field, Tag

from testbed.aircraft.shape import Shape
from testbed.common.signals import RATES, TELEMETRY
from testbed.flight.columns import ALWAYS_KNOWN
from testbed.flight.events import LIMITS
from testbed.flight.flight import Flight, Outcome
from testbed.inputs.base import NonNegative, Number, Positive, Whole, one_line
from testbed.inputs.problems import BadInput, Problem, one_of
from testbed.inputs.yaml_source import describe

_Flag = Annotated[bool, Field(strict=True)]
_Word = Annotated[str, Field(strict=True)]
_Name = Annotated[_Word, AfterValidator(one_line)]
_Known = Number | None
"""A number, or None where it was not finite."""


class _Part(BaseModel):
    model_config = ConfigDict(frozen=True, extra="allow", hide_input_in_errors=True)


class Event(_Part):
    """What every event has; one of another kind is shown by its kind alone."""

    time_s: NonNegative
    kind: _Word
    actuator: _Word | None = None


class Injection(Event):
    """A failure begins or ends."""

    failure: Whole = 0
    type: _Word = ""
    active: _Flag = True
    verified: _Flag | None = True


class Detection(Event):
    """An actuator that is broken was flagged."""

    actuator: _Word
    delay_s: Number


class FalseAlarm(Event):
    """An actuator was flagged that is not broken."""

    actuator: _Word


class Release(Event):
    """A controlled rate was given up."""

    axis: Literal[RATES]  # type: ignore[valid-type]


class Recovered(Event):
    """The aircraft recovered from a failure."""

    after_s: Number


class Diagnosis(Event):
    """What the controller said."""

    text: _Word


class _Passed(_Part):
    limit: Literal[tuple(LIMITS)]  # type: ignore[valid-type]
    value: Number
    allowed: Number
    unit: _Word


class _AtStop(_Part):
    actuator: _Word
    stop: _Word


class Lost(Event):
    """The aircraft was lost."""

    limits: tuple[_Passed, ...]
    at_stop: tuple[_AtStop, ...]


_BY_KIND: dict[str, type[Event]] = {
    "injection": Injection, "detection": Detection, "false_alarm": FalseAlarm, "release": Release,
    "recovered": Recovered, "diagnosis": Diagnosis, "lost": Lost, "other": Event,
}  # fmt: skip


def _kind(event: Any) -> str:
    kind = event.get("kind") if isinstance(event, Mapping) else getattr(event, "kind", None)
    return kind if isinstance(kind, str) and kind in _BY_KIND else "other"


_AnyEvent: Any = Annotated[
    Union[tuple(Annotated[model, Tag(kind)] for kind, model in _BY_KIND.items())],  # noqa: UP007
    Discriminator(_kind),
]


class Verdict(_Part):
    """What was found of a requirement."""

    name: _Name
    passed: _Flag | None
    value: _Known
    limit: _Word = ""
    margin: _Known = None
    robustness: _Known = None
    reason: _Word = ""


class Facts(_Part):
    """What is said of an actuator."""

    name: _Name
    kind: _Word
    unit: _Word
    limits: tuple[Number, Number]
    scale: Positive


class Summary(_Part):
    """summary.json of a run folder, whole."""

    outcome: Outcome
    end_time_s: NonNegative
    events: tuple[_AnyEvent, ...]  # type: ignore[valid-type]
    requirements: tuple[Verdict, ...]
    metrics: Annotated[dict[str, _Known], Field(max_length=500)]
    actuators: Annotated[tuple[Facts, ...], Field(max_length=100)]
    warnings: tuple[_Word, ...] = ()
    shape: Shape | None = None
    flown_by: _Word = ""
    flown_by_sha256: _Word = ""
    parts_sha256: dict[str, _Word] = Field(default_factory=dict, max_length=100)


_NEEDED = (
    "time_s", "altitude_m", "altitude_command_m", "airspeed_m_s", "airspeed_command_m_s", "heading_deg", "heading_command_deg",
    "roll_deg", "pitch_deg", "beta_deg",
)  # fmt: skip
"""Columns that every comparison, verdict and story rests on."""
_OF_AN_ACTUATOR = ("position", "effectiveness", *TELEMETRY)
_OF_ACTUATORS = ("detection", "false_alarm")
"""Kinds of events that are always of an actuator."""
_ROUNDED_S = 1e-6
_SHOWN = 3
"""Problems that are named: a damaged file has one in each cell."""


def refuse_damaged(flight: Flight, summary: str, log: str) -> None:
    """Raise BadInput for a flight that was not one, with the file, `summary` or `log`, in which this is.

    The events are of failures, actuators, axes and times of the flight. The log has rows, the columns of `_NEEDED` and of its
    actuators, and a number in each of ALWAYS_KNOWN; the state of a flight that diverged may be none. Times increase up to the
    flight's end.
    """
    for problems in (_other_events(flight, summary), _problems(flight, log)):
        if shown := list(islice(problems, _SHOWN)):
            raise BadInput(shown)


def _other_events(flight: Flight, file: str) -> Iterator[Problem]:
    scenario, end_s = flight.scenario, flight.end_time_s
    if end_s > scenario.duration_s + _ROUNDED_S:
        expected = f"at most {scenario.duration_s:g}, as the scenario says"
        yield Problem(f"is {end_s:g}", file, None, "end_time_s", expected)
    short_s = scenario.duration_s - end_s - 1.0 / scenario.log_hz
    if flight.outcome is Outcome.completed and short_s > _ROUNDED_S:
        expected = f"{scenario.duration_s:g}, as the scenario says: it was flown to the end"
        yield Problem(f"is {end_s:g}", file, None, "end_time_s", expected)
    for i, event in enumerate(flight.events):
        for key, what, expected in _foreign(event, flight):
            yield Problem(what, file, None, f"events.{i}.{key}", expected)


def _foreign(event: Mapping[str, Any], flight: Flight) -> Iterator[tuple[str, str, str]]:
    """(key, what is wrong, what is expected) of what an event says and the flight has not."""
    failures = len(flight.scenario.failures)
    if event["time_s"] > flight.end_time_s + _ROUNDED_S:
        yield "time_s", f"is {event['time_s']:g}", f"at most the flight's end, {flight.end_time_s:g}"
    if event["kind"] == "injection" and event.get("failure", 0) >= failures:
        yield "failure", f"is not in the scenario, which has {failures}", ""
    if event["kind"] in _OF_ACTUATORS and event["actuator"] not in flight.actuators:
        what = f"is no actuator of this flight: {describe(event['actuator'])}"
        yield "actuator", what, one_of(flight.actuators)
    if event["kind"] == "release" and f"{event['axis']}_released" not in flight.columns:
        yield "axis", f"is {event['axis']}, of which the log says nothing", ""


def _problems(flight: Flight, file: str) -> Iterator[Problem]:
    if not len(flight.data):
        yield Problem("has no rows", file, expected="the log of a flight")
        return
    needed = [*_NEEDED, *(f"{name}_{of}" for name in flight.actuators for of in _OF_AN_ACTUATOR)]
    missing = [name for name in needed if name not in flight.columns]
    yield from (Problem(f"has no column {name}", file, 1) for name in missing)
    known = () if flight.outcome is Outcome.diverged else ALWAYS_KNOWN
    for name in (name for name in known if name in flight.columns):
        values = flight.column(name)
        for row in np.flatnonzero(~np.isfinite(values)):  # line 1 has the names
            yield Problem(f"is {values[row]:g}", file, int(row) + 2, name, "a finite number")
    if "time_s" not in missing:
        time_s = flight.column("time_s")
        for row in np.flatnonzero(~(np.diff(time_s) > 0.0)):
            yield Problem(f"is {time_s[row + 1]:g}", file, int(row) + 3, "time_s", "times that increase")
        step_s = max([1.0 / flight.scenario.log_hz, *np.diff(time_s[-2:])])  # a log may have one row
        if not 0.0 <= flight.end_time_s - time_s[-1] <= step_s + _ROUNDED_S:
            what, expected = f"ends at {time_s[-1]:g} s", f"the flight's end, {flight.end_time_s:g} s"
            yield Problem(what, file, len(time_s) + 1, "time_s", expected)

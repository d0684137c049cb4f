"""The part of a scenario that a flight has flown so far, as a scenario of its own: it flies to the same bytes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, TypeVar

from testbed.air.config import Atmosphere
from testbed.common.signals import begins_within
from testbed.failures import Failure, stream_names
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.yaml_source import Source
from testbed.scenario.model import Scenario
from testbed.scenario.requirement import Requirement
from testbed.sensors.faults import SensorFault
from testbed.sensors.settings import Sensors

Timed = TypeVar("Timed", Failure, SensorFault)
Windowed = TypeVar("Windowed", Failure, SensorFault, Requirement)
_RANDOM_FAULTS = ("dropout", "noise")
_NOT_DEFAULT_S = 20.0
"""A correlation time that is not the default one. It acts on nothing while there is no wander."""


def flown_part(scenario: Scenario, steps: int) -> Scenario:
    """The scenario of the first control steps of a flight, without what begins after them.

    Raises:
        BadInput: what is left would draw other random numbers, since these depend on a place in a list.
    """
    end_s, rate_hz = steps / scenario.rate_hz, scenario.rate_hz
    failures = _cut(scenario.failures, rate_hz, steps)
    faults = _cut(scenario.sensors.faults, rate_hz, steps)
    _refuse_renumbered(scenario, failures, faults)
    changes = {
        "duration_s": end_s,
        "commands": tuple(c for c in scenario.commands if begins_within(c.at_s, rate_hz, steps)),
        "failures": tuple(_within(failure, end_s) for failure in failures),
        "sensors": _sensors(scenario.sensors, tuple(_within(fault, end_s) for fault in faults)),
        "atmosphere": _air(scenario, steps),
        "requirements": tuple(_requirements(scenario.requirements, end_s)),
    }
    return altered(scenario, **changes)


def altered(scenario: Scenario, **changes: Any) -> Scenario:
    """The scenario with other values of its keys, which are known to be valid; places in its file no longer apply."""
    made = scenario.model_copy(update=changes)
    made._source = Source()
    return made


def longer_scenario(scenario: Scenario, duration_s: float) -> Scenario:
    """The same scenario with a longer duration, whose flight begins with the same bytes."""
    air = _until(scenario.atmosphere, scenario.duration_s)
    return altered(scenario, duration_s=duration_s, atmosphere=air)


def _cut(each: Iterable[Timed], rate_hz: float, steps: int) -> list[Timed]:
    return [one for one in each if begins_within(one.at_s, rate_hz, steps)]


def _within(one: Windowed, end_s: float) -> Windowed:
    """The failure, fault or requirement, without an end that is after the flight's."""
    ends_later = one.until_s is not None and one.until_s > end_s
    return one.model_copy(update={"until_s": None}) if ends_later else one


def _refuse_renumbered(
    scenario: Scenario, failures: Sequence[Failure], faults: Sequence[SensorFault]
) -> None:
    """Raise BadInput if random numbers of a failure or fault that is left depend on one that is left out."""
    whole, part = stream_names(scenario.failures), stream_names(failures)
    names = {id(one): name for one, name in zip(scenario.failures, whole, strict=True)}
    moved = [one for one, name in zip(failures, part, strict=True) if one.draws and names[id(one)] != name]
    places = {id(one): i for i, one in enumerate(scenario.sensors.faults)}
    shifted = [one for i, one in enumerate(faults) if one.type in _RANDOM_FAULTS and places[id(one)] != i]
    problems = [
        Problem(
            f"the random numbers of {one.type} at {one.at_s:g} s depend on what begins later and is listed before it",
            path=path,
            expected="those listed in order of time",
        )
        for path, some in (("failures", moved), ("sensors.faults", shifted))
        for one in some
    ]
    if problems:
        raise BadInput(problems)


def _sensors(sensors: Sensors, faults: tuple[SensorFault, ...]) -> Sensors:
    """The sensors with fewer faults. Sensors that were not ideal because of a fault alone differ from ideal ones in how rates are
    found, so they stay what they were."""
    made = sensors.model_copy(update={"faults": faults})
    if not made.is_ideal or sensors.is_ideal:
        return made
    real = made.of("altitude").model_copy(update={"wander_time_s": _NOT_DEFAULT_S})
    return made.model_copy(update={"altitude": real})


def _air(scenario: Scenario, steps: int) -> Atmosphere:
    """The air without gusts and changes that begin later, and without a noise whose window does."""
    air, rate_hz = _until(scenario.atmosphere, scenario.duration_s), scenario.rate_hz
    gusts = tuple(gust for gust in air.gusts if begins_within(gust.at_s, rate_hz, steps))
    changes = tuple(each for each in air.turbulence_changes if begins_within(each.at_s, rate_hz, steps))
    begun = air.noise is not None and begins_within(air.noise.from_s, rate_hz, steps)
    return air.model_copy(
        update={
            "gusts": gusts,
            "turbulence_changes": changes,
            "noise": air.noise if begun else None,
        }
    )


def _until(air: Atmosphere, end_s: float) -> Atmosphere:
    """The air with the end of the noise's window written out: the window is not to change with the duration."""
    if air.noise is None or air.noise.until_s is not None:
        return air
    return air.model_copy(update={"noise": air.noise.model_copy(update={"until_s": end_s})})


def _requirements(requirements: Iterable[Requirement], end_s: float) -> Iterator[Requirement]:
    """Those that begin within the flight; their windows end with it at the latest."""
    for each in requirements:
        if max(each.begins_s, each.never_for_longer_than_s or 0.0) < end_s:
            yield _within(each, end_s)

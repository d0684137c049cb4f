"""What is given to a flight in the hand: failures, commands and gusts, each checked alone, at once, before anything changes.

Each begins in the next control step, `step`, unless it says when. What cannot be is refused by BadInput.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from pydantic import BaseModel, create_model

from testbed.air.config import Gust, TurbulenceChange, Vector, WindChange
from testbed.common.signals import first_step_at
from testbed.failures import TABLE, Failure, When
from testbed.flight.columns import Recorded, columns, reader
from testbed.inputs.base import Settings, any_of
from testbed.inputs.problems import Issue, TreePath
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import Source
from testbed.plant.first_load import property_catalog
from testbed.scenario.consistency import failure_issues, glides, no_altitude
from testbed.scenario.model import Command
from testbed.sensors.faults import TABLE as FAULTS
from testbed.sensors.faults import SensorFault
from testbed.simulation.assembly import Assembly


def failure_of(given: Failure | Mapping[str, Any], parts: Assembly, recorded: Recorded) -> Failure:
    """The failure, where `recorded` has the rows flown so far."""
    scenario, aircraft, step = parts.scenario, parts.aircraft, len(recorded.truth)

    def fits(failure: Failure, path: TreePath) -> Iterator[Issue]:
        properties, names = property_catalog(aircraft), columns(aircraft)
        issues = list(failure_issues(failure, aircraft, scenario.rate_hz, names, properties, path))
        yield from issues or _met(failure.when, parts, recorded, path)

    return _valid("failure", any_of(TABLE), "inject", given, parts, step, fits)


def _met(when: When | None, parts: Assembly, recorded: Recorded, path: TreePath) -> Iterator[Issue]:
    """Refuse a `when` that was true before now: flown again from the saved scenario, the failure would start then."""
    if when is None:
        return
    signal = reader(parts.aircraft, parts.scenario.rate_hz, recorded, when.signal)
    for step in range(len(recorded.truth) - 1):
        if when.met(signal(step)):
            what = f"{when} was so at {step / parts.scenario.rate_hz:g} s already"
            yield Issue((*path, "when"), what, "a limit that has not been passed yet, or at_s")
            return


def fault_of(given: SensorFault | Mapping[str, Any], parts: Assembly, step: int) -> SensorFault:
    """The fault of a sensor."""

    def fits(_: SensorFault, path: TreePath) -> Iterator[Issue]:
        if parts.sensors is None:
            yield Issue(path, "the sensors of this flight are ideal", "a scenario with sensors: mems")

    return _valid("fault", any_of(FAULTS), "inject", given, parts, step, fits)


def command_of(given: Command | Mapping[str, Any], parts: Assembly, step: int) -> Command:
    """The command."""

    def fits(command: Command, path: TreePath) -> Iterator[Issue]:
        if command.model_dump(exclude={"at_s"}, exclude_none=True) == {}:
            yield Issue(path, "asks for nothing", "altitude_m, airspeed_m_s or heading_deg")
        if glides(parts.aircraft) and command.altitude_m is not None:
            yield no_altitude(parts.aircraft, (*path, "altitude_m"))

    return _valid("command", Command, "order", given, parts, step, fits)


def gust_of(
    given: Gust | WindChange | Mapping[str, Any], parts: Assembly, step: int, wind_m_s: Vector
) -> tuple[Gust, Vector]:
    """The gust, and the steady wind after it.

    Args:
        given: a gust; or a steady wind in place of that so far, which is `wind_m_s` [m/s, north, east, down].
    """
    if isinstance(given, WindChange) or (isinstance(given, Mapping) and "wind_m_s" in given):
        change = _valid("wind", WindChange, "blow", given, parts, step)
        return change.gust(step / parts.scenario.rate_hz, wind_m_s), change.wind_m_s
    return _valid("gust", Gust, "blow", given, parts, step), wind_m_s


def turbulence_of(
    given: TurbulenceChange | Mapping[str, Any], parts: Assembly, step: int
) -> TurbulenceChange:
    """The change of turbulence."""

    def fits(_: TurbulenceChange, path: TreePath) -> Iterator[Issue]:
        if (model := parts.scenario.atmosphere.model) != "jsbsim":
            what = f"{model} turbulence does not change in flight"
            yield Issue(path, what, "a scenario with model: jsbsim")

    return _valid("turbulence", TurbulenceChange, "blow", given, parts, step, fits)


def _valid(
    key: str,
    kind: Any,
    verb: str,
    given: BaseModel | Mapping[str, Any],
    parts: Assembly,
    step: int,
    fits: Callable[[Any, TreePath], Iterable[Issue]] = lambda *_: (),
) -> Any:
    """What was given as this kind of settings, under a key as in a scenario; BadInput has every problem, each with the method
    that was called."""
    tree: Any = given.model_dump(exclude_none=True) if isinstance(given, BaseModel) else given
    if isinstance(tree, Mapping):  # what is neither a mapping nor a model is refused with its place
        begins = kind is not WindChange and not (key == "failure" and "when" in tree)
        now = {"at_s": step / parts.scenario.rate_hz} if begins else {}
        tree = {**now, **tree}

    def issues(made: Any) -> Iterator[Issue]:
        one = getattr(made, key)
        yield from _times(one, parts, step, (key,))
        yield from fits(one, (key,))

    fields: dict[str, Any] = {key: (kind, ...)}
    holder = create_model("Given", __base__=Settings, **fields)
    return getattr(validated(holder, Source(verb, {key: tree}), issues), key)


def _times(one: BaseModel, parts: Assembly, step: int, path: TreePath) -> Iterator[Issue]:
    """Times that are past, or after the end of the flight."""
    rate_hz, end_s, now_s = parts.scenario.rate_hz, parts.scenario.duration_s, step / parts.scenario.rate_hz
    at_s, until_s = getattr(one, "at_s", None), getattr(one, "until_s", None)
    if at_s is not None and first_step_at(at_s, rate_hz) < step:
        yield Issue((*path, "at_s"), f"{at_s:g} s has passed", f"at least {now_s:g}, which is now")
    for key, time_s, last_s in (("at_s", at_s, end_s - 1.0 / rate_hz), ("until_s", until_s, end_s)):
        if time_s is not None and time_s > last_s:
            yield Issue((*path, key), f"{time_s:g} s is after the flight's end at {end_s:g} s")
    if until_s is not None and until_s <= now_s:
        yield Issue((*path, "until_s"), f"{until_s:g} s has passed", f"more than {now_s:g}")

"""What is given to a flight in the hand: failures, commands and gusts, each checked alone, at once, before anything changes."""

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
from testbed.scenario.checks import failure_issues, glides, no_altitude
from testbed.scenario.model import Command
from testbed.sensors.faults import TABLE as FAULTS
from testbed.sensors.faults import SensorFault
from testbed.simulation.assembly import Assembly


def failure_of(given: Failure | Mapping[str, Any], parts: Assembly, recorded: Recorded) -> Failure:
    """The failure, which starts in the next control step unless it says when; raises BadInput.

    Args:
        recorded: the rows flown so far.
    """
    scenario, aircraft, step = parts.scenario, parts.aircraft, len(recorded.truth)

    def fits(failure: Failure, path: TreePath) -> Iterator[Issue]:
        yield from _times(failure, parts, step, path)
        properties = property_catalog(aircraft)
        issues = list(
            failure_issues(failure, aircraft, scenario.rate_hz, columns(aircraft), properties, path)
        )
        yield from issues or _met(failure.when, parts, recorded, path)

    tree = _tree(given)
    now = {} if isinstance(tree, dict) and "when" in tree else _now(parts, step)
    return _valid("failure", any_of(TABLE), "inject", tree, now, fits)


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
    """The fault of a sensor, from control step `step` on unless it says when; raises BadInput."""

    def fits(fault: SensorFault, path: TreePath) -> Iterator[Issue]:
        yield from _times(fault, parts, step, path)
        if parts.sensors is None:
            yield Issue(path, "the sensors of this flight are ideal", "a scenario with sensors: mems")

    fault: SensorFault = _valid("fault", any_of(FAULTS), "inject", _tree(given), _now(parts, step), fits)
    return fault


def command_of(given: Command | Mapping[str, Any], parts: Assembly, step: int) -> Command:
    """The command, from control step `step` on unless it says when; raises BadInput."""

    def fits(command: Command, path: TreePath) -> Iterator[Issue]:
        yield from _times(command, parts, step, path)
        if command.model_dump(exclude={"at_s"}, exclude_none=True) == {}:
            yield Issue(path, "asks for nothing", "altitude_m, airspeed_m_s or heading_deg")
        if glides(parts.aircraft) and command.altitude_m is not None:
            yield no_altitude(parts.aircraft, (*path, "altitude_m"))

    return _valid("command", Command, "order", _tree(given), _now(parts, step), fits)


def gust_of(
    given: Gust | WindChange | Mapping[str, Any],
    parts: Assembly,
    step: int,
    wind_m_s: Vector,
) -> tuple[Gust, Vector]:
    """The gust, from control step `step` on unless it says when, and the steady wind after it; raises BadInput.

    Args:
        given: a gust; or a steady wind in place of that so far, which is `wind_m_s` [m/s, north, east, down].
    """
    tree, now = _tree(given), _now(parts, step)
    if isinstance(tree, dict) and "wind_m_s" in tree:
        change = _valid("wind", WindChange, "blow", tree, {})
        return change.gust(now["at_s"], wind_m_s), change.wind_m_s
    gust = _valid("gust", Gust, "blow", tree, now, lambda gust, path: _times(gust, parts, step, path))
    return gust, wind_m_s


def turbulence_of(
    given: TurbulenceChange | Mapping[str, Any], parts: Assembly, step: int
) -> TurbulenceChange:
    """The change of turbulence, from control step `step` on unless it says when; raises BadInput."""

    def fits(change: TurbulenceChange, path: TreePath) -> Iterator[Issue]:
        yield from _times(change, parts, step, path)
        if (model := parts.scenario.atmosphere.model) != "jsbsim":
            what = f"{model} turbulence does not change in flight"
            yield Issue(path, what, "a scenario with model: jsbsim")

    change: TurbulenceChange = _valid(
        "turbulence", TurbulenceChange, "blow", _tree(given), _now(parts, step), fits
    )
    return change


def _now(parts: Assembly, step: int) -> dict[str, float]:
    return {"at_s": step / parts.scenario.rate_hz}


def _tree(given: BaseModel | Mapping[str, Any]) -> Any:
    """What was given as a tree; what is neither a mapping nor a model is refused with its place."""
    if isinstance(given, BaseModel):
        return given.model_dump(exclude_none=True)
    return dict(given) if isinstance(given, Mapping) else given


def _valid(
    key: str,
    kind: Any,
    verb: str,
    tree: Any,
    defaults: Mapping[str, Any],
    fits: Callable[[Any, TreePath], Iterable[Issue]] = lambda *_: (),
) -> Any:
    """A tree as this kind of settings, under a key as in a scenario; raises BadInput with every problem, each with the method that
    was called."""
    fields: dict[str, Any] = {key: (kind, ...)}
    holder = create_model("Given", __base__=Settings, **fields)
    whole = {**defaults, **tree} if isinstance(tree, dict) else tree
    source = Source(verb, {key: whole})
    return getattr(validated(holder, source, lambda made: fits(getattr(made, key), (key,))), key)


def _times(
    one: Failure | Command | Gust | SensorFault | TurbulenceChange, parts: Assembly, step: int, path: TreePath
) -> Iterator[Issue]:
    """Times that are past, or after the end of the flight."""
    rate_hz, end_s, now_s = parts.scenario.rate_hz, parts.scenario.duration_s, step / parts.scenario.rate_hz
    if one.at_s is not None and first_step_at(one.at_s, rate_hz) < step:
        yield Issue((*path, "at_s"), f"{one.at_s:g} s has passed", f"at least {now_s:g}, which is now")
    for key in ("at_s", "until_s"):
        time_s = getattr(one, key, None)
        if time_s is not None and time_s > end_s - (key == "at_s") / rate_hz:
            yield Issue((*path, key), f"{time_s:g} s is after the flight's end at {end_s:g} s")
    until_s = getattr(one, "until_s", None)
    if until_s is not None and until_s <= now_s:
        yield Issue((*path, "until_s"), f"{until_s:g} s has passed", f"more than {now_s:g}")

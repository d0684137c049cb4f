"""Checks of a scenario as a whole: whether its times fit together, and whether aircraft, JSBSim, log and metrics have its names."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping

from testbed.air.config import PARTS
from testbed.aircraft.description import Aircraft
from testbed.common.signals import GROUND_M, first_step_at
from testbed.common.text import with_article
from testbed.failures import Failure, overlaps, same_property
from testbed.inputs.problems import Issue, Problem, TreePath, did_you_mean, one_of, unknown
from testbed.scenario import references
from testbed.scenario.model import Scenario

MAX_STEPS = 20_000_000
"""Most control steps of a flight; the log of more would not fit into memory."""
MAX_PHYSICS_STEPS = 100_000_000
"""Most physics steps of a flight: some ten minutes of computing at 6 us each."""


def check(scenario: Scenario, aircraft: Aircraft | None) -> Iterator[Issue]:
    """Issues that can be found without the simulator; with `aircraft` None, only those of times."""
    yield from _times(scenario)
    yield from _steps(scenario)
    if aircraft is not None:
        yield from _initial(scenario, aircraft)
        yield from _glide(scenario, aircraft)
        yield from _axes(scenario, aircraft)
        yield from _coefficients(scenario, aircraft)
        yield from _noise(scenario)
        yield from _failures(scenario, aircraft)
        if scenario.reference is not None:
            yield from _known(scenario.reference, references.TABLE, "reference", ("reference",))


def unknown_names(
    scenario: Scenario,
    aircraft: Aircraft,
    signals: Collection[str],
    metrics: Collection[str],
    properties: Mapping[str, bool],
    in_flight: Collection[str],
) -> list[Problem]:
    """Unknown names of properties, signals and metrics in failures and requirements, each with its place in the file.

    Args:
        signals: columns of the flight's log.
        in_flight: those that are known while it is flown, for which a failure can wait.
        metrics: names of all metrics.
        properties: those of the loaded JSBSim model, and whether each can be written; not used without failures.
    """
    issues = list(_names(scenario, signals, metrics, in_flight))
    if scenario.failures:
        # Not without them, to save time: a model may have a thousand properties, and each flight is checked.
        writable = {same_property(name): can for name, can in properties.items()}
        for i, failure in enumerate(scenario.failures):
            issues += _unwritable(failure, aircraft, writable, ("failures", i))
    return [scenario.source.problem(*issue) for issue in issues]


def _unwritable(
    failure: Failure, aircraft: Aircraft, writable: Mapping[str, bool], path: TreePath
) -> Iterator[Issue]:
    """Properties that a failure would hold but that the JSBSim model does not have, or that cannot be written."""
    for name in failure.properties(aircraft):
        here = (*path, "set", name) if name in getattr(failure, "set", {}) else path
        can = writable.get(same_property(name))
        if can is None:
            yield Issue(here, f"unknown property {name}", suggestion=did_you_mean(name, writable))
        elif not can:
            yield Issue(here, f"property {name} is read-only", "a writable property")


def failure_issues(
    failure: Failure,
    aircraft: Aircraft,
    rate_hz: float,
    signals: Collection[str],
    properties: Mapping[str, bool],
    path: TreePath,
) -> Iterator[Issue]:
    """What does not fit of one failure alone, whose keys are valid; arguments as of `unknown_names`.

    With an unknown actuator, nothing else can be said.
    """
    issues = list(_unfit(failure, aircraft, rate_hz, path))
    yield from issues
    if any(issue.path[-1] == "actuator" for issue in issues):
        return
    if failure.when is not None:
        yield from _known(failure.when.signal, signals, "signal", (*path, "when", "signal"))
    writable = {same_property(name): can for name, can in properties.items()}
    yield from _unwritable(failure, aircraft, writable, path)


def _names(
    scenario: Scenario, signals: Collection[str], metrics: Collection[str], in_flight: Collection[str]
) -> Iterator[Issue]:
    """Unknown signals in `when` of failures and in requirements, and unknown metrics in requirements."""
    for i, failure in enumerate(scenario.failures):
        if failure.when is not None:
            yield from _known(failure.when.signal, in_flight, "signal", ("failures", i, "when", "signal"))
    for i, requirement in enumerate(scenario.requirements):
        here = ("requirements", i)
        if requirement.metric is not None:
            yield from _known(requirement.metric, metrics, "metric", (*here, "metric"))
        if requirement.signal is not None:
            yield from _known(requirement.signal, signals, "signal", (*here, "signal"))
        if isinstance(requirement.of, str):
            yield from _known(requirement.of, signals, "signal", (*here, "of"))
        if requirement.formula is not None:
            for name in dict.fromkeys(requirement.parsed.columns()):
                yield from _known(name, signals, "signal", (*here, "formula"))


def _known(word: str, known: Collection[str], kind: str, path: TreePath) -> Iterator[Issue]:
    if word not in known:
        yield unknown(path, f"unknown {kind} {word!r}", word, known, own=kind in ("metric", "reference"))


def _times(scenario: Scenario) -> Iterator[Issue]:
    """Times after the end of the flight. What is asked for there would never happen, and nobody would notice."""
    end, before = scenario.duration_s, f"less than duration_s {scenario.duration_s:g}"
    known_rate = scenario.rate_hz > 1 and end * scenario.rate_hz <= MAX_STEPS
    if scenario.commands and scenario.commands[-1].at_s >= end:
        what = f"the last of {len(scenario.commands)} is at {scenario.commands[-1].at_s:g} s"
        yield Issue(("commands",), what, before)
    for path, time in _starts(scenario):
        if time >= end:
            yield Issue(path, f"{time:g} s is not within the flight", before)
        elif known_rate and first_step_at(time, scenario.rate_hz) >= scenario.steps:
            last_s = (scenario.steps - 1) / scenario.rate_hz
            yield Issue(path, f"{time:g} s is after the last control step", f"at most {last_s:g}")
    for path, time in _ends(scenario):
        if time > end:
            yield Issue(path, f"{time:g} s is after the flight's end", f"at most duration_s {end:g}")


def _starts(scenario: Scenario) -> Iterator[tuple[TreePath, float]]:
    """Path and time [s] of everything that begins in the flight, and durations that the flight must be longer than, such as
    what formulas look ahead."""
    air = scenario.atmosphere
    yield from _given(("failures",), scenario.failures, "at_s")
    yield from _given(("sensors", "faults"), scenario.sensors.faults, "at_s")
    yield from _given(("atmosphere", "gusts"), air.gusts, "at_s")
    yield from _given(("atmosphere", "turbulence_changes"), air.turbulence_changes, "at_s")
    if air.noise is not None:
        yield ("atmosphere", "noise", "from_s"), air.noise.from_s
    keys = ("from_s", "settles_by_s", "never_for_longer_than_s")
    yield from _given(("requirements",), scenario.requirements, *keys)
    for i, requirement in enumerate(scenario.requirements):
        if requirement.formula is not None:
            yield ("requirements", i, "formula"), requirement.parsed.horizon_s


def _ends(scenario: Scenario) -> Iterator[tuple[TreePath, float]]:
    """Path and time [s] of everything that ends in the flight."""
    yield from _given(("failures",), scenario.failures, "until_s")
    yield from _given(("sensors", "faults"), scenario.sensors.faults, "until_s")
    yield from _given(("requirements",), scenario.requirements, "until_s")


def _given(path: TreePath, each: Iterable[object], *keys: str) -> Iterator[tuple[TreePath, float]]:
    """Path and value of those keys that are given, of each entry of a list."""
    for i, entry in enumerate(each):
        for key in keys:
            if (time := getattr(entry, key)) is not None:
                yield (*path, i, key), time


def _steps(scenario: Scenario) -> Iterator[Issue]:
    steps = scenario.duration_s * scenario.rate_hz
    physics_steps = scenario.duration_s * scenario.physics_hz
    if steps > MAX_STEPS:
        yield Issue(("duration_s",), f"is {steps:g} control steps", f"at most {MAX_STEPS}")
    elif physics_steps > MAX_PHYSICS_STEPS:
        yield Issue(("duration_s",), f"is {physics_steps:g} physics steps", f"at most {MAX_PHYSICS_STEPS}")
    elif abs(steps - round(steps)) > 1e-6 or round(steps) < 1:
        what = f"{scenario.duration_s:g} s at {scenario.rate_hz} Hz is {steps:g} steps"
        yield Issue(("duration_s",), what, "a whole number of control steps")


def _initial(scenario: Scenario, aircraft: Aircraft) -> Iterator[Issue]:
    envelope, initial = aircraft.envelope, scenario.initial
    if initial.altitude_m < GROUND_M:
        what = f"{initial.altitude_m:g} m is on or below the ground, which is at sea level"
        yield Issue(("initial", "altitude_m"), what, f"at least {GROUND_M:g}")
    for name, low, high in (
        ("airspeed_m_s", envelope.airspeed_min_m_s, envelope.airspeed_max_m_s),
        ("altitude_m", envelope.altitude_min_m, None),
    ):
        value, what = getattr(initial, name), f"is outside {aircraft.name}'s envelope"
        if low is not None and value < low:
            yield Issue(("initial", name), f"{value:g} {what}", f"at least {low:g}")
        if high is not None and value > high:
            yield Issue(("initial", name), f"{value:g} {what}", f"at most {high:g}")


def _glide(scenario: Scenario, aircraft: Aircraft) -> Iterator[Issue]:
    """Altitudes that an aircraft without propulsion is asked to fly to: its reference of altitude is its glide."""
    if not glides(aircraft):
        return
    for i, command in enumerate(scenario.commands):
        if command.altitude_m not in (None, scenario.initial.altitude_m):
            yield no_altitude(aircraft, ("commands", i, "altitude_m"))


def glides(aircraft: Aircraft) -> bool:
    """Whether an aircraft has no propulsion."""
    return all(actuator.kind == "servo" for actuator in aircraft.actuators.values())


def no_altitude(aircraft: Aircraft, path: TreePath) -> Issue:
    """The issue of a commanded altitude for an aircraft that glides."""
    return Issue(
        path, f"{aircraft.name} has no propulsion: it glides, and holds no altitude", "no altitude_m"
    )


def _axes(scenario: Scenario, aircraft: Aircraft) -> Iterator[Issue]:
    for i, axis in enumerate(scenario.controller.released or ()):
        if axis not in aircraft.axes:
            path = ("controller", "released", i)
            yield Issue(path, f"{aircraft.name} has no axis {axis}", one_of(aircraft.axes))


def _coefficients(scenario: Scenario, aircraft: Aircraft) -> Iterator[Issue]:
    """Coefficients in `model_error` that the design model does not have."""
    if scenario.controller.model_error:
        # Imported here, because scipy is slow to import and few scenarios need it.
        from testbed.aircraft.design_model import coefficient_names

        known = coefficient_names(aircraft.actuators)
        for name in scenario.controller.model_error:
            if name not in known:
                path: TreePath = ("controller", "model_error", name)
                close = did_you_mean(name, known)
                expected = "" if close else f"such as {known[0]} or {known[-1]}"
                yield Issue(path, f"unknown coefficient {name!r}", expected, close)


def _noise(scenario: Scenario) -> Iterator[Issue]:
    """More coefficients of a noise than it has samples."""
    noise = scenario.atmosphere.noise
    if noise is None or scenario.rate_hz <= 1:
        return
    first, end = noise.window(scenario.rate_hz, scenario.steps)
    if end > MAX_STEPS:
        until_s = scenario.duration_s if noise.until_s is None else noise.until_s
        what = f"{until_s:g} s is control step {end}"
        yield Issue(("atmosphere", "noise", "until_s"), what, f"at most {MAX_STEPS}")
    for part in PARTS:
        count = len(getattr(noise, part))
        if count > max(end - first, 0) > 0:
            what = f"has {count} coefficients for {end - first} control steps"
            yield Issue(("atmosphere", "noise", part), what, f"at most {end - first}")


def _failures(scenario: Scenario, aircraft: Aircraft) -> Iterator[Issue]:
    known: list[int] = []
    rate_hz = scenario.rate_hz if scenario.rate_hz > 1 else 1e9  # 1 is the stand-in for a refused rate
    for i, failure in enumerate(scenario.failures):
        issues = list(_unfit(failure, aircraft, rate_hz, ("failures", i)))
        yield from issues
        if not any(issue.path[-1] == "actuator" for issue in issues):
            known.append(i)
    for i, j, name in overlaps([scenario.failures[i] for i in known], aircraft):
        what = f"overlaps failures.{known[i]}: both hold {name}"
        yield Issue(("failures", known[j]), what, "time windows that do not overlap")


def _unfit(failure: Failure, aircraft: Aircraft, rate_hz: float, path: TreePath) -> Iterator[Issue]:
    """Whether the aircraft has a failure's actuator, and what does not fit it otherwise."""
    name, here = failure.actuator, (*path, "actuator")
    actuator = aircraft.actuators.get(name or "")
    if name is not None and actuator is None:
        yield unknown(here, f"{aircraft.name} has no actuator {name!r}", name, aircraft.actuators)
    elif actuator is not None and actuator.kind not in failure.kinds:
        what = f"{name} is {with_article(actuator.kind)}, {failure.type} is for another kind"
        yield Issue(here, what, with_article(" or ".join(failure.kinds)))
    else:
        yield from (issue._replace(path=(*path, *issue.path)) for issue in failure.faults(aircraft, rate_hz))

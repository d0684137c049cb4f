"""Judge what a flight has recorded: its log, events, metrics, and verdicts on the requirements."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from testbed.aircraft.description import Aircraft
from testbed.flight.breakage import recovery_events
from testbed.flight.columns import Columns, Recorded, all_columns, stuck_sensors, table
from testbed.flight.events import controller_events, loss_event
from testbed.flight.flight import Flying, Outcome
from testbed.flight.requirements import judge
from testbed.metrics import Readings, adaptation_rates, measure, unjudged
from testbed.parts import digests
from testbed.reporting.flight import ReportedFlight
from testbed.scenario import conditions
from testbed.scenario.model import Scenario
from testbed.simulation.assembly import Assembly


def conclude(parts: Assembly, scenario: Scenario, outcome: Outcome, recorded: Recorded) -> ReportedFlight:
    """The flight, with its log, events, metrics and verdicts on the requirements. The parts can be flown on.

    Args:
        scenario: what was flown: that of the parts, or the part of it that was flown so far.
        recorded: the rows of the control steps flown.
    """
    aircraft, steps = parts.aircraft, len(recorded[0])
    names = all_columns(aircraft, scenario)
    more = parts.sensors.columns(recorded[0]) | stuck_sensors(recorded) if parts.sensors else {}
    if not scenario.atmosphere.is_calm:
        more |= parts.weather.columns(steps)
    data = table(aircraft, scenario.rate_hz, recorded, more.values())
    log, every = dict(zip(names, data, strict=True)), scenario.rate_hz // scenario.log_hz
    actuators = _actuators(aircraft)
    events, warnings = _events(parts, scenario, log, outcome, steps)
    if not parts.flown_by:
        warnings += conditions.warnings(scenario)
    gamma = {} if parts.flown_by else adaptation_rates(scenario, actuators)
    metrics = measure(Readings(log, events, actuators, gamma, outcome is Outcome.completed))
    return ReportedFlight(
        scenario=scenario,
        outcome=outcome,
        end_time_s=steps / scenario.rate_hz,
        columns=names,
        data=np.ascontiguousarray(data[:, ::every]).T,
        events=events,
        metrics=metrics,
        requirements=judge(scenario.requirements, log, metrics, scenario.duration_s, unjudged(log)),
        actuators=actuators,
        warnings=warnings,
        shape=parts.shape,
        flown_by=parts.flown_by,
        flown_by_sha256=parts.flown_by_sha256,
        parts=digests(),
    )


def so_far(
    parts: Assembly, scenario: Scenario, outcome: Outcome, recorded: Recorded, read: Callable[[], object]
) -> Flying:
    """As `conclude`, but only what is told in words. `read` is called whenever some rows have been read."""
    log, logged = (
        Columns(parts.aircraft, scenario.rate_hz, recorded, read, every)
        for every in (1, scenario.rate_hz // scenario.log_hz)
    )
    steps = len(recorded.truth)
    events, _ = _events(parts, scenario, log, outcome, steps)
    return Flying(
        scenario=scenario,
        outcome=outcome,
        end_time_s=steps / scenario.rate_hz,
        columns=tuple(log),
        data=np.zeros((0, len(log))),
        events=events,
        actuators=_actuators(parts.aircraft),
        flown_by=parts.flown_by,
        signals=logged,
    )


def _actuators(aircraft: Aircraft) -> dict[str, dict[str, Any]]:
    return {
        name: actuator.model_dump(include={"kind", "unit", "limits", "scale"})
        for name, actuator in aircraft.actuators.items()
    }


def _events(
    parts: Assembly, scenario: Scenario, log: Mapping[str, np.ndarray], outcome: Outcome, steps: int
) -> tuple[list[dict[str, Any]], list[str]]:
    """Injections, sensor faults, what the controller flagged and released, its reasons, recoveries and the loss of the
    aircraft, in order of time; and a warning for each failure that did not act as asked."""
    survived, actuators = outcome is Outcome.completed, _actuators(parts.aircraft)
    injections, warnings = parts.injector.concluded(scenario.steps)
    faults = parts.sensors.receipts(steps, scenario.steps) if parts.sensors else []
    events = [
        *injections,
        *faults,
        *controller_events(log, tuple(actuators), injections),
        *recovery_events(log, injections, survived),
    ]
    if not survived:
        events.append(loss_event(log, outcome, parts.aircraft.envelope, actuators))
    for step, text in parts.controller.reasons:
        events.append({"time_s": step / parts.scenario.rate_hz, "kind": "diagnosis", "text": text})
    return sorted(events, key=lambda event: event["time_s"]), warnings

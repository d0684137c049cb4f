"""Flights with the paper's law and its estimates measured, for the benchmarks of section 4 of the paper."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from flights import Record, fly_all

from testbed.flight.flight import Flight
from testbed.inputs import overrides
from testbed.inputs.yaml_source import parse
from testbed.scenario.load import Scenario, scenario_from
from testbed.simulation import fly

NAMES = ("left_ruddervator", "right_ruddervator", "left_propeller", "right_propeller")
KINDS = {"tail": slice(0, 2), "propeller": slice(2, 4)}
SETTLED_S, LATE_S = 10.0, 60.0
"""From when on estimates are measured: in flights without a failure, and in those with one, which are of slower laws too."""
DT_S = 0.005
BASE = """
name: section 4
aircraft: vtail
duration_s: 130
rate_hz: 200
seed: 1
initial: {altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
controller:
  {type: adaptive_inversion, preset: paper, gamma: 2, lambda_min: 0.01, lambda_max: 10, ablate: [monitor, jam_test, speed_rule]}
commands:
  - {at_s: 0, altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
sensors: {model: ideal}
"""
"""The paper's law, whose estimates are neither acted upon by the monitor nor bounded where the theory has no bound."""
ALARMS = {"0.6, none": (0.6, 0.0), "0.6, 0.1 s": (0.6, 0.1), "0.7, 0.1 s": (0.7, 0.1)}
"""Threshold over the truth, and persistence [s], for which false alarms are counted in the log."""


def with_values(values: Mapping[str, Any]) -> Scenario:
    """The scenario with these settings by dotted paths."""
    source = parse(BASE, "section 4")
    overrides.apply(source, values)
    return scenario_from(source)


def at_speed(airspeed_m_s: float) -> dict[str, Any]:
    command = {"at_s": 0, "altitude_m": 300, "airspeed_m_s": airspeed_m_s, "heading_deg": 90}
    return {"initial.airspeed_m_s": airspeed_m_s, "commands": [command]}


def fly_and_measure(scenario: Scenario) -> Flight:
    """Fly, and add metrics of each estimate once the flight is settled, until the first failure."""
    flight = fly(scenario)
    log = flight.log
    end = min((failure.at_s or math.inf for failure in scenario.failures), default=math.inf)
    rows = (log.time_s > (LATE_S if scenario.failures else SETTLED_S)) & (log.time_s < end)
    found: dict[str, float] = {}
    for i, name in enumerate(NAMES):
        estimate = log.loc[rows, f"{name}_effectiveness_estimate"].to_numpy()
        found[f"mean_{i}"] = float(estimate.mean())
        found[f"std_{i}"] = float((1.0 / estimate).std() / (1.0 / estimate).mean() ** 2)
        for which, (threshold, persistence_s) in ALARMS.items():
            found[f"alarms_{which}_{i}"] = float(alarms(estimate, threshold, persistence_s))
        if scenario.failures and i == NAMES.index(scenario.failures[0].actuator):
            after = log.loc[log.time_s >= end, f"{name}_effectiveness_estimate"].to_numpy()
            level = 1.0 - (1.0 - scenario.failures[0].value) * (1.0 - math.exp(-1.0))
            found["converged_s"] = 3.0 * (np.argmax(after <= level) + 1) * DT_S
    found["level"] = float(level_until(flight, end))
    flags = [event for event in flight.events if event["kind"] == "detection"]
    found["flagged_s"] = float(flags[0]["delay_s"]) if flags else math.nan
    return replace(flight, metrics={**flight.metrics, **found})


def level_until(flight: Flight, end_s: float) -> bool:
    """Whether a level flight has kept its trim up to this time: within 5 m, 2 m/s and 15 deg of its references."""
    log = flight.log[flight.log.time_s < end_s]
    initial = flight.scenario.initial
    heading = (log.heading_deg - initial.heading_deg + 180.0) % 360.0 - 180.0
    near = (
        (log.altitude_m - initial.altitude_m).abs().max() <= 5.0,
        (log.airspeed_m_s - initial.airspeed_m_s).abs().max() <= 2.0,
        heading.abs().max() <= 15.0,
    )
    return all(near)


def alarms(estimate: np.ndarray, threshold: float, persistence_s: float) -> int:
    """How often the estimate is below the threshold for longer than the persistence."""
    low = np.concatenate([[0], (estimate < threshold).astype(int), [0]])
    starts, ends = np.flatnonzero(np.diff(low) == 1), np.flatnonzero(np.diff(low) == -1)
    return int(((ends - starts) > round(persistence_s / DT_S)).sum())


def measured(flights: Sequence[Mapping[str, Any]], seeds: int, jobs: int | None) -> list[list[Record]]:
    """The records of each setting, flown with each seed."""
    tasks = [(seed, values) for values in flights for seed in range(1, seeds + 1)]
    records = fly_all(BASE, tasks, jobs, "section4_flights:fly_and_measure")
    return [records[k * seeds : (k + 1) * seeds] for k in range(len(flights))]


def over(records: Sequence[Record], metric: str) -> np.ndarray:
    """[flights that were flown to the end, 4] of a metric of each actuator."""
    flown = [record["metrics"] for record in records if record["outcome"] == "completed"]
    return np.array([[metrics[f"{metric}_{i}"] for i in range(4)] for metrics in flown]).reshape(-1, 4)


def error(value: float, predicted: float) -> str:
    """Relative error in percent."""
    if not (math.isfinite(value) and math.isfinite(predicted)):
        return "-"
    return f"{100.0 * (value / predicted - 1.0):+.1f} %"


def head(*titles: str) -> Iterator[str]:
    """The first two lines of a table."""
    yield f"| {' | '.join(titles)} |"
    yield "| --- " * len(titles) + "|"


def row(*cells: object) -> str:
    """A line of a table; numbers with three digits."""
    return f"| {' | '.join(f'{cell:.3g}' if isinstance(cell, float) else str(cell) for cell in cells)} |"

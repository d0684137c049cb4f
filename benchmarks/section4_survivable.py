"""Which error of each coefficient of the design model a law survives, for `section4_noise`."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from flights import Record, fly_all
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import ROWS
from testbed.flight.flight import Flight
from testbed.inputs.problems import BadInput
from testbed.plant.identification import stored
from testbed.scenario.load import Scenario, changed
from testbed.simulation import fly

FLIGHT = """
name: survivable
aircraft: vtail
duration_s: 50
rate_hz: 200
seed: 1
initial: {altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
controller: {type: adaptive_inversion}
commands:
  - {at_s: 0, altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
  - {at_s: 5, airspeed_m_s: 20}
  - {at_s: 10, heading_deg: 120}
  - {at_s: 20, altitude_m: 310}
failures:
  - {type: effectiveness, actuator: left_ruddervator, at_s: 30, value: 0.5}
requirements:
  - {metric: altitude_error_max_m, at_most: 5}
  - {metric: heading_error_max_deg, at_most: 15}
"""
LAWS: Mapping[str, Mapping[str, Any]] = {
    "preset: paper": {"type": "adaptive_inversion", "preset": "paper"},
    "default": {"type": "adaptive_inversion"},
}
FACTORS = (-1.0, 0.0, 0.5, 0.8, 0.9, 1.1, 1.2, 1.5, 2.0, 3.0, 4.0)


def survivable(quick: bool, jobs: int | None, figure: Path) -> Iterator[str]:
    """Fly the map, draw it, and yield the rows of its table."""
    names = coefficients()[:: 8 if quick else 1]
    factors = FACTORS[:: 4 if quick else 1]
    cases = [(law, name, factor) for law in LAWS for name in names for factor in factors]
    flights = [
        (1, {"controller": {**LAWS[law], "model_error": {name: factor}}}) for law, name, factor in cases
    ]
    records = fly_all(FLIGHT, flights, jobs, "section4_survivable:fly_or_refuse")
    held = {case: holds(record) for case, record in zip(cases, records, strict=True)}
    ranges = {
        (law, name): survived([(factor, held[law, name, factor]) for factor in factors])
        for law in LAWS
        for name in names
    }
    draw(names, ranges, figure)
    yield f"| coefficient | {' | '.join(LAWS)} |\n| --- |{' --- |' * len(LAWS)}"
    for name in names:
        cells = [words(*ranges[law, name], factors) for law in LAWS]
        if len(set(cells)) == 1 and ">" in cells[0] and "<" in cells[0]:
            continue  # no factor of any law is too much
        yield f"| `{name}` | {' | '.join(cells)} |"


def coefficients() -> list[str]:
    """The coefficients of the controlled rates that are not zero."""
    model = stored(load_aircraft("vtail"))
    values = np.hstack([np.array(model.derivatives), np.array(model.input_matrix)])
    names = np.array(model.coefficient_names()).reshape(len(ROWS), -1)
    return [
        str(name)
        for name, value in zip(names[:4].ravel(), values[:4].ravel(), strict=True)
        if abs(value) > 1e-6
    ]


def fly_or_refuse(scenario: Scenario) -> Flight:
    """Fly, with the metric `refused`: 1 where the law refuses the erroneous model, and the correct one was flown instead."""
    refused = 0.0
    try:
        flight = fly(scenario)
    except BadInput:
        refused = 1.0
        flight = fly(changed(scenario, {"controller": {"type": "adaptive_inversion"}}))
    return replace(flight, metrics={**flight.metrics, "refused": refused})


def holds(record: Record) -> bool:
    flown = record["outcome"] == "completed" and not record["metrics"]["refused"]
    return flown and bool(record["passed"])


def survived(flown: Sequence[tuple[float, bool]]) -> tuple[float, float]:
    """Lowest and highest factor about 1 between which every factor flown is survivable; 1 itself where its neighbour is not."""
    low, high = 1.0, 1.0
    for factor, held in sorted((f for f in flown if f[0] < 1.0), reverse=True):
        if not held:
            break
        low = factor
    for factor, held in sorted(f for f in flown if f[0] > 1.0):
        if not held:
            break
        high = factor
    return low, high


def words(low: float, high: float, factors: Sequence[float]) -> str:
    below = "< " if math.isclose(low, min(factors)) else ""
    above = "> " if math.isclose(high, max(factors)) else ""
    return f"{below}{low:g} to {above}{high:g}"


def draw(names: Sequence[str], ranges: Mapping[tuple[str, str], tuple[float, float]], path: Path) -> None:
    """A bar for each coefficient and law."""
    figure = Figure(figsize=(7.5, 0.24 * len(names) + 1.4), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots()
    for k, (law, shade) in enumerate(zip(LAWS, ("0.25", "0.65"), strict=True)):
        low, high = np.array([ranges[law, name] for name in names]).T
        rows = np.arange(len(names)) + 0.36 * (k - 0.5)
        axes.barh(rows, high - low, left=low, height=0.32, color=shade, label=law)
    axes.axvline(1.0, color="0.0", linewidth=0.8)
    axes.set_yticks(range(len(names)), names, fontsize=8)
    axes.invert_yaxis()
    axes.set_xlabel("factor on the coefficient of the design model [-]")
    figure.legend(loc="outside upper center", ncols=2)
    figure.savefig(path, dpi=150)

"""A small search, and made-up flights whose failures are known."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from sweep_flights import COLUMNS

from testbed import searching, simulation
from testbed.flight.flight import Flight, Outcome
from testbed.scenario.load import Scenario
from testbed.searches.folder import Store
from testbed.searches.run import Refused, search_in
from testbed.searching import SearchResult
from testbed.sweeps.drawing.builder import Task
from testbed.sweeps.workers.flying import Flown, Job, fly_task

SEARCH = """\
name: gusty
scenario: scenarios/left_tail_fail.yaml
goal: smallest
budget: 300
seed: 3
set:
  duration_s: 1
  failures: [{type: effectiveness, actuator: left_ruddervator, at_s: 0.3, value: 0.2}]
  atmosphere: {wind_m_s: [0, 0, 0]}
  requirements: [{name: held, metric: altitude_error_max_m, at_most: 1}]
vary:
  atmosphere.wind_m_s.0: {normal: [0, 2]}
  atmosphere.wind_m_s.1: {normal: [0, 2]}
"""
REAL = SEARCH.replace("budget: 300", "budget: 24").replace(
    "atmosphere:", "initial: {altitude_m: 300, airspeed_m_s: 18}\n  atmosphere:"
)
"""With few flights, which the simulator flies."""
BETA = 2.5
"""Distance of the failures of `gusty`, in standard deviations of the wind: a wind along (3, 4) that is too strong."""
DESIGN = (0.6 * BETA, 0.8 * BETA)


def written(folder: Path, text: str = SEARCH, name: str = "gusty.yaml") -> Path:
    file = folder / name
    file.write_text(text)
    return file


def gusty(scenario: Scenario) -> Flight:
    """A flight made up from its wind, which is in standard deviations of 2 m/s."""
    north, east, _ = scenario.atmosphere.wind_m_s
    left = BETA - (0.6 * north + 0.8 * east) / 2.0
    rows = 20
    time_s = np.arange(rows) * (scenario.duration_s / rows)
    data = np.column_stack([time_s, *[np.full(rows, 300.0)] * 6])
    verdict = {
        "name": "held",
        "passed": left >= 0,
        "value": 1 - left,
        "limit": "at most 1",
        "margin": left,
        "robustness": left,
    }
    metrics = {"altitude_error_max_m": 1.0 - left, "detection_delay_s": math.nan}
    return Flight(scenario, Outcome.completed, scenario.duration_s, COLUMNS, data, (), metrics, (verdict,))


def simulated(scenario: Scenario) -> Flight:
    """A flight of the simulator."""
    return simulation.fly(scenario)


def slow(scenario: Scenario) -> Flight:
    """The same, taking its time."""
    time.sleep(0.01)
    return gusty(scenario)


def unbreakable(scenario: Scenario) -> Flight:
    """A flight whose requirement is met in any wind."""
    flight = gusty(scenario)
    verdict = {**flight.requirements[0], "passed": True, "margin": 9.0, "robustness": 9.0}
    return Flight(
        scenario, flight.outcome, flight.end_time_s, COLUMNS, flight.data, (), flight.metrics, (verdict,)
    )


def broken_downwards(scenario: Scenario) -> Flight:
    """A flight that does not bear any wind downwards."""
    flight = gusty(scenario)
    down = scenario.atmosphere.wind_m_s[2]
    left = flight.requirements[0]["robustness"] - 5.0 * down
    return replace(
        flight, requirements=({**flight.requirements[0], "passed": left >= 0, "robustness": left},)
    )


def lost(scenario: Scenario) -> Flight:
    """No flight at all."""
    raise ValueError("it went wrong")


def in_its_process(scenario: Scenario) -> Flight:
    """A flight whose metrics tell which process flew it."""
    flight = gusty(scenario)
    return replace(flight, metrics={"process": float(os.getpid())})


class Here:
    """Flies in this process: for tests of what is made of the flights, as starting workers would take longer than all the rest."""

    def __init__(self, job: Job) -> None:
        self.job = job

    def fly(self, tasks: Sequence[Task]) -> Iterator[tuple[Task, Flown]]:
        """The tasks in reverse, as no order is promised."""
        for task in reversed(tasks):
            yield task, fly_task(self.job, task)


def searched(
    file: Path, folder: Path, *settings: str, fly: str = "gusty", resume: bool = False, figures: bool = False
) -> SearchResult:
    """A whole search with made-up flights, flown in this process."""
    plan, _ = searching.prepare(file, folder, settings)
    job = Job(plan.plan.builder, f"search_files:{fly}", "none")
    store = Store(folder, plan, job.fly, resume=resume)
    try:
        found = search_in(plan, store, Here(job))
    except Refused:
        store.remove()
        raise
    finally:
        store.close()
    return SearchResult(folder, searching.finish(plan, folder, found, job, figures=figures))

"""Fly a benchmark into its folder: the flights that are missing, each stored as it finishes."""

from __future__ import annotations

from pathlib import Path

from testbed.studies.benchmark.plan import Benchmark
from testbed.studies.run import Flights, Options, fly_into
from testbed.studies.sweep import Passed


def fly_benchmark(plan: Benchmark, folder: Path, options: Options, *, resume: bool = False) -> Flights:
    """Fly the flights that a folder does not have yet; returns what was flown. Raises BadInput and Stopped as `fly_into`."""
    return fly_into(plan, folder, options, _fly, resume=resume)


def _fly(flights: Flights) -> None:
    passed = Passed(flights.plan)
    flights.words = passed.words
    tasks = (flights.plan.task(k) for k in range(flights.plan.size))
    for task, record in flights.fly(tasks, flights.plan.key):
        passed.add(task.variant, record.passed)

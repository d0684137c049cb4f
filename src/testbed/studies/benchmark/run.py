"""Fly a benchmark into its folder: the flights that are missing, each stored as it finishes."""

from __future__ import annotations

from pathlib import Path

from testbed.studies.benchmark.plan import Benchmark
from testbed.studies.run import Flights, Options, fly_into
from testbed.studies.sweep import fly_shard


def fly_benchmark(plan: Benchmark, folder: Path, options: Options, *, resume: bool = False) -> Flights:
    """Fly the flights that a folder does not have yet, or a shard of them; returns what was flown.

    Raises BadInput and Stopped as `fly_into`.
    """
    return fly_into(plan, folder, options, lambda flights: fly_shard(flights, *options.part), resume=resume)

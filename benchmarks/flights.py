"""Fly variations of one scenario in several processes, for the other benchmarks. `sweeps.workers.flying` describes records."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from typing import Any

from testbed.inputs.yaml_source import parse
from testbed.sweeps.drawing.builder import Builder, Task, Variant
from testbed.sweeps.workers.flying import FLY, Job
from testbed.sweeps.workers.pool import fly_locally

Values = Mapping[str, Any]
"""Settings by dotted paths, as for `--set`."""
Record = dict[str, Any]


def fly_all(
    base: str, flights: Iterable[tuple[int, Values]], jobs: int | None = None, fly: str = FLY
) -> list[Record]:
    """Fly the scenario with the YAML text `base` once for each (seed, values); returns the records in that order.

    Progress is shown on stderr. Exits if a flight has no result.

    Args:
        jobs: processes; one for each core by default.
        fly: the function that flies, as `module:name`.
    """
    tasks = [Task(run, 0, seed, values) for run, (seed, values) in enumerate(flights)]
    job = Job(Builder(parse(base, "campaign"), (Variant("", {}),)), fly, save_logs="none", time_limit_s=600.0)
    records: list[Record] = [{}] * len(tasks)
    for done, (task, flown) in enumerate(fly_locally(job, tasks, jobs), 1):
        records[task.run] = flown.record
        if done % 100 == 0 or done == len(tasks):
            print(f"\r{done} of {len(tasks)} flights", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    broken = [record for record in records if record["outcome"] in ("invalid", "error", "timeout", "crashed")]
    if broken:
        raise SystemExit(f"{len(broken)} flights could not be flown: {broken[0]['reason']}")
    return records

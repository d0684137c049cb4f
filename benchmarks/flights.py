"""Fly variations of one scenario in several processes, for the other benchmarks. `testbed.studies.record` describes records."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from testbed.inputs.yaml_source import parse
from testbed.studies.drawing.builder import Builder, Task, Variant
from testbed.studies.flying.flight import FLY, Job
from testbed.studies.flying.pool import workers
from testbed.studies.record import NO_RESULT

Values = Mapping[str, Any]
"""Settings by dotted paths, as for `--set`."""
Record = dict[str, Any]


def fly_all(
    base: str, flights: Iterable[tuple[int, Values]], jobs: int | None = None, fly: str = FLY
) -> list[Record]:
    """As `fly_each`; returns the records in the order of `flights`."""
    planned = list(flights)
    records: list[Record] = [{}] * len(planned)
    for number, record in fly_each(base, planned, jobs, fly):
        records[number] = record
    return records


def fly_each(
    base: str, flights: Sequence[tuple[int, Values]], jobs: int | None = None, fly: str = FLY
) -> Iterator[tuple[int, Record]]:
    """Fly the scenario with the YAML text `base` once for each (seed, values); yields (number, record) as each has flown.

    Progress is shown on stderr. Exits if a flight has no result.

    Args:
        jobs: processes; one for each core by default.
        fly: the function that flies, as `module:name`.
    """
    tasks = [Task(run, 0, seed, values) for run, (seed, values) in enumerate(flights)]
    job = Job(Builder(parse(base, "campaign"), (Variant("", {}),)), fly, save_logs="none", time_limit_s=600.0)
    with workers(job, jobs) as fly_tasks:
        for done, flown in enumerate(fly_tasks(tasks), 1):
            if flown.record.outcome in NO_RESULT:
                raise SystemExit(f"a flight could not be flown: {flown.record.reason}: {flown.record}")
            if done % 100 == 0 or done == len(tasks):
                print(f"\r{done} of {len(tasks)} flights", end="", file=sys.stderr, flush=True)
            yield flown.record.run, vars(flown.record)
    print(file=sys.stderr)


def coefficient_errors(names: Sequence[str], size: float, seed: int) -> dict[str, float]:
    """Factors 1 + size or 1 - size on the coefficients of a design model; the seed decides each sign."""
    signs = np.random.default_rng([seed, 4]).choice((-1.0, 1.0), len(names))
    return dict(zip(names, (1.0 + size * signs).tolist(), strict=True))

"""Fly a sweep into its folder: fly the missing flights, store each as it finishes, then write the table."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from testbed.common.writing import write
from testbed.inputs.problems import BadInput, Problem
from testbed.studies.drawing.builder import Task
from testbed.studies.flying.pool import Done, FlyAll, default_jobs, workers
from testbed.studies.folder import table
from testbed.studies.folder.begin import SWEEP
from testbed.studies.folder.names import log_file
from testbed.studies.folder.reading import records
from testbed.studies.folder.store import Store
from testbed.studies.plan import Plan
from testbed.studies.progress import Progress
from testbed.studies.record import key_of
from testbed.studies.run import Options, flying_into
from testbed.studies.stopping import Stopping


@dataclass(frozen=True)
class Flights:
    """What one call of `fly_sweep` has flown: number of flights, their simulated time [s], and the wall time [s]."""

    count: int
    flown_s: float
    wall_s: float

    def __str__(self) -> str:
        rate, speed = self.count / self.wall_s, self.flown_s / self.wall_s
        return (
            f"{self.count} flights in {self.wall_s:.1f} s: {rate:.1f} flights/s, {speed:.0f} times real time"
        )


def fly_sweep(plan: Plan, folder: Path, options: Options, *, resume: bool = False) -> Flights:
    """Fly the flights that a folder does not have yet, and write its table; returns what was flown.

    Raises BadInput and Stopped as `run.flying_into`.
    """
    kept = f"of {plan.size} flights are kept, --resume flies the rest"
    with flying_into(folder, SWEEP, plan, plan.tree, options, kept, resume=resume) as (store, fly_all):
        return fly_missing(plan, store, fly_all)


def fly_missing(plan: Plan, store: Store, fly_all: FlyAll) -> Flights:
    """As `fly_sweep`, into an open store, and with anything that flies."""
    begun, count, flown_s = time.perf_counter(), 0, 0.0
    passed, complete = Passed(plan), _CompleteRuns(plan, store)
    complete.advance()
    with Progress(plan.name, plan.size, passed.words, len(store)) as progress:
        for task, flown in fly_all(complete.missing()):
            k, record = plan.number(task), flown.record
            if flown.log:
                write(log_file(store.folder, plan, k), flown.log, within=store.folder)
            store.add(key_of(k), record, flown.history)
            count += 1
            flown_s += record.end_time_s if record.end_time_s > 0.0 else 0.0  # NaN without a result
            passed.add(task.variant, record.passed)
            progress.add()
            if complete.advance():
                break
    runs = complete.stopping.stopped_at
    table.write(plan, lambda: records(plan, store, runs), store.folder)
    return Flights(count, flown_s, max(time.perf_counter() - begun, 1e-9))


class Passed:
    """The share of each variant's flights that passed."""

    def __init__(self, plan: Plan) -> None:
        self._variants = plan.variants
        self._counts = [[0, 0] for _ in plan.variants]

    def add(self, variant: int, passed: bool) -> None:
        """Count one more flight."""
        self._counts[variant][0] += passed
        self._counts[variant][1] += 1

    def words(self) -> str:
        """`adaptive_inversion 93 %  fixed_inversion 12 %`."""
        shares = zip(self._variants, self._counts, strict=True)
        return "  ".join(f"{v.label or 'passed'} {100 * p / n:.0f} %" for v, (p, n) in shares if n)


class _CompleteRuns:
    """Counts the complete runs from run 0 up to the first that is not complete; and lists the flights still to fly.

    The stopping rule gets these runs in order, so its decision does not depend on the order in which flights finish.
    """

    def __init__(self, plan: Plan, store: Store) -> None:
        self._plan, self._store = plan, store
        self._runs = 0
        self.stopping = Stopping(plan.sweep.stop_when, len(plan.variants))

    def advance(self) -> bool:
        """Give the stopping rule every run that has become complete; returns whether the sweep may stop."""
        plan, store, n = self._plan, self._store, len(self._plan.variants)
        if plan.sweep.stop_when is None:
            return False
        while self.stopping.stopped_at is None and self._runs < plan.runs:
            keys = [key_of(k) for k in range(self._runs * n, (self._runs + 1) * n)]
            if not all(key in store for key in keys):
                break
            self.stopping.add([store.record(key).passed for key in keys])
            self._runs += 1
        return self.stopping.stopped_at is not None

    def missing(self) -> Iterator[Task]:
        """Flights still to fly, in order."""
        for k in range(self._plan.size):
            if self.stopping.stopped_at is not None:
                return
            if key_of(k) not in self._store:
                yield self._plan.task(k)


def fly_only(plan: Plan, run: int, options: Options, variant: int | None = None) -> list[Done]:
    """Fly all variants of one run, or one of them; returns them in order. Raises BadInput when there is no such run."""
    if not 0 <= run < plan.runs:
        raise BadInput([Problem(f"there is no run {run}", "--only", expected=f"0 to {plan.runs - 1}")])
    n = len(plan.variants)
    chosen = range(n) if variant is None else [variant]
    tasks = [plan.task(run * n + number) for number in chosen]
    with workers(options.job(plan), min(len(tasks), options.jobs or default_jobs())) as fly_all:
        return sorted(fly_all(tasks), key=lambda done: done[0].variant)

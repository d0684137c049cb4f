"""Fly a sweep into its folder: fly the missing flights, store each as it finishes, then write the table."""

from __future__ import annotations

import itertools
import time
from collections.abc import Generator, Iterator
from contextlib import closing, suppress
from dataclasses import dataclass
from pathlib import Path

from testbed.inputs.problems import BadInput, Problem
from testbed.sweeps.drawing.builder import Task
from testbed.sweeps.folder import results
from testbed.sweeps.folder.store import Store
from testbed.sweeps.plan import Plan
from testbed.sweeps.progress import Progress
from testbed.sweeps.stopping import Stopping
from testbed.sweeps.workers import cluster, pool
from testbed.sweeps.workers.flying import Fly, Job, fly_reference


class Stopped(Exception):
    """A sweep or a search ended early. The finished flights are kept, and --resume flies the rest."""


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


@dataclass(frozen=True)
class Options:
    """How to fly: number of processes or a cluster, logs to keep, function that flies. Only `fly` can change the results."""

    jobs: int | None = None
    cluster: str | None = None
    save_logs: str = "failed"
    fly: Fly | None = None

    def job(self, plan: Plan) -> Job:
        """The job that workers need to fly this plan; raises BadInput when it cannot be flown so."""
        if self.fly is not None and plan.builder.own:
            what = "flies the scenario in its own way, and so no controller of one's own"
            raise BadInput([Problem(what, path="fly", expected="no fly, or no controllers")])
        return Job(plan.builder, fly_reference(self.fly), self.save_logs, plan.sweep.time_limit_s)


def fly_sweep(plan: Plan, folder: Path, options: Options, *, resume: bool = False) -> Flights:
    """Fly the flights that a folder does not have yet, and write its table; returns what was flown.

    Raises BadInput when it cannot begin, Stopped when it ended early: Ctrl-C, disk full, cluster gone. If no flight had finished
    then, a new folder is removed.
    """
    job = options.job(plan)
    if options.cluster is not None:
        cluster.refuse_dead(options.cluster)  # before the folder is made
    store = _store(folder, plan, job, resume)
    try:
        flights, runs = _fly_missing(store, job, options)
        results.write(plan, lambda: (record for _, record in store.records(runs)), folder)
        return flights
    except KeyboardInterrupt:
        raise Stopped(_kept(store, "interrupted")) from None
    except OSError as error:
        raise Stopped(_kept(store, f"cannot write: {error.strerror or error}")) from None
    except BadInput as error:
        raise Stopped(_kept(store, str(error))) from None
    finally:
        with suppress(OSError):  # a full disk has been reported above
            store.close()
        store.remove_if_empty()


def _store(folder: Path, plan: Plan, job: Job, resume: bool) -> Store:
    """The folder, open; raises BadInput when it cannot be written."""
    try:
        return Store(folder, plan, job.fly, resume=resume)
    except OSError as error:
        raise BadInput([Problem(f"cannot be written: {error.strerror or error}", str(folder))]) from None


def _kept(store: Store, why: str) -> str:
    """Why a sweep ended early, and what is there of it."""
    if store.is_for_nothing:
        return f"{store.folder}: {why}; no flight had finished, and nothing is kept"
    return (
        f"{store.folder}: {why}; {len(store)} of {store.plan.size} flights are kept, --resume flies the rest"
    )


def _fly_missing(store: Store, job: Job, options: Options) -> tuple[Flights, int]:
    """Fly until no flight is missing or `stop_when` holds; returns what was flown, and the number of runs for the table."""
    plan, complete = store.plan, _CompleteRuns(store)
    begun, count, flown_s = time.perf_counter(), 0, 0.0
    complete.advance()
    with Progress(plan, len(store)) as progress:
        flying = _flying(job, complete, options)
        with closing(flying):
            for task, flown in flying:
                store.add(task.run * len(plan.variants) + task.variant, flown)
                count += 1
                flown_s += flown.record.get("end_time_s", 0.0)
                progress.add(task.variant, flown.record["passed"])
                if complete.advance():
                    break
    runs = complete.stopping.stopped_at or plan.runs
    return Flights(count, flown_s, max(time.perf_counter() - begun, 1e-9)), runs


def _flying(job: Job, complete: _CompleteRuns, options: Options) -> Generator[pool.Done, None, None]:
    missing = complete.missing()
    first = next(missing, None)
    if first is None:
        return  # nothing to fly: start no process
    tasks = itertools.chain([first], missing)
    if options.cluster is not None:
        yield from cluster.fly_on_cluster(job, tasks, options.cluster)
    else:
        yield from pool.fly_locally(job, tasks, options.jobs)


class _CompleteRuns:
    """Counts the complete runs from run 0 up to the first that is not complete; and lists the flights still to fly.

    The stopping rule gets these runs in order, so its decision does not depend on the order in which flights finish.
    """

    def __init__(self, store: Store) -> None:
        self._store = store
        self._runs = 0
        self.stopping = Stopping(store.plan.sweep.stop_when, len(store.plan.variants))

    def advance(self) -> bool:
        """Give the stopping rule every run that has become complete; returns whether the sweep may stop."""
        store, n = self._store, len(self._store.plan.variants)
        while self.stopping.stopped_at is None and self._runs < store.plan.runs:
            flights = range(self._runs * n, (self._runs + 1) * n)
            if not all(k in store for k in flights):
                break
            if store.plan.sweep.stop_when is not None:
                self.stopping.add([bool(store.record(k)["passed"]) for k in flights])
            self._runs += 1
        return self.stopping.stopped_at is not None

    def missing(self) -> Iterator[Task]:
        """Flights still to fly, in order."""
        store = self._store
        for k in range(store.plan.size):
            if self.stopping.stopped_at is not None:
                return
            if k not in store:
                yield store.plan.task(k)


def fly_only(plan: Plan, run: int, options: Options, variant: int | None = None) -> list[pool.Done]:
    """Fly all variants of one run, or one of them; returns them in order. Raises BadInput when there is no such run."""
    if not 0 <= run < plan.runs:
        raise BadInput([Problem(f"there is no run {run}", "--only", expected=f"0 to {plan.runs - 1}")])
    n = len(plan.variants)
    chosen = range(n) if variant is None else [variant]
    tasks = [plan.task(run * n + number) for number in chosen]
    flying = pool.fly_locally(options.job(plan), tasks, min(len(tasks), options.jobs or pool.default_jobs()))
    with closing(flying):
        return sorted(flying, key=lambda done: done[0].variant)

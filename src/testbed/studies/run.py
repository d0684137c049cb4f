"""Flying any kind of study into its folder: how to fly, which shard K/N, what is stored, the bar on stderr, how it ends early.

A sweep flies the missing flights of its list, up to the run at which it may stop by its rule; then it writes its table.
"""

from __future__ import annotations

import os
import re
import shutil
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from itertools import takewhile
from operator import attrgetter
from pathlib import Path
from typing import Any

from testbed.common.statistics import proportion
from testbed.common.text import printable
from testbed.common.writing import write
from testbed.inputs.problems import BadInput, Problem
from testbed.reporting.words import count
from testbed.studies.drawing.builder import Task
from testbed.studies.flying.flight import SAVE_LOGS, Fly, Job, fly_reference
from testbed.studies.flying.pool import MOST_JOBS, FlyAll, Workers, default_jobs, refuse_dead, workers
from testbed.studies.folder import table
from testbed.studies.folder.begin import begin, remove_results
from testbed.studies.folder.logs import log_file
from testbed.studies.folder.store import Store
from testbed.studies.folder.table import records
from testbed.studies.model import StopWhen
from testbed.studies.plan import Plan
from testbed.studies.record import Record, key_of

_LONGEST_WAIT_S = 86400.0


class Stopped(Exception):
    """A study ended early. The finished flights are kept, and --resume flies the rest."""


class Refused(BadInput):
    """A study of which the first flights show that it is none: it leaves no folder."""


@dataclass(frozen=True)
class Options:
    """How to fly: number of processes or a cluster and the wait for it, logs to keep, what flies one flight and many, which part.

    Only `fly` can change the results, and `mixed`, which allows workers of other environments, their last digits. Raises BadInput
    when one is out of range.
    """

    jobs: int | None = None
    cluster: str | None = None
    save_logs: str = "failed"
    fly: Fly | None = None
    workers: Workers = workers
    shard: str | None = None
    cluster_wait_s: float | None = None
    mixed: bool = False

    @property
    def part(self) -> tuple[int, int]:
        """(k, n) of `shard` K/N: every n-th run is flown, from the k-th on, with k from 0. (0, 1) is all of them."""
        found = re.fullmatch(r"([1-9]\d{0,5})/([1-9]\d{0,5})", self.shard or "1/1")
        return (int(found[1]) - 1, int(found[2])) if found else (0, 0)

    def __post_init__(self) -> None:
        problems = []
        if self.jobs is not None and not 1 <= self.jobs <= MOST_JOBS:
            limit = "at least 1" if self.jobs < 1 else f"at most {MOST_JOBS}"
            problems.append(Problem(f"is {self.jobs}", "--jobs", expected=limit))
        if self.save_logs not in SAVE_LOGS:
            problems.append(Problem(f"is {self.save_logs!r}", "--save-logs", expected="none, failed or all"))
        wait_s = self.cluster_wait_s
        if wait_s is not None and not (self.cluster and 0.0 < wait_s <= _LONGEST_WAIT_S):
            expected = f"above 0 to {_LONGEST_WAIT_S:g} s, beside --cluster"
            problems.append(Problem(f"is {wait_s:g}", "--cluster-wait", expected=expected))
        if self.part[0] >= self.part[1]:
            problems.append(Problem(f"is {self.shard!r}", "--shard", expected="K/N, K from 1 to N"))
        if problems:
            raise BadInput(problems)

    def job(self, plan: Plan) -> Job:
        """The job that workers need to fly this plan; raises BadInput when it cannot be flown so."""
        if self.fly is not None and plan.builder.own:
            what = "flies the scenario in its own way, and so no controller of one's own"
            raise BadInput([Problem(what, path="fly", expected="no fly, or no controllers")])
        limit_s = plan.study.time_limit_s
        return Job(plan.builder, fly_reference(self.fly), self.save_logs, limit_s, mixed=self.mixed)


class Flights:
    """Flies the flights of a study that its store does not have, and stores each as it finishes.

    Attributes:
        store: the finished flights.
        job: with which each can be flown again.
        found: what the study found by them, in the end.
        words: what is said of them below the bar.
        count: number of flights flown so far; `str` also says how fast.
    """

    def __init__(self, plan: Plan, job: Job, store: Store, fly_all: FlyAll) -> None:
        self.plan, self.job, self.store, self._fly_all = plan, job, store, fly_all
        self.found: Any = None
        self.words: Callable[[], str] = str
        self.count, self._flown_s = 0, 0.0
        self._begun = self._ended = time.perf_counter()
        self.shown: Callable[[], None] = lambda: None

    def fly(self, tasks: Iterable[Task], key: Callable[[Task], bytes]) -> Iterator[Record]:
        """Fly those of the tasks that are missing; yields each when it is stored under its key, in any order."""
        folder = self.store.folder
        for flown in self._fly_all(task for task in tasks if key(task) not in self.store):
            record = flown.record
            if not self.count:
                remove_results(folder)  # which are those of fewer flights
            if flown.log:
                label = self.plan.variants[record.variant].label
                write(log_file(folder, record.run, label), flown.log, within=folder)
            self.store.add(key(record), record, flown.history if self.plan.histories else b"")
            self.count, self._ended = self.count + 1, time.perf_counter()
            self._flown_s += max(0.0, record.end_time_s)  # NaN without a result
            self.shown()
            yield record

    def __str__(self) -> str:
        if not self.count:
            return "no flight was missing"
        wall_s = max(self._ended - self._begun, 1e-9)
        rate, speed = self.count / wall_s, self._flown_s / wall_s
        many = f"{rate:.1f} flights/s" if rate >= 1.0 else f"{1.0 / rate:.1f} s a flight"
        return f"{count(self.count, 'flight')} in {wall_s:.1f} s: {many}, {speed:.0f} times real time"


def fly_into(
    plan: Plan, folder: Path, options: Options, fly: Callable[[Flights], Any], *, resume: bool
) -> Flights:
    """The flights of a study in its folder, and what `fly` finds by them.

    Raises BadInput when it cannot begin, Stopped when it ended early: Ctrl-C, disk full, cluster gone. If no flight had
    finished then, a new folder is removed.
    """
    job = options.job(plan)
    if options.cluster is not None:
        refuse_dead(options.cluster, options.cluster_wait_s)  # before the folder is made
    new = not os.path.lexists(folder)
    store = begin(folder, plan, job.fly, resume=resume, mixed=options.mixed)
    job = replace(job, environment=store.inputs)
    useless = False
    try:
        with options.workers(job, options.jobs, options.cluster) as fly_all:
            flights = Flights(plan, job, store, fly_all)
            with progress(plan.name, plan.size, lambda: flights.words(), len(store)) as flights.shown:
                flights.found = fly(flights)
                return flights
    except Refused:
        useless = new
        raise
    except (KeyboardInterrupt, OSError, BadInput) as error:
        useless = new and not len(store)
        of = f"flights of shard {options.shard}" if options.shard else f"of {plan.at_most}{plan.size} flights"
        kept = f"{len(store)} {of} are kept, --resume flies the rest"
        kept = "no flight had finished, and nothing is kept" if useless else kept
        raise Stopped(f"{folder}: {_why(error)}; {kept}") from None
    finally:
        with suppress(OSError):  # a full disk has been reported above
            store.close()
        if useless:
            shutil.rmtree(folder, ignore_errors=True)


def _why(error: BaseException) -> str:
    if isinstance(error, OSError):
        return f"cannot write: {error.strerror or error}"
    return "interrupted" if isinstance(error, KeyboardInterrupt) else str(error)


@contextmanager
def progress(name: str, total: int, so_far: Callable[[], str], done: int = 0) -> Iterator[Callable[[], None]]:
    """Shows the number of finished flights, flights per second, the time left, and the words of `so_far`, uncut.

    Yields what is to be called after each flight.
    """
    from rich.console import Console

    console = Console(file=sys.__stderr__)  # not sys.stderr: commands let no escape sequence pass there
    if not console.is_terminal:
        yield lambda: None
        return
    with bar(console, lambda: printable(so_far())) as shown:
        task = shown.add_task(printable(name), total=total, completed=done, rate="")

        def add() -> None:
            speed = shown.tasks[task].speed
            shown.update(task, advance=1, rate=f"{speed:.1f} flights/s" if speed else "")

        yield add


def bar(console: Any, below: Callable[[], str]) -> Any:
    """A bar of rich with a text below it. The sweep's name and the bar itself give way where the terminal is narrow."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
    from rich.table import Column
    from rich.text import Text

    class Bar(Progress):
        def get_renderables(self) -> Iterator[Any]:
            yield from super().get_renderables()
            yield Text(below(), overflow="fold")

    def fixed() -> Column:
        return Column(no_wrap=True)

    name = Column(no_wrap=True, overflow="ellipsis", max_width=max(console.width - 52, 8))
    return Bar(
        TextColumn("{task.description}", markup=False, table_column=name),
        BarColumn(bar_width=None if console.width < 100 else 40, table_column=Column(min_width=4)),
        MofNCompleteColumn(table_column=fixed()), TextColumn("{task.fields[rate]}", table_column=fixed()),
        TimeRemainingColumn(table_column=fixed()), console=console, transient=True,
    )  # fmt: skip


def fly_sweep(plan: Plan, folder: Path, options: Options, *, resume: bool = False) -> Flights:
    """Fly the flights of a plan that its folder does not have yet, and write its table; returns what was flown.

    With `options.shard` it flies every n-th run and writes no table: the folder is that of an unfinished sweep, which
    `testbed.merge` joins with the others. Raises BadInput and Stopped as `fly_into`.
    """
    if options.shard is None:
        return fly_into(plan, folder, options, fly_missing, resume=resume)
    if plan.stop_when is not None:
        what = "cannot stop by itself, as each shard knows only its own flights"
        raise BadInput([Problem(what, "--shard", expected="a sweep without stop_when")])
    return fly_part(plan, folder, options, resume=resume)


def fly_part(plan: Plan, folder: Path, options: Options, *, resume: bool = False) -> Flights:
    """As `fly_sweep`, without a table: every n-th run of `options.shard`, by default all."""
    k, n = options.part

    def fly(flights: Flights) -> None:
        passed = Passed(plan)
        flights.words = passed.words
        tasks = (plan.task(number) for number in range(plan.size) if number // len(plan.variants) % n == k)
        for record in flights.fly(tasks, plan.key):
            passed.add(record.variant, record.passed)

    return fly_into(plan, folder, options, fly, resume=resume)


def fly_missing(flights: Flights) -> None:
    """As `fly_sweep`, with what flies into an open folder."""
    plan, store = flights.plan, flights.store
    passed, stopping = Passed(plan), Stopping(plan.stop_when, len(plan.variants))
    flights.words = passed.words
    stopping.advance(plan, store)
    numbers = takewhile(lambda _: stopping.stopped_at is None, range(plan.size))
    for record in flights.fly(map(plan.task, numbers), plan.key):
        passed.add(record.variant, record.passed)
        if stopping.advance(plan, store):
            break
    table.write(plan, lambda: records(plan, store, stopping.stopped_at), store.folder)


class Passed:
    """The share that passed of each variant's flights that were judged."""

    def __init__(self, plan: Plan) -> None:
        self._variants = plan.variants
        self._counts = [[0, 0] for _ in plan.variants]

    def add(self, variant: int, passed: bool | None) -> None:
        """Count one more flight."""
        self._counts[variant][0] += bool(passed)
        self._counts[variant][1] += passed is not None

    def words(self) -> str:
        """`adaptive_inversion 93 %  fixed_inversion 12 %`."""
        shares = zip(self._variants, self._counts, strict=True)
        return "  ".join(f"{v.label or 'passed'} {100 * p / n:.0f} %" for v, (p, n) in shares if n)


def fly_only(plan: Plan, run: int, job: Job, jobs: int | None, variant: int | None = None) -> list[Record]:
    """Fly all variants of one run, or one of them; returns their records in order. Raises BadInput when there is no such run."""
    if not 0 <= run < plan.runs:
        raise BadInput([Problem(f"there is no run {run}", "--only", expected=f"0 to {plan.runs - 1}")])
    n = len(plan.variants)
    chosen = range(n) if variant is None else [variant]
    tasks = [plan.task(run * n + number) for number in chosen]
    with workers(job, min(len(tasks), jobs or default_jobs())) as fly_all:
        return sorted((flown.record for flown in fly_all(tasks)), key=attrgetter("variant"))


class Stopping:
    """Takes the verdicts of each run, in the order of runs; `stopped_at` is the number of runs at which the rule held, or None.

    The rule is checked after every run up to 100, then each time the number of runs has grown by 1 %. It uses exact
    intervals (Clopper-Pearson): repeated checking makes any interval too narrow, and the exact ones tend to be too wide.
    """

    def __init__(self, rule: StopWhen | None, variants: int) -> None:
        self._rule = rule
        self._counts = [(0, 0)] * variants  # passed, judged
        self._next = 1
        self.runs = 0
        self.stopped_at: int | None = None

    def advance(self, plan: Plan, store: Store) -> bool:
        """Add the runs that have become complete, in order up to the first that is not; returns whether to stop.

        Whether it stops does not depend on the order in which flights finish.
        """
        n = len(plan.variants)
        while self._rule and self.stopped_at is None and self.runs < plan.runs:
            keys = [key_of(self.runs * n + variant) for variant in range(n)]
            if not all(key in store for key in keys):
                break
            self.add([store.record(key).passed for key in keys])
        return self.stopped_at is not None

    def add(self, passed: Sequence[bool | None]) -> bool:
        """Count one more run, with a verdict for each variant, None if it was not judged; returns whether to stop."""
        if self.stopped_at is not None or self._rule is None:
            return self.stopped_at is not None
        self.runs += 1
        self._counts = [
            (n + bool(p), judged + (p is not None))
            for (n, judged), p in zip(self._counts, passed, strict=True)
        ]
        if self.runs >= self._next:
            self._next = self.runs + max(1, self.runs // 100)
            if all(self._close(*counts) for counts in self._counts):
                self.stopped_at = self.runs
        return self.stopped_at is not None

    def _close(self, passed: int, judged: int) -> bool:
        assert self._rule is not None
        known = proportion(passed, judged, self._rule.confidence, method="exact")
        return (known.high - known.low) / 2.0 <= self._rule.half_width

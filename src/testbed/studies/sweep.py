"""Fly a sweep: the missing flights of its list, up to the run at which it may stop by its rule; then its table."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile
from operator import attrgetter
from pathlib import Path

from testbed.common.statistics import proportion
from testbed.inputs.problems import BadInput, Problem
from testbed.studies.flying.flight import Job
from testbed.studies.flying.pool import default_jobs, workers
from testbed.studies.folder import table
from testbed.studies.folder.store import Store
from testbed.studies.folder.table import records
from testbed.studies.model import StopWhen
from testbed.studies.plan import Plan
from testbed.studies.record import Record, key_of
from testbed.studies.run import Flights, Options, fly_into


def fly_sweep(plan: Plan, folder: Path, options: Options, *, resume: bool = False) -> Flights:
    """Fly the flights of a plan that its folder does not have yet, and write its table; returns what was flown.

    With `options.shard` it flies every n-th run and writes no table: the folder is that of an unfinished sweep, which
    `testbed.merge` joins with the others. Raises BadInput and Stopped as `run.fly_into`.
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

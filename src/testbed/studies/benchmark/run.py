"""Fly a benchmark into its folder: the flights that are missing, each stored as it finishes."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from testbed.studies.benchmark.plan import Benchmark
from testbed.studies.folder.begin import Kind
from testbed.studies.progress import Progress
from testbed.studies.record import key_of
from testbed.studies.run import Options, flying_into

BENCHMARK = Kind("benchmark", ("draws",))


def fly_benchmark(plan: Benchmark, folder: Path, options: Options, *, resume: bool = False) -> int:
    """Fly the flights that a folder does not have yet; returns how many. Raises BadInput and Stopped as `flying_into`."""
    kept = f"of {plan.size} flights are kept, --resume flies the rest"
    with flying_into(folder, BENCHMARK, plan, plan.tree, options, kept, resume=resume) as (store, fly_all):
        missing = (plan.task(k) for k in range(plan.size) if key_of(k) not in store)
        held, count = Counter[int](), Counter[int]()

        def words() -> str:
            return "  ".join(f"{name} {held[j]}/{count[j]}" for j, name in enumerate(plan.labels) if count[j])

        with Progress(plan.name, plan.size, words, len(store)) as progress:
            for task, flown in fly_all(missing):
                store.add(key_of(plan.number(task)), flown.record, flown.history)
                held[task.variant] += flown.record.passed
                count[task.variant] += 1
                progress.add()
    return count.total()

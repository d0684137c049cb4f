"""A small search, and a whole one with made-up flights."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from testbed import searching
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


def written(folder: Path, text: str = SEARCH, name: str = "gusty.yaml") -> Path:
    file = folder / name
    file.write_text(text)
    return file


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
    job = Job(plan.plan.builder, f"search_flights:{fly}", "none")
    store = Store(folder, plan, job.fly, resume=resume)
    try:
        found = search_in(plan, store, Here(job))
    except Refused:
        store.remove()
        raise
    finally:
        store.close()
    return SearchResult(folder, searching.finish(plan, folder, found, job, figures=figures))

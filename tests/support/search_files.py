"""A small search, and a whole one with made-up flights."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import search_flights

from testbed.api import search
from testbed.api.search import SearchResult
from testbed.studies.flying.flight import Job
from testbed.studies.flying.pool import FlyAll, serial
from testbed.studies.run import Options
from testbed.studies.search.plan import SearchPlan
from testbed.studies.search.run import run_search

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


@contextmanager
def backwards(job: Job, jobs: int | None = None, cluster: str | None = None) -> Iterator[FlyAll]:
    """Flies in this process, the tasks in reverse, as no order is promised."""
    with serial(job) as fly_all:
        yield lambda tasks: fly_all(reversed(list(tasks)))


def searched(
    file: Path, folder: Path, *settings: str, fly: str = "gusty", resume: bool = False, figures: bool = False
) -> SearchResult:
    """A whole search with made-up flights, flown in this process."""
    plan, _ = search.prepare(file, folder, settings)
    options = Options(save_logs="none", fly=getattr(search_flights, fly), workers=backwards)
    return search_here(plan, folder, options, resume=resume, figures=figures)


def search_here(
    plan: SearchPlan, folder: Path, options: Options, *, resume: bool = False, figures: bool = False
) -> SearchResult:
    """A whole search, as `testbed.search`."""
    flights = run_search(plan, folder, options, resume=resume)
    return SearchResult(folder, search.finish(plan, folder, flights, figures=figures))

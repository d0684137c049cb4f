"""What the functions for sweeps and for searches are given alike."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from testbed.inputs.overrides import Option
from testbed.inputs.problems import BadInput, Problem
from testbed.studies.flying.flight import SAVE_LOGS, Fly
from testbed.studies.flying.pool import MOST_JOBS
from testbed.studies.run import Options


def changes(settings: Sequence[str], by_path: Mapping[str, Any] | None) -> list[str]:
    """Changes as `--set` takes them, each KEY=VALUE: those given so, and those by dotted paths."""
    return [*settings, *(f"{path}={json.dumps(value)}" for path, value in (by_path or {}).items())]


def own_options(**given: int | None) -> list[Option]:
    """Keys of a file that have an option of their own, each KEY=VALUE; without those that are None."""
    return [Option(f"{name}={value}") for name, value in given.items() if value is not None]


def checked_options(
    jobs: int | None, cluster: str | None, save_logs: str = "none", fly: Fly | None = None
) -> Options:
    """How to fly; raises BadInput when an option is out of range."""
    problems = []
    if jobs is not None and not 1 <= jobs <= MOST_JOBS:
        limit = "at least 1" if jobs < 1 else f"at most {MOST_JOBS}"
        problems.append(Problem(f"is {jobs}", "--jobs", expected=limit))
    if save_logs not in SAVE_LOGS:
        problems.append(Problem(f"is {save_logs!r}", "--save-logs", expected="none, failed or all"))
    if problems:
        raise BadInput(problems)
    return Options(jobs, cluster, save_logs, fly)

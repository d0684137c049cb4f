"""Fly one flight of a study, in a worker process, and make the record that is kept of it."""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pkgutil import resolve_name
from typing import Any

from testbed.common.arithmetic import environment
from testbed.flight.flight import Flight
from testbed.inputs.problems import BadInput, Problem
from testbed.parts import Parts, in_use
from testbed.scenario.load import Scenario
from testbed.studies.drawing.builder import Builder, Task
from testbed.studies.folder import logs
from testbed.studies.record import Flown, Record

Fly = Callable[[Scenario], Flight]
FLY = "testbed.simulation:fly"
SAVE_LOGS = ("none", "failed", "all")
_LONGEST_REASON = 300
"""Longer reasons are cut to this length [characters]."""


@dataclass(frozen=True)
class Job:
    """What a worker needs to fly any flight of a study."""

    builder: Builder
    fly: str = FLY
    """Function that flies, as `module:name`."""
    save_logs: str = "failed"
    time_limit_s: float = 300.0
    environment: Mapping[str, Any] = field(default_factory=environment)
    """The `environment` that the study was begun in."""
    mixed: bool = False
    """Whether a worker may fly in another one, which its records then say."""
    parts: tuple[Parts, ...] = field(default_factory=in_use)
    search_path: tuple[str, ...] = field(default_factory=lambda: tuple(sys.path))


def fly_reference(fly: Fly | None) -> str:
    """A function as `module:name`, for worker processes to import; raises BadInput if they could not import it."""
    if fly is None:
        return FLY
    module, name = getattr(fly, "__module__", ""), getattr(fly, "__qualname__", "<")
    if "<" in name or module == "__main__":
        what = f"the function that flies, {name}, cannot be imported by a worker"
        raise BadInput([Problem(what, expected="a function at the top of an importable module")])
    return f"{module}:{name}"


def flight_of(job: Job, task: Task) -> Flight:
    """Fly one task; raises BadInput, or whatever the user's function or controller raises."""
    scenario = job.builder.scenario(task)
    own = job.builder.own_controller(task)
    if own is None:
        return resolve_name(job.fly)(scenario)
    from testbed.simulation import fly

    return fly(scenario, own.load())


def fly_task(job: Job, task: Task) -> Flown:
    """Fly one task; an exception becomes a record with the reason."""
    try:
        return _flown(job, task, flight_of(job, task))
    except BadInput as error:
        return not_flown(task, "invalid", "; ".join(_place_free(p) for p in error.problems))
    except Exception as error:
        return not_flown(task, "error", f"{type(error).__name__}: {error}")


def not_flown(task: Task, outcome: str, reason: str) -> Flown:
    """The record of a flight that has no result, which counts as not passed."""
    # Memory addresses differ between processes.
    reason = re.sub(r"0x[0-9a-f]{6,}", "0x...", " ".join(reason.split()))[:_LONGEST_REASON]
    return Flown(Record(**vars(task), outcome=outcome, passed=False, reason=reason))


def _flown(job: Job, task: Task, flight: Flight) -> Flown:
    record = Record(
        **vars(task),
        outcome=str(flight.outcome),
        passed=flight.passed,
        end_time_s=float(flight.end_time_s),
        robustness=float(flight.robustness),
        metrics={name: float(value) for name, value in flight.metrics.items()},
        requirements=tuple(
            (r["passed"], _number(r["value"]), _number(r.get("robustness"))) for r in flight.requirements
        ),
    )
    wanted = job.save_logs == "all" or (job.save_logs == "failed" and flight.passed is False)
    return Flown(record, logs.history(flight), logs.encode(flight) if wanted else b"")


def _number(value: Any) -> float:
    return math.nan if value is None else float(value)


def _place_free(problem: Problem) -> str:
    """A problem as text without file and line, which may differ from machine to machine."""
    return str(Problem(problem.what, "", None, problem.path, problem.expected, problem.suggestion))

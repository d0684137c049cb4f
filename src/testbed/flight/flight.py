"""A finished flight: how it ended, its log, events, metrics and verdicts."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from testbed.aircraft.shape import Shape
from testbed.common.files import plain
from testbed.flight import columns
from testbed.scenario.load import Scenario

if TYPE_CHECKING:
    import pandas as pd


class Outcome(StrEnum):
    """How a flight ended. `sentence` is the predicate of a sentence about the aircraft."""

    completed = "completed", "flew to the end"
    ground_contact = "ground_contact", "hit the ground"
    envelope_exceeded = "envelope_exceeded", "left the aircraft's flight envelope"
    diverged = "diverged", "diverged to a state that is not finite"

    sentence: str

    def __new__(cls, word: str, sentence: str) -> Self:
        outcome = str.__new__(cls, word)
        outcome._value_, outcome.sentence = word, sentence
        return outcome

    @property
    def is_lost(self) -> bool:
        """Whether the aircraft was lost: the flight ended early."""
        return self is not Outcome.completed


LOSSES = frozenset(str(outcome) for outcome in Outcome if outcome.is_lost)
"""Outcomes of flights in which the aircraft was lost, as tables and summaries name them; other words are of flights that were
not flown."""


@dataclass(frozen=True, eq=False, repr=False)
class Flight:
    """A scenario and its result, as data; `reporting.flight` draws and reports it.

    `data` [rows, columns] is the log, with a row for each logged control step, named by `columns`.
    """

    scenario: Scenario
    outcome: Outcome
    end_time_s: float
    columns: tuple[str, ...]
    data: np.ndarray
    events: Sequence[Mapping[str, Any]] = ()
    """What happened, in order of time: {time_s, kind, ...}."""
    metrics: Mapping[str, float] = field(default_factory=dict)
    """The value of every metric of `testbed.metrics.TABLE` by name; NaN if it has none in this flight."""
    requirements: Sequence[Mapping[str, Any]] = ()
    """The verdict on each of the scenario's requirements: {name, passed, value, limit, margin, robustness, reason}.
    `passed` is None where the controller does not say what it limits: it is not judged."""
    actuators: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    """{kind, unit, limits, scale} of each actuator by name, so that the log can be read without the aircraft's files."""
    warnings: Sequence[str] = ()
    """Reasons to doubt the result: a failure that did not act as asked, or never started."""
    shape: Shape | None = None
    """What the aircraft looks like, for the replay; None if its folder does not say."""
    flown_by: str = ""
    """The user's own controller that flew in place of the scenario's; empty if the scenario's controller flew."""
    flown_by_sha256: str = ""
    """Digest of that controller's files and arguments; empty where it is in no file."""
    parts: Mapping[str, str] = field(default_factory=dict)
    """SHA-256 of each file of parts of the user's own that was used, by its name."""
    files: Mapping[str, bytes] = field(default_factory=dict)
    """Files of that controller's own, by name: its log, its parameters. A run folder has them in `controller/`."""

    def __repr__(self) -> str:
        """`<Flight 'left tail failure': completed at 60 s, passed (25 of 25 requirements met), ...>`."""
        rows, columns = self.data.shape
        events = f"{len(self.events)} event{'' if len(self.events) == 1 else 's'}"
        return (
            f"<Flight {self.scenario.name!r}: {self.outcome} at {self.end_time_s:g} s, "
            f"{self.verdict} ({self.counted}), "
            f"{rows} rows x {columns} columns, {events}>"
        )

    @property
    def controller(self) -> str:
        """The controller that flew: the type of the scenario's, or the name of the user's own."""
        return self.flown_by or self.scenario.controller.type

    def column(self, name: str) -> np.ndarray:
        """[rows] a column of the log; raises ValueError when there is none of this name."""
        return self.data[:, self.columns.index(name)]

    @cached_property
    def signals(self) -> Mapping[str, np.ndarray]:
        """The columns of the log by name, each [rows] and contiguous."""
        return dict(zip(self.columns, np.ascontiguousarray(self.data.T), strict=True))

    @cached_property
    def log(self) -> pd.DataFrame:
        """The log as a DataFrame."""
        import pandas as pd

        return pd.DataFrame(self.data, columns=list(self.columns))

    def beliefs(self) -> list[dict[str, Any]]:
        """What the controller took each actuator for, and when: see `flight.columns.beliefs`."""
        return columns.beliefs(self.signals, self.actuators)

    @property
    def passed(self) -> bool | None:
        """Whether the aircraft was flown to the end and every requirement that can be judged was met; None if none can."""
        if self.outcome.is_lost:
            return False
        return all(r["passed"] for r in self._judged) if self._judged or not self.requirements else None

    @property
    def _judged(self) -> list[Mapping[str, Any]]:
        return [r for r in self.requirements if r["passed"] is not None]

    @property
    def judged(self) -> bool | None:
        """As `passed`, but None where the aircraft survived and nothing else was asked: that is neither good nor bad news."""
        return self.passed if self.requirements or self.outcome.is_lost else None

    @property
    def verdict(self) -> str:
        """`passed`, `not passed` or `not judged`."""
        return {True: "passed", False: "not passed", None: "not judged"}[self.judged]

    @property
    def counted(self) -> str:
        """`8 of 25 requirements met, 17 not judged`; `no requirements` without any."""
        total, judged = len(self.requirements), self._judged
        others = f", {total - len(judged)} not judged" if len(judged) < total else ""
        met = f"{sum(r['passed'] for r in judged)} of {total} requirements met"
        return met + others if total else "no requirements"

    @property
    def robustness(self) -> float:
        """The least robustness of its requirements that were judged; infinite without requirements, NaN if none was judged, or in a
        folder written before there was robustness. It is not negative if the flight passed.

        Of a flight that ended early it is that, or 0 if it is positive, less the share of the duration that was not flown.
        """
        found = [r.get("robustness", math.nan) for r in self._judged]
        least = float(np.min(found, initial=math.inf))
        if self.outcome is Outcome.completed:
            return least if self.passed is not None else math.nan
        # The last step, in which it ended, was not flown to its end.
        flown_s = self.end_time_s - 1.0 / self.scenario.rate_hz
        return min(least, 0.0) + flown_s / self.scenario.duration_s - 1.0

    @property
    def summary(self) -> dict[str, Any]:
        """Contents of summary.json. They do not depend on clock or machine; a number that is not finite is None."""
        summary = {
            "scenario": self.scenario.name,
            "seed": self.scenario.seed,
            "outcome": str(self.outcome),
            "end_time_s": self.end_time_s,
            "passed": self.passed,
            "robustness": self.robustness,
            "requirements": list(self.requirements),
            "events": list(self.events),
            "metrics": dict(self.metrics),
            "actuators": [{"name": name, **facts} for name, facts in self.actuators.items()],
            "warnings": list(self.warnings),
        }
        where_known = {
            "shape": self.shape and self.shape.model_dump(exclude_none=True),
            "flown_by": self.flown_by,
            "flown_by_sha256": self.flown_by_sha256,
            "parts_sha256": dict(self.parts),
        }
        summary |= {name: value for name, value in where_known.items() if value}
        contents: dict[str, Any] = plain(summary)
        return contents


@dataclass(frozen=True, eq=False, repr=False)
class Flying(Flight):
    """A flight that goes on, as far as it is told in words: it has no `data`, no metrics and no verdicts."""

    signals: Mapping[str, np.ndarray] = field(default_factory=dict)
    """The columns of the log by name, which may be computed when they are read."""

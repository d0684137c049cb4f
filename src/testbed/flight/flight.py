"""A finished flight: how it ended, its log and its verdict; written to and read from a run folder."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from testbed.common.plain import plain
from testbed.scenario.load import Scenario

if TYPE_CHECKING:
    import pandas as pd


class Outcome(StrEnum):
    """How a flight ended; `sentence` says it to a person."""

    completed = "completed"
    ground_contact = "ground_contact"
    envelope_exceeded = "envelope_exceeded"
    diverged = "diverged"

    @property
    def sentence(self) -> str:
        return _SENTENCES[self]


_SENTENCES = {
    Outcome.completed: "flew to the end",
    Outcome.ground_contact: "hit the ground",
    Outcome.envelope_exceeded: "left the aircraft's flight envelope",
    Outcome.diverged: "the state stopped being finite numbers",
}


@dataclass(frozen=True, eq=False)
class Flight:
    """A scenario and what came of it. `data` is the log: a row for each logged step, in `columns`."""

    scenario: Scenario
    outcome: Outcome
    end_time_s: float
    columns: tuple[str, ...]
    data: np.ndarray
    events: Sequence[Mapping[str, Any]] = ()
    metrics: Mapping[str, float] = field(default_factory=dict)
    requirements: Sequence[Mapping[str, Any]] = ()
    """Verdicts: {name, passed, value, limit, margin, reason} for each of the scenario's requirements."""
    actuators: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    """{kind, unit, limits, scale} of each actuator, so that a log is understood without the aircraft."""
    warnings: Sequence[str] = ()
    """What makes the flight mean less than it seems: a failure that did not act, or never started."""
    flown_by: str = ""
    """The user's own controller that flew in place of the scenario's, as `module:Class`; else empty."""

    @property
    def controller(self) -> str:
        """What flew it."""
        return self.flown_by or self.scenario.controller.type

    @cached_property
    def log(self) -> pd.DataFrame:
        """The log as a DataFrame."""
        import pandas as pd

        return pd.DataFrame(self.data, columns=list(self.columns))

    @property
    def passed(self) -> bool:
        """Flown to the end, with every requirement met."""
        return self.outcome is Outcome.completed and all(r["passed"] for r in self.requirements)

    @property
    def summary(self) -> dict[str, Any]:
        """Contents of summary.json. Nothing in it depends on clock or machine; what is not finite is None."""
        summary = {
            "scenario": self.scenario.name,
            "seed": self.scenario.seed,
            "outcome": str(self.outcome),
            "end_time_s": self.end_time_s,
            "passed": self.passed,
            "requirements": list(self.requirements),
            "events": list(self.events),
            "metrics": dict(self.metrics),
            "actuators": [{"name": name, **facts} for name, facts in self.actuators.items()],
            "warnings": list(self.warnings),
        }
        if self.flown_by:
            summary["flown_by"] = self.flown_by
        contents: dict[str, Any] = plain(summary)
        return contents

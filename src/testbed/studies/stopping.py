"""The rule by which a sweep may stop early: once the probability of passing is known well enough."""

from __future__ import annotations

from collections.abc import Sequence

from testbed.common.statistics import proportion
from testbed.studies.model import StopWhen


class Stopping:
    """Takes the verdicts of each run, in the order of runs; `stopped_at` is the number of runs at which the rule held, or None.

    The rule is checked after every run up to 100, then each time the number of runs has grown by 1 %. It uses exact
    intervals (Clopper-Pearson): repeated checking makes any interval too narrow, and the exact ones tend to be too wide.
    """

    def __init__(self, rule: StopWhen | None, variants: int) -> None:
        self._rule = rule
        self._passed = [0] * variants
        self._next = 1
        self.runs = 0
        self.stopped_at: int | None = None

    def add(self, passed: Sequence[bool]) -> bool:
        """Count one more run, with a verdict for each variant; returns whether to stop."""
        if self.stopped_at is not None or self._rule is None:
            return self.stopped_at is not None
        self.runs += 1
        self._passed = [n + p for n, p in zip(self._passed, passed, strict=True)]
        if self.runs >= self._next:
            self._next = self.runs + max(1, self.runs // 100)
            if all(self._close(n) for n in self._passed):
                self.stopped_at = self.runs
        return self.stopped_at is not None

    def _close(self, passed: int) -> bool:
        assert self._rule is not None
        known = proportion(passed, self.runs, self._rule.confidence, method="exact")
        return (known.high - known.low) / 2.0 <= self._rule.half_width

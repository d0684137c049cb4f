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
        self._counts = [(0, 0)] * variants  # passed, judged
        self._next = 1
        self.runs = 0
        self.stopped_at: int | None = None

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

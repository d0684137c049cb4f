"""Progress of a search: a bar on stderr if stderr is a terminal, else nothing; below it, the nearest failure so far."""

from __future__ import annotations

import math
import sys
from types import TracebackType
from typing import Any

from testbed.common.text import printable
from testbed.searches.plan import Part, SearchPlan
from testbed.sweeps.progress import bar


class Progress:
    """Shows the number of flights out of the most that there can be, and the nearest failure of the part being searched."""

    def __init__(self, plan: SearchPlan) -> None:
        self._plan = plan
        self._done, self._failures = 0, 0
        self._nearest: dict[int, float] = {}
        self._part: Part | None = None
        self._bar: Any = None
        self._task: Any = None

    def __enter__(self) -> Progress:
        from rich.console import Console

        console = Console(file=sys.__stderr__)
        if console.is_terminal:
            self._bar = bar(console, lambda: self.words)
            total = self._plan.search.budget * len(self._plan.parts)
            self._task = self._bar.add_task(printable(self._plan.name), total=total, rate="")
            self._bar.start()
        return self

    def add(self, part: Part, point: tuple[float, ...], failed: bool) -> None:
        """Count one more finished flight."""
        self._part = part
        self._done += 1
        if failed:
            self._failures += 1
            self._nearest[part.number] = min(math.hypot(*point), self._nearest.get(part.number, math.inf))
        if self._bar is not None:
            speed = self._bar.tasks[self._task].speed
            self._bar.update(self._task, completed=self._done, rate=f"{speed:.1f} flights/s" if speed else "")

    @property
    def words(self) -> str:
        """`ACTUATOR: nearest failure at distance 2.31; 12 failures`."""
        if self._part is None:
            return ""
        label, nearest = self._plan.label(self._part), self._nearest.get(self._part.number)
        found = "no failure yet" if nearest is None else f"nearest failure at distance {nearest:.2f}"
        return printable(f"{label}: {found}" if label else found)

    def __exit__(self, *_: type[BaseException] | BaseException | TracebackType | None) -> None:
        if self._bar is not None:
            self._bar.stop()

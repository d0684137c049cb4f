"""Progress of a sweep: a bar on stderr if stderr is a terminal, else nothing."""

from __future__ import annotations

import sys
from types import TracebackType
from typing import Any

from testbed.common.text import printable
from testbed.sweeps.plan import Plan


class Progress:
    """Shows the number of finished flights, flights per second, the time left, and the share of each variant that passed."""

    def __init__(self, plan: Plan, done: int) -> None:
        self._plan = plan
        self._counts = [[0, 0] for _ in plan.variants]
        self._done = done
        self._bar: Any = None
        self._task: Any = None
        self._live: Any = None
        self._shares: Any = None

    def __enter__(self) -> Progress:
        from rich.console import Console

        console = Console(file=sys.__stderr__)  # not sys.stderr: commands let no escape sequence pass there
        if console.is_terminal:
            self._start(console)
        return self

    def _start(self, console: Any) -> None:
        """Three lines, since they are too long for one of 80 columns: name, bar, and the shares that passed."""
        from rich.console import Group
        from rich.live import Live
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
        from rich.text import Text

        self._bar = Progress(
            BarColumn(), MofNCompleteColumn(), TextColumn("{task.fields[rate]}"), TimeRemainingColumn()
        )
        self._task = self._bar.add_task("", total=self._plan.size, completed=self._done, rate="")
        self._shares = Text()
        lines = Group(Text(printable(self._plan.name)), self._bar, self._shares)
        self._live = Live(lines, console=console, transient=True)
        self._live.start()

    def add(self, variant: int, passed: bool) -> None:
        """Count one more finished flight."""
        self._done += 1
        self._counts[variant][0] += passed
        self._counts[variant][1] += 1
        if self._bar is not None:
            task = self._bar.tasks[self._task]
            rate = f"{task.speed:.1f} flights/s" if task.speed else ""
            self._bar.update(self._task, completed=self._done, rate=rate)
            self._shares.plain = f"passed: {self.passed}"

    @property
    def passed(self) -> str:
        """`adaptive_inversion 93 %  fixed_inversion 12 %`."""
        shares = zip(self._plan.variants, self._counts, strict=True)
        return printable("  ".join(f"{v.label or 'passed'} {100 * p / n:.0f} %" for v, (p, n) in shares if n))

    def __exit__(self, *_: type[BaseException] | BaseException | TracebackType | None) -> None:
        if self._live is not None:
            self._live.stop()

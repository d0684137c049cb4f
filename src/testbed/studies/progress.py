"""Progress of a study: a bar on stderr if stderr is a terminal, else nothing; below it, what has been found so far."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from types import TracebackType
from typing import Any

from testbed.common.text import printable


class Progress:
    """Shows the number of finished flights, flights per second, the time left, and the words of `so_far`, uncut."""

    def __init__(self, name: str, total: int, so_far: Callable[[], str], done: int = 0) -> None:
        self._name, self._total, self._so_far, self._done = name, total, so_far, done
        self._bar: Any = None
        self._task: Any = None

    def __enter__(self) -> Progress:
        from rich.console import Console

        console = Console(file=sys.__stderr__)  # not sys.stderr: commands let no escape sequence pass there
        if console.is_terminal:
            self._bar = bar(console, lambda: printable(self._so_far()))
            name = printable(self._name)
            self._task = self._bar.add_task(name, total=self._total, completed=self._done, rate="")
            self._bar.start()
        return self

    def add(self) -> None:
        """Count one more finished flight."""
        self._done += 1
        if self._bar is not None:
            speed = self._bar.tasks[self._task].speed
            self._bar.update(self._task, completed=self._done, rate=f"{speed:.1f} flights/s" if speed else "")

    def __exit__(self, *_: type[BaseException] | BaseException | TracebackType | None) -> None:
        if self._bar is not None:
            self._bar.stop()


def bar(console: Any, below: Callable[[], str]) -> Any:
    """A bar of rich with a text below it. The sweep's name and the bar itself give way where the terminal is narrow."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
    from rich.table import Column
    from rich.text import Text

    class Bar(Progress):
        def get_renderables(self) -> Iterator[Any]:
            yield from super().get_renderables()
            yield Text(below(), overflow="fold")

    def fixed() -> Column:
        return Column(no_wrap=True)

    name = Column(no_wrap=True, overflow="ellipsis", max_width=max(console.width - 52, 8))
    return Bar(
        TextColumn("{task.description}", markup=False, table_column=name),
        BarColumn(bar_width=None if console.width < 100 else 40, table_column=Column(min_width=4)),
        MofNCompleteColumn(table_column=fixed()), TextColumn("{task.fields[rate]}", table_column=fixed()),
        TimeRemainingColumn(table_column=fixed()), console=console, transient=True,
    )  # fmt: skip

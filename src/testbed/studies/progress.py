"""Progress of a study: a bar on stderr if stderr is a terminal, else nothing; below it, what has been found so far."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from testbed.common.text import printable


@contextmanager
def progress(name: str, total: int, so_far: Callable[[], str], done: int = 0) -> Iterator[Callable[[], None]]:
    """Shows the number of finished flights, flights per second, the time left, and the words of `so_far`, uncut.

    Yields what is to be called after each flight.
    """
    from rich.console import Console

    console = Console(file=sys.__stderr__)  # not sys.stderr: commands let no escape sequence pass there
    if not console.is_terminal:
        yield lambda: None
        return
    with bar(console, lambda: printable(so_far())) as shown:
        task = shown.add_task(printable(name), total=total, completed=done, rate="")

        def add() -> None:
            speed = shown.tasks[task].speed
            shown.update(task, advance=1, rate=f"{speed:.1f} flights/s" if speed else "")

        yield add


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

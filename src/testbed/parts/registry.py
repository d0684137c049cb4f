"""The files of parts that this process uses. What is used stands in the tables of the shipped parts."""

from __future__ import annotations

import traceback
from collections.abc import Iterable, Iterator
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from testbed.controllers.user.loader import raised
from testbed.inputs.problems import BadInput, Problem
from testbed.parts.files import KINDS, Parts, loaded
from testbed.scenario.model import take_parts

_used: dict[str, Parts] = {}
"""By the name of the file."""


class Used:
    """Files of parts that are used from now on, or until the end of a `with` block.

    The block raises BadInput, with file and line, for what a part of the user's own raises in it.
    """

    def __init__(self, parts: list[Parts]) -> None:
        self.parts = parts

    def end(self) -> None:
        """Use them no longer."""
        for parts in self.parts:
            del _used[parts.name]
            for table, own in parts.tables.items():
                for name in own:
                    del KINDS[table].table[name]
        self.parts = []
        take_parts()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        problem = _blamed(error) if isinstance(error, Exception) else None
        self.end()
        if problem is not None:
            raise BadInput([problem]) from error


def use(*files: str | Path) -> Used:
    """Use the parts of your own in these files: failures, sensor faults, presets of sensors, metrics, panels, references.

    From now on a scenario can name them, or until the end of a block `with testbed.use("my_parts.py"):`. `testbed.parts` says
    what a file of parts has. A file that is in use already is not run again.

    Raises BadInput with every part that is none, or whose name another part has.
    """
    return Used([parts for file in files if (parts := _use(file)) is not None])


def _use(file: str | Path) -> Parts | None:
    name = Path(file).name
    if name in _used:
        if _used[name].file == str(Path(file).resolve()):
            return None
        what = f"has the name of {_used[name].file}, which is used already"
        raise BadInput([Problem(what, str(file), expected="another name")])
    parts = loaded(file)
    for table, own in parts.tables.items():
        KINDS[table].table.update(own)
    _used[name] = parts
    take_parts()
    return parts


def take(sent: Iterable[Parts]) -> None:
    """Use what `in_use` of another process gave; raises BadInput for code that has changed since."""
    use(*(parts.file for parts in sent))
    if changed := [parts for parts in sent if _used[parts.name].digest != parts.digest]:
        raise BadInput([Problem("was changed while it is used", parts.file) for parts in changed])


def in_use() -> tuple[Parts, ...]:
    """The files of parts that are used, in the order in which they were taken, as a worker is sent them."""
    return tuple(parts.sent() for parts in _used.values())


def tables_in_use() -> Iterator[tuple[str, str, Any]]:
    """(table, name, part) of every part that is used."""
    for parts in _used.values():
        for kind, table in parts.tables.items():
            yield from ((kind, name, part) for name, part in table.items())


def digests() -> dict[str, str]:
    """SHA-256 of the code of each file of parts that is used, by its name."""
    return {name: parts.digest for name, parts in sorted(_used.items())}


def _blamed(error: Exception) -> Problem | None:
    """The problem to report for an exception that a part of the user's own raised; None if none of them took part."""
    if isinstance(error, BadInput):
        return None
    for frame in reversed(traceback.extract_tb(error.__traceback__)):
        if frame.filename in {parts.file for parts in _used.values()}:
            return raised(error, frame.filename, "in a part of your own")
    return None

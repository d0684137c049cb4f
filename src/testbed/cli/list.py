"""`testbed list`: everything that a scenario or a command can name, each with its meaning in one line."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Mapping
from functools import partial
from importlib import import_module
from itertools import takewhile
from pathlib import Path

from testbed.aircraft import shipped
from testbed.cli.command import Command
from testbed.cli.status import MET
from testbed.common.docstrings import first_line

Entries = list[tuple[str, str]]
"""(name, meaning) of each entry."""


def _aircraft() -> Entries:
    from testbed.aircraft.description import load_aircraft

    return [(name, load_aircraft(name).description) for name in shipped.aircraft_names()]


def _table(module: str) -> Entries:
    """Names in the TABLE of a module, which is imported when it is asked for, each with the first line of its docstring."""
    table: Mapping[str, object] = import_module(module).TABLE
    return [(name, first_line(entry)) for name, entry in table.items()]


def _files(folder: str) -> Entries:
    """Shipped files by the path that commands take, each with the first paragraph of its comment or, without one, its name."""
    return [(str(file.relative_to(shipped.data_root())), _about(file)) for file in shipped.files_in(folder)]


def _about(file: Path) -> str:
    lines = file.read_text(encoding="utf-8").splitlines()
    if lines and lines[0].startswith("# yaml-language-server:"):  # for editors
        del lines[0]
    comment = takewhile(lambda line: line.startswith("# "), lines)  # its first paragraph
    return " ".join(line.lstrip("# ") for line in comment) or file.stem.replace("_", " ")


TABLE: dict[str, Callable[[], Entries]] = {
    "aircraft": _aircraft,
    "controllers": partial(_table, "testbed.controllers.config"),
    "failures": partial(_table, "testbed.failures"),
    "matrices": partial(_files, "scenarios/matrices"),
    "metrics": partial(_table, "testbed.metrics"),
    "scenarios": partial(_files, "scenarios"),
    "searches": partial(_files, "scenarios/searches"),
    "suites": partial(_files, "scenarios/suites"),
    "sweeps": partial(_files, "scenarios/sweeps"),
}
"""The lists that `testbed list` can show."""


def _arguments(command: ArgumentParser) -> None:
    command.add_argument("what", nargs="?", choices=TABLE, help="default: everything")


def _run(options: Namespace) -> int:
    for what in [options.what] if options.what else TABLE:
        print(what)
        entries = TABLE[what]()
        width = max((len(name) for name, _ in entries), default=0) + 2
        for name, meaning in entries:
            print(f"  {name:<{width}}{meaning}")
    return MET


COMMAND = Command(
    "list the names that scenarios and commands can use, with their meanings",
    _arguments,
    _run,
    ("testbed list", "testbed list failures"),
)

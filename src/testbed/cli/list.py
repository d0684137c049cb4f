"""`testbed list`: everything that a scenario or a command can name, each with its meaning in one line."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Mapping
from functools import partial
from importlib import import_module
from itertools import takewhile
from pathlib import Path

from testbed.aircraft import shipped
from testbed.cli.ending import MET
from testbed.common.docstrings import first_line
from testbed.inputs.problems import BadInput, Problem

PURPOSE = "list the names that scenarios and commands can use, with their meanings"
EXAMPLES = (
    "testbed list",
    "testbed list failures",
    "testbed list fmu pilot.fmu",
    "testbed list own --with my_parts.py",
)

Entries = list[tuple[str, str]]
"""(name, meaning) of each entry."""


def _aircraft() -> Entries:
    from testbed.aircraft.description import load_aircraft

    return [(name, load_aircraft(name).description) for name in shipped.aircraft_names()]


def _table(module: str) -> Entries:
    """Names in the TABLE of a module, which is imported when it is asked for, each with the first line of its docstring."""
    table: Mapping[str, object] = import_module(module).TABLE
    return [(name, first_line(entry)) for name, entry in table.items()]


def _own() -> Entries:
    """The parts of the user's own that were given."""
    from testbed.parts.files import KINDS
    from testbed.parts.registry import tables_in_use

    return [
        (name, f"{KINDS[kind].word}: {'' if isinstance(part, Mapping) else first_line(part)}".rstrip(": "))
        for kind, name, part in tables_in_use()
    ]


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
    "own": _own,
    "scenarios": partial(_files, "scenarios"),
    "searches": partial(_files, "scenarios/searches"),
    "sensor_faults": partial(_table, "testbed.sensors.faults"),
    "suites": partial(_files, "scenarios/suites"),
    "sweeps": partial(_files, "scenarios/sweeps"),
}
"""The lists that `testbed list` can show."""
_FMU, _FMU_EXPECTED = "fmu", "testbed list fmu FILE [MAPPING]"


def _fmu(options: Namespace) -> Entries:
    """The inputs and outputs of an FMU, each with what it takes or commands; raises BadInput as a flight with it."""
    from testbed.aircraft.description import load_aircraft
    from testbed.controllers.external.fmu import shown

    if len(options.files) not in (1, 2):
        raise BadInput([Problem("names no FMU, or too many files", "list", expected=_FMU_EXPECTED)])
    file, mapping = [*options.files, None][:2]
    return shown(file, mapping, tuple(load_aircraft(options.aircraft).actuators))


def arguments(command: ArgumentParser) -> None:
    command.add_argument("what", nargs="?", choices=[*TABLE, _FMU], help="default: everything, but for fmu")
    command.add_argument("files", nargs="*", metavar="FILE", help="of fmu: the FMU, and a mapping for it")
    command.add_argument(
        "--aircraft", default="vtail", metavar="NAME", help="of fmu: whose actuators it is to command"
    )


def run(options: Namespace) -> int:
    if options.files and options.what != _FMU:
        raise BadInput([Problem("takes no file", f"list {options.what}", expected=_FMU_EXPECTED)])
    for what in [options.what] if options.what else TABLE:
        entries = TABLE[what]() if what in TABLE else _fmu(options)
        print(what)
        if not entries:  # parts of the user's own, where none are given
            print("  none: --with FILE.py gives some")
        width = max((len(name) for name, _ in entries), default=0) + 2
        for name, meaning in entries:
            print(f"  {name:<{width}}{meaning}")
    return MET

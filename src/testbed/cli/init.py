"""`testbed init`: a small project that runs as it is, to be edited."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.aircraft.shipped import data_root
from testbed.cli.ending import MET
from testbed.cli.schema import TABLE, text_of
from testbed.common.writing import write
from testbed.inputs.output_file import writing
from testbed.inputs.problems import BadInput, Problem

if TYPE_CHECKING:
    from testbed.aircraft.description import Aircraft

PURPOSE = "make a small project: a scenario, a sweep, controllers, and schemas for editors"
EXAMPLES = ("testbed init my_project", "testbed init my_project --aircraft ./my_aircraft")

TEMPLATES = Path(__file__).parent / "template"
"""The files that a new project begins with, beside the examples of controllers."""
_CONTROLLERS = ("my_controller.py", "pilot.pl", "pilot.c", "testbed_controller.h")
_USUAL = "vtail"
"""The aircraft of a project for which none is chosen."""
_CLIMB_M = 10


def arguments(command: ArgumentParser) -> None:
    command.add_argument("folder", type=Path, help="new or empty folder")
    command.add_argument("--aircraft", metavar="AIRCRAFT", help="name or folder of the one that is flown")


def run(options: Namespace) -> int:
    """Fill a new or empty folder; raises BadInput if it holds something, cannot be written, or there is no such aircraft."""
    from testbed.aircraft.description import load_aircraft

    folder, choice = options.folder, options.aircraft or _USUAL
    aircraft = load_aircraft(choice)
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
        if any(folder.iterdir()):
            raise BadInput([Problem("is not empty", str(folder), expected="a new or empty folder")])
        for file in sorted(each for each in TEMPLATES.rglob("*") if each.is_file()):
            text = _filled(file.read_text(encoding="utf-8"), choice, aircraft)
            write(folder / file.relative_to(TEMPLATES), text, within=folder)
        for name in _CONTROLLERS:
            write(folder / name, (data_root() / "examples" / name).read_bytes())
        for kind in TABLE:
            write(folder / "schemas" / f"{kind}.json", text_of(kind), within=folder)
    print(f"wrote {folder}: README.md says what to run")
    return MET


def _filled(text: str, choice: str, aircraft: Aircraft) -> str:
    """A template with the aircraft's own facts; one that is given by its folder is named by the whole path."""
    facts = {
        "AIRCRAFT": str(Path(choice).resolve()) if Path(choice).is_dir() else choice,
        "ACTUATOR": next(iter(aircraft.actuators)),
        "altitude_m: 310": f"altitude_m: {aircraft.reference.altitude_m + _CLIMB_M:g}",
    }
    for word, fact in facts.items():
        text = text.replace(word, fact)
    return text

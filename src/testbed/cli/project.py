"""`testbed init`: a small project that runs as it is, to be edited."""

from __future__ import annotations

from pathlib import Path

from testbed.aircraft.shipped import data_root
from testbed.cli.schema import TABLE, text_of
from testbed.inputs.problems import BadInput, Problem

TEMPLATES = Path(__file__).parent / "template"
"""The files that a new project begins with, beside the example of a controller."""


def make(folder: Path) -> None:
    """Fill a new or empty folder; raises BadInput if it holds something already, or cannot be written."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if any(folder.iterdir()):
            raise BadInput([Problem("is not empty", str(folder), expected="a new or empty folder")])
        for file in [*sorted(TEMPLATES.iterdir()), data_root() / "examples" / "my_controller.py"]:
            if file.is_file():
                (folder / file.name).write_bytes(file.read_bytes())
        (folder / "schemas").mkdir()
        for kind in TABLE:
            (folder / "schemas" / f"{kind}.json").write_text(text_of(kind), encoding="utf-8")
    except OSError as error:
        raise BadInput([Problem(f"cannot be written: {error.strerror}", str(folder))]) from None
    print(f"wrote {folder}: README.md says what to run")

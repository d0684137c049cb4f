"""`testbed adopt`: make an aircraft of a JSBSim model, and print its card."""

from __future__ import annotations

import os
from pathlib import Path

from testbed.common.text import printable
from testbed.inputs.problems import BadInput, Problem


def adopt(model: str, out: Path | None) -> None:
    """Adopt a model into `out`, by default a folder of the model's name here; raises BadInput with what is missing."""
    from testbed.adoption.child import adopted_card
    from testbed.adoption.first_flight import FILE
    from testbed.adoption.source import find_source, package_root

    source = find_source(model, package_root())
    folder = Path(source.name) if out is None else out
    _refuse(folder)
    print(adopted_card(source, folder.resolve()))
    print(f"\nwrote {folder}; break it with: testbed run {folder / FILE}")


def _refuse(folder: Path) -> None:
    """Raise BadInput for a folder that is not new or empty, or whose name could not be that of an aircraft or a folder."""
    name = folder.resolve().name
    if name != printable(name):
        expected = "--out with a folder whose name has letters, digits and the like alone"
        raise BadInput([Problem("has control characters in its name", str(folder), expected=expected)])
    try:
        if not os.path.lexists(folder):
            folder.mkdir(parents=True)
            folder.rmdir()
        elif not folder.is_dir() or any(folder.iterdir()):
            raise BadInput([Problem("exists already", str(folder), expected="--out with a new folder")])
    except OSError as error:
        raise BadInput([Problem(f"cannot be written: {error.strerror}", str(folder))]) from None

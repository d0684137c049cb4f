"""Adoption as a user asks for it: a model by its name or folder, into a new folder."""

from __future__ import annotations

import os
from pathlib import Path
from typing import NamedTuple

from testbed.common.text import printable
from testbed.inputs.problems import BadInput, Problem


class Adoption(NamedTuple):
    """The folder of an adopted aircraft, and its card: trim, modes, input matrix, and what is kept without each actuator."""

    folder: Path
    card: str


def adopt(model: str | Path, out: str | Path | None = None) -> Adoption:
    """Make an aircraft of a JSBSim model.

    Args:
        model: the name of a model in the jsbsim package, or the folder of any model.
        out: the folder to write, by default one of the model's name here. It must be new or empty.

    Raises BadInput with what is missing. Nothing is written then.
    """
    from testbed.adoption.child import adopted_card
    from testbed.adoption.source import find_source, package_root

    source = find_source(str(model), package_root())
    folder = Path(source.name) if out is None else Path(out)
    _refuse(folder)
    return Adoption(folder, adopted_card(source, folder.resolve()))


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

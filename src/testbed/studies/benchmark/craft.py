"""The aircraft of a suite. Those that are adopted from JSBSim are kept in the user's cache folder, made when first needed."""

from __future__ import annotations

import hashlib
import tempfile
from functools import cache
from importlib.metadata import version
from pathlib import Path

from testbed.adoption.entry import adopt
from testbed.common.private import private_folder
from testbed.inputs.problems import BadInput, Problem
from testbed.studies.benchmark.model import Craft

_PACKAGE = Path(__file__).parents[2]
_MADE_BY = ("adoption", "plant", "aircraft")
"""Packages on which an adopted aircraft depends: with other code it is adopted again."""


@cache
def hangar() -> Path:
    """The folder of the adopted aircraft, for this version of JSBSim and of the program; raises BadInput for no place."""
    digest = hashlib.sha256(version("jsbsim").encode())
    for file in sorted(file for name in _MADE_BY for file in (_PACKAGE / name).rglob("*.py")):
        digest.update(file.read_bytes())
    # What is in there is flown as it is, so nobody else may have put it there.
    folder = private_folder(f"adopted-{digest.hexdigest()[:16]}")
    if folder is None:
        what = "there is no place for adopted aircraft that this user alone can write to"
        raise BadInput([Problem(what, expected="a home folder, or XDG_CACHE_HOME")])
    return folder


def beside() -> str:
    """The file beside which the aircraft stand, as far as scenarios are concerned; there is no such file."""
    return str(hangar() / "suite.yaml")


def placed(name: str, craft: Craft) -> str:
    """How a scenario in the folder `hangar` names an aircraft: the same on every machine."""
    return name if craft.adopt is None else f"./{craft.adopt}"


def provide(model: str) -> None:
    """Adopt a model that the hangar does not have; raises BadInput if it cannot be adopted."""
    folder = hangar() / model
    if folder.is_dir():
        return
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=".") as partial:
        made = adopt(model, Path(partial) / model).folder
        try:
            made.rename(folder)
        except OSError as error:  # another process was first
            if not folder.is_dir():
                raise BadInput([]) from error

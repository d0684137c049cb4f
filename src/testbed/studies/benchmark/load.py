"""Read a suite's file, choose who flies it with which seed, find its aircraft, and read back what a folder was begun with.

Aircraft that are adopted from JSBSim are kept in the user's cache folder, made when first needed.
"""

from __future__ import annotations

import hashlib
import json
import tempfile
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ConfigDict, Field, RootModel

from testbed.adoption.entry import adopt
from testbed.aircraft.shipped import find_suite
from testbed.common.private import private_folder
from testbed.controllers.config import AnyController
from testbed.controllers.user.own import OwnController, own_controllers, sha256_of
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.base import Text, Whole
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import Source
from testbed.studies.benchmark.model import Suite
from testbed.studies.drawing.distributions import hashed

_PACKAGE = Path(__file__).parents[2]
_LAW = ("controllers", "aircraft/control_design.py")
_OUTSIDE = ("controllers/external/", "controllers/user/")
"""Seams through which controllers of others come in: no shipped controller is flown by them."""
_MADE_BY = ("adoption", "plant", "aircraft")
"""Packages on which an adopted aircraft depends: with other code it is adopted again."""
Compared = dict[str, Mapping[str, Any] | OwnController]
"""Controllers by name: settings of a shipped one, or one of the user's."""


def load_suite(file: str | Path) -> tuple[Suite, dict[str, Any]]:
    """The suite in a file, or a shipped one by its name, and its tree; raises BadInput with every problem of its keys."""
    source = yamlfile.read(find_suite(file))
    return validated(Suite, source), source.tree


def chosen(suite: Suite, said: Mapping[str, Any], given: Sequence[str]) -> Compared:
    """The controllers to fly.

    Args:
        said: the tree of the suite's file.
        given: each NAME of one in the suite, to fly no others of it; NAME=FILE.py:CLASS, to fly that too; or NAME={type: ...},
            a shipped one with settings.
    """
    names = [text for text in given if "=" not in text]
    settings = dict(_settings(text) for text in given if _is_settings(text))
    known = suite.controllers
    problems = [
        Problem(f"{suite.suite} has no controller {name!r}", "--controller", None, "", *guess(name, known))
        for name in names
        if name not in known
    ]
    own = own_controllers([text for text in given if "=" in text and not _is_settings(text)])
    problems += [
        Problem(f"{name} is a controller of {suite.suite}", "--controller", expected="another name")
        for name in (*own, *settings)
        if name in known
    ]
    if problems:
        raise BadInput(problems)
    shipped = {name: each for name, each in said["controllers"].items() if name in names or not names}
    return {**shipped, **settings, **own}


def as_given(suite: Suite, name: str, said: Any) -> str:
    """How `--controller` names a controller by what a folder says of it: by its name alone if the suite has it."""
    if isinstance(said, str):
        return f"{name}={said}"
    return name if name in suite.controllers else f"{name}={json.dumps(said)}"


def _is_settings(text: str) -> bool:
    return text.partition("=")[2].startswith("{")


def _settings(text: str) -> tuple[str, dict[str, Any]]:
    """Name and settings of NAME={type: ...}; raises BadInput with every problem of them."""
    name, _, said = text.partition("=")
    if not name.isidentifier():
        raise BadInput([Problem(f"is {text!r}", "--controller", expected="NAME={type: ...}")])
    tree: dict[str, Any] = yamlfile.parsed(said, "--controller").tree
    validated(_Given, Source("--controller", {name: tree}))
    return name, tree


class _Given(RootModel[dict[Text, AnyController]]):
    """Controllers of the command line, by name."""


class _Begun(BaseModel):
    """What benchmark.yaml of a folder must say to be believed; the suite is checked as one."""

    model_config = ConfigDict(extra="ignore", hide_input_in_errors=True)
    file: Text
    seed: Whole
    draws: int = Field(strict=True, gt=0)
    controllers: dict[str, Text | dict[str, Any]] = Field(min_length=1)
    suite: dict[str, Any]
    law_sha256: str = ""
    word: str = ""


def read_back(folder: Path) -> tuple[Suite, Compared, dict[str, Any]]:
    """What benchmark.yaml of a folder says: the suite, the controllers, of the user's without their code, and the whole tree."""
    source = yamlfile.read(folder / "benchmark.yaml")
    tree = source.tree
    validated(_Begun, source)
    compared: Compared = {}
    for name, said in tree["controllers"].items():
        file, _, made_by = str(said).rpartition(":")
        compared[name] = said if isinstance(said, dict) else OwnController(name, file, made_by)
    return validated(Suite, Source(source.file, tree["suite"])), compared, tree


def law_sha256() -> str:
    """SHA-256 of the code of every shipped controller and of the control design, without the seams for others' controllers."""
    files = (file for name in _LAW for file in [_PACKAGE / name, *(_PACKAGE / name).rglob("*.py")])
    names = {file: file.relative_to(_PACKAGE).as_posix() for file in sorted(files) if file.is_file()}
    return sha256_of(
        (name, file.read_bytes()) for file, name in names.items() if not name.startswith(_OUTSIDE)
    )


def seed_of(word: str) -> int:
    """The seed for a law that is frozen and a public word that was said afterwards, so that nobody can choose the draws for it."""
    return hashed(law_sha256(), word)


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

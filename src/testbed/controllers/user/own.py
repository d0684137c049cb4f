"""A user's own controllers in a sweep: named classes in files, with the code on which results depend.

`NAME=FILE.py:CLASS` names one. Its name stands beside the shipped types in what the sweep compares. Its code is the file and
those beside it that it imports; a digest of them shows whether a sweep is resumed with the same code, and a cluster gets
their contents.
"""

from __future__ import annotations

import ast
import hashlib
import os
import shlex
import sys
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from testbed.controllers.config import TABLE, ControllerSettings
from testbed.controllers.external.reference import External
from testbed.controllers.user.loader import Factory, load_controller
from testbed.inputs.problems import BadInput, Problem

EXPECTED = "NAME=FILE.py:CLASS, or NAME= and a command or a C library"


@dataclass(frozen=True)
class OwnController:
    """A controller of the user's: a class in a file, a C library or a command.

    Attributes:
        name: by which the sweep calls it.
        file: path of its file, or the command with the whole paths of its files.
        made_by: name of the class in that file; empty if it is no class.
        code: path and contents of the file and of those beside it that it imports; empty if the class has not been given.
    """

    name: str
    file: str
    made_by: str
    code: tuple[tuple[str, bytes], ...] = ()

    @property
    def reference(self) -> str:
        """`FILE.py:CLASS` without the folder: the same on every machine."""
        return (
            f"{Path(self.file).name}:{self.made_by}" if self.made_by else Path(shlex.split(self.file)[0]).name
        )

    @property
    def digest(self) -> str:
        """SHA-256 of its code, and of a command's arguments."""
        return sha256_of(self.code, () if self.made_by else shlex.split(self.file))

    def load(self) -> Factory:
        """The class. Its file is run once in a process; raises BadInput with file and line when that fails."""
        return _loaded(f"{self.file}:{self.made_by}" if self.made_by else self.file)

    def unpacked(self, folder: Path) -> OwnController:
        """The same with its code in a folder, into which a worker has written `code`."""
        if self.made_by:
            return replace(self, file=str(folder / Path(self.file).name))
        there = {Path(name).name: str(folder / name) for name, _ in self.code}
        for path in there.values():
            os.chmod(path, 0o700)  # what was sent may have to be run
        return replace(self, file=shlex.join(there.get(Path(w).name, w) for w in shlex.split(self.file)))


def own_controllers(given: Iterable[str]) -> dict[str, OwnController]:
    """The controllers that `NAME=FILE.py:CLASS` name, by name. Their files are run; raises BadInput with every problem."""
    found: dict[str, OwnController] = {}
    problems: list[Problem] = []
    for text in given:
        try:
            own = _own(text, found)
            found[own.name] = own
        except BadInput as error:
            problems += error.problems
    if problems:
        raise BadInput(problems)
    return found


def digest_of(factory: Factory) -> str:
    """SHA-256 of what makes a flight's controller, as `OwnController.digest`; empty of a class that is in no file."""
    if isinstance(factory, External):
        return sha256_of(_contents(factory), factory.words)
    file = getattr(sys.modules.get(getattr(factory, "__module__", "")), "__file__", None) or ""
    return sha256_of(code_of(Path(file).resolve())) if file.endswith(".py") and os.path.isfile(file) else ""


def sha256_of(code: Iterable[tuple[str, bytes]], words: Iterable[str] = ()) -> str:
    """Of files, and of the words of a command, in which the folders of files do not count."""
    digest = hashlib.sha256()
    for name, content in code:
        digest.update(f"{name}\0".encode() + content + b"\0")
    for word in words:
        digest.update(f"{Path(word).name if os.path.isabs(word) else word}\0".encode())
    return digest.hexdigest()


def _contents(command: External) -> tuple[tuple[str, bytes], ...]:
    return tuple((path.name, path.read_bytes()) for path in command.files())


def not_given(name: str) -> Problem:
    """The problem of a sweep that names a controller of the user's without its class."""
    what = f"{name} is a controller of one's own, and its class was not given"
    return Problem(what, path="controllers", expected=f"--controller {name}=FILE.py:CLASS")


def unused_parameters(settings: ControllerSettings) -> list[Problem]:
    """The problem of `parameters` for a controller that takes none: a shipped one."""
    if not settings.parameters:
        return []
    what = f"are for a controller of one's own, and {settings.type} flies"
    return [Problem(what, path="controller.parameters", expected="no parameters, or --controller")]


def _own(text: str, others: Mapping[str, OwnController]) -> OwnController:
    name, equals, reference = text.partition("=")
    if not equals or not name.isidentifier():
        raise BadInput([Problem(f"is {text!r}", "--controller", expected=EXPECTED)])
    if name in TABLE or name in others:
        what = f"{name} is the name of a {'shipped controller' if name in TABLE else 'controller twice'}"
        raise BadInput([Problem(what, "--controller", expected="another name")])
    factory = load_controller(reference)
    if isinstance(factory, External):
        return OwnController(name, shlex.join(factory.words), "", _contents(factory))
    file, _, made_by = reference.rpartition(":")
    return OwnController(name, str(Path(file).resolve()), made_by, tuple(code_of(Path(file).resolve())))


def code_of(file: Path) -> Iterator[tuple[str, bytes]]:
    """(path from its folder, contents) of a file and of the modules and packages beside it that it imports, in order."""
    folder, found, waiting = file.parent, set[Path](), [file]
    while waiting:
        path = waiting.pop()
        if path not in found:
            found.add(path)
            waiting += [beside for name in _imported(path) for beside in _files_of(folder, name)]
    for path in sorted(found):
        yield path.relative_to(folder).as_posix(), path.read_bytes()


def _imported(file: Path) -> Iterator[str]:
    """First part of the name of every module that a file imports."""
    for node in ast.walk(ast.parse(file.read_bytes())):
        if isinstance(node, ast.Import):
            yield from (alias.name.partition(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield node.module.partition(".")[0]


def _files_of(folder: Path, name: str) -> list[Path]:
    """The files of a module or package in this folder; none if it is not there."""
    module = folder / f"{name}.py"
    return [module] if module.is_file() else sorted((folder / name).rglob("*.py"))


@cache
def _loaded(reference: str) -> Factory:
    return load_controller(reference)

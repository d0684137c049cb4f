"""What `--controller` names when it is no Python class: an autopilot, an FMU, a C library or a command.

`ardupilot:PATH` and `px4:PATH` are executables, with a parameter file as a second word; without PATH, the environment names it.
An FMU may have its mapping file as a second word. It and a library are told from a command by the kind of their file.

Naming loads and starts nothing, and needs no numba: results name controllers too.
"""

from __future__ import annotations

import os
import shlex
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

from testbed.inputs.problems import BadInput, Problem, did_you_mean

_LIBRARIES, _FMU = (".so", ".dylib", ".dll"), ".fmu"
EXPECTED = "FILE.py:CLASS, a C library (.so, .dylib, .dll), an FMU (.fmu), ardupilot:PATH, px4:PATH, or a command in quotes"
ARDUPILOT = "ardupilot:"
_AUTOPILOTS = {ARDUPILOT: "TESTBED_ARDUPILOT", "px4:": "TESTBED_PX4"}
"""What begins the name of an autopilot's executable, which `External.words` has as a word of its own; what names it otherwise."""


@dataclass(frozen=True)
class External:
    """A command, an FMU, a C library or an autopilot; picklable, so that workers fly it too.

    Attributes:
        words: the command, the path of the library or FMU, or of `_AUTOPILOTS` with its files; what is run or loaded is found.
        controller_name: by which results call it.
    """

    words: tuple[str, ...]
    controller_name: str
    takes_any_parameters = True

    def __call__(self, setup: Any) -> Any:
        """The controller of one flight with this `Setup`; raises BadInput when it cannot be started."""
        module = import_module(f"testbed.controllers.external.{self._kind}")
        return module.started(setup, self.words)

    @property
    def _kind(self) -> str:
        if self.words[0] in _AUTOPILOTS:
            return self.words[0].removesuffix(":")
        if self.words[0].endswith(_FMU):
            return "fmu"
        return "c_library" if self.words[0].endswith(_LIBRARIES) else "process"

    def files(self) -> Iterator[Path]:
        """The files on which its commands depend, as far as the command names them; not what comes with the system."""
        files = (Path(word) for word in self.words if os.path.isfile(word))
        yield from (
            path for path in files if not path.is_relative_to("/usr") and not path.is_relative_to("/bin")
        )


def load(reference: str) -> External:
    """What a text names; raises BadInput when there is no such file, or it is not one that can be flown."""
    try:
        words = shlex.split(reference)
    except ValueError as error:
        raise BadInput([Problem(f"is {reference!r}: {error}", "--controller", expected=EXPECTED)]) from None
    if not words:
        raise BadInput([Problem("is empty", "--controller", expected=EXPECTED)])
    if kind := next((kind for kind in _AUTOPILOTS if words[0].startswith(kind)), ""):
        return _autopilot(kind, words)
    return External((_found(words[0]), *map(_absolute, words[1:])), Path(words[0]).name)


def autopilot(path: str, parameters: Path | None) -> External:
    """ArduPilot by its executable, or the one of the environment if the path is empty; raises BadInput as `load`."""
    return load(shlex.join([ARDUPILOT, path, *([str(parameters)] if parameters else [])]))


def _autopilot(kind: str, words: list[str]) -> External:
    first = words[0].removeprefix(kind)
    path, *parameters = [first, *words[1:]] if first or not words[1:] else words[1:]
    if not (path := path or os.environ.get(_AUTOPILOTS[kind], "")):
        what = f"names no executable, and {_AUTOPILOTS[kind]} is not set"
        raise BadInput([Problem(what, kind, expected=EXPECTED)])
    if len(parameters) > 1 or any(not os.path.isfile(file) for file in parameters):
        what = f"{' '.join(parameters)}: there is no such file of parameters"
        raise BadInput([Problem(what, kind, expected=f"{kind}PATH FILE")])
    return External((kind, _found(path), *map(os.path.abspath, parameters)), Path(path).name)


def _found(name: str) -> str:
    """The path of a file that can be run or loaded."""
    if name.endswith((*_LIBRARIES, _FMU)) and os.path.isfile(name):
        return os.path.abspath(name)
    if runs := shutil.which(name) or shutil.which(name, path=os.curdir):
        return os.path.abspath(runs)
    folder = Path(name).parent
    near = [str(path) for path in folder.glob("*")] if folder.is_dir() else []
    what = "there is no such file" if not os.path.exists(name) else "cannot be run: its permissions forbid it"
    what = f"{name} is a folder" if os.path.isdir(name) else f"{name}: {what}"
    raise BadInput([Problem(what, "--controller", expected=EXPECTED, suggestion=did_you_mean(name, near))])


def _absolute(word: str) -> str:
    """A word of the command; with its whole path if it is a file, so that a worker in another folder finds it."""
    return os.path.abspath(word) if os.path.isfile(word) else word

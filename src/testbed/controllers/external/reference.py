"""What `--controller` names when it is no Python class: a C library or a command, told apart by the file's kind.

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

_LIBRARIES = (".so", ".dylib", ".dll")
EXPECTED = "FILE.py:CLASS, a C library (.so, .dylib, .dll), or a command in quotes"


@dataclass(frozen=True)
class External:
    """A command or a C library; picklable, so that workers fly it too.

    Attributes:
        words: the command or the library's path, with the file that is run or loaded found.
        controller_name: by which results call it.
    """

    words: tuple[str, ...]
    controller_name: str
    takes_any_parameters = True

    def __call__(self, setup: Any) -> Any:
        """The controller of one flight with this `Setup`; raises BadInput when it cannot be started."""
        module = "c_library" if self.words[0].endswith(_LIBRARIES) else "process"
        return import_module(f"testbed.controllers.external.{module}").started(setup, self.words)

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
    return External((_found(words[0]), *map(_absolute, words[1:])), Path(words[0]).name)


def _found(name: str) -> str:
    """The path of a file that can be run or loaded."""
    if name.endswith(_LIBRARIES) and os.path.isfile(name):
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

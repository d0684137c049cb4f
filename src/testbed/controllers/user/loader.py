"""Loads a user's controller class from a Python file; what goes wrong is reported with that file and line."""

from __future__ import annotations

import importlib.util
import os
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, NoReturn

from testbed.inputs.problems import BadInput, Problem, did_you_mean, one_of

if TYPE_CHECKING:  # a sweep's parent loads classes and makes none of them; what makes them is slow to import
    from testbed.controllers.setup import Setup

Factory = Callable[["Setup"], Any]


_PREFIX = "testbed_user_"
"""Beginning of the module's name, so that a user's file json.py does not take the place of the module json."""
_PLACE = "_testbed_place"
"""Attribute of the user's module that keeps its path as the user gave it."""
_PACKAGE = Path(__file__).parents[2]
_end = os._exit
_process_of: dict[str, int] = {}
"""The process that has loaded each file of the user's, by the file as Python names it in a frame."""


def name_of(factory: Factory) -> str:
    """`module:Class`, the same on every machine. For a class loaded from a file, `module` is the file's name without `.py`."""
    if isinstance(named := getattr(factory, "controller_name", None), str):
        return named
    module = getattr(factory, "__module__", "") or ""
    name = getattr(factory, "__qualname__", type(factory).__name__)
    return f"{module.removeprefix(_PREFIX)}:{name}"


def place_of(factory: Factory) -> str:
    """The file that the class was loaded from, as the user gave it; `name_of` if it was not loaded from a file."""
    module = sys.modules.get(getattr(factory, "__module__", "") or "")
    return getattr(module, _PLACE, "") or name_of(factory)


def undeclared(factory: Factory, given: Mapping[str, Any]) -> list[Problem]:
    """A problem for each parameter given that the class does not declare in its attribute `parameters`."""
    declared = getattr(factory, "parameters", {})
    if getattr(factory, "takes_any_parameters", False):
        return []
    if not isinstance(declared, Mapping):
        what = f"the attribute `parameters` is {shown(declared)}"
        return [Problem(what, place_of(factory), expected="a mapping of names to defaults")]
    return [
        Problem(
            f"{place_of(factory)} declares no parameter {key}",
            path=f"controller.parameters.{key}",
            expected=one_of(declared) if declared else "a class with an attribute `parameters`",
            suggestion=did_you_mean(key, declared),
        )
        for key in given
        if key not in declared
    ]


def load_controller(reference: str) -> Factory:
    """What makes the controller that a text names: a class, a C library or a command.

    Of `my_file.py:MyController` the file is run; what goes wrong raises BadInput with file and line. For the others see
    `external.reference`.
    """
    file, colon, name = reference.rpartition(":")
    if not colon or not name.isidentifier() or not file.endswith(".py"):
        if file.endswith(".py") or (reference.endswith(".py") and not colon):
            raise BadInput([Problem(f"is {reference!r}", "--controller", expected="FILE.py:CLASS")])
        from testbed.controllers.external.reference import load

        return load(reference)
    module = module_of(Path(file))
    made = getattr(module, name, None)
    own = [key for key, value in vars(module).items() if getattr(value, "__module__", "") == module.__name__]
    if made is None:
        problem = f"has no class {name}"
        raise BadInput([Problem(problem, file, expected=one_of(own), suggestion=did_you_mean(name, own))])
    if not callable(made):
        raise BadInput([Problem(f"{name} is {made!r}", file, expected="a class")])
    return made  # type: ignore[no-any-return]


def module_of(path: Path) -> ModuleType:
    """Run a Python file and return its module. The file may import others in its folder."""
    if not os.path.isfile(path):
        problem = "is a folder" if os.path.isdir(path) else "there is no such file"
        near = [str(p) for p in path.parent.glob("*.py")] if os.path.isdir(path.parent) else []
        raise BadInput([Problem(problem, str(path), suggestion=did_you_mean(str(path), near))])
    name = _PREFIX + path.stem
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise BadInput([Problem("cannot be read as Python", str(path))])
    module = importlib.util.module_from_spec(spec)
    setattr(module, _PLACE, str(path))
    sys.modules[name] = module
    # From now on `os._exit` in this file, in this process, is raised as `sys.exit` is: it would end a command in silence.
    _process_of.update(dict.fromkeys((str(path), os.path.abspath(path)), os.getpid()))
    os._exit = _end_or_raise
    if str(path.resolve().parent) not in sys.path:
        sys.path.insert(0, str(path.resolve().parent))
    with in_words(str(path), "while being read"):
        try:
            spec.loader.exec_module(module)
        except SyntaxError as error:
            raise BadInput([Problem(f"is not Python: {error.msg}", str(path), error.lineno)]) from error
    return module


def _end_or_raise(status: int) -> NoReturn:
    """`os._exit` as before for all others, such as a process that the user's code has started and ends."""
    if _process_of.get(sys._getframe(1).f_code.co_filename) == os.getpid():
        raise SystemExit(f"os._exit({status})")
    _end(status)


@contextmanager
def in_words(name: str, when: str) -> Iterator[None]:
    """Turn whatever the user's code raises, also `sys.exit`, into BadInput, but not Ctrl-C. Arguments as of `raised`."""
    try:
        yield
    except (KeyboardInterrupt, BadInput):  # or from a controller of the testbed, which refuses the aircraft
        raise
    except BaseException as error:
        raise BadInput([raised(error, name, when)]) from error


def shown(value: object) -> str:
    """A value of the user's for a message, at most 80 characters of it; its kind where it has no text."""
    try:
        text = repr(value)
    except Exception:
        text = f"of type {type(value).__name__}"
    return text if len(text) < 80 else text[:77] + "..."


def raised(error: BaseException, name: str, when: str) -> Problem:
    """The problem to report for an exception in the user's code: its text, and the last line of their file in the traceback.

    Args:
        name: the user's file, as they gave it.
        when: when it was raised, such as "at 1.250 s".
    """
    frames: Sequence[traceback.FrameSummary] = traceback.extract_tb(error.__traceback__)
    theirs = [frame for frame in frames if frame.filename in (name, str(Path(name).resolve()))]
    frame = (theirs or frames)[-1]
    # The testbed's call itself failed (wrong arguments, a set-up that was changed), so no line of the user's was reached.
    ours = Path(frame.filename).is_relative_to(_PACKAGE)
    last = traceback.format_exception_only(error)[-1].strip()
    file = name if theirs or ours else frame.filename
    return Problem(f"raised {when}: {last}", file, None if ours else frame.lineno)

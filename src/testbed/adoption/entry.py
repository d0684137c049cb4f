"""`testbed adopt MODEL`: a model by its name or folder, adopted into a new folder or refused.

It happens in a child process, `python -m testbed.adoption.entry`: JSBSim may end the process of a model that it does not like, or
never return. The child is asked with {source, folder}, and answers {card} or {problems}.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any, NamedTuple

from testbed.adoption.source import Source, find_source, package_root
from testbed.common import child
from testbed.common.text import printable
from testbed.inputs.output_file import cannot_write
from testbed.inputs.problems import BadInput, Problem

LONGEST_S = 120
"""Processor time after which an adoption is given up [s]; the slowest of the jsbsim package takes a fifth of it."""


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
        raise BadInput([cannot_write(folder, error)]) from None


def adopted_card(source: Source, folder: Path, longest_s: int = LONGEST_S) -> str:
    """Adopt a model into a folder, in a child process; returns the card.

    Raises BadInput with what is missing, also where JSBSim ended the process or did not return.
    """
    paths = {"name": source.name, "folder": str(source.folder.resolve()), "root": str(source.root.resolve())}
    request = {"source": paths, "folder": str(folder.resolve())}
    try:
        ended = child.ask("testbed.adoption.entry", request, child.Limits(longest_s))
    except OSError as error:
        raise BadInput([Problem(f"no process can be started to adopt it: {error.strerror}")]) from None
    if ended.status == 0 and "card" in ended.last:
        return str(ended.last["card"])
    if ended.status == 0 and "problems" in ended.last:
        raise BadInput([Problem(**problem) for problem in ended.last["problems"]])
    raise BadInput([Problem(f"{source.name} cannot be adopted: {_why(ended)}", str(source.file))])


def _why(ended: child.Ended) -> str:
    """What ended a process without an answer."""
    if ended.overtime:
        return f"it was not adopted within {ended.overtime}"
    if ended.signal:
        return f"JSBSim ended the process ({ended.signal})"
    words = ended.errors.strip().splitlines()
    return f"its process ended without an answer: {words[-1] if words else f'exit status {ended.status}'}"


def _adopted(request: dict[str, Any]) -> Iterator[child.Answer]:
    """In the child: the answer to a request."""
    from testbed.adoption.adopt import adopt

    paths = request["source"]
    source = Source(paths["name"], Path(paths["folder"]), Path(paths["root"]))
    try:
        yield {"card": adopt(source, Path(request["folder"]))}
    except BadInput as error:
        yield {"problems": [asdict(problem) for problem in error.problems]}


if __name__ == "__main__":
    child.answer(_adopted)

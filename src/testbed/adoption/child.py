"""Adoption in a child process: JSBSim may end the process of a model that it does not like, or never return.

`python -m testbed.adoption.child` is that process. It is asked with {source, folder}, and answers {card} or {problems}.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from testbed.adoption.source import Source
from testbed.common import child
from testbed.inputs.problems import BadInput, Problem

LONGEST_S = 120
"""Processor time after which an adoption is given up [s]; the slowest of the jsbsim package takes a fifth of it."""


def adopted_card(source: Source, folder: Path, longest_s: int = LONGEST_S) -> str:
    """Adopt a model into a folder, in a child process; returns the card.

    Raises BadInput with what is missing, also where JSBSim ended the process or did not return.
    """
    paths = {"name": source.name, "folder": str(source.folder.resolve()), "root": str(source.root.resolve())}
    request = {"source": paths, "folder": str(folder.resolve())}
    try:
        ended = child.ask("testbed.adoption.child", request, child.Limits(longest_s))
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
        yield {"card": adopt(source, Path(request["folder"])).card()}
    except BadInput as error:
        yield {"problems": [asdict(problem) for problem in error.problems]}


if __name__ == "__main__":
    child.answer(_adopted)

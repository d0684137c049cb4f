"""Adoption in a process of its own: JSBSim may end the process of a model that it does not like, or never return."""

from __future__ import annotations

import multiprocessing
import multiprocessing.connection
import os
import signal
from pathlib import Path

from testbed.adoption.source import Source
from testbed.inputs.problems import BadInput, Problem

LONGEST_S = 120.0
"""Time after which an adoption is given up; on an idle machine the slowest of the jsbsim package takes a fifth of it."""


def adopted_card(source: Source, folder: Path, longest_s: float = LONGEST_S) -> str:
    """Adopt a model into a folder, in a new process; returns the card.

    Raises BadInput with what is missing, also where JSBSim ended the process or did not return.
    """
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe(duplex=False)
    child = context.Process(target=_run, args=(source, folder, theirs), daemon=True)
    child.start()
    theirs.close()
    try:
        answer = ours.recv() if ours.poll(longest_s) else None
    except EOFError:
        child.join()
        raise _refused(source, f"JSBSim ended the process{_signal(child.exitcode)}") from None
    finally:
        child.kill()
        child.join()
    if answer is None:
        raise _refused(source, f"it was not adopted within {longest_s:g} s")
    if isinstance(answer, BadInput):
        raise answer
    return str(answer)


def _run(source: Source, folder: Path, pipe: multiprocessing.connection.Connection) -> None:
    """In the new process: adopt, and send the card or the problems."""
    from testbed.adoption.adopt import adopt

    try:
        pipe.send(adopt(source, folder).card())
    except BadInput as error:
        pipe.send(error)
    pipe.close()
    os._exit(0)  # at once: JSBSim may abort while it takes a model apart


def _refused(source: Source, why: str) -> BadInput:
    return BadInput([Problem(f"{source.name} cannot be adopted: {why}", str(source.file))])


def _signal(exitcode: int | None) -> str:
    return f" ({signal.Signals(-exitcode).name})" if exitcode is not None and exitcode < 0 else ""

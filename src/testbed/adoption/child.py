"""Adoption in a process of its own: JSBSim may end the process of a model that it does not like, or never return.

`python -m testbed.adoption.child` is that process. It reads {source, folder} as JSON from stdin, and its last line of JSON on
stdout is its answer: {card} or {problems}. It is no copy of the process that starts it, so a script needs no `__main__` guard.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from dataclasses import asdict
from pathlib import Path
from typing import Any

from testbed.adoption.source import Source
from testbed.common.processes import answers, environment, signal_name
from testbed.inputs.problems import BadInput, Problem

LONGEST_S = 120.0
"""Time after which an adoption is given up; on an idle machine the slowest of the jsbsim package takes a fifth of it."""


def adopted_card(source: Source, folder: Path, longest_s: float = LONGEST_S) -> str:
    """Adopt a model into a folder, in a new process; returns the card.

    Raises BadInput with what is missing, also where JSBSim ended the process or did not return.
    """
    paths = {"name": source.name, "folder": str(source.folder.resolve()), "root": str(source.root.resolve())}
    request = json.dumps({"source": paths, "folder": str(folder.resolve())})
    try:
        with tempfile.TemporaryDirectory() as empty:  # modules beside the user's files are not imported
            done = subprocess.run(
                [sys.executable, "-m", "testbed.adoption.child"], input=request, capture_output=True, text=True,
                errors="replace", timeout=longest_s, cwd=empty, env=environment(), check=False,
            )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise _refused(source, f"it was not adopted within {longest_s:g} s") from None
    except OSError as error:
        raise BadInput([Problem(f"no process can be started to adopt it: {error.strerror}")]) from None
    found = answers(done.stdout)
    if done.returncode == 0 and found and "card" in found[-1]:
        return str(found[-1]["card"])
    if done.returncode == 0 and found and "problems" in found[-1]:
        raise BadInput([Problem(**problem) for problem in found[-1]["problems"]])
    raise _refused(source, _end(done))


def _end(done: subprocess.CompletedProcess[str]) -> str:
    """What ended a process without an answer."""
    if done.returncode < 0:
        return f"JSBSim ended the process ({signal_name(-done.returncode)})"
    words = done.stderr.strip().splitlines()
    return f"its process ended without an answer: {words[-1] if words else f'exit status {done.returncode}'}"


def main() -> None:
    """In the new process: adopt, and answer."""
    from testbed.adoption.adopt import adopt

    request = json.load(sys.stdin)
    paths = request["source"]
    source = Source(paths["name"], Path(paths["folder"]), Path(paths["root"]))
    answer: dict[str, Any]
    try:
        answer = {"card": adopt(source, Path(request["folder"])).card()}
    except BadInput as error:
        answer = {"problems": [asdict(problem) for problem in error.problems]}
    print(f"\n{json.dumps(answer)}", flush=True)


def _refused(source: Source, why: str) -> BadInput:
    return BadInput([Problem(f"{source.name} cannot be adopted: {why}", str(source.file))])


if __name__ == "__main__":
    main()
    os._exit(0)  # at once: JSBSim may abort while it takes a model apart

"""Completion of commands, options and shipped scenarios in a shell, by argcomplete (the `completion` extra)."""

from __future__ import annotations

import argparse
import os
from pathlib import Path

from testbed.aircraft.shipped import data_root, scenario_files, search_files, sweep_files
from testbed.inputs.problems import BadInput, Problem

SHELLS = ("bash", "zsh", "fish")


def script(shell: str) -> str:
    """The script that this shell has to source to complete `testbed`; raises BadInput if argcomplete is not installed."""
    try:
        from argcomplete.shell_integration import shellcode
    except ImportError:
        what = "completion needs argcomplete"
        raise BadInput([Problem(what, expected="pip install 'testbed[completion]'")]) from None
    text: str = shellcode(["testbed"], shell=shell)
    return text


def answer(parser: argparse.ArgumentParser) -> None:
    """If a shell asks for completions, answer it and end the process; else return at once."""
    if "_ARGCOMPLETE" in os.environ:
        import argcomplete

        argcomplete.autocomplete(parser)


def files(prefix: str, **_: object) -> list[str]:
    """YAML files and folders, and shipped scenarios, sweeps and searches, whose paths begin with `prefix`."""
    every = (*scenario_files(), *sweep_files(), *search_files())
    shipped = [str(file.relative_to(data_root())) for file in every]
    folder = Path(prefix).parent if Path(prefix).name or not prefix else Path(prefix)
    here = (
        [f"{path}/" if path.is_dir() else str(path) for path in folder.glob("*")] if folder.is_dir() else []
    )
    known = {name for name in (*shipped, *here) if name.endswith((".yaml", "/"))}
    return sorted(name for name in known if name.startswith(prefix))

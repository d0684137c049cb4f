"""Completion, as bash asks for it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import ROOT, Called

from testbed.cli.command import matching_files as files
from testbed.cli.completion import SHELLS

pytest.importorskip("argcomplete", reason="the completion extra")

ASK = """
source completion.sh
COMP_LINE="$1" COMP_POINT=${#1} COMP_TYPE=9 COMP_KEY=9 COMP_CWORD=9
COMP_WORDS=($1)
_python_argcomplete testbed
printf '%s\\n' "${COMPREPLY[@]}"
"""


@pytest.fixture
def program(tmp_path: Path) -> Path:
    """A folder with `testbed` as a command, and its completion script for bash."""
    command = tmp_path / "testbed"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m testbed "$@"\n')
    command.chmod(0o755)
    return tmp_path


def completed(program: Path, line: str) -> list[str]:
    """What bash would offer after this line."""
    paths = {"PATH": f"{program}:{os.environ['PATH']}", "PYTHONPATH": str(ROOT / "src")}
    environment = {**os.environ, **paths}
    with (program / "completion.sh").open("w") as script:
        subprocess.run(["testbed", "completion", "bash"], env=environment, stdout=script, check=True)
    bash = ["bash", "--norc", "--noprofile", "-c", ASK, "ask", line]
    result = subprocess.run(bash, cwd=program, env=environment, capture_output=True, text=True, check=True)
    return sorted(word.strip() for word in result.stdout.split("\n") if word.strip())


@pytest.mark.skipif(shutil.which("bash") is None, reason="there is no bash")
@pytest.mark.parametrize(
    ("line", "offered"),
    [
        ("testbed re", ["report"]),
        ("testbed list f", ["failures", "fmu"]),
        ("testbed sweep --sa", ["--save-logs"]),
        ("testbed run scenarios/left_t", ["scenarios/left_tail_fail.yaml"]),
        ("testbed sweep scenarios/sweeps/l", ["scenarios/sweeps/left_tail_monte_carlo.yaml"]),
        ("testbed run mi", ["mine.yaml"]),
    ],
)
def test_bash_completes(program: Path, line: str, offered: list[str]) -> None:
    (program / "mine.yaml").write_text("name: mine\n")
    assert completed(program, line) == offered


@pytest.mark.parametrize("shell", SHELLS)
def test_each_shell_has_its_script(called: Called, shell: str) -> None:
    status, out, err = called("completion", shell)
    assert (status, err) == (0, "") and "testbed" in out
    assert out.startswith("#compdef testbed\n") == (shell == "zsh"), "which begins a script of zsh"


def test_files_are_those_here_and_those_shipped(here: Path) -> None:
    (here / "scenarios").mkdir()
    (here / "scenarios" / "own.yaml").touch()
    (here / "note.txt").touch()
    assert files("") == sorted({"scenarios/", *(name for name in files("s") if name != "scenarios/")})
    assert files("scenarios/o") == ["scenarios/oscillating_ruddervator.yaml", "scenarios/own.yaml"]
    assert files("none/") == []

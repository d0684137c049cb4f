"""What a terminal shows while something takes long, read from a real pseudo-terminal; nothing where there is none."""

from __future__ import annotations

import os
import pty
import subprocess
import sys

from command_line import ROOT

PROGRAM = """
import time
from testbed.cli.working import working
with working("flying"):
    time.sleep({seconds})
"""


def _shown(seconds: float, terminal: bool, program: str = PROGRAM) -> str:
    """What is written to stderr."""
    command = [sys.executable, "-c", program.format(seconds=seconds)]
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "src")}
    if not terminal:
        return subprocess.run(command, capture_output=True, text=True, check=True, env=environment).stderr
    outside, inside = pty.openpty()
    subprocess.run(command, stderr=inside, check=True, env=environment)
    os.write(inside, b"end")
    os.close(inside)
    text = os.read(outside, 10000).decode()
    os.close(outside)
    return text


def test_long_work_is_named_and_leaves_no_trace() -> None:
    shown = _shown(2.2, terminal=True)
    assert "flying: 1 s" in shown
    last = shown.removesuffix("end").split("\r")
    assert last[-1] == "" and not last[-2].strip(), "the line is cleared"
    assert "\x1b" not in shown, "no colour, no hidden cursor"


def test_what_is_printed_meanwhile_has_a_line_of_its_own() -> None:
    program = PROGRAM.replace(
        "import time", "import sys, time\nfrom testbed.cli.terminal import plain_output"
    )
    program += "    with plain_output():\n        print('WARNING: wind', file=sys.stderr)\n"
    shown = _shown(1.8, terminal=True, program=program)
    assert "flying" in shown and shown.partition("WARNING")[0].endswith("\r")


def test_short_work_says_nothing() -> None:
    assert _shown(0.0, terminal=True) == "end"


def test_a_file_gets_nothing() -> None:
    assert _shown(1.5, terminal=False) == ""

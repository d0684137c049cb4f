"""What a terminal shows while something takes long, read from a real pseudo-terminal; nothing where there is none."""

from __future__ import annotations

import os
import pty
import re
import subprocess
import sys
import time

from command_line import ROOT

PROGRAM = """
import sys, time
from testbed.cli.terminal import working
with working("flying"):
    {work}
"""
UNTIL_TOLD = "sys.stdin.readline()"
LINE = re.compile(r"flying: (\d+) s")


def _started(program: str, stderr: int) -> subprocess.Popen[str]:
    command, environment = [sys.executable, "-c", program], {**os.environ, "PYTHONPATH": str(ROOT / "src")}
    return subprocess.Popen(command, stdin=subprocess.PIPE, stderr=stderr, text=True, env=environment)


def _shown(work: str, program: str = PROGRAM) -> str:
    """What a terminal gets, up to `end` from us; work that waits to be told is told once the line is there."""
    outside, inside = pty.openpty()
    process, text = _started(program.format(work=work), inside), ""
    while work == UNTIL_TOLD and not LINE.search(text):
        text += os.read(outside, 10000).decode()
    process.communicate("go on\n")
    assert process.returncode == 0
    os.write(inside, b"end")
    os.close(inside)
    text += os.read(outside, 10000).decode()
    os.close(outside)
    return text


def test_long_work_is_named_and_leaves_no_trace() -> None:
    before = time.monotonic()
    shown = _shown(UNTIL_TOLD)
    took = time.monotonic() - before
    times = [int(seconds) for seconds in LINE.findall(shown)]
    assert times and times == sorted(times) and times[0] >= 1 and times[-1] <= round(took)
    last = shown.removesuffix("end").split("\r")
    assert last[-1] == "" and not last[-2].strip(), "the line is cleared"
    assert "\x1b" not in shown, "no colour, no hidden cursor"


def test_what_is_printed_meanwhile_has_a_line_of_its_own() -> None:
    program = PROGRAM + "    from testbed.cli.terminal import plain_output\n    with plain_output():\n"
    shown = _shown(UNTIL_TOLD, program + "        print('WARNING: wind', file=sys.stderr)\n")
    assert "flying" in shown and shown.partition("WARNING")[0].endswith("\r")


def test_short_work_says_nothing() -> None:
    assert _shown("pass") == "end"


def test_a_file_gets_nothing() -> None:
    process = _started(PROGRAM.format(work="time.sleep(1.5)"), subprocess.PIPE)
    assert process.communicate()[1] == "" and process.returncode == 0

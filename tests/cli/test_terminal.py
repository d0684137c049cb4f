"""What commands print is shown by a terminal, not obeyed; in any encoding; into closed and full outputs."""

from __future__ import annotations

import os
import pty
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import Called

NAMED = "name: '{}'\naircraft: vtail\nduration_s: 1\ninitial: {{heading_deg: 90}}\n"


def test_an_escape_sequence_in_a_file_does_not_reach_the_terminal(here: Path, called: Called) -> None:
    (here / "s.yaml").write_text('"\\e[31mkey": 1\nname: "\\e]0;title\\a"\n')
    status, out, err = called("validate", "s.yaml")
    assert status == 2 and r"\x1b[31mkey: unknown key" in err
    assert "\x1b" not in out + err


def process(folder: Path, *arguments: str, **more: object) -> subprocess.CompletedProcess[bytes]:
    command = [sys.executable, "-m", "testbed", *arguments]
    return subprocess.run(command, cwd=folder, check=False, stderr=subprocess.PIPE, **more)  # type: ignore[call-overload, no-any-return]


def test_a_name_that_the_terminal_cannot_show_is_no_error(tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    done = process(tmp_path, "validate", "Ω.yaml", env=environment)
    assert (done.returncode, done.stderr) == (2, b"\\u03a9.yaml: there is no such file\n")


@pytest.mark.parametrize("closed", ["1>&-", "2>&-", "1>&- 2>&-"])
def test_closed_outputs(tmp_path: Path, closed: str) -> None:
    done = subprocess.run(
        f"{sys.executable} -m testbed list aircraft {closed}", shell=True, cwd=tmp_path, check=False
    )
    assert done.returncode == 0


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no /dev/full")
def test_a_full_disk_behind_stdout_is_said(tmp_path: Path) -> None:
    with open("/dev/full", "w") as full:
        done = process(tmp_path, "list", stdout=full)
    assert (done.returncode, done.stderr) == (3, b"cannot be read or written: No space left on device\n")


VERDICT = """
from testbed.cli.terminal import plain_output, print_verdict_word
with plain_output():
    print_verdict_word("passed", good=True)
    print(": all", flush=True)
"""


@pytest.mark.parametrize(
    ("more", "shown"),
    [({"TERM": "xterm"}, b"\x1b[32mpassed\x1b[0m: all"), ({"NO_COLOR": "1"}, b"passed: all"), ({"TERM": "dumb"}, b"passed: all")],
)  # fmt: skip
def test_the_verdict_has_a_colour_on_a_terminal_that_wants_it(more: dict[str, str], shown: bytes) -> None:
    environment = {**{name: value for name, value in os.environ.items() if name != "NO_COLOR"}, **more}
    outside, inside = pty.openpty()
    subprocess.run([sys.executable, "-c", VERDICT], stdout=inside, env=environment, check=True)
    os.close(inside)
    text = os.read(outside, 1000)
    os.close(outside)
    assert text.strip() == shown


def test_the_verdict_has_no_colour_in_a_file() -> None:
    done = subprocess.run([sys.executable, "-c", VERDICT], capture_output=True, check=True)
    assert done.stdout == b"passed: all\n"

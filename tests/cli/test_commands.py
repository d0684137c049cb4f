"""The commands as a whole: usage, version, exit status, and readers that go away."""

from __future__ import annotations

import argparse
import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import Called

import testbed as package
from testbed.aircraft.shipped import find_scenario
from testbed.cli.commands import FIRST_STEPS, TABLE, parser


@pytest.mark.parametrize(
    "arguments",
    [[], ["fly"], ["run"], ["list", "planes"], ["report", "nothing"], ["validate", "."], ["sweep", "x.yaml"]],
)
def test_usage_errors(here: Path, called: Called, arguments: list[str]) -> None:
    status, _, err = called(*arguments)
    assert status == 2
    assert err
    assert "Traceback" not in err


def test_the_version_is_the_packages(called: Called) -> None:
    assert called("--version") == (0, f"testbed {package.__version__}\n", "")


@pytest.mark.parametrize(
    ("command", "status"),
    [("list", 0), ("validate left_tail_fail.yaml", 0), ("validate left_tail_fail.yaml --set rate_hz=0", 2)],
)
def test_a_reader_that_goes_away_is_no_error(tmp_path: Path, command: str, status: int) -> None:
    """As of `testbed list | head -1`: the pipe's reading end is closed before anything is written to it."""
    reading, writing = os.pipe()
    os.close(reading)
    process = subprocess.run([sys.executable, "-m", "testbed", *command.split()], cwd=tmp_path, check=False,
                             stdout=writing, stderr=subprocess.PIPE, text=True)  # fmt: skip
    os.close(writing)
    assert process.returncode == status and (status != 0 or process.stderr == "")


def test_no_command_at_all_gets_first_steps(called: Called) -> None:
    assert called() == (2, "", FIRST_STEPS)
    for line in FIRST_STEPS.splitlines()[2:]:
        command = line.strip().partition("  ")[0]
        assert command == "testbed --help" or parses(command)


@pytest.mark.parametrize("name", TABLE)
def test_the_examples_of_a_command_are_its_own(name: str) -> None:
    """Each can be parsed, and a file that is shipped by its name is there."""
    assert TABLE[name].EXAMPLES
    for example in TABLE[name].EXAMPLES:
        options = parses(example)
        assert options.command == TABLE[name].run
        for given in (getattr(options, key, "") for key in ("scenario", "sweep", "search")):
            assert not given or given.startswith("my_") or find_scenario(given).is_file()


def parses(line: str) -> argparse.Namespace:
    program, *arguments = shlex.split(line.partition(" > ")[0])
    assert program == "testbed"
    return parser().parse_args(arguments)


def test_the_examples_are_shown(called: Called) -> None:
    status, out, _ = called("adopt", "--help")
    assert status == 0 and out.endswith("".join(f"\n  {line}" for line in TABLE["adopt"].EXAMPLES) + "\n")


def test_help_imports_nothing_heavy() -> None:
    program = (
        "import sys; from testbed.cli.commands import parser; parser().format_help()\n"
        "assert not {'numpy', 'pydantic', 'yaml', 'importlib.metadata'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", program], check=True)

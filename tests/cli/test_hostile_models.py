"""Models of others: whatever is wrong with one is said with its file, in every command, and nothing else happens."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from command_line import Called, testbed
from hostile_models import HOSTILE, vtail_at

SCENARIO = "name: x\naircraft: ./vtail\nduration_s: 1\nfailures:\n  - {type: motor_stop, actuator: left_propeller, at_s: 0.5}\n"
SWEEP = "scenario: s.yaml\nruns: 2\nvary: {initial.altitude_m: {uniform: [300, 310]}}\n"
_DEADLY = (
    "no engine file",
    "missing system",
    "no flight control",
    "missing property in aerodynamics",
    "nan in a propeller table",
)
"""Each of these ended the process of `validate`, `run` and `sweep` when JSBSim loaded the model there."""


def _with(name: str, folder: Path) -> None:
    HOSTILE[name].spoil(vtail_at(folder))
    (folder / "s.yaml").write_text(SCENARIO)
    (folder / "sweep.yaml").write_text(SWEEP)


def _names_the_fault(name: str, said: str) -> bool:
    files = HOSTILE[name].file.split("|")
    return any(
        Path(file).name in line and re.search(HOSTILE[name].words, line)
        for line in said.splitlines()
        for file in files
    )


@pytest.mark.parametrize("name", HOSTILE)
def test_validate_says_what_is_wrong_with_the_file(name: str, here: Path, called: Called) -> None:
    _with(name, here)
    before = sorted(here.rglob("*"))
    status, out, said = called("validate", "s.yaml")
    assert (status, out) == (2, "")
    assert _names_the_fault(name, said), said
    assert "Traceback" not in said
    assert sorted(here.rglob("*")) == before


@pytest.mark.parametrize(
    ("command", "name"),
    [
        *((command, name) for command in (("run", "s.yaml"), ("identify", "./vtail")) for name in _DEADLY),
        (("sweep", "sweep.yaml"), _DEADLY[0]),
        *(pytest.param(("sweep", "sweep.yaml"), name, marks=pytest.mark.nightly) for name in _DEADLY[1:]),
    ],
    ids=lambda each: each if isinstance(each, str) else each[0],
)
def test_every_command_survives_what_ends_jsbsim(
    name: str, command: tuple[str, ...], here: Path, called: Called
) -> None:
    _with(name, here)
    status, _, said = called(*command)
    assert status == 2
    assert _names_the_fault(name, said), said
    assert not (here / "runs").exists()


@pytest.mark.nightly
def test_a_process_of_its_own_ends_with_exit_status_2(tmp_path: Path) -> None:
    _with("missing property in aerodynamics", tmp_path)
    for command in (
        ("validate", "s.yaml"),
        ("run", "s.yaml"),
        ("sweep", "sweep.yaml"),
        ("identify", "./vtail"),
    ):
        done = testbed(tmp_path, *command)
        assert done.returncode == 2, done.stderr
        assert "did you mean aero/alpha-rad?" in done.stderr

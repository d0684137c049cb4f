"""The command line, as real processes: what it refuses, how it says so, and that it leaves nothing behind."""

from __future__ import annotations

import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest
from command_line import ROOT, testbed
from handmade import make_flight

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL
from testbed.cli.flight import write
from testbed.controllers.config import SETTINGS
from testbed.failures import TYPES
from testbed.flight.folder import write_run_folder
from testbed.metrics import TABLE as METRICS

BAD = """\
name: bad
aircraft: vtail
duration_s: 60
sed: 1
failures:
  - {type: effectiveness, actuator: left_rudervator, at_s: 5, value: 0.2}
  - {type: effectiveness, actuator: left_ruddervator, at_s: -1, value: 0.2}
"""

BAD_LINES = [
    "bad.yaml:4: sed: unknown key, did you mean seed?",
    "bad.yaml:6: failures.0.actuator: vtail has no actuator 'left_rudervator', "
    "did you mean left_ruddervator?",
    "bad.yaml:7: failures.1.at_s: is -1, expected greater than or equal to 0",
]


@pytest.mark.parametrize(
    "command", [["run"], ["validate"], ["run", "--out", "out", "--no-plots"]], ids=" ".join
)
def test_bad_input_is_refused_before_anything_happens(tmp_path: Path, command: list[str]) -> None:
    (tmp_path / "bad.yaml").write_text(BAD)
    result = testbed(tmp_path, command[0], "bad.yaml", *command[1:])
    assert result.returncode == 2
    assert result.stderr.splitlines() == BAD_LINES
    assert result.stdout == ""
    assert [p.name for p in tmp_path.iterdir()] == ["bad.yaml"]


def test_problems_of_settings_and_of_the_folder_come_together(tmp_path: Path) -> None:
    (tmp_path / "out").mkdir()
    scenario = "scenarios/left_tail_fail.yaml"
    result = testbed(
        tmp_path, "run", scenario, "--out", "out", "--set", "controller.gama=4", "--set", "seed=-1"
    )
    assert result.returncode == 2
    assert sorted(result.stderr.splitlines(), reverse=True) == [
        "out: exists already, expected a folder that does not exist yet",
        "--set seed=-1: seed: is -1, expected greater than or equal to 0",
        "--set controller.gama=4: controller.gama: unknown key, did you mean gamma?",
    ]
    assert [p.name for p in tmp_path.rglob("*")] == ["out"]


def test_validate_accepts_what_is_shipped_from_any_folder(tmp_path: Path) -> None:
    names = [
        f"scenarios/{side}_{part}_fail.yaml" for side in ("left", "right") for part in ("tail", "propeller")
    ]
    result = testbed(tmp_path, "validate", *names)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.splitlines() == [f"{name}: ok" for name in names]


def test_validate_knows_the_model_the_log_and_the_metrics(tmp_path: Path) -> None:
    """What can be checked only against the loaded JSBSim model and the tables of higher layers."""
    (tmp_path / "x.yaml").write_text(
        "name: x\naircraft: vtail\nduration_s: 60\nfailures:\n"
        "  - {type: property, at_s: 5, set: {fcs/left-ruddervator/comand-scale: 1}}\n"
        "  - {type: property, at_s: 5, set: {aero/alpha-rad: 1, fcs/left-ruddervator/command-scale: 1}}\n"
        "  - {type: property, when: {signal: altitud_m, below: 1}, set: {atmosphere/delta-T: 1}}\n"
        "requirements:\n  - {metric: altitude_error_mx_m, at_most: 1}\n  - {signal: heading_dg, at_most: 1}\n"
    )
    result = testbed(tmp_path, "validate", "x.yaml")
    assert result.returncode == 2
    assert sorted(line.split(":")[1:3] for line in result.stderr.splitlines()) == [
        ["10", " requirements.1.signal"],
        ["5", " failures.0.set.fcs/left-ruddervator/comand-scale"],
        ["6", " failures.1.set.aero/alpha-rad"],
        ["7", " failures.2.when.signal"],
        ["9", " requirements.0.metric"],
    ]
    assert result.stderr.count("did you mean") == 4


def test_validate_goes_on_after_a_bad_file(tmp_path: Path) -> None:
    (tmp_path / "bad.yaml").write_text(BAD)
    result = testbed(
        tmp_path, "validate", "bad.yaml", "scenarios/left_tail_fail.yaml", "scenarios/lefttail_fail.yaml"
    )
    assert result.returncode == 2
    assert result.stdout == "scenarios/left_tail_fail.yaml: ok\n"
    *first, last = result.stderr.splitlines()
    assert first == BAD_LINES
    assert last.endswith("there is no such file, did you mean scenarios/left_tail_fail.yaml?")


def test_a_file_in_the_folder_comes_before_a_shipped_one(tmp_path: Path) -> None:
    (tmp_path / "scenarios").mkdir()
    (tmp_path / "scenarios" / "left_tail_fail.yaml").write_text(BAD)
    assert testbed(tmp_path, "validate", "scenarios/left_tail_fail.yaml").returncode == 2


@pytest.mark.parametrize(
    ("what", "names"),
    [("failures", TYPES), ("controllers", SETTINGS), ("aircraft", ["vtail"]), ("metrics", METRICS)],
)
def test_list(tmp_path: Path, what: str, names: list[str]) -> None:
    result = testbed(tmp_path, "list", what)
    assert result.returncode == 0
    listed = {line.split()[0]: line.split()[1:] for line in result.stdout.splitlines()[1:]}
    assert set(names) <= set(listed)
    assert all(listed.values()), "each with its meaning"


@pytest.mark.parametrize(
    "arguments",
    [[], ["fly"], ["run"], ["list", "planes"], ["report", "nothing"], ["validate", "."], ["sweep", "x.yaml"]],
)
def test_usage_errors(tmp_path: Path, arguments: list[str]) -> None:
    result = testbed(tmp_path, *arguments)
    assert result.returncode == 2
    assert result.stderr
    assert "Traceback" not in result.stderr


def test_a_damaged_run_folder_is_reported(tmp_path: Path) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    (folder / "summary.json").unlink()
    result = testbed(tmp_path, "report", "run")
    assert result.returncode == 2
    assert result.stderr == "run/summary.json: is missing from the run folder\n"


def test_default_folders_are_numbered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    folders = [str(write(make_flight(), None, lambda _: None)) for _ in range(3)]
    assert folders == [f"runs/left-tail-failure{end}" for end in ("", "-2", "-3")]


def test_validating_without_failures_is_quick(tmp_path: Path) -> None:
    """Heavy libraries stay out; the limit is generous, the list of what must not be loaded is not."""
    (tmp_path / "x.yaml").write_text("name: x\naircraft: vtail\nduration_s: 1\n")
    program = (
        "import sys; from testbed.__main__ import main; assert main(['validate', 'x.yaml']) == 0\n"
        "assert not {'pandas', 'matplotlib', 'numba', 'scipy', 'jsbsim', 'pyarrow'} & set(sys.modules)"
    )
    start = time.perf_counter()
    subprocess.run([sys.executable, "-c", program], cwd=tmp_path, check=True)
    assert time.perf_counter() - start < 3.0


def test_identify_writes_what_it_then_agrees_with(tmp_path: Path) -> None:
    """On a copy of the v-tail: written anew it is the stored one; a changed number is noticed, and mended."""
    folder = shutil.copytree(load_aircraft("vtail").folder, tmp_path / "aircraft" / "vtail")
    model = folder / DESIGN_MODEL
    name = str(folder)
    assert testbed(tmp_path, "identify", name, "--check").returncode == 0
    text = model.read_text()
    model.write_text(text.replace('"altitude_m": 300', '"altitude_m": 301'))
    assert model.read_text() != text
    differs = testbed(tmp_path, "identify", name, "--check")
    assert (differs.returncode, differs.stdout) == (1, f"{model}: differs from what is identified now\n")
    assert testbed(tmp_path, "identify", name).stdout == f"wrote {model}\n"
    assert testbed(tmp_path, "identify", name, "--check").returncode == 0
    model.write_text("{}")
    damaged = testbed(tmp_path, "identify", name, "--check")
    assert damaged.returncode == 2
    assert damaged.stderr.startswith(f"{model}: is no design model: ")
    assert testbed(tmp_path, "identify", "vtial").returncode == 2


def test_what_the_controller_says_of_a_failure_is_printed(tmp_path: Path) -> None:
    shipped = (ROOT / "scenarios" / "mems_turbulence.yaml").read_text()
    lost = "{type: effectiveness, actuator: left_ruddervator, at_s: 40, value: 0.0}"
    assert lost in shipped
    (tmp_path / "reversed.yaml").write_text(
        shipped.replace(lost, "{type: reversal, actuator: left_ruddervator, at_s: 40}")
    )
    result = testbed(tmp_path, "run", "reversed.yaml", "--no-plots", "--out", "out")
    assert result.returncode == 0, result.stdout + result.stderr
    said = [line for line in result.stdout.splitlines() if line.startswith("  controller at 40.")]
    assert len(said) == 1 and "left_ruddervator: not a loss of effectiveness" in said[0]

"""Input is checked whole before anything flies: every problem at once, each with its place."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from command_line import in_this_process, testbed

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
    result = in_this_process(tmp_path, command[0], "bad.yaml", *command[1:])
    assert result.returncode == 2
    assert result.stderr.splitlines() == BAD_LINES
    assert result.stdout == ""
    assert [p.name for p in tmp_path.iterdir()] == ["bad.yaml"]


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
    result = in_this_process(tmp_path, "validate", "x.yaml")
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
    result = in_this_process(
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
    assert in_this_process(tmp_path, "validate", "scenarios/left_tail_fail.yaml").returncode == 2


def test_validating_what_is_known_imports_nothing_heavy(tmp_path: Path) -> None:
    """The first time, the model is loaded and trimmed. After that nothing heavy is imported; how long it takes is not measured."""
    (tmp_path / "x.yaml").write_text("name: x\naircraft: vtail\nduration_s: 1\n")
    assert testbed(tmp_path, "validate", "x.yaml").returncode == 0
    program = (
        "import sys; from testbed.__main__ import main; assert main(['validate', 'x.yaml']) == 0\n"
        "assert not {'pandas', 'matplotlib', 'numba', 'scipy', 'jsbsim', 'pyarrow'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", program], cwd=tmp_path, check=True)

"""The `control` block of an aircraft: a typo is refused when the aircraft is loaded, at its line, by every command."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from command_line import ROOT, in_this_process

from testbed.aircraft.control_design import ControlDesign, IntegralDeviations, StateDeviations
from testbed.aircraft.description import load_aircraft
from testbed.common.signals import RATES
from testbed.controllers.records import INTEGRALS, REGULATOR_STATE
from testbed.inputs.problems import BadInput

SCENARIO = """name: mine
aircraft: ./vtail
duration_s: 1
initial: {altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
"""
WRONG = {
    ("  priorities: [", "  prioritie: ["): "control.prioritie: unknown key, did you mean priorities?",
    (
        "left_propeller: [p_dot]",
        "left_propelle: [p_dot]",
    ): "control.release.left_propelle: vtail has no actuator 'left_propelle', did you mean left_propeller?",
    (
        "left_propeller: [p_dot]",
        "left_propeller: [p_dott]",
    ): "control.release.left_propeller.0: 'p_dott' is not known, did you mean p_dot?",
    (
        "left_ruddervator+right_ruddervator:",
        "right_ruddervator+left_ruddervator:",
    ): "is not in the order of the actuators, expected left_ruddervator+right_ruddervator",
    (
        "priorities: [q_dot, u_dot, r_dot, p_dot]",
        "priorities: [q_dot, q_dot]",
    ): "control.priorities.1: names q_dot twice, expected each axis once",
    ("axes: [p_dot, q_dot,", "axes: [q_dot,"): "vtail has no axis p_dot, expected one of q_dot, r_dot, u_dot",
    (
        "  priorities: [",
        "  loops: {airspeed_kpp: 1}\n  priorities: [",
    ): "control.loops.airspeed_kpp: unknown key, did you mean airspeed_kp?",
    (
        "  priorities: [",
        '  condition_max: "50"\n  priorities: [',
    ): "control.condition_max: is '50', expected a",
}


def changed(folder: Path, old: str, new: str) -> Path:
    """A copy of the v-tail with one change in its YAML."""
    shutil.copytree(ROOT / "aircraft" / "vtail", folder / "vtail")
    file = folder / "vtail" / "vtail.yaml"
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))
    return file


@pytest.mark.parametrize(("change", "message"), WRONG.items(), ids=[new for _, new in WRONG])
def test_what_is_wrong_is_said_at_its_line(tmp_path: Path, change: tuple[str, str], message: str) -> None:
    file = changed(tmp_path, *change)
    with pytest.raises(BadInput) as caught:
        load_aircraft(str(tmp_path / "vtail"))
    (problem, *_) = [p for p in caught.value.problems if message in str(p)]
    line = file.read_text().splitlines()[(problem.line or 0) - 1]
    assert problem.path.split(".")[-1] in line or problem.path.split(".")[-2] in line


def test_validate_and_run_refuse_it_alike(tmp_path: Path) -> None:
    changed(tmp_path, "  priorities: [", "  prioritie: [")
    (tmp_path / "mine.yaml").write_text(SCENARIO)
    for arguments in (["validate", "mine.yaml"], ["run", "mine.yaml", "--out", "out"]):
        result = in_this_process(tmp_path, *arguments)
        assert result.returncode == 2
        assert re.search(
            r"vtail\.yaml:\d+: control\.prioritie: unknown key, did you mean priorities\?", result.stderr
        )
        assert "Traceback" not in result.stderr


def test_without_a_block_the_defaults_are_flown(tmp_path: Path) -> None:
    text = (ROOT / "aircraft" / "vtail" / "vtail.yaml").read_text()
    changed(tmp_path, text[text.index("\ncontrol:") :], "\n")
    assert load_aircraft(str(tmp_path / "vtail")).control == ControlDesign()


def test_every_state_integral_and_rate_has_its_weight() -> None:
    assert tuple(StateDeviations.model_fields) == REGULATOR_STATE
    assert tuple(IntegralDeviations.model_fields) == INTEGRALS
    design = ControlDesign()
    assert tuple(type(design.disturbance).model_fields) == RATES
    assert tuple(type(design.model_error_std).model_fields) == RATES

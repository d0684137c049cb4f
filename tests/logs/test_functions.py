"""The functions of an aircraft's XML behind a coefficient: those that the model's author put there, and by how much."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from testbed.aircraft.description import load_aircraft
from testbed.logs.identification import REST, makers


def test_the_functions_of_a_coefficient() -> None:
    """Pitch damping of the v-tail: Cm_q -10.06 and Cm_alphadot -3.64 of the XML, as pitching is alpha's rate too while alpha is
    held; the lift's arm about the centre of gravity and the slipstream on the tails are left."""
    found = makers(load_aircraft("vtail"), ["Cm_q", "Cl_p", "Cn_left_propeller"])
    first, second = found["Cm_q"]
    assert (first[:2], second[:2]) == (
        ("aero/coefficient/Cm_q", "PITCH"),
        ("aero/coefficient/Cm_alphadot", "PITCH"),
    )
    assert first.share / second.share == pytest.approx(10.0586 / 3.64479, rel=0.15)
    assert [str(each) for each in found["Cl_p"]] == ["aero/coefficient/Cl_p (ROLL) 100 %"]
    assert found["Cn_left_propeller"][0].function == REST


def test_a_function_without_a_name_is_among_the_rest(tmp_path: Path) -> None:
    """With the share that it had under its name."""
    folder = shutil.copytree(load_aircraft("aerosonde").folder, tmp_path / "aerosonde")
    before = makers(load_aircraft(str(folder)), ["CX_elevator"])["CX_elevator"]
    xml = folder / "aerosonde.xml"
    xml.write_text(xml.read_text().replace('<function name="aero/coefficient/CD_elevator">', "<function>"))
    after = makers(load_aircraft(str(folder)), ["CX_elevator"])["CX_elevator"]
    assert before[0][:2] == ("aero/coefficient/CD_elevator", "DRAG")
    assert after[0].function == REST and after[0].share == pytest.approx(before[0].share, abs=0.01)


def test_nothing_wanted_needs_no_trim() -> None:
    assert makers(load_aircraft("vtail"), []) == {}

"""An aircraft's YAML: what it says, what is refused, and the fingerprint of all that it is made of."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import pytest

from testbed.aircraft.description import Aircraft, MotorActuator, Servo, load_aircraft
from testbed.inputs.problems import BadInput


def change(folder: Path, old: str, new: str, file: str = "vtail.yaml") -> None:
    text = (folder / file).read_text()
    assert old in text
    (folder / file).write_text(text.replace(old, new, 1))


def test_the_vtail(vtail: Aircraft) -> None:
    assert vtail.name == vtail.model == vtail.folder.name == "vtail"
    assert list(vtail.actuators) == [
        "left_ruddervator",
        "right_ruddervator",
        "left_propeller",
        "right_propeller",
    ]
    assert [type(a) for a in vtail.actuators.values()] == [Servo, Servo, MotorActuator, MotorActuator]
    assert set(vtail.axes) == {"p_dot", "q_dot", "r_dot", "u_dot"}


def test_the_lag_of_a_motor(vtail: Aircraft) -> None:
    """1 / time constant of a motor without load, R J K_v / K_t with K_t = 1 / K_v: the README states 35 ms with the
    propeller's share of damping left out."""
    motor = vtail.actuators["left_propeller"]
    assert isinstance(motor, MotorActuator)
    k_v = motor.motor.velocity_constant_rpm_v * 2.0 * math.pi / 60.0
    expected = 1.0 / (motor.motor.resistance_ohm * motor.motor.rotor_inertia_kg_m2 * k_v * k_v)
    assert motor.lag_rad_s == pytest.approx(expected)
    assert 1.0 / motor.lag_rad_s == pytest.approx(0.035, abs=0.001)


REFUSED = [
    ("kind: servo", "kind: servoo", "actuators.left_ruddervator.kind", "did you mean servo?"),
    ("model: vtail", "modle: vtail", "modle", "did you mean model?"),
    ("rate_limit:", "rate_limt:", "actuators.left_ruddervator.rate_limt", "did you mean rate_limit?"),
    ("axes: [", "axes: [q_dot, ", "axes", "names an axis twice"),
    ("airspeed_m_s: 18", "airspeed_m_s: 0", "reference.airspeed_m_s", "greater than 0"),
]


@pytest.mark.parametrize(("old", "new", "path", "words"), REFUSED)
def test_refused_at_its_place(vtail_copy: Path, old: str, new: str, path: str, words: str) -> None:
    change(vtail_copy, old, new)
    with pytest.raises(BadInput) as caught:
        load_aircraft(str(vtail_copy))
    found = {problem.path: problem for problem in caught.value.problems}
    assert words in str(found[path])
    assert found[path].file == str(vtail_copy / "vtail.yaml")
    assert found[path].line


def test_limits_must_leave_room(vtail_copy: Path) -> None:
    text = (vtail_copy / "vtail.yaml").read_text()
    limits = next(line.strip() for line in text.splitlines() if "limits:" in line)
    change(vtail_copy, limits, "limits: [5, 5]")
    with pytest.raises(BadInput, match=r"limits: \[5.0, 5.0\] leaves no travel"):
        load_aircraft(str(vtail_copy))


def test_it_is_read_again_when_it_was_edited(vtail_copy: Path) -> None:
    first = load_aircraft(str(vtail_copy))
    first.fingerprint()
    assert load_aircraft(str(vtail_copy)) == first
    change(vtail_copy, "name: vtail", "name: edited")
    assert load_aircraft(str(vtail_copy)).name == "edited"


# The fingerprint --------------------------------------------------------------------------------------------------


def propeller(folder: Path) -> None:
    change(folder, "<numblades>2", "<numblades>3", "Engines/vtail_prop.xml")


def mass(folder: Path) -> None:
    change(folder, '<emptywt unit="KG">4.95', '<emptywt unit="KG">5.94', "vtail.xml")


def servo(folder: Path) -> None:
    change(folder, "lag_rad_s: 30", "lag_rad_s: 20")


def reference(folder: Path) -> None:
    change(folder, "airspeed_m_s: 18", "airspeed_m_s: 19")


def new_file(folder: Path) -> None:
    (folder / "Engines" / "another.xml").write_text("<x/>")


def renamed(folder: Path) -> None:
    (folder / "Engines" / "vtail_prop.xml").rename(folder / "vtail_prop.xml")


@pytest.mark.parametrize("edit", [propeller, mass, servo, reference, new_file, renamed])
def test_an_edit_of_what_flies_has_another_fingerprint(
    vtail_copy: Path, edit: Callable[[Path], None]
) -> None:
    before = load_aircraft(str(vtail_copy)).fingerprint()
    edit(vtail_copy)
    assert load_aircraft(str(vtail_copy)).fingerprint() != before


def test_the_fingerprint_is_of_the_contents(vtail: Aircraft, vtail_copy: Path) -> None:
    """The same wherever the folder is, and whatever is said of it."""
    assert load_aircraft(str(vtail_copy)).fingerprint() == vtail.fingerprint()
    change(vtail_copy, "name: vtail", "name: edited")
    assert load_aircraft(str(vtail_copy)).fingerprint() == vtail.fingerprint()


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("prefix: fcs/left-ruddervator", "prefix: 'nan]]>fcs/left'", "is no name of a property"),
        ("prefix: fcs/left-ruddervator", "prefix: fcs/left-rudde]rvator", "is no name of a property"),
        ("  left_ruddervator:", "  '=left, right':", "cannot begin the name of a column"),
    ],
)
def test_names_that_a_property_or_a_column_cannot_have(
    vtail_copy: Path, old: str, new: str, words: str
) -> None:
    file = vtail_copy / "vtail.yaml"
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))
    with pytest.raises(BadInput, match=words):
        load_aircraft(str(vtail_copy))

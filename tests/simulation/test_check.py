"""The check before a flight: one for the command line, `fly` and `Session`, with every problem and its place."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import caches
import pytest

import testbed
from testbed import BadInput, Session
from testbed.aircraft.description import load_aircraft
from testbed.plant.trim import NoTrim, trimmed_start
from testbed.scenario.load import load_scenario
from testbed.simulation.check import check, check_start, name_problems

CRUISE = "name: x\naircraft: vtail\nduration_s: 3\n"
SLOW = "initial: {altitude_m: 300, airspeed_m_s: 9}\n"
NAMES = (
    "failures:\n  - {type: property, at_s: 1, set: {fcs/left-ruddervator/comand-scale: 1}}\n"
    "requirements:\n  - {metric: altitude_error_mx_m, at_most: 1}\n"
)


def problems_of(file: Path) -> list[str]:
    """What each of the three ways to fly a scenario says, which must be the same."""
    said = []
    for way in (lambda: check(load_scenario(file)), lambda: testbed.fly(file), lambda: Session(file)):
        with pytest.raises(BadInput) as caught:
            way()
        said.append([str(problem).removeprefix(f"{file}:") for problem in caught.value.problems])
    assert said[0] == said[1] == said[2]
    return said[0]


def test_everything_unknown_has_its_place(tmp_path: Path) -> None:
    (file := tmp_path / "x.yaml").write_text(CRUISE + NAMES)
    assert problems_of(file) == [
        "7: requirements.0.metric: unknown metric 'altitude_error_mx_m'"
        " (one of your own needs --with FILE.py), did you mean altitude_error_max_m?",
        "5: failures.0.set.fcs/left-ruddervator/comand-scale: unknown property "
        "fcs/left-ruddervator/comand-scale, did you mean fcs/left-ruddervator/command-scale?",
    ]
    scenario = load_scenario(file)
    assert len(name_problems(scenario, load_aircraft("vtail"))) == 2


def test_a_start_without_a_trimmed_flight_has_its_place_beside_the_rest(tmp_path: Path) -> None:
    (file := tmp_path / "x.yaml").write_text(CRUISE + SLOW + NAMES)
    metric, start = problems_of(file)
    assert metric.startswith("8: requirements.0.metric")
    assert start.startswith("4: initial: no steady flight of vtail was found at 9 m/s, 300 m")


@pytest.mark.parametrize(("altitude_m", "refused"), [(-50, True), (0, True), (0.49, True), (1.0, False)])
def test_a_start_on_or_below_the_ground_is_refused(altitude_m: float, refused: bool) -> None:
    changes = {"initial.altitude_m": altitude_m, "duration_s": 0.1, "failures": [], "commands": []}
    changes |= {"requirements": []}
    if not refused:
        assert testbed.fly("scenarios/left_tail_fail.yaml", set=changes).end_time_s == 0.1
        return
    words = f"initial.altitude_m: {altitude_m:g} m is on or below the ground, .*expected at least 0.5"
    with pytest.raises(BadInput, match=words):
        testbed.fly("scenarios/left_tail_fail.yaml", set=changes)


def test_wheels_in_the_ground_are_refused(vtail_copy: Path) -> None:
    """A contact point 2 m below the centre of gravity, and flights one metre lower and higher than that."""
    model = vtail_copy / "vtail.xml"
    contact = """<ground_reactions><contact type="STRUCTURE" name="SKID">
      <location unit="M"><x>0.04564</x><y>0</y><z>-2.07744</z></location>
      <static_friction>0.2</static_friction><dynamic_friction>0.2</dynamic_friction><rolling_friction>0</rolling_friction>
      <spring_coeff unit="N/M">100</spring_coeff><damping_coeff unit="N/M/SEC">10</damping_coeff>
      </contact></ground_reactions>"""
    model.write_text(model.read_text().replace("<ground_reactions/>", contact))
    aircraft = load_aircraft(str(vtail_copy))
    assert trimmed_start(aircraft, 200.0, 18.0, 3.0, 0.0).residual < 1e-6
    with pytest.raises(NoTrim, match=r"touches the ground at 1 m, expected a higher one"):
        trimmed_start(aircraft, 200.0, 18.0, 1.0, 0.0)


def test_a_failure_waits_for_what_is_known_in_flight(tmp_path: Path) -> None:
    """The columns of sensors are made after it."""
    waits: dict[str, Any] = {"type": "stuck", "actuator": "left_ruddervator"}
    waits["when"] = {"signal": "alpha_measured_deg", "above": 3}
    changes = {"sensors": "mems", "failures": [waits]}
    with pytest.raises(BadInput, match=r"failures\.0\.when\.signal: unknown signal 'alpha_measured_deg'"):
        testbed.fly("scenarios/left_tail_fail.yaml", set=changes)


START = (200.0, 18.0, 300.0, 0.0)


def test_no_flight_begins_where_there_is_no_trim(vtail_copy: Path) -> None:
    with pytest.raises(NoTrim, match=r"no steady flight of vtail was found at 9 m/s"):
        check_start(load_aircraft(str(vtail_copy)), (200.0, 9.0, 300.0, 0.0))


def test_what_is_known_is_not_tried_again(
    vtail_copy: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    caches.forget()
    aircraft = load_aircraft(str(vtail_copy))
    check_start(aircraft, START)
    monkeypatch.setattr("testbed.plant.trim.trimmed_start", lambda *_: pytest.fail("trimmed again"))
    check_start(aircraft, START)
    with pytest.raises(BaseException, match="trimmed again"):
        check_start(aircraft, (200.0, 18.5, 300.0, 0.0))


def test_a_design_model_that_is_none_is_bad_input(vtail_copy: Path) -> None:
    (vtail_copy / "design_model.json").write_text("{}")
    with pytest.raises(BadInput, match=r"design_model\.json: is no design model"):
        check_start(load_aircraft(str(vtail_copy)), START)

"""One failure on one plant: what it holds, what it warns of, and which actuator it breaks."""

from __future__ import annotations

from pathlib import Path

import pytest
from broken_flights import AIRCRAFT, END_S, START_S, example, fly, scenario

from testbed.cli.commands import main
from testbed.failures import TABLE
from testbed.flight.folder import load
from testbed.injection.injection import broken_actuator
from testbed.scenario.load import dump

LEFT, RIGHT = "fcs/left-ruddervator/", "fcs/right-ruddervator/"


@pytest.mark.parametrize(
    ("held", "actuator"),
    [
        ([f"{LEFT}command-scale"], "left_ruddervator"),
        ([f"{RIGHT}command-scale", f"{RIGHT}servo-rate-rad_sec"], "right_ruddervator"),
        ([f"{LEFT}command-scale", f"{RIGHT}command-scale"], None),
        ([f"{LEFT}command-scale", "atmosphere/wind-north-fps"], None),
        (["fcs/left-ruddervator-trim"], None),
    ],
)
def test_a_property_failure_breaks_the_actuator_whose_block_it_stays_in(
    held: list[str], actuator: str | None
) -> None:
    failure = TABLE["property"].model_validate(
        {"type": "property", "at_s": 1.0, "set": dict.fromkeys(held, 0.5)}
    )
    assert broken_actuator(failure, AIRCRAFT) == actuator


def test_any_other_failure_breaks_the_actuator_it_names() -> None:
    failure = TABLE["surface_lost"].model_validate(
        {"type": "surface_lost", "actuator": "left_ruddervator", "at_s": 1.0}
    )
    assert any(not name.startswith(LEFT) for name in failure.properties(AIRCRAFT))  # its mass
    assert broken_actuator(failure, AIRCRAFT) == "left_ruddervator"


def test_receipts_of_start_and_end() -> None:
    flown = fly(example("command_scale", "left_propeller"))
    start, end = flown.event(), flown.event(active=False)
    name = "fcs/left-propeller/command-scale"
    assert (start["time_s"], start["properties"]) == (START_S, {name: 0.5})
    assert (end["time_s"], end["properties"], end["verified"]) == (END_S, {name: 1.0}, True)
    assert "effect" in start and "effect" not in end


def test_a_failure_that_starts_after_the_end_says_so() -> None:
    """Nothing is due in a flight that ends on the ground before."""
    low = {"initial": {"altitude_m": 0.6, "airspeed_m_s": 18, "heading_deg": 90}}
    low["commands"] = [{"at_s": 0, "altitude_m": -50}]
    flown = fly({"type": "stuck", "actuator": "left_propeller", "at_s": 1.0}, **low)
    assert flown.flight.end_time_s < 1.0
    assert flown.flight.warnings == [
        "failures.0 (stuck, left_propeller) never started: the flight ended before"
    ]


def test_the_command_line_is_loud(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "scenario.yaml"
    file.write_text(dump(scenario({**example("effectiveness", "left_ruddervator"), "value": 1.0})))
    main(["run", str(file), "--out", str(tmp_path / "run"), "--no-plots"])
    warning = "failures.0 (effectiveness, left_ruddervator) at 0.5 s had no observable effect"
    assert f"WARNING: {warning}" in capfd.readouterr().err
    assert warning in load(tmp_path / "run").warnings[0]

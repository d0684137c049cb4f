"""The minimal aircraft of the reference page: as short as it says, and it flies."""

from __future__ import annotations

from command_line import ROOT

from testbed.flight.flight import Outcome
from testbed.scenario.model import Scenario
from testbed.simulation import fly

FOLDER = ROOT / "examples" / "minimal"


def test_it_is_minimal() -> None:
    assert len((FOLDER / "minimal.xml").read_text(encoding="utf-8").splitlines()) <= 60


def test_it_turns_and_climbs() -> None:
    flight = fly(
        Scenario.model_validate(
            {
                "name": "minimal",
                "aircraft": str(FOLDER),
                "duration_s": 30,
                "initial": {"altitude_m": 300, "airspeed_m_s": 18, "heading_deg": 90},
                "commands": [{"at_s": 2, "heading_deg": 110, "altitude_m": 305}],
            }
        )
    )
    end = flight.log.iloc[-1]
    assert flight.outcome is Outcome.completed
    assert abs(end.altitude_m - 305) < 0.5
    assert abs(end.heading_deg - 110) < 1.0

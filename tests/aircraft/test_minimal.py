"""The minimal aircraft of the reference page: as short as it says, and it flies."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from command_line import ROOT

from testbed.flight.flight import Outcome
from testbed.scenario.model import Scenario
from testbed.simulation import fly

FOLDER = ROOT / "examples" / "minimal"
START = {"altitude_m": 300, "airspeed_m_s": 18, "heading_deg": 90}


def test_it_is_minimal() -> None:
    assert len((FOLDER / "minimal.xml").read_text(encoding="utf-8").splitlines()) <= 60


def test_it_turns_and_climbs() -> None:
    flight = fly(
        Scenario.model_validate(
            {
                "name": "minimal",
                "aircraft": str(FOLDER),
                "duration_s": 30,
                "initial": START,
                "commands": [{"at_s": 2, "heading_deg": 110, "altitude_m": 305}],
            }
        )
    )
    end = flight.log.iloc[-1]
    assert flight.outcome is Outcome.completed
    assert abs(end.altitude_m - 305) < 0.5
    assert abs(end.heading_deg - 110) < 1.0


@pytest.mark.parametrize(
    "failure",
    [
        {"type": "effectiveness", "value": 0.4},
        {"type": "stuck"},
        {"type": "hardover", "to": "max"},
        {"type": "float"},
        {"type": "bias", "value": 1},
    ],
    ids=lambda failure: failure["type"],
)
def test_the_block_of_the_reference_page_breaks(failure: dict[str, object], tmp_path: Path) -> None:
    """The servo's block on the page, in place of the short one of the minimal aircraft's elevator: each failure acts at once."""
    page = (ROOT / "docs" / "reference" / "aircraft.md").read_text(encoding="utf-8")
    block = re.search(r"```xml\n(<property value=\"0\">fcs/elevator/.*?)```", page, re.DOTALL)
    assert block is not None
    folder = Path(shutil.copytree(FOLDER, tmp_path / "minimal"))
    text = (folder / "minimal.xml").read_text(encoding="utf-8")
    text = re.sub(r"<property value=\"\d\">fcs/elevator/[a-z-]+</property>", "", text)
    text = re.sub(r"<actuator name=\"fcs/elevator/servo\">.*?</actuator>", "", text, flags=re.DOTALL)
    text = text.replace("</flight_control>", f"{block[1]}</flight_control>")
    (folder / "minimal.xml").write_text(text, encoding="utf-8")
    flight = fly(
        Scenario.model_validate(
            {
                "name": "page",
                "aircraft": str(folder),
                "duration_s": 2,
                "initial": START,
                "failures": [{**failure, "actuator": "elevator", "at_s": 1}],
            }
        )
    )
    (injection,) = (event for event in flight.events if event["kind"] == "injection")
    assert injection["verified"], injection

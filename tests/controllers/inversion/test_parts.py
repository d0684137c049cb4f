"""Each test for a kind of failure can be switched off, and then that failure is taken for another."""

from __future__ import annotations

from pathlib import Path

import pytest

from testbed import fly
from testbed.scenario.load import load_scenario

SCENARIOS = Path(__file__).parents[3] / "scenarios"
TAIL = "actuator: left_ruddervator"
FLIGHTS = {
    "offset_test": (
        "jammed_ruddervator.yaml",
        f"failures=[{{type: bias, {TAIL}, at_s: 2, value: 10}}]",
        "duration_s=8",
        "commands=[]",
    ),
    "lateness": (
        "mems_turbulence.yaml",
        f"failures=[{{type: delay, {TAIL}, at_s: 20, delay_s: 0.15}}]",
        "initial.airspeed_m_s=15",
        "commands=[{at_s: 8, heading_deg: 120, altitude_m: 305}, {at_s: 18, altitude_m: 312}]",
        "duration_s=28",
        "seed=101",
    ),
}


@pytest.mark.parametrize(
    ("part", "with_it", "without"),
    [
        ("offset_test", "follows its command with an offset", "does not follow its command"),
        ("lateness", None, "does not follow its command"),
    ],
)
def test_what_a_part_finds_is_not_found_without_it(
    part: str, with_it: str | None, without: str | None
) -> None:
    for ablate, said, unsaid in (("", with_it, without), (part, without, with_it)):
        file, *changes = FLIGHTS[part]
        controller = f"controller={{type: adaptive_inversion, ablate: [{ablate}]}}"
        flight = fly(load_scenario(SCENARIOS / file, [*changes, controller, "requirements=[]"]))
        texts = " ".join(event.get("text", "") for event in flight.events)
        assert said is None or said in texts
        assert unsaid is None or unsaid not in texts

"""x"""

from __future__ import annotations

import pytest

from testbed import fly
from testbed.scenario.load import Scenario, load_scenario


def scenario(*settings: str) -> Scenario:
    return load_scenario(
        "scenarios/left_tail_fail.yaml", ["duration_s=2", "failures=[]", "requirements=[]", *settings]
    )


@pytest.mark.parametrize(
    "errors",
    [
        "{Cm_alpha: 1.2, Cl_beta: 0.8, Cm_right_ruddervator: 1.2, CX_left_propeller: 1.2}",
        "{Cl_left_propeller: 1.2}",
    ],
)
def test_a_model_error_changes_the_flight_but_not_the_trim(errors: str) -> None:
    """In trimmed flight a wrong slope has nothing to act on; in a manoeuvre it has."""
    turn = "commands=[{at_s: 1, heading_deg: 120, altitude_m: 305}]"
    sure, wrong = fly(scenario(turn)), fly(scenario(turn, f"controller.model_error={errors}"))
    before = sure.log["time_s"] <= 1.0
    for name in ("altitude_m", "heading_deg", "airspeed_m_s", "pitch_deg"):
        difference = (wrong.log[name] - sure.log[name]).abs()
        assert difference[before].max() < 1e-4, name
        assert difference[~before].max() > 10 * difference[before].max(), name

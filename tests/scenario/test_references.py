"""References approach commands at their limited rate, and headings turn the short way."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from testbed.common.signals import SETPOINT
from testbed.scenario.load import Scenario
from testbed.scenario.references import references

RATES = {"heading_deg_s": 4, "altitude_m_s": 2, "airspeed_m_s2": 0.5}


def scenario_of(*commands: dict[str, Any], heading_deg: float = 90.0) -> Scenario:
    return Scenario.model_validate(
        {
            "name": "references",
            "aircraft": "vtail",
            "duration_s": 20,
            "rate_hz": 10,
            "initial": {"altitude_m": 300, "airspeed_m_s": 18, "heading_deg": heading_deg},
            "commands": list(commands),
            "command_rates": RATES,
        }
    )


def flown(*commands: dict[str, Any], heading_deg: float = 90.0) -> dict[str, np.ndarray]:
    """References of 20 s at 10 Hz by name, from 300 m, 18 m/s."""
    rows = references(scenario_of(*commands, heading_deg=heading_deg))
    assert rows.shape == (200, len(SETPOINT))
    return dict(zip(SETPOINT, rows.T, strict=True))


def test_without_commands_the_initial_condition_is_held() -> None:
    of = flown()
    for name, value in (("altitude", 300.0), ("airspeed", 18.0), ("heading", math.pi / 2)):
        assert np.all(of[name] == value)
        assert np.all(of[f"{name}_rate"] == 0.0)


def test_a_ramp_and_its_rate() -> None:
    """From 5 s on 2 m/s, 10 m in 5 s; at the moment of the command nothing has moved yet."""
    of = flown({"at_s": 5, "altitude_m": 310})
    time = np.arange(200) / 10
    np.testing.assert_allclose(of["altitude"], 300 + np.clip(2 * (time - 5), 0, 10), atol=1e-9)
    assert np.array_equal(of["altitude_rate"], np.where((time >= 5) & (time < 10), 2.0, 0.0))
    assert np.all(of["airspeed"] == 18.0) and np.all(of["heading_rate"] == 0.0)


def test_downwards_too() -> None:
    of = flown({"at_s": 1, "airspeed_m_s": 16})
    assert of["airspeed"][-1] == pytest.approx(16.0)
    assert of["airspeed_rate"].min() == -0.5 and of["airspeed_rate"].max() == 0.0


@pytest.mark.parametrize(
    ("begin", "target", "turn"), [(90, 120, 30), (350, 10, 20), (10, 350, -20), (0, 90, 90), (200, 10, 170)]
)
def test_a_heading_turns_the_short_way(begin: float, target: float, turn: float) -> None:
    """Continuous, also across north: it goes on below 0 or beyond 360 degrees."""
    of = flown({"at_s": 0, "heading_deg": begin}, {"at_s": 2, "heading_deg": target}, heading_deg=begin)
    change = np.degrees(of["heading"] - of["heading"][0])
    assert change[-1] == pytest.approx(math.copysign(min(abs(turn), 4 * 17.9), turn))
    assert np.abs(np.diff(change)).max() == pytest.approx(0.4)


def test_a_command_before_the_last_is_reached_starts_from_there() -> None:
    of = flown({"at_s": 0, "altitude_m": 320}, {"at_s": 4, "altitude_m": 300})
    assert of["altitude"][40] == pytest.approx(308.0)
    assert of["altitude"][80] == pytest.approx(300.0)
    assert of["altitude"].max() == pytest.approx(308.0)
    assert np.abs(np.diff(of["altitude"])).max() <= 0.2 + 1e-9


def test_a_command_after_the_last_step_changes_nothing() -> None:
    """The last step of 20 s at 10 Hz is at 19.9 s."""
    assert np.all(flown({"at_s": 19.95, "altitude_m": 310})["altitude"] == 300.0)
    assert flown({"at_s": 19.9, "altitude_m": 310})["altitude_rate"][-1] == 2.0


@pytest.mark.parametrize("done", [1, 49, 50, 51, 90, 120, 199])
def test_made_again_from_a_row_on_they_are_the_same_bytes(done: int) -> None:
    """With a command before, at and after it, in the middle of a change; the rows before are not touched."""
    before = [{"at_s": 1.3, "altitude_m": 307.7, "heading_deg": 10}, {"at_s": 5, "airspeed_m_s": 19.3}]
    after = [{"at_s": done / 10, "altitude_m": 303.1}, {"at_s": 15.1, "heading_deg": 200, "altitude_m": 300}]
    earlier = [command for command in before if command["at_s"] < done / 10]
    both = scenario_of(*earlier, *(command for command in after if command["at_s"] >= done / 10))
    for angle in (0.0, -0.05):
        whole, rows = references(both, angle), references(scenario_of(*earlier), angle)
        assert references(both, angle, rows, done) is rows
        assert rows.tobytes() == whole.tobytes()

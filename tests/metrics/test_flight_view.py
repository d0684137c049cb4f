"""What metrics see of a flight, and the questions that many of them ask."""

from __future__ import annotations

import pytest
from handmade import ACTUATORS, at, flight_of, injection, level_log, readings_of

from testbed.flight.flight import Outcome
from testbed.metrics import adaptation_rates, readings
from testbed.scenario.load import Scenario


def test_of_a_flight() -> None:
    log = level_log()
    log["altitude_m"][at(3)] = 102.0
    of = readings(flight_of(log, [injection(4.0)], outcome=Outcome.diverged))
    assert of.error("altitude")[at(3)] == 2.0 and of.log["altitude_m"].flags.c_contiguous
    assert (of.survived, of.failure_times_s()) == (False, [4.0])
    assert list(of.actuators) == list(ACTUATORS)


@pytest.mark.parametrize(
    ("heading", "command", "error"),
    [(5.0, 350.0, 15.0), (350.0, 5.0, -15.0), (90.0, 80.0, 10.0), (180.0, 0.0, 180.0), (0.0, 180.0, -180.0)],
)
def test_heading_error_goes_the_short_way(heading: float, command: float, error: float) -> None:
    log = level_log()
    log["heading_deg"][:], log["heading_command_deg"][:] = heading, command
    assert set(readings_of(log).error("heading")) == {error}


def test_rows_and_failures() -> None:
    of = readings_of(level_log(), injection(4.0), injection(2.0, "fan"), injection(6.0, active=False))
    assert of.failure_times_s() == [2.0, 4.0]
    assert of.first_failed_row() == at(2.0)
    assert readings_of(level_log()).first_failed_row() == 1000
    assert of.step_s == pytest.approx(0.01) and of.row_at(3.005) == 301


@pytest.mark.parametrize(
    ("controller", "rates"),
    [
        ({"type": "adaptive_inversion", "gamma": 2.0}, {"elevon": 2.0, "fan": 2.0}),
        ({"type": "adaptive_inversion", "gamma": {"servo": 2.0, "motor": 3.0}}, {"elevon": 2.0, "fan": 3.0}),
        ({"type": "pid"}, {}),
    ],
)
def test_adaptation_rates(controller: dict[str, object], rates: dict[str, float]) -> None:
    scenario = Scenario.model_validate(
        {**flight_of(level_log()).scenario.model_dump(), "controller": controller}
    )
    assert adaptation_rates(scenario, ACTUATORS) == rates

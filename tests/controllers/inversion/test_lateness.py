"""Late actuators: a delay is found, and is not taken for lost effectiveness."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from command_line import ROOT
from short_flights import worst_errors

from testbed.controllers.inversion.estimator import (
    LATENESS_MAX,
    LATENESS_VARIANCE_MAX,
    delay_regressor,
    estimate_lateness,
)
from testbed.controllers.inversion.law import lag_gain, low_pass
from testbed.controllers.records import memory_dtype, settings_dtype
from testbed.flight.flight import Outcome
from testbed.scenario.load import load_scenario
from testbed.simulation import fly

N, DT, CORNER = 2, 0.005, 20.0
EFFECT = np.array([[2.0, 0.3], [0.2, 4.0], [1.0, -1.0], [0.1, 0.2]])


def oscillation(
    delay_s: float, effectiveness: float, seconds: float = 30.0, rate: float = 6.3
) -> tuple[Any, np.ndarray]:
    """Memory after an oscillation of `rate` rad/s with the first actuator late or weak, and the last error that was left [4]."""
    c, s = np.zeros(1, settings_dtype(N))[0], np.zeros(1, memory_dtype(N))[0]
    c.dt, c.late_noise, c.filter_rate = DT, 0.1, CORNER
    c.noise[:] = [0.5, 0.5, 0.15, 0.08]
    s.lambda_hat[:] = 1.0
    phi, e, z_lags = np.zeros((4, N)), np.zeros(4), np.zeros((2, 4))
    worst = np.zeros(4)
    for k in range(round(seconds / DT)):
        t = k * DT
        a = np.array([math.sin(rate * t), math.cos(4.0 * t)])
        late = np.array([effectiveness * math.sin(rate * (t - delay_s)), a[1]])
        phi[:] = EFFECT * a
        z = EFFECT @ late
        low_pass(z, z_lags, lag_gain(CORNER * DT))
        for i in range(4):
            low_pass(phi[i], s.filtered_phi[:, i], lag_gain(CORNER * DT))
        delay_regressor(phi, c, s)
        e[:] = z - phi @ s.lambda_hat
        estimate_lateness(e, c, s)
        if t > seconds - 2.0:
            worst = np.maximum(worst, np.abs(e))
    return s, worst


@pytest.mark.parametrize("delay_s", [0.03, 0.1])
def test_a_delay_is_found_and_explains_the_error(delay_s: float) -> None:
    s, worst = oscillation(delay_s, 1.0)
    assert s.late[0] / CORNER == pytest.approx(delay_s, rel=0.2)
    assert s.late[1] == pytest.approx(0.0, abs=0.1)
    assert worst[0] < 0.3 * 2.0 * 2.0 * math.sin(0.5 * 6.3 * 0.1), "less than a third of the error without it"


def test_of_a_fast_swing_late_by_a_quarter_of_a_turn_half_is_explained() -> None:
    """.15 s at 10 rad/s is a phase of 86 deg: a lag turns by it only with a part of the size."""
    s, worst = oscillation(0.15, 1.0, rate=10.0)
    without = 2.0 * 2.0 / (1.0 + (10.0 / CORNER) ** 2) * math.sin(0.5 * 10.0 * 0.15)
    assert worst[0] < 0.5 * without
    assert 0.1 < s.late[0] / CORNER < 0.25


def test_no_delay_is_found_where_there_is_none() -> None:
    s, worst = oscillation(0.0, 1.0)
    assert np.all(s.late < 1e-6) and np.all(worst < 1e-6)


def test_a_weak_actuator_is_not_called_late() -> None:
    s, _ = oscillation(0.0, 0.5)
    assert s.late[0] / CORNER < 0.01


def test_lateness_and_its_variance_are_bounded() -> None:
    s, _ = oscillation(0.45, 1.0, 5.0)
    assert np.all((s.late >= 0.0) & (s.late <= LATENESS_MAX)) and np.all(
        s.late_variance <= LATENESS_VARIANCE_MAX
    )


@pytest.mark.parametrize("late", ["left_ruddervator", "left_ruddervator, right_ruddervator"])
def test_late_surfaces_are_flown_without_swinging(late: str) -> None:
    """At 15 m/s in gusts ruddervators .15 s late are not given more gain for a low estimate: nothing is flagged."""
    failures = ", ".join(
        f"{{type: delay, actuator: {name}, at_s: 20, delay_s: 0.15}}" for name in late.split(", ")
    )
    scenario = load_scenario(
        ROOT / "scenarios" / "mems_turbulence.yaml",
        [
            f"failures=[{failures}]",
            "initial.airspeed_m_s=15",
            "controller={type: adaptive_inversion}",
            "commands=[{at_s: 8, heading_deg: 120, altitude_m: 305}, {at_s: 18, altitude_m: 312}]",
            "requirements=[]",
            "duration_s=36",
            "seed=101",
        ],
    )
    flight = fly(scenario)
    altitude, heading, _ = worst_errors(flight, 20.0)
    assert flight.outcome is Outcome.completed and altitude < 5.0 and heading < 15.0
    assert not [event for event in flight.events if event["kind"] in ("detection", "false_alarm")]

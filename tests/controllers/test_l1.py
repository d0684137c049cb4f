"""L1 inversion: a fast estimator, a low-pass in the control channel, and a monitor that shares nothing with either."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from short_flights import scenario, worst_errors
from vtail_setup import Records, records_of, vtail_setup

from testbed.controllers.augmentation import (
    adapt_fast,
    fast_settings,
    forget_lost,
    l1_inversion,
    low_pass_channel,
)
from testbed.controllers.config import L1InversionSettings
from testbed.inputs.problems import BadInput
from testbed.metrics import readings
from testbed.simulation import fly

SETTINGS = L1InversionSettings(released=())
SETUP = vtail_setup(SETTINGS)
DT = 0.005


def records(**settings: float) -> Records:
    """The controller's records, wide stops, and these settings."""
    found = records_of(SETUP)._replace(c=fast_settings(SETUP, SETTINGS)[0])
    found.m.low[:], found.m.high[:] = -1e6, 1e6
    for name, value in settings.items():
        found.c[name] = value
    return found


def test_the_channel_ends_in_r_over_lambda_without_a_division() -> None:
    """With the truth for an estimate, from r to lambda u it is lambda (s + k) / (s + k lambda): a step begins with lambda r and
    settles with k lambda. Explicit steps: the factor of each is exactly 1 - k lambda dt."""
    m, c, k, s, _ = records(channel_rate=8.0)
    truth = np.array([1.0, 0.5, 0.2, 1.6])
    s.lambda_hat[:], s.r[:], s.correction[:] = truth, 0.3, 0.0
    effects = []
    for _ in range(400):
        low_pass_channel(m, c, k, s)
        effects.append(truth * s.u / 0.3 - 1.0)
    decay = 1.0 - 8.0 * truth * DT
    expected = (truth - 1.0) * decay ** np.arange(1, 401)[:, None]
    assert np.array(effects) == pytest.approx(expected, abs=1e-13)


@pytest.mark.parametrize("estimate", [0.05, 0.2, 1.0, 2.0])
def test_the_channel_never_raises_the_gain_at_high_frequencies(estimate: float) -> None:
    """At half the sample rate u = r (z - 1 + k dt) / (z - 1 + k lambda_hat dt) with z = -1: within 3 % of r for any estimate,
    where r / lambda_hat is up to 20 r."""
    m, c, k, s, _ = records(channel_rate=8.0)
    s.lambda_hat[:], s.correction[:] = estimate, 0.0
    gains = []
    for step in range(4000):
        s.r[:] = (-1.0) ** step
        low_pass_channel(m, c, k, s)
        gains.append(abs(s.u[0]))
    expected = (2.0 - 8.0 * DT) / (2.0 - 8.0 * estimate * DT)
    assert gains[-1] == pytest.approx(expected, rel=0.05)
    assert 0.9 < gains[-1] < 1.1


def test_at_a_stop_the_channel_does_not_wind_up() -> None:
    m, c, k, s, _ = records()
    m.high[:] = 0.5
    s.lambda_hat[:], s.r[:], s.correction[:] = 0.1, 0.3, 0.0
    for _ in range(2000):
        low_pass_channel(m, c, k, s)
    assert s.u.tolist() == [0.5] * 4 and s.correction == pytest.approx(np.full(4, 0.2))
    s.r[:] = -0.3
    low_pass_channel(m, c, k, s)
    assert s.u[0] < 0.0


def test_what_is_not_used_goes_to_its_trim_position() -> None:
    m, c, k, s, _ = records()
    k.available[1], s.r[:], s.correction[:] = 0, 0.3, 0.7
    low_pass_channel(m, c, k, s)
    assert (s.u[1], s.correction[1]) == (m.trim_position[1], 0.0)


def test_eq_13_fast_estimates_are_of_the_mode_in_force() -> None:
    """With yaw given up an error of yaw alone changes nothing; with all rates kept it is (13)."""
    m, c, k, s, _ = records(epsilon=np.full(4, 1e-6))
    s.position[:] = [0.3, -0.2, 1.0, 2.0]
    e = np.array([0.0, 0.0, 0.4, 0.0])
    adapt_fast(e, 1.0, m, c, k, s)
    expected = 1.0 + DT * 20.0 * np.linalg.inv(m.B) @ e / s.position
    assert s.lambda_hat == pytest.approx(expected, rel=1e-12)
    before = s.lambda_hat.copy()
    k.B_hat_inv[:, 2] = 0.0
    adapt_fast(e, 1.0, m, c, k, s)
    assert s.lambda_hat.tolist() == before.tolist()


def test_fast_estimates_are_projected_and_stop_with_the_actuator() -> None:
    m, c, k, s, _ = records()
    s.position[:], k.available[3] = 1.0, 0
    for sign, bound in ((-1.0, c.lambda_min), (1.0, c.lambda_max)):
        for _ in range(2000):
            adapt_fast(sign * m.B.sum(axis=1), 1.0, m, c, k, s)
        assert s.lambda_hat.tolist() == [bound] * 3 + [1.0]


def test_a_lost_actuator_explains_nothing() -> None:
    *_, s, w = records()
    w.phi[:], s.failed[:], s.jammed[:] = 1.0, [1, 0, 1, 0], [0, 0, 1, 0]
    forget_lost(w.phi, s)
    assert w.phi.tolist() == [[0.0, 1.0, 1.0, 1.0]] * 4


def test_fast_adaptation_is_integral_control_of_the_measured_effect() -> None:
    """v' = k (r - lambda_hat u) with lambda_hat u -> z as Gamma grows: the same commands as v' = k (r - z), incremental
    inversion's. On an actuator of effectiveness 0.4 with a disturbance."""
    apart = []
    for gamma in (20.0, 180.0):
        m, c, k, s, _ = records(gamma=np.full(4, gamma), epsilon=np.full(4, 1e-6), channel_rate=4.0)
        c.lambda_max, s.correction[:] = 10.0, 0.0
        v = 0.0
        worst = 0.0
        for step in range(600):
            s.r[:] = 1.0 + 0.3 * np.sin(4.0 * step * DT)
            low_pass_channel(m, c, k, s)
            s.position[:] = s.u
            z = 0.4 * s.u + 0.1
            e = m.B @ (z - s.lambda_hat * s.position)
            adapt_fast(e, 1.0, m, c, k, s)
            of_integral = s.r[0] + v
            v += DT * 4.0 * (s.r[0] - (0.4 * of_integral + 0.1))
            worst = max(worst, abs(of_integral - s.u[0]) if step > 60 else 0.0)
        apart.append(worst)
    assert apart[1] < 0.25 * apart[0] and apart[1] < 0.04


def test_the_settings_are_its_own() -> None:
    chosen = L1InversionSettings(fast_gamma=7.0, control_rad_s=3.0, lambda_max=1.5, filter_rad_s=9.0)
    c = fast_settings(vtail_setup(chosen), chosen)[0]
    assert (c.gamma.tolist(), c.channel_rate, c.lambda_max, c.filter_rate) == ([7.0] * 4, 3.0, 1.5, 9.0)


def test_an_aircraft_that_cannot_be_inverted_is_refused_before_the_flight() -> None:
    control = SETUP.control.model_copy(update={"condition_max": 2.0})
    with pytest.raises(BadInput, match="vtail cannot be flown by inversion"):
        l1_inversion(replace(SETUP, control=control))


def test_it_flies_a_lost_tail_and_logs_what_its_monitor_estimates(tmp_path: Path) -> None:
    lost = "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 5, value: 0}]"
    flight = fly(scenario(tmp_path, "l1_inversion", 14, lost))
    assert (flight.outcome, flight.metrics["missed_detections"]) == ("completed", 0)
    assert flight.metrics["false_alarms"] == 0 and flight.metrics["detection_delay_s"] < 1.5
    altitude, heading, _ = worst_errors(flight)
    assert (altitude < 1.5, heading < 6.0) == (True, True), (altitude, heading)
    estimate = readings(flight).log["left_ruddervator_effectiveness_estimate"]
    assert estimate[0] == 1.0 and estimate[-1] < 0.1


def test_it_says_that_a_surface_has_an_offset(tmp_path: Path) -> None:
    offset = "failures=[{type: bias, actuator: left_ruddervator, at_s: 2, value: 13.5}]"
    flight = fly(scenario(tmp_path, "l1_inversion", 8, offset))
    assert any("with an offset" in event.get("text", "") for event in flight.events)


def test_without_its_monitor_it_makes_up_for_a_loss_and_flags_nothing(tmp_path: Path) -> None:
    weak = "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 3, value: 0.2}]"
    flight = fly(scenario(tmp_path, "l1_inversion", 14, weak, "controller.monitor=false"))
    altitude, heading, _ = worst_errors(flight)
    assert (flight.outcome, altitude < 1.0, heading < 4.0) == ("completed", True, True), (altitude, heading)
    assert np.isnan(flight.column("left_ruddervator_failed")).all()
    assert np.isnan(flight.column("left_ruddervator_effectiveness_estimate")).all()

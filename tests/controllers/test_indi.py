"""Incremental inversion: what is measured stands in for what is modelled."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from short_flights import scenario, worst_errors
from vtail_setup import records_of, trim_state, vtail_setup

from testbed.controllers.config import IndiSettings
from testbed.controllers.indi import indi, measured_remainder
from testbed.controllers.inversion.law import regressor, state_function
from testbed.inputs.problems import BadInput
from testbed.metrics import readings
from testbed.simulation import fly

SETUP = vtail_setup(IndiSettings())
MODEL = SETUP.model


@pytest.mark.parametrize("regulated", [0, 1])
def test_the_remainder_is_the_measured_rates_without_the_actuators(regulated: int) -> None:
    """z = x_c_dot - Phi 1, and without f_m in a regulated mode; no filter."""
    m, c, k, s, w = records_of(SETUP)
    rates = {"p_dot": 0.3, "q_dot": -0.2, "r_dot": 0.1, "u_dot": 0.4}
    y = trim_state(MODEL, beta=0.02, **rates)
    s.position[:], c.filter_rate, k.regulated = [0.2, -0.1, 1.0, 2.0], 0.0, regulated
    state_function(y, m, w.f)
    measured_remainder(y, 1.0, m, c, k, s, w.f, w.phi, w.z)
    phi = np.zeros((4, 4))
    regressor(1.0, m, s, phi)
    assert w.z == pytest.approx(np.array(list(rates.values())) + m.offset - regulated * w.f - phi.sum(axis=1))


def test_what_is_flagged_acts_by_its_known_position_or_not_at_all() -> None:
    m, c, k, s, w = records_of(SETUP)
    y = trim_state(MODEL)
    c.filter_rate, k.regulated = 0.0, 0
    s.position[:] = [0.2, -0.1, 1.0, 2.0]
    s.failed[:], s.jammed[:], s.lambda_hat[:] = [1, 0, 1, 0], [1, 0, 0, 0], [-0.7, 1.0, 0.3, 1.0]
    measured_remainder(y, 1.0, m, c, k, s, w.f, w.phi, w.z)
    acts = m.B[:, 0] * -0.7 + m.B[:, 1] * -0.1 + m.B[:, 3] * 2.0
    propeller = s.torque[3] - m.torque_slope[3] * 2.0
    assert w.z == pytest.approx(m.offset - acts - m.B_torque[:, 3] * propeller)


def test_with_a_monitor_it_sees_what_the_adaptive_law_would(tmp_path: Path) -> None:
    lost = "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 5, value: 0}]"
    without = fly(scenario(tmp_path, "indi", 12, lost))
    flight = fly(scenario(tmp_path, "indi", 12, lost, "controller.monitor=true"))
    assert math.isnan(without.metrics["missed_detections"]) and flight.metrics["missed_detections"] == 0
    assert (flight.metrics["false_alarms"], flight.outcome) == (0, "completed")
    log = readings(flight).log
    assert [round(log[f"{name}_effectiveness_estimate"][-1]) for name in flight.actuators] == [0, 1, 1, 1]


def test_the_filter_is_the_settings() -> None:
    controller = indi(vtail_setup(IndiSettings(filter_rad_s=7.0)))
    assert controller._records[1][0].filter_rate == 7.0


def test_an_aircraft_that_cannot_be_inverted_is_refused_before_the_flight() -> None:
    control = SETUP.control.model_copy(update={"condition_max": 2.0})
    with pytest.raises(BadInput, match="vtail cannot be flown by inversion"):
        indi(replace(SETUP, control=control))


def test_indi_makes_up_for_a_wrong_model(tmp_path: Path) -> None:
    """Half the pitch stiffness missing from its model: increments find the rest, a fixed inversion is thrown off."""
    wrong = "controller.model_error={Cm_alpha: 0.5, Cm_q: 0.5}"
    indi = worst_errors(fly(scenario(tmp_path, "indi", 25, wrong)))[0]
    fixed = worst_errors(fly(scenario(tmp_path, "fixed_inversion", 25, wrong)))[0]
    assert indi < fixed


def test_light_turbulence_is_held_with_real_sensors(tmp_path: Path) -> None:
    """What is asked of the healthy aircraft: within 4 m and 6 deg."""
    weather = ("sensors=mems", "atmosphere.turbulence_w20_m_s=7.62", "seed=2", "controller.released=[p_dot]")
    altitude, heading, _ = worst_errors(fly(scenario(tmp_path, "indi", 40, *weather)))
    assert altitude < 4.0
    assert heading < 6.0

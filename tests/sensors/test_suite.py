"""Sensors in a flight: what the accelerometer feels, ideal sensors, noise in the log, and determinism."""

from __future__ import annotations

import math

import numpy as np
import pytest
from measuring import RATE, scenario

from testbed import fly
from testbed.sensors.measurement import ERROR, FAULT, OFFSET, READING
from testbed.sensors.settings import Sensors
from testbed.sensors.suite import RealSensors


def test_the_accelerometer_feels_what_jsbsim_flies() -> None:
    """With sensors that have no errors, u_dot of the accelerometer is JSBSim's own in a manoeuvre, but for
    gravity's change with place (0.3 %) and the Earth's rotation; p_dot is a step late."""
    fault = "sensors={faults: [{type: bias, sensor: position, at_s: 3.9, value_m: 1}]}"
    turn = "commands=[{at_s: 0, heading_deg: 120, airspeed_m_s: 19}]"
    log = fly(scenario(fault, turn)).log
    assert log["u_dot_true_m_s2"].abs().max() > 0.2
    assert (log["u_dot_m_s2"] - log["u_dot_true_m_s2"]).abs().max() < 0.01
    assert (log["q_dot_deg_s2"] - log["q_dot_true_deg_s2"].shift(1)).abs().max() < 1e-6


def test_ideal_is_the_truth_and_adds_nothing() -> None:
    flight = fly(scenario("sensors=ideal"))
    assert not [c for c in flight.columns if "measured" in c or "_true_" in c]
    assert fly(scenario()).data.tobytes() == flight.data.tobytes()
    assert Sensors.model_validate("ideal").is_ideal
    assert Sensors.model_validate({"gyro": {"noise_deg_s_rthz": 0.0}}).is_ideal
    assert not Sensors.model_validate("mems").is_ideal


def test_noise_of_a_flight_measured_from_its_log() -> None:
    """From the log of a flight with MEMS gyros: 0.007 deg/s/rtHz. First differences, so that bias and drift
    do not count: their variance is twice the noise's; quantisation adds 1/12 digit squared."""
    log = fly(scenario("sensors=mems", "controller.released=[p_dot]", "controller.filter_rad_s=20")).log
    for name in "pqr":
        error = np.diff(log[f"{name}_measured_deg_s"] - log[f"{name}_deg_s"])[10:]
        expected = 2 * (0.007**2 * RATE / 2 + 0.0153**2 / 12)
        assert np.var(error) == pytest.approx(expected, rel=5 * math.sqrt(3 / len(error)))


def test_the_same_flight_twice_and_another_seed() -> None:
    settings = ("sensors=mems", "controller.released=[p_dot]", "duration_s=1")
    first, again, other = (fly(scenario(*settings, f"seed={seed}")) for seed in (1, 1, 2))
    assert first.data.tobytes() == again.data.tobytes()
    assert first.data.tobytes() != other.data.tobytes()


def test_a_flight_that_gets_longer_has_the_errors_of_a_long_one_and_keeps_its_memory() -> None:
    """With a fault that draws random numbers to the end. Copies of the process share what is not written again."""
    settings = Sensors.model_validate(
        {"model": "mems", "faults": [{"type": "dropout", "sensor": "gyro_q", "at_s": 1, "fraction": 0.5}]}
    )
    whole, grown = (RealSensors(settings, lambda: 0.0, 200, steps, 3) for steps in (1600, 400))
    grown.table[READING, :400] = 7.0
    grown.lengthen(800)
    before = grown.table
    grown.lengthen(1600)
    assert np.shares_memory(before, grown.table)
    for layer in (ERROR, OFFSET, FAULT):
        assert grown.table[layer, :1600].tobytes() == whole.table[layer].tobytes()
    assert np.all(grown.table[READING, :400] == 7.0) and np.all(grown.table[READING, 400:1600] == 0.0)

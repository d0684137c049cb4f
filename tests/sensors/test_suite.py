"""Sensors in a flight: what the accelerometer feels, ideal sensors, noise in the log, and determinism.

Random errors have the densities, variances and correlation times that were asked for, each from its own stream.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from measuring import NAMES, RATE, fault_of, measured, readings, scenario, truth_rows

from testbed import fly
from testbed.sensors.channels import CHANNELS
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


@pytest.mark.parametrize("channel", NAMES)
def test_noise_has_the_density_that_was_asked_for(channel: str) -> None:
    """sigma = N sqrt(rate/2), and means of m samples have 1/m of its variance, as white noise of one-sided
    density N must. A variance of n samples has the relative deviation sqrt(2/n); 5 of them fail once in 2
    million."""
    _, sensor, _, unit = CHANNELS[NAMES.index(channel)]
    density, n, m = 0.01, 40_000, 100
    error = readings({sensor: {f"noise_{unit}_rthz": density}}, channel, n)
    variance = density**2 * RATE / 2
    assert np.var(error) == pytest.approx(variance, rel=5 * math.sqrt(2 / n))
    means = error.reshape(-1, m).mean(axis=1)
    assert np.mean(means**2) == pytest.approx(variance / m, rel=5 * math.sqrt(2 * m / n))


def test_drift_and_wander() -> None:
    """A random walk's increments have variance K^2 dt; a wander has its sigma and correlation time: the
    relative deviation of its variance over T is sqrt(2 tau / T)."""
    walk = readings({"altitude": {"drift_m_rts": 0.3}}, "altitude", 20_000)
    assert walk[0] == 0.0
    assert np.var(np.diff(walk)) == pytest.approx(0.3**2 / RATE, rel=5 * math.sqrt(2 / 20_000))
    tau, steps = 0.05, 40_000
    wander = readings({"alpha": {"wander_deg": 0.4, "wander_time_s": tau}}, "alpha", steps)
    bound = 5 * math.sqrt(2 * tau * RATE / steps)
    assert np.mean(wander**2) == pytest.approx(0.16, rel=bound)
    lag = round(tau * RATE)
    assert np.mean(wander[lag:] * wander[:-lag]) == pytest.approx(0.16 * math.exp(-1), rel=2 * bound)


def test_bias_and_scale_are_drawn_for_each_flight() -> None:
    draws = [readings({"beta": {"bias_sigma_deg": 0.3}}, "beta", 2, seed) for seed in range(300)]
    assert all(one[0] == pytest.approx(one[1]) for one in draws)
    assert np.std([one[0] for one in draws]) == pytest.approx(0.3, rel=5 / math.sqrt(600))
    scales = {float(readings({"airspeed": {"scale_error_sigma": 0.1}}, "airspeed", 2, s)[0]) for s in (1, 2)}
    assert len(scales) == 2


def test_adding_a_random_part_moves_no_other() -> None:
    truth = truth_rows(200)
    few = {"gyro": {"noise_deg_s_rthz": 0.01}}
    more = {"gyro": {"noise_deg_s_rthz": 0.01, "bias_sigma_deg_s": 1.0}, "altitude": {"noise_m_rthz": 1.0}}
    more["faults"] = [fault_of("noise", "airspeed")]  # type: ignore[assignment]
    one, other = (measured(settings, truth)[0].table[READING] for settings in (few, more))
    q = NAMES.index("gyro_q")
    shift = other[:, q] - one[:, q]
    np.testing.assert_allclose(shift, shift[0], atol=1e-15)  # the bias, and the same noise
    longer = measured(few, truth_rows(300))[0].table[READING]
    assert np.array_equal(longer[:200], one)

"""Random errors have the densities, variances and correlation times that were asked for, each from its own stream."""

from __future__ import annotations

import math

import numpy as np
import pytest
from measuring import NAMES, RATE, fault_of, measured, readings, truth_rows

from testbed.sensors.channels import CHANNELS
from testbed.sensors.measurement import READING


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

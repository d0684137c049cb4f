"""The compiled step of the sensors: which truth reaches which measured signal, against closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from measuring import NAMES, RATE, SENSED, measured, truth_rows

from testbed.common.signals import STATE
from testbed.sensors.measurement import READING


@pytest.mark.parametrize("column", range(len(STATE) + 8))
def test_what_has_no_sensor_is_not_known(column: int) -> None:
    """NaN in one entry of the truth reaches what is computed from its sensor, and nothing else."""
    truth = truth_rows(20)
    _, sound = measured("mems", truth)
    truth[:, column] = np.nan
    _, poisoned = measured("mems", truth)
    name = STATE[column] if column < len(STATE) else "an actuator"
    reached = {STATE[i] for i in np.flatnonzero(np.isnan(poisoned).any(axis=0))}
    if name not in SENSED:
        assert not reached
    else:
        derived = {"pitch", "q", "r", "airspeed", "alpha", "beta"}
        expected = {name} | ({"u_dot"} if name in derived else set())
        expected |= {f"{name}_dot"} if name in ("p", "q", "r") else set()
        assert reached == expected
    others = [i for i, s in enumerate(STATE) if s not in reached]
    assert np.array_equal(poisoned[:, others], sound[:, others])


def test_rates_come_from_gyros_and_accelerometer() -> None:
    truth = truth_rows(50)
    fault = {"type": "bias", "sensor": "gyro_p", "at_s": 0.1, "value_deg_s": 1}
    _, told = measured({"faults": [fault]}, truth)
    p, q, r = (told[:, STATE.index(name)] for name in "pqr")
    for name, rate in zip("pqr", (p, q, r), strict=True):
        np.testing.assert_allclose(told[1:, STATE.index(f"{name}_dot")], np.diff(rate) * RATE, atol=1e-9)
    speed, alpha, beta, pitch = (told[:, STATE.index(n)] for n in ("airspeed", "alpha", "beta", "pitch"))
    v, w = speed * np.sin(beta), speed * np.sin(alpha) * np.cos(beta)
    u_dot = 0.3 - 9.80665 * np.sin(pitch) - q * w + r * v
    np.testing.assert_allclose(told[:, STATE.index("u_dot")], u_dot, rtol=1e-12)


def test_sensors_without_errors_tell_the_truth() -> None:
    truth = truth_rows(100)
    _, told = measured({"model": "ideal"}, truth)
    kept = [i for i, name in enumerate(STATE) if not name.endswith("_dot")]
    assert np.array_equal(told[:, kept], truth[:, : len(STATE)][:, kept])


def test_deterministic_errors() -> None:
    truth = truth_rows(100)
    index, column = NAMES.index("airspeed"), STATE.index("airspeed")

    def read(**model: float) -> np.ndarray:
        return measured({"airspeed": model}, truth)[0].table[READING, :, index]

    v = truth[:, column]
    np.testing.assert_allclose(read(bias_m_s=0.4), v + 0.4, rtol=1e-14)
    np.testing.assert_allclose(read(scale_error=0.02), 1.02 * v, rtol=1e-14)
    assert np.array_equal(read(delay_s=0.02)[4:], v[:-4]) and np.all(read(delay_s=0.02)[:4] == v[0])
    digits = read(resolution_m_s=0.5)
    assert np.all(np.abs(digits - v) <= 0.25 + 1e-12) and np.all(digits * 2 == np.round(digits * 2))
    truth[:, column] = 18.0
    truth[1:, column] = 19.0
    lagged = read(low_pass_rad_s=20.0)
    np.testing.assert_allclose(19.0 - lagged, np.exp(-20.0 * np.arange(100) / RATE), rtol=1e-9)


def test_heading_goes_round() -> None:
    """A lag and a bias across north give no jump through the south."""
    truth = truth_rows(200)
    truth[:, STATE.index("heading")] = (6.2 + 0.002 * np.arange(200)) % (2 * np.pi)
    settings = {"heading": {"low_pass_rad_s": 20.0, "bias_deg": -3.0}}
    heading = measured(settings, truth)[1][:, STATE.index("heading")]
    assert np.all((heading >= 0.0) & (heading < 2 * np.pi))
    steps = (np.diff(heading) + np.pi) % (2 * np.pi) - np.pi
    assert np.all(np.abs(steps) < 0.003)

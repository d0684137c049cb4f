"""One control step: the order of figure 2, and what it leaves undone when the failures change."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from vtail_setup import WEATHER, setpoint, trim_state, vtail_setup

from testbed.common.signals import RATES, SETPOINT, STATE, record_dtype, telemetry_width
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import model_record, settings_record, trimmed_memory
from testbed.controllers.inversion.evidence import BEYOND_DOUBT, MEAN_S
from testbed.controllers.inversion.mode_switch import ModeSwitch
from testbed.controllers.inversion.step import (
    adaptive_step,
    add_model_error,
    add_unused,
    command_step,
    estimate,
    regression,
)
from testbed.controllers.records import REGULATOR_STATE, work_dtype
from testbed.controllers.setup import Setup

NEWTON = vtail_setup()
WEIGHTED = vtail_setup(WEATHER)
MODEL = NEWTON.model


def parts_of(setup: Setup, effectiveness: float = 1.0) -> tuple[Any, ...]:
    """Channels of one step at the trim, measured rates being the design model's with this left tail, and the records."""
    measured, references = np.zeros(1, record_dtype(STATE)), np.zeros(1, record_dtype(SETPOINT))
    measured[:] = trim_state(MODEL)
    x = {name: float(measured[0][name]) for name in REGULATOR_STATE[:8]}
    rates = MODEL.rates(x, np.array(MODEL.trim), np.array([effectiveness, 1.0, 1.0, 1.0]))
    for name, value in zip(RATES, rates, strict=False):
        measured[name] = value
    references[:] = setpoint(altitude=MODEL.altitude_m, airspeed=MODEL.airspeed_m_s)
    memory, chosen = trimmed_memory(setup), setup.settings
    assert isinstance(chosen, AdaptiveInversionSettings)
    mode = ModeSwitch(setup, memory).record
    own = (model_record(setup), settings_record(setup, chosen), mode, memory, np.zeros(1, work_dtype(4)))
    return measured.copy(), references, np.zeros((1, telemetry_width(4))), *own, measured


@pytest.mark.parametrize("setup", [NEWTON, WEIGHTED], ids=["newton", "weighted"])
def test_at_the_trim_it_commands_the_trim(setup: Setup) -> None:
    parts = parts_of(setup)
    s = parts[6][0]
    before = s.position.copy()
    assert adaptive_step(0, parts) == 0
    assert s.u == pytest.approx(before, abs=1e-3)
    assert s.lambda_hat == pytest.approx(np.ones(4), abs=1e-4)
    assert parts[2][0, 4:8].tolist() == s.u.tolist()


@pytest.mark.parametrize("setup", [NEWTON, WEIGHTED], ids=["newton", "weighted"])
def test_the_lost_actuator_is_the_one_whose_estimate_falls(setup: Setup) -> None:
    parts = parts_of(setup, effectiveness=0.0)
    m, c, s, w = parts[3][0], parts[4][0], parts[6][0], parts[7][0]
    y = parts[0][0]
    from testbed.controllers.inversion.law import state_function

    state_function(y, m, w.f)
    for _ in range(200):
        estimate(y, parts[1][0], m, c, s, w)
    assert s.lambda_hat[0] < 0.9
    assert s.lambda_hat[0] == min(s.lambda_hat)


def test_a_step_that_flags_has_not_commanded_yet() -> None:
    """It waits for the mode of the new failures; `command_step` then fills commands and telemetry."""
    parts = parts_of(NEWTON, effectiveness=0.0)
    telemetry, s = parts[2], parts[6][0]
    for _ in range(2000):
        telemetry[:] = 0.0
        if adaptive_step(0, parts):
            break
    assert s.failed.tolist() == [1, 0, 0, 0]
    assert not telemetry.any()
    command_step(0, parts[:8])
    assert telemetry[0, 12:16].tolist() == [1.0, 0.0, 0.0, 0.0] and telemetry[0, :8].any()


def test_eq_10_without_an_actuator_model_the_error_is_of_the_rates_that_were_asked_for() -> None:
    """The paper's (10): x_c_dot - f_m - B r, though the modelled positions are elsewhere; thrust has the torque of its rotor."""
    parts = parts_of(vtail_setup(AdaptiveInversionSettings(preset="paper", ablate=("actuator_model",))))
    y, m, s, w = parts[0][0], parts[3][0], parts[6][0], parts[7][0]
    s.r[:], s.lambda_hat[:] = [0.3, -0.2, 1.0, 1.5], [0.5, 1.0, 0.8, 1.0]
    commanded, r = s.r / s.lambda_hat, s.r.copy()
    adaptive_step(0, parts)
    assert s.position == pytest.approx(commanded, rel=1e-12)
    rates = np.array([y.p_dot, y.q_dot, y.r_dot, y.u_dot]) + m.offset
    assert w.e == pytest.approx(rates - w.f - m.B @ r, abs=1e-9)


def test_without_adaptation_nothing_is_estimated() -> None:
    parts = parts_of(NEWTON, effectiveness=0.0)
    parts[4][0].adapts = 0
    assert not any(adaptive_step(0, parts) for _ in range(300))
    assert parts[6][0].lambda_hat.tolist() == [1.0] * 4


def test_of_the_rotations_the_model_error_beyond_gusts_is_inverted() -> None:
    """Less the force of an offset, which commands make up for; all of it in `u_dot`, and while a vane is stuck."""
    parts = parts_of(WEIGHTED)
    m, c, s = parts[3][0], parts[4][0], parts[6][0]
    gusts = BEYOND_DOUBT * c.noise[:3] / np.sqrt(2.0 * MEAN_S)
    s.shift[0] = 0.5
    force = m.B[:4, 0] * s.shift[0]
    for error in (-3.0, -0.5, 0.5, 3.0):
        s.b[:] = np.array([*(error * gusts), 0.2]) + force
        f = np.zeros(4)
        add_model_error(f, 1.0, m, c, s)
        assert f == pytest.approx([*(np.sign(error) * max(abs(error) - 1.0, 0.0) * gusts), 0.2])
    s.stuck[0] = 1
    f = np.zeros(4)
    add_model_error(f, 1.0, m, c, s)
    assert f == pytest.approx([*(3.0 * gusts), 0.2])


def test_what_is_given_up_is_inverted_with_the_force_that_it_has() -> None:
    """That of a jammed one is B times its position, that of a lost one B times what is left of it; a regulator's f_m stays."""
    parts = parts_of(WEIGHTED)
    m, k, s = parts[3][0], parts[5][0], parts[6][0]
    s.lambda_hat[:], s.position[:] = [1.7, 0.9, 0.1, 0.8], [-0.4, 0.6, 1.5, 2.0]
    s.jammed[0], k.available[:] = 1, [0, 1, 0, 1]
    f, twice_the_pressure = np.zeros(4), 2.0
    k.regulated = 1
    add_unused(f, twice_the_pressure, m, k, s)
    assert f.tolist() == [0.0] * 4
    k.regulated = 0
    add_unused(f, twice_the_pressure, m, k, s)
    surface, thrust = 2.0 * 1.7, 0.1 * 1.5  # thrust does not grow with dynamic pressure
    assert f == pytest.approx(m.B[:4, 0] * surface + m.B[:4, 2] * thrust)


def test_the_position_that_a_jam_is_found_at_is_as_late_as_the_regression() -> None:
    """The command runs to a stop when a surface jams, so its modelled position is far ahead of what the estimate belongs to."""
    measured, _, _, models, settings, _, memories, works, _ = parts_of(WEIGHTED)
    y, m, c, s, w = measured[0], models[0], settings[0], memories[0], works[0]
    late = []
    for step in range(2000):
        if step >= 1900:
            s.position[0] = m.high[0]
        regression(y, 1.0, m, c, s, w)
        if step >= 1900:
            assert s.filtered_phi[1, :, 0] == pytest.approx(m.B[:, 0] * s.filtered_position[1, 0], abs=1e-6)
            late.append(float(m.high[0] - s.filtered_position[1, 0]))
    assert late[0] > 0.9 * (m.high[0] - m.trim_position[0]) and late[-1] < 0.1 * late[0]

"""The records as a flight begins: the design model's numbers, the designer's choices, everything at its trim."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from vtail_setup import WEATHER, axial, records_of, vtail_setup

from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import settings_record, trimmed_memory


def test_the_model_is_in_scaled_units() -> None:
    setup = vtail_setup()
    m = records_of(setup).m
    assert np.array(m.B) / setup.scale == pytest.approx(np.array(setup.model.input_matrix)[:4])
    assert m.B_inv @ m.B == pytest.approx(np.eye(4), abs=1e-9)
    assert m.trim_position * setup.scale == pytest.approx(setup.model.trim)
    assert m.servo.tolist() == [1, 1, 0, 0]
    assert m.rate[0] == pytest.approx(math.radians(401.07) / setup.actuators[0].scale)
    assert m.bias - m.offset == pytest.approx(setup.model.bias[:4])


def test_the_scenarios_choices_arrive() -> None:
    chosen = AdaptiveInversionSettings.model_validate(
        {"gamma": {"servo": 2, "motor": 3}, "epsilon": 0.1, "threshold": 0.2, "recovery": 0.7,
         "persistence_s": 0.3, "recovery_s": 2.0, "lambda_min": 0.01, "lambda_max": 1.5, "filter_rad_s": 9.0}
    )  # fmt: skip
    c = records_of(vtail_setup(chosen)).c
    assert c.gamma.tolist() == [2.0, 2.0, 3.0, 3.0] and c.epsilon.tolist() == [0.1] * 4
    assert (c.threshold, c.recovery, c.persistence, c.recovery_time) == (0.2, 0.7, 0.3, 2.0)
    assert (c.lambda_min, c.lambda_max, c.filter_rate) == (0.01, 1.5, 9.0)
    assert (c.adapts, c.weighted, c.flag_std_max) == (1, 0, math.inf)


def test_weighted_estimation_has_a_covariance_to_flag_by() -> None:
    c = records_of(vtail_setup(WEATHER)).c
    assert (c.weighted, c.flag_std_max, c.process_noise) == (1, 0.15, 0.1)
    assert c.noise.tolist() == [2.0, 0.5, 0.15, 0.08]
    assert c.model_error_std.tolist() == [0.3, 0.3, 0.1, 0.1]
    assert c.model_error_rate == pytest.approx(0.1)


def test_thrust_that_turns_the_aircraft_is_told_from_gusts() -> None:
    """The v-tail's propellers stand apart; with their yawing moment taken away they show in u_dot alone."""
    setup = vtail_setup(WEATHER)
    assert settings_record(setup, WEATHER)[0].turns.tolist() == [1, 1, 1, 1]
    b = np.array(setup.model.input_matrix)
    b[:3, 2:] = 0.0
    setup = replace(setup, model=replace(setup.model, input_matrix=tuple(map(tuple, b))))
    assert settings_record(setup, WEATHER)[0].turns.tolist() == [1, 1, 0, 0]


def test_a_law_without_estimation_neither_adapts_nor_divides_by_nothing() -> None:
    c = settings_record(vtail_setup(), None)[0]
    assert (c.adapts, c.weighted) == (0, 0)
    assert c.divisor_min > 0.0


def test_loops_are_in_radians() -> None:
    setup = vtail_setup()
    loops = setup.control.loops.model_copy(
        update={"roll_max_deg": 30.0, "q_kp": 7.0, "altitude_error_max_m": 6.0}
    )
    setup = replace(setup, control=setup.control.model_copy(update={"loops": loops}))
    c = records_of(setup).c
    assert (c.roll_max, c.q_kp, c.altitude_error_max) == (math.radians(30.0), 7.0, 6.0)
    assert c.heading_error_max == math.radians(20.0)


def test_the_memory_is_that_of_a_whole_trimmed_aircraft() -> None:
    setup = vtail_setup()
    s = trimmed_memory(setup)[0]
    trim = np.asarray(setup.trim_positions) / setup.scale
    for name in ("r", "u", "position", "servo_input", "servo_lagged"):
        assert s[name] == pytest.approx(trim)
    assert s.lambda_hat.tolist() == [1.0] * 4 and not s.failed.any() and not s.jammed.any()
    assert s.command == pytest.approx(setup.trim_commands)
    assert s.pitch_integral == setup.trim_pitch
    propulsor = setup.model.propulsors[2]
    assert propulsor is not None
    speed = propulsor.speed_at(setup.model.trim[2], axial(setup.model), setup.model.density_kg_m3)
    assert s.rotor == pytest.approx([0.0, 0.0, speed, speed], rel=1e-6)

"""The conventional autopilot: its allocation, its loops by hand, and that it flies."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from short_flights import scenario, worst_errors
from vtail_setup import records_of, setpoint, trim_state, vtail_setup

from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.config import PidSettings
from testbed.controllers.inversion.allocation import allocate_and_command
from testbed.controllers.pid import gains_record, lateral, longitudinal, mode_record, suited
from testbed.controllers.records import P_DOT, Q_DOT, R_DOT, U_DOT
from testbed.metrics import readings
from testbed.simulation import fly

SETUP = vtail_setup(PidSettings())
MODEL = SETUP.model
GAIN = suited(PidSettings(), SETUP)
K = mode_record(SETUP)[0]
LEVEL = {"altitude": MODEL.altitude_m, "airspeed": MODEL.airspeed_m_s}


def test_gains_are_the_settings_with_angles_in_radians() -> None:
    record = gains_record(suited(PidSettings(q_kp=11.0, roll_max_deg=20.0), SETUP))[0]
    assert record.q_kp == 11.0 and record.roll_max == math.radians(20.0)
    assert {name for name in PidSettings.model_fields if name.endswith(("kp", "ki", "max"))} <= set(
        record.dtype.names
    )


def test_on_its_references_nothing_is_asked() -> None:
    s, g = records_of(SETUP).s, gains_record(GAIN)[0]
    longitudinal(trim_state(MODEL), setpoint(**LEVEL), SETUP.dt_s, g, K, s)
    lateral(trim_state(MODEL), setpoint(**LEVEL), SETUP.dt_s, g, K, s)
    assert s.x_dc_dot == pytest.approx(np.zeros(4), abs=1e-12)


def test_altitude_asks_for_pitch_and_airspeed_for_thrust() -> None:
    s, g, v = records_of(SETUP).s, gains_record(GAIN)[0], MODEL.airspeed_m_s
    longitudinal(trim_state(MODEL), setpoint(altitude=300.5, airspeed=v + 0.5), SETUP.dt_s, g, K, s)
    climb, integral = GAIN.altitude_kp * 0.5, GAIN.altitude_ki * 0.5 * SETUP.dt_s
    assert s.x_dc_dot[Q_DOT] == pytest.approx(GAIN.q_kp * GAIN.pitch_kp * (climb / v + integral))
    thrust = GRAVITY_M_S2 * climb / v  # for the energy of the climb
    assert s.x_dc_dot[U_DOT] == pytest.approx(
        0.5 * GAIN.airspeed_kp + 0.5 * GAIN.airspeed_ki * SETUP.dt_s + thrust
    )


def test_heading_asks_for_bank_and_bank_for_yaw() -> None:
    s, g, v = records_of(SETUP).s, gains_record(GAIN)[0], MODEL.airspeed_m_s
    lateral(trim_state(MODEL), setpoint(**LEVEL, heading=0.1), SETUP.dt_s, g, K, s)
    turn_rate = (GAIN.heading_kp + GAIN.heading_ki * SETUP.dt_s) * 0.1
    bank = math.atan(v / GRAVITY_M_S2 * turn_rate)
    assert s.x_dc_dot[R_DOT] == pytest.approx(GAIN.r_kp * GAIN.roll_kp * bank)


def test_with_roll_kept_bank_asks_for_roll_and_yaw_is_that_of_the_turn() -> None:
    s, g, v = records_of(SETUP).s, gains_record(GAIN)[0], MODEL.airspeed_m_s
    kept = mode_record(replace(SETUP, released=()))[0]
    lateral(trim_state(MODEL, roll=0.2), setpoint(**LEVEL), SETUP.dt_s, g, kept, s)
    assert s.x_dc_dot[P_DOT] == pytest.approx(GAIN.p_kp * GAIN.bank_kp * -0.2)
    assert s.x_dc_dot[R_DOT] == pytest.approx(GAIN.r_kp * GRAVITY_M_S2 / v * math.sin(0.2))


def test_too_slow_counts_as_too_high() -> None:
    s, g = records_of(SETUP).s, gains_record(GAIN)[0]
    slow = trim_state(MODEL, airspeed=MODEL.airspeed_m_s - K.slow_descent_from - 1.0)
    longitudinal(slow, setpoint(**LEVEL), SETUP.dt_s, g, K, s)
    assert s.x_dc_dot[Q_DOT] < 0.0
    level = records_of(SETUP).s
    longitudinal(trim_state(MODEL), setpoint(**LEVEL), SETUP.dt_s, g, K, level)
    assert s.x_dc_dot[U_DOT] > level.x_dc_dot[U_DOT]


@pytest.mark.parametrize("pressure_ratio", [1.0, 2.0])
def test_the_allocation_gives_what_is_asked_about_the_trim(pressure_ratio: float) -> None:
    """Rates within what the stops allow are given exactly; the released one is not asked for."""
    m, c, _, s, w = records_of(SETUP)
    asked = np.array([9.0, 1.0, -0.5, 0.2])
    allocate_and_command(asked, pressure_ratio, MODEL.airspeed_m_s, m, c, K, s, w)
    given = m.B @ (s.u * np.where(m.servo == 1, pressure_ratio, 1.0) - m.trim_position)
    assert K.released.tolist() == [1, 0, 0, 0]
    assert given[1:] == pytest.approx(asked[1:])


def test_an_aircraft_with_ailerons_is_rolled_by_them(tmp_path: Path) -> None:
    """Nothing is released on the aerosonde: a turn of 30 deg and a climb of 5 m are flown with ailerons."""
    flight = fly(scenario(tmp_path, "pid", 25, "aircraft=aerosonde", "initial.airspeed_m_s=25"))
    altitude, heading, _ = worst_errors(flight)
    log = readings(flight).log
    assert (altitude < 1.0, heading < 6.0) == (True, True), (altitude, heading)
    assert np.ptp(log["aileron_position"]) > 1.0
    assert not log["p_dot_released"].any()


def test_a_gain_of_zero_is_noticed(tmp_path: Path) -> None:
    """Negative control: the bounds of `test_make` are not met by a controller that does not steer."""
    _, heading, _ = worst_errors(fly(scenario(tmp_path, "pid", 25, "controller.r_kp=0")))
    assert heading > 4.0


def test_light_turbulence_is_held_with_real_sensors(tmp_path: Path) -> None:
    """What is asked of the healthy aircraft: within 4 m and 6 deg."""
    weather = ("sensors=mems", "atmosphere.turbulence_w20_m_s=7.62", "seed=2", "controller.released=[p_dot]")
    altitude, heading, _ = worst_errors(fly(scenario(tmp_path, "pid", 40, *weather)))
    assert altitude < 4.0
    assert heading < 6.0

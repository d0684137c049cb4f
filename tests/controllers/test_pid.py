"""The conventional autopilot: its mixer, its loops by hand, and that it flies."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from short_flights import scenario, worst_errors
from vtail_setup import records_of, setpoint, trim_state, vtail, vtail_setup

from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.config import PidSettings
from testbed.controllers.pid import GAINS, gains_record, lateral, longitudinal, mix, mixer_of
from testbed.controllers.records import Q_DOT, R_DOT, U_DOT
from testbed.simulation import fly

SETUP = vtail_setup(PidSettings())
MODEL = SETUP.model
GAIN = PidSettings()
LEVEL = {"altitude": MODEL.altitude_m, "airspeed": MODEL.airspeed_m_s}


def test_gains_are_the_settings_with_angles_in_radians() -> None:
    record = gains_record(PidSettings(q_kp=11.0, roll_max_deg=20.0))[0]
    assert record.q_kp == 11.0 and record.roll_max == math.radians(20.0)
    assert {name for name in PidSettings.model_fields if name.endswith(("kp", "ki", "max"))} <= set(GAINS)


def test_on_its_references_nothing_is_asked() -> None:
    s, g = records_of(SETUP).s, gains_record(GAIN)[0]
    longitudinal(trim_state(MODEL), setpoint(**LEVEL), SETUP.dt_s, g, s)
    lateral(trim_state(MODEL), setpoint(**LEVEL), SETUP.dt_s, g, s)
    assert s.x_dc_dot == pytest.approx(np.zeros(4), abs=1e-12)


def test_altitude_asks_for_pitch_and_airspeed_for_thrust() -> None:
    s, g, v = records_of(SETUP).s, gains_record(GAIN)[0], MODEL.airspeed_m_s
    longitudinal(trim_state(MODEL), setpoint(altitude=301.0, airspeed=v + 1.0), SETUP.dt_s, g, s)
    climb, integral = GAIN.altitude_kp * 1.0, GAIN.altitude_ki * SETUP.dt_s
    assert s.x_dc_dot[Q_DOT] == pytest.approx(GAIN.q_kp * GAIN.pitch_kp * (climb / v + integral))
    assert s.x_dc_dot[U_DOT] == pytest.approx(GAIN.airspeed_kp + GAIN.airspeed_ki * SETUP.dt_s)


def test_heading_asks_for_bank_and_bank_for_yaw() -> None:
    s, g, v = records_of(SETUP).s, gains_record(GAIN)[0], MODEL.airspeed_m_s
    lateral(trim_state(MODEL), setpoint(**LEVEL, heading=0.1), SETUP.dt_s, g, s)
    turn_rate = (GAIN.heading_kp + GAIN.heading_ki * SETUP.dt_s) * 0.1
    bank = math.atan(v / GRAVITY_M_S2 * turn_rate)
    assert s.x_dc_dot[R_DOT] == pytest.approx(GAIN.r_kp * GAIN.roll_kp * bank)


def test_surfaces_deflect_less_at_speed_and_no_further_than_their_stops() -> None:
    m, _, _, s, _ = records_of(SETUP)
    mixer = mixer_of(np.array(m.B), MODEL.kinds)
    s.x_dc_dot[:] = [0.0, 1.0, 0.0, 0.5]
    mix(2.0, mixer, m, s)
    moved = (s.r - m.trim_position) * np.where(m.servo == 1, 2.0, 1.0)
    assert moved == pytest.approx(mixer @ s.x_dc_dot)
    s.x_dc_dot[:] = [0.0, 1e4, 0.0, 1e4]
    mix(1.0, mixer, m, s)
    assert np.all((s.u == m.low) | (s.u == m.high))


def test_the_mixer_is_elevator_and_rudder() -> None:
    """Equal for pitch, opposite for yaw, equal thrust; and B times it is what was asked for."""
    _, model = vtail()
    b = np.array(model.input_matrix)[:4]
    mixer = mixer_of(b, model.kinds)
    assert mixer[:2, 1] == pytest.approx([mixer[0, 1]] * 2)
    assert mixer[0, 2] == pytest.approx(-mixer[1, 2])
    assert mixer[2:, 3] == pytest.approx([mixer[2, 3]] * 2)
    assert not mixer[:, 0].any()
    assert (b @ mixer)[1, 1] == pytest.approx(1.0)
    assert (b @ mixer)[2, 2] == pytest.approx(1.0)


@pytest.mark.slow
def test_a_gain_of_zero_is_noticed(tmp_path: Path) -> None:
    """Negative control: the bounds of `test_make` are not met by a controller that does not steer."""
    _, heading, _ = worst_errors(fly(scenario(tmp_path, "pid", 25, "controller.r_kp=0")))
    assert heading > 4.0


@pytest.mark.slow
def test_light_turbulence_is_held_with_real_sensors(tmp_path: Path) -> None:
    """What is asked of the healthy aircraft: within 4 m and 6 deg. Seed 2: one that the gains were chosen with."""
    weather = ("sensors=mems", "atmosphere.turbulence_w20_m_s=7.62", "seed=2", "controller.released=[p_dot]")
    altitude, heading, _ = worst_errors(fly(scenario(tmp_path, "pid", 40, *weather)))
    assert altitude < 4.0
    assert heading < 6.0

"""The records of the compiled functions at the beginning of a flight: design model, settings, memory in trimmed flight."""

from __future__ import annotations

import math

import numpy as np

from testbed.aircraft.control_design import LOOP_GAINS
from testbed.aircraft.design_model import COLUMNS, ROWS, DesignModel
from testbed.aircraft.propulsors import EngineMap, Propulsor
from testbed.common.signals import RATES
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.inversion.degraded_aircraft import forward_curvature
from testbed.controllers.inversion.estimator import HEALTHY_VARIANCE
from testbed.controllers.records import memory_dtype, model_dtype, settings_dtype
from testbed.controllers.setup import Setup

_DIVISOR_MIN = 0.1
"""Least estimate that a reference is divided by: adaptation multiplies no reference by more than ten."""
_LATE_NOISE = 0.1
"""[1/sqrt(s)] Process noise of an actuator's lateness (`estimator.estimate_lateness`)."""
_GIVE_UP_TIME_S = 2.0
"""[s] Little of a gust passes, and airspeed is lost more slowly than this."""
_SINK_TIME_S = 1.0
"""[s] Turbulence at low altitude changes within this; a thermal does not."""


def model_record(setup: Setup) -> np.ndarray:
    """The design model as the compiled functions read it: one record of `model_dtype`, in scaled units."""
    model, scale, limits = setup.model, setup.scale, setup.limits
    record = np.zeros(1, model_dtype(len(scale)))
    m = record[0]
    m.airspeed, m.alpha, m.density = model.airspeed_m_s, model.alpha_rad, model.density_kg_m3
    m.stall_alpha = model.stall_alpha_rad
    m.servo[:] = [kind == "servo" for kind in model.kinds]
    m.scale[:], m.low[:], m.high[:] = scale, limits[:, 0], limits[:, 1]
    m.lag[:] = setup.lags
    m.rate[:] = [a.rate / a.scale for a in setup.actuators]
    m.trim_position[:] = np.array(model.trim) / scale
    offsets = np.array(model.offset_matrix)[:4]
    m.offset[:] = offsets[:, [kind == "motor" for kind in model.kinds]].sum(axis=1)
    m.bias[:] = np.array(model.bias)[:4] + offsets.sum(axis=1)
    m.A[:], m.B[:] = np.array(model.derivatives)[:4], np.array(model.input_matrix)[:4] * scale
    m.side_slope = model.derivatives[ROWS.index("v_dot")][COLUMNS.index("beta")]
    m.sideslip[:], m.gyroscopic[:] = model.sideslip[:4], model.gyroscopic
    linear = isinstance(setup.settings, AdaptiveInversionSettings) and setup.settings.preset == "paper"
    m.forward_curvature = 0.0 if linear else forward_curvature(model)
    m.zero_lift_alpha = -math.inf if linear else _zero_lift_alpha(model)
    m.B_inv[:], m.B_torque[:] = np.linalg.pinv(m.B), np.array(model.torque_matrix)[:4]
    for i, propulsor in enumerate(model.propulsors):
        if isinstance(propulsor, Propulsor):
            _fill_motor(m, i, propulsor, model)
        elif isinstance(propulsor, EngineMap):
            p = propulsor
            m.engine[i], m.throttles[i], m.speeds[i] = True, p.throttles, p.speeds
            m.thrust_map[i], m.rising_map[i] = np.array(p.thrust) / scale[i], p.rising / scale[i]
            m.engine_lag[i], m.rise[i], m.fall[i] = p.lag_rad_s, p.rise_s, p.fall_s
    return record


def _zero_lift_alpha(model: DesignModel) -> float:
    """Angle of attack at which the lift of the reference condition, its weight, is gone [rad]."""
    slope = -model.derivatives[ROWS.index("w_dot")][COLUMNS.index("alpha")]
    return model.alpha_rad - GRAVITY_M_S2 / slope if slope > 0.0 else -math.inf


def _fill_motor(m: np.record, i: int, p: Propulsor, model: DesignModel) -> None:
    axial = model.airspeed_m_s * math.cos(model.alpha_rad)
    _, slope = p.torque_at(model.trim[i], axial, model.density_kg_m3)
    m.torque_slope[i] = slope * m.scale[i]
    m.c_thrust[i], m.c_torque[i] = p.thrust, p.torque
    m.diameter[i], m.rotor_inertia[i], m.max_volts[i] = p.diameter_m, p.rotor_inertia_kg_m2, p.max_volts
    m.advance_min[i] = p.advance[0]
    m.advance_step[i] = (p.advance[1] - p.advance[0]) / (len(p.thrust) - 1)
    m.k_v[i], m.k_t[i] = p.velocity_constant_rps_v, p.torque_constant_n_m_a
    m.resistance[i], m.no_load_current[i] = p.resistance_ohm, p.no_load_current_a


def settings_record(setup: Setup, estimation: AdaptiveInversionSettings | None) -> np.ndarray:
    """The settings of the inversion law, from the aircraft's designer and the scenario: one record of `settings_dtype`.

    Args:
        estimation: the scenario's settings of estimation and monitor; None for a law without them.
    """
    control = setup.control
    record = np.zeros(1, settings_dtype(len(setup.actuators)))
    c = record[0]
    c.dt, c.divisor_min = setup.dt_s, _DIVISOR_MIN
    _fill_loops(c, setup)
    c.noise[:] = [getattr(control.disturbance, rate) for rate in RATES]
    c.turns[:] = setup.turns
    c.model_error_std[:] = [getattr(control.model_error_std, rate) for rate in RATES]
    c.model_error_rate, c.coefficient_error = 1.0 / control.model_error_time_s, control.coefficient_error
    paper = estimation is not None and estimation.preset == "paper"
    c.give_up_time, c.sink_time = (0.0, 0.0) if paper else (_GIVE_UP_TIME_S, _SINK_TIME_S)
    if estimation is not None:
        _fill_estimation(c, estimation, setup.model.kinds)
    return record


def _fill_loops(c: np.record, setup: Setup) -> None:
    """Gains and limits of the outer loops, angles in radians."""
    loops = setup.control.loops
    for name in (*LOOP_GAINS, "u_dot_max", "climb_max", "climb_kp"):
        c[name] = getattr(loops, name)
    c.roll_max = math.radians(loops.roll_max_deg)
    c.heading_error_max = math.radians(loops.heading_error_max_deg)
    c.altitude_error_max, c.airspeed_error_max = loops.altitude_error_max_m, loops.airspeed_error_max_m_s


def _fill_estimation(c: np.record, chosen: AdaptiveInversionSettings, kinds: tuple[str, ...]) -> None:
    c.adapts, c.estimates, c.weighted = True, True, chosen.estimation == "weighted"
    c.uncompensated, c.monitors = "estimate" in chosen.ablate, "monitor" not in chosen.ablate
    c.tests_jams = c.weighted and "jam_test" not in chosen.ablate
    c.tests_offsets = c.weighted and "offset_test" not in chosen.ablate
    c.probes = c.weighted and "probing" not in chosen.ablate
    c.guards = c.weighted and "sensor_guard" not in chosen.ablate
    c.ideal_actuators = "actuator_model" in chosen.ablate
    c.late_noise = 0.0 if "lateness" in chosen.ablate else _LATE_NOISE
    if "model_error" in chosen.ablate:
        c.model_error_std[:], c.coefficient_error = 0.0, 0.0
    c.gamma[:] = [chosen.gamma.of(kind) for kind in kinds]
    c.epsilon[:] = [chosen.epsilon.of(kind) for kind in kinds]
    if chosen.propeller_threshold is not None:
        c.threshold_rise[:] = [
            chosen.propeller_threshold - chosen.threshold if k != "servo" else 0.0 for k in kinds
        ]
    c.threshold, c.persistence = chosen.threshold, chosen.persistence_s
    c.recovery, c.recovery_time = chosen.recovery, chosen.recovery_s
    c.lambda_min, c.lambda_max = chosen.lambda_min, chosen.lambda_max
    c.filter_rate, c.process_noise = chosen.filter_rad_s, chosen.process_noise_per_root_s
    c.flag_std_max = chosen.flag_std_max if c.weighted else math.inf  # (13) gives no variance to compare


def trimmed_memory(setup: Setup) -> np.ndarray:
    """Memory in steady trimmed flight with healthy actuators: one record of `memory_dtype`."""
    n, model, scale = len(setup.actuators), setup.model, setup.scale
    record = np.zeros(1, memory_dtype(n))
    s = record[0]
    s.repeated[:] = -math.inf  # what never changed is not stuck: in calm air it may be zero
    s.lambda_hat[:], s.lambda_slow[:], s.since_flag[:] = 1.0, 1.0, math.inf
    s.P[:n, :n] = np.diag(np.full(n, HEALTHY_VARIANCE))
    s.command[:] = setup.trim_commands
    for name in ("r", "u", "position", "servo_input", "servo_lagged"):
        s[name][:] = np.asarray(setup.trim_positions) / scale
    axial = model.airspeed_m_s * math.cos(model.alpha_rad)
    for i, propulsor in enumerate(model.propulsors):
        if isinstance(propulsor, Propulsor):
            s.rotor[i] = propulsor.speed_at(setup.trim_positions[i], axial, model.density_kg_m3)
        elif isinstance(propulsor, EngineMap):
            s.followed[i] = setup.trim_commands[i]
    s.filtered_position[:] = s.position
    s.pitch_integral = setup.trim_pitch
    return record

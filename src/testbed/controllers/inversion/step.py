"""One control step of the adaptive inversion controller: the block diagram of the paper's figure 2, top to bottom.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import write_diagnosis, write_telemetry
from testbed.controllers.inversion.allocation import allocate_and_command
from testbed.controllers.inversion.estimator import (
    adapt_weighted,
    delay_regressor,
    estimate_lateness,
    expect_change,
    update_model_error_variance,
)
from testbed.controllers.inversion.evidence import BEYOND_DOUBT, MEAN_S
from testbed.controllers.inversion.jam_detection import detect_jam
from testbed.controllers.inversion.law import (
    adapt,
    assume_ideal_actuators,
    effect_ratio,
    lag_gain,
    lagged,
    low_pass,
    measured_error,
    pressure_ratio_of,
    regressor,
    state_function,
)
from testbed.controllers.inversion.loss_detection import monitor
from testbed.controllers.inversion.offset_detection import keep_offsets
from testbed.controllers.inversion.probing import probe
from testbed.controllers.inversion.sensor_guard import believe, vane_is_stuck
from testbed.controllers.outer_loops import clip, virtual_control
from testbed.controllers.records import U_DOT


@compiled
def adaptive_step(step, parts):
    """Estimate, monitor, invert and command for one measured state.

    Returns 1 when the flagged failures or the stuck sensors changed, an offset was found, or a jammed actuator moved. Then nothing
    has been commanded yet: the caller must put the new mode in force, and then call `command_step`.

    Args:
        step: row of the channels.
        parts: see `CompiledController`; the states are those that are believed, and the last are those measured.
    """
    believed, setpoints, telemetry, models, settings, modes, memories, works, states = parts
    ref, m, c, k, s, w = setpoints[step], models[0], settings[0], modes[0], memories[0], works[0]
    changed = believe(step, states, believed, ref, telemetry[step], m, c, k, s)
    y = believed[step]
    advance_actuators(c.dt, axial_speed(y), m, s)
    if c.ideal_actuators:
        assume_ideal_actuators(m, c, k, s)
    state_function(y, m, w.f)  # (2)
    if (c.adapts and estimate(y, ref, m, c, s, w)) or changed:
        return 1
    command(y, ref, telemetry[step], m, c, k, s, w)
    return 0


@compiled
def estimate(y, ref, m, c, s, w):
    """Estimate effectiveness from the measured rates, then monitor it and look for jams; returns 1 as `adaptive_step` does."""
    z, e, phi = w.z, w.e, w.phi
    pressure_ratio = pressure_ratio_of(y, m)
    regression(y, pressure_ratio, m, c, s, w)  # both sides of (10)
    if c.weighted:
        delay_regressor(phi, c, s)
    update_model_error_variance(y, pressure_ratio, phi, m, c, s)
    measured_error(z, phi, s, e)  # (10)
    if c.weighted:
        estimate_lateness(e, c, s)
        expect_change(e, phi, m, c, s, w.weight)
        keep_offsets(pressure_ratio, m, c, s)
        adapt_weighted(z, phi, w.P_h, m, c, s)
    else:
        adapt(e, pressure_ratio, m, c, s)  # (13), (14)
    if c.monitors and monitor(m, c, s):  # section 2.3
        return 1
    if c.probes and probe(e, pressure_ratio, m, c, s):
        return 1
    return detect_jam(pressure_ratio, m, c, s) if c.tests_jams else 0


@compiled
def regression(y, pressure_ratio, m, c, s, w):
    """The two sides of (10), z = x_c_dot - f_m and Phi, both filtered alike, into z [4] and phi [4, n] of `w`."""
    f, z, phi = w.f, w.z, w.phi
    # x_c_dot of (10), measured, less f_m
    z[0], z[1], z[2], z[3] = y.p_dot - f[0], y.q_dot - f[1], y.r_dot - f[2], y.u_dot - f[3]
    for i in range(4):  # both f and Phi contain the constant part of the propellers' torque: count it once
        z[i] += m.offset[i] * pressure_ratio
    regressor(pressure_ratio, m, s, phi)
    gain = lag_gain(c.filter_rate * c.dt)
    low_pass(z, s.filtered, gain)
    for i in range(4):
        low_pass(phi[i], s.filtered_phi[:, i], gain)
    for i in range(len(s.position)):
        lagged(s.position[i], s.filtered_position, i, gain)


@compiled
def command_step(step, parts):
    """Outer loops, inversion and commands with the mode in force, for the state that the estimation of this step believed."""
    believed, setpoints, telemetry, models, settings, modes, memories, works = parts
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    command(believed[step], setpoints[step], telemetry[step], m, c, k, s, works[0])


@compiled
def add_model_error(f, pressure_ratio, m, c, s):
    """Add the estimated model error b to f_m [4], less the force of offsets, for which commands make up already by their `shift`.
    A regulator does not invert f_m: with it only the desired rates that are logged change.

    Of `u_dot` all of b: the outer loop of airspeed may ask for less acceleration than the error of the modelled drag far from trim,
    and then airspeed would run away. Of the rotations what is beyond `BEYOND_DOUBT` deviations of what gusts leave of b in
    `MEAN_S`: smaller errors are left to the outer loops. All of it while a vane is stuck, since it is then also what gusts do that
    are not measured.

    Where a large error of the rotations is not inverted, a sideslip is held for ever: the inversion cancels a restoring moment of
    the model that a jammed rudder, say, balances, and commands the rudder to where it is jammed. So it seems to work, and heading
    is lost.
    """
    for i in range(4):
        error = s.b[i]
        for j in range(len(s.shift)):
            error -= m.B[i, j] * effect_ratio(j, pressure_ratio, m) * s.shift[j]
        if i != U_DOT and not vane_is_stuck(s):
            error -= clip(error, BEYOND_DOUBT * c.noise[i] / math.sqrt(2.0 * MEAN_S))
        f[i] += error


@compiled
def add_unused(f, pressure_ratio, m, k, s):
    """Add to f_m [4] what the actuators that are given up do, by their estimates: the force of a jammed one, and what is left of a
    lost one's. A regulator has the force of a jammed one in its trim. With this left to the outer loops, a T-38 with one of its two
    ailerons jammed did not turn."""
    if k.regulated:
        return
    for j in range(len(s.position)):
        if s.jammed[j] or not k.available[j]:
            force = s.lambda_hat[j] * (1.0 if s.jammed[j] else s.position[j])
            force *= effect_ratio(j, pressure_ratio, m)
            for i in range(4):
                f[i] += m.B[i, j] * force


@compiled
def command(y, ref, row, m, c, k, s, w):
    """Outer loops, inversion and commands for a state y, and a row of telemetry."""
    pressure_ratio = pressure_ratio_of(y, m)
    add_model_error(w.f, pressure_ratio, m, c, s)
    add_unused(w.f, pressure_ratio, m, k, s)
    virtual_control(y, ref, m, c, k, s, w)  # the bracket of (6) and (29)
    allocate_and_command(w.nu, pressure_ratio, axial_speed(y), m, c, k, s, w)  # (6), (29), (8)
    write_telemetry(row, k.released, s)
    write_diagnosis(row, c, s)

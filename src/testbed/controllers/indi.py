"""Incremental nonlinear dynamic inversion: the effect of everything but the actuators is measured, not modelled.

u = u_f + B^-1 (nu - x_c_dot_f) (Sieberling, Chu and Mulder, J. Guidance 33 (2010) 1732; Smeur, Chu and de Croon,
J. Guidance 39 (2016) 450). The command is the position that the modelled actuators have reached, plus an increment for the
difference between desired and measured rates. Measured rates are noisy and have to be filtered (subscript f). The actuators'
positions pass the same filter, so that both have the same delay (Smeur's synchronisation).

The positions enter as their effect on the rates, B u_f = (Phi 1)_f (`law.regressor`, with 1 a vector of ones), which takes
the present dynamic pressure and motor torque into account. With all axes controlled, nu is the desired rates of the paper's
outer loops. With an axis released, the outer loop is the adaptive law's regulator. It keeps f_m, and with it the natural
stability, so f_m is subtracted from the measured rates too, before the filter.

By itself it neither estimates nor monitors: the next increment corrects for a lost actuator as for any other error. With
`monitor` it has the diagnosis of the adaptive law (`controllers.diagnosis`). No command is divided by an estimate. So this
separates what diagnosis brings from what compensation brings.

`adaptive_indi` learns its input matrix in flight, by least mean squares (LMS; Smeur, Chu and de Croon, section "Adaptive parameter
estimation"; bounds as in the open autopilot Paparazzi, which flies it). The increments of rates and of actuators within a step,
both through one filter, tell the input matrix G: what else changes the rates changes slowly.

    G <- G - mu (G du_f - dx_c_dot_f) du_f'     (a)

Every element of G is learnt, and stays between its first value divided by `factor_max` and times that (b). The command is then
that of `indi` with G in place of B_m. Its authors have no diagnosis: nothing is flagged and no mode is switched. What is logged as
effectiveness of an actuator is its column of G, as a multiple of the first one.

Letters: those of `records`, and h what is learnt (`learning_dtype`).
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import numpy as np

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import command_actuators, write_diagnosis, write_telemetry
from testbed.controllers.config import AdaptiveIndiSettings, IndiSettings
from testbed.controllers.diagnosis import DiagnosedController
from testbed.controllers.initial_records import settings_record
from testbed.controllers.inversion.allocation import allocate_and_command, allocate_within_stops
from testbed.controllers.inversion.controller import InversionController
from testbed.controllers.inversion.law import (
    compensate,
    effect_ratio,
    invert,
    lag_gain,
    low_pass,
    pressure_ratio_of,
    regressor,
    state_function,
)
from testbed.controllers.outer_loops import virtual_control
from testbed.controllers.setup import Setup

SETTLED = 10.0
"""Time constants of the filter that pass before anything is learnt, so that it has forgotten its zero state."""


@compiled
def measured_remainder(y, pressure_ratio, m, c, k, s, f, phi, z):
    """z = (x_c_dot - Phi 1)_f, into z [4]: the part of the measured rates that the actuators do not make.

    Of flagged actuators, one that is jammed acts by its estimated position, one that is reversed by minus its position, and one
    that is lost does not act. In a regulated mode f_m is subtracted too. `m.offset` is added back: it is the constant part of the
    propellers' torque, which Phi contains, but which belongs to f_m because B is linear.
    """
    regressor(pressure_ratio, m, s, phi)
    z[0], z[1], z[2], z[3] = y.p_dot, y.q_dot, y.r_dot, y.u_dot
    for i in range(4):
        z[i] += m.offset[i] * pressure_ratio - (f[i] if k.regulated else 0.0)
        for j in range(len(s.position)):
            if s.jammed[j]:
                z[i] -= phi[i, j] * s.lambda_hat[j]
            elif s.reversed[j]:
                z[i] += phi[i, j]
            elif not s.failed[j]:
                z[i] -= phi[i, j]
    low_pass(z, s.filtered, lag_gain(c.filter_rate * c.dt))


@compiled
def increment(y, ref, pressure_ratio, m, c, k, s, w):
    """The rates to be added to those that the actuators give now, into w.nu: what the outer loops ask for, less the remainder."""
    state_function(y, m, w.f)
    measured_remainder(y, pressure_ratio, m, c, k, s, w.f, w.phi, w.z)
    virtual_control(y, ref, m, c, k, s, w)
    for i in range(4):
        w.nu[i] = (w.nu[i] if k.regulated else s.x_dc_dot[i]) - w.z[i]


@compiled
def indi_step(step, parts):
    """One control step: remainder, outer loops, increment, allocation, commands; see `DiagnosedController`."""
    states, setpoints, telemetry, models, settings, modes, memories, works, chosen, diagnoses = parts
    y, ref, w = states[step], setpoints[step], works[0]
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    pressure_ratio, axial = pressure_ratio_of(y, m), axial_speed(y)
    advance_actuators(c.dt, axial, m, s)
    increment(y, ref, pressure_ratio, m, c, k, s, w)
    allocate_and_command(w.nu, pressure_ratio, axial, m, c, k, s, w)
    write_telemetry(telemetry[step], k.released, s)
    write_diagnosis(telemetry[step], chosen[0], diagnoses[0])


def indi(setup: Setup) -> DiagnosedController:
    """The controller; raises BadInput as `InversionController` does. Logged are the estimates of the diagnosis, if there is one;
    no command is divided by them."""
    chosen, settings = setup.settings_as(IndiSettings), settings_record(setup, None)
    settings[0].filter_rate, settings[0].uncompensated = chosen.filter_rad_s, True
    return DiagnosedController(setup, indi_step, settings, chosen.monitor)


def learning_dtype(n: int) -> np.dtype:
    """What is learnt of n actuators, and what that needs.

    `mu` [s], `factor_max` [1] and `filter_rate` [rad/s] of the increments: settings. `deviation`: squared weight of a deviation in
    the allocation. `B` [4, n]: the first value of G [x_c per scaled unit]. `rates` [4] and `inputs` [n]: as filtered in the last
    step, with the lags' states. `change` [4] and `moved` [n]: how fast they change [x_c/s, scaled/s].
    """
    kind = np.float64
    fields = [(name, kind) for name in ("mu", "factor_max", "filter_rate", "deviation")]
    rows = [("rates", kind, (4,)), ("change", kind, (4,)), ("rate_lags", kind, (2, 4))]
    columns = [("inputs", kind, (n,)), ("moved", kind, (n,)), ("input_lags", kind, (2, n))]
    return np.dtype((np.record, np.dtype([*fields, *rows, *columns, ("B", kind, (4, n))])))


@compiled
def increments(y, pressure_ratio, m, c, s, h):
    """How fast filtered rates and actuators change, into `change` [4] and `moved` [n] of h.

    What the propellers' torque does beyond its part in thrust is no effect of a position, and is taken from the rates.
    """
    for i in range(4):
        h.change[i] = -h.rates[i]
    h.rates[0], h.rates[1], h.rates[2], h.rates[3] = y.p_dot, y.q_dot, y.r_dot, y.u_dot
    for j in range(len(h.inputs)):
        h.moved[j] = -h.inputs[j]
        h.inputs[j] = s.position[j] * effect_ratio(j, pressure_ratio, m)
        if not m.servo[j]:
            for i in range(4):
                h.rates[i] -= m.B_torque[i, j] * (s.torque[j] - m.torque_slope[j] * s.position[j])
    gain = lag_gain(h.filter_rate * c.dt)
    low_pass(h.rates, h.rate_lags, gain)
    low_pass(h.inputs, h.input_lags, gain)
    for i in range(4):
        h.change[i] = (h.change[i] + h.rates[i]) / c.dt
    for j in range(len(h.inputs)):
        h.moved[j] = (h.moved[j] + h.inputs[j]) / c.dt


@compiled
def learn(dt, m, s, h):
    """(a) and (b): one step of G, which stands in `m.B`, and of the logged effectiveness."""
    n = len(h.inputs)
    for i in range(4):
        error = -h.change[i]
        for j in range(n):
            error += m.B[i, j] * h.moved[j]
        for j in range(n):
            first, most = abs(h.B[i, j]), h.factor_max
            learnt = m.B[i, j] - dt * h.mu * error * h.moved[j]  # (a)
            size = learnt if h.B[i, j] > 0.0 else -learnt
            size = min(max(size, first / most), first * most)  # (b)
            m.B[i, j] = size if h.B[i, j] > 0.0 else -size
    for j in range(n):
        learnt, first = 0.0, 1e-12
        for i in range(4):
            learnt += m.B[i, j] * h.B[i, j]
            first += h.B[i, j] * h.B[i, j]
        s.lambda_hat[j] = learnt / first


@compiled
def weigh(m, k, h):
    """The allocation's Hessian G' diag(row_weight) G + deviation for the present G."""
    n = len(h.inputs)
    for a in range(n):
        for b in range(n):
            k.hessian[a, b] = h.deviation if a == b else 0.0
            for i in range(4):
                k.hessian[a, b] += m.B[i, a] * k.row_weight[i] * m.B[i, b]


@compiled
def adaptive_indi_step(step, parts):
    """One control step: learn, remainder, loops, increment, allocation, commands; returns 0. What is learnt is among its parts."""
    states, setpoints, telemetry, models, settings, modes, memories, works, learnt, _ = parts
    y, ref, w, h = states[step], setpoints[step], works[0], learnt[0]
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    pressure_ratio, axial = pressure_ratio_of(y, m), axial_speed(y)
    advance_actuators(c.dt, axial, m, s)
    increments(y, pressure_ratio, m, c, s, h)
    if step * c.dt > SETTLED / h.filter_rate:
        learn(c.dt, m, s, h)
        weigh(m, k, h)
    increment(y, ref, pressure_ratio, m, c, k, s, w)
    invert(w.nu, pressure_ratio, m, k, s)
    allocate_within_stops(w.nu, pressure_ratio, m, c, k, s, w)  # G's inverse, within the stops
    compensate(m, c, k, s)
    command_actuators(axial, m, s)
    write_telemetry(telemetry[step], k.released, s)
    write_diagnosis(telemetry[step], c, s)
    return 0


def adaptive_indi(setup: Setup) -> InversionController:
    """The controller; raises BadInput as `InversionController` does."""
    chosen, settings = setup.settings_as(AdaptiveIndiSettings), settings_record(setup, None)
    settings[0].filter_rate, settings[0].uncompensated = chosen.filter_rad_s, True
    settings[0].estimates = True
    learning = np.zeros(1, learning_dtype(len(setup.actuators)))
    h = learning[0]
    h.mu, h.factor_max, h.filter_rate = chosen.mu_s, chosen.factor_max, chosen.learning_filter_rad_s
    h.B[:] = np.array(setup.model.input_matrix)[:4] * setup.scale
    h.deviation = setup.control.allocation.deviation**2
    return InversionController(setup, settings, adaptive_indi_step, (learning,))

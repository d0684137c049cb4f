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

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import write_diagnosis, write_telemetry
from testbed.controllers.config import IndiSettings
from testbed.controllers.diagnosis import DiagnosedController
from testbed.controllers.initial_records import settings_record
from testbed.controllers.inversion.allocation import allocate_and_command
from testbed.controllers.inversion.law import low_pass, pressure_ratio_of, regressor, state_function
from testbed.controllers.outer_loops import virtual_control
from testbed.controllers.setup import Setup


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
    low_pass(z, s.filtered, c.filter_rate * c.dt)


@compiled
def indi_step(step, parts):
    """One control step: remainder, outer loops, increment, allocation, commands; see `DiagnosedController`."""
    states, setpoints, telemetry, models, settings, modes, memories, works, chosen, diagnoses = parts
    y, ref, w = states[step], setpoints[step], works[0]
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    pressure_ratio, axial = pressure_ratio_of(y, m), axial_speed(y)
    advance_actuators(c.dt, axial, m, s)
    state_function(y, m, w.f)
    measured_remainder(y, pressure_ratio, m, c, k, s, w.f, w.phi, w.z)
    virtual_control(y, ref, m, c, k, s, w)
    for i in range(4):
        w.nu[i] = (w.nu[i] if k.regulated else s.x_dc_dot[i]) - w.z[i]
    allocate_and_command(w.nu, pressure_ratio, axial, m, c, k, s, w)
    write_telemetry(telemetry[step], k.released, s)
    write_diagnosis(telemetry[step], chosen[0], diagnoses[0])


def indi(setup: Setup) -> DiagnosedController:
    """The controller; raises BadInput as `InversionController` does. Logged are the estimates of the diagnosis, if there is one;
    no command is divided by them."""
    chosen, settings = setup.settings_as(IndiSettings), settings_record(setup, None)
    settings[0].filter_rate, settings[0].uncompensated = chosen.filter_rad_s, True
    return DiagnosedController(setup, indi_step, settings, chosen.monitor)

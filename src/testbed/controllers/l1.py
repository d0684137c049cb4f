"""L1 adaptive inversion: adaptation as fast as it likes, with a low-pass filter between it and the actuators.

The paper divides the reference by the estimate, u = r / lambda_hat, so the gain gamma sets at once how fast a loss is made up
for, how much noise reaches the actuators, and how fast and how surely a failure is detected. Here these are three parts:

* a **fast estimator** for control alone, lambda_hat' = Gamma (B_hat^-1 e) g(a, epsilon), projected onto [lambda_min, lambda_max]
  as in (13), but with the inverse of the mode in force, so that released rates do not disturb it;
* a **low-pass filter in the control channel**, u = r + v with v' = k (r - lambda_hat u). Nothing is divided. From r to the effect
  lambda u this is lambda (s + k) / (s + k lambda): exact when steady, and never more than 1 at high frequencies, so the estimate
  cannot raise the loop's gain there;
* a **slow monitor**: the diagnosis of the adaptive law (`controllers.diagnosis`), which shares nothing with the fast estimator.

It is the adaptive augmentation of a baseline control by L1 theory for an unknown input gain, with the integrator D(s) = 1/s
(Hovakimyan and Cao, L1 Adaptive Control Theory, SIAM 2010, ch. 2). As Gamma grows, lambda_hat u becomes the measured effect z, and
v' = k (r - z) is integral control on the measured rates: incremental inversion (`controllers.indi`).

Letters: those of `records`, and d the memory of the diagnosis.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import numpy as np

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import command_actuators, write_diagnosis, write_telemetry
from testbed.controllers.config import L1InversionSettings
from testbed.controllers.diagnosis import DiagnosedController
from testbed.controllers.initial_records import settings_record
from testbed.controllers.inversion.allocation import allocate
from testbed.controllers.inversion.law import (
    effect_ratio,
    measured_error,
    modified_inverse,
    pressure_ratio_of,
    state_function,
)
from testbed.controllers.inversion.step import regression
from testbed.controllers.outer_loops import virtual_control
from testbed.controllers.setup import Setup


@compiled
def forget_lost(phi, s):
    """A lost actuator has no effect: its column of Phi [4, n] becomes zero."""
    for j in range(len(s.failed)):
        if s.failed[j] and not s.jammed[j]:
            phi[:, j] = 0.0


@compiled
def adapt_fast(e, pressure_ratio, m, c, k, s):
    """lambda_hat' = Gamma (B_hat^-1 e) g(a, epsilon), projected, for the actuators that are used; e [4] is (10)."""
    for i in range(len(s.lambda_hat)):
        if not k.available[i]:
            continue
        x = 0.0
        for j in range(4):
            x += k.B_hat_inv[i, j] * e[j]
        x /= effect_ratio(i, pressure_ratio, m)
        change = c.dt * c.gamma[i] * x * modified_inverse(s.position[i], c.epsilon[i])
        s.lambda_hat[i] = min(max(s.lambda_hat[i] + change, c.lambda_min), c.lambda_max)


@compiled
def low_pass_channel(m, c, k, s):
    """u = r + v with v' = k (r - lambda_hat u), within the stops; an actuator that is not used is sent to its trim position.

    At a stop, v is what takes u there, so it does not wind up.
    """
    for i in range(len(s.u)):
        u = m.trim_position[i]
        if k.available[i]:
            u = s.r[i] + s.correction[i]
            u += c.dt * c.channel_rate * (s.r[i] - s.lambda_hat[i] * u)
        s.u[i] = min(max(u, m.low[i]), m.high[i])
        s.correction[i] = s.u[i] - s.r[i] if k.available[i] else 0.0


@compiled
def l1_step(step, parts):
    """One control step: fast estimate, outer loops, allocation, low-pass channel, commands."""
    states, setpoints, telemetry, models, settings, modes, memories, works, chosen, diagnoses = parts
    y, ref, w = states[step], setpoints[step], works[0]
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    pressure_ratio, axial = pressure_ratio_of(y, m), axial_speed(y)
    advance_actuators(c.dt, axial, m, s)
    state_function(y, m, w.f)
    regression(y, pressure_ratio, m, c, s, w)
    forget_lost(w.phi, s)
    measured_error(w.z, w.phi, s, w.e)
    adapt_fast(w.e, pressure_ratio, m, c, k, s)
    virtual_control(y, ref, m, c, k, s, w)
    allocate(w.nu, pressure_ratio, m, c, k, s, w)
    low_pass_channel(m, c, k, s)
    command_actuators(axial, m, s)
    write_telemetry(telemetry[step], k.released, s)
    write_diagnosis(telemetry[step], chosen[0], diagnoses[0])


def l1_inversion(setup: Setup) -> DiagnosedController:
    """The controller; raises BadInput as `InversionController` does. Logged are the estimates of the slow monitor."""
    chosen = setup.settings_as(L1InversionSettings)
    return DiagnosedController(setup, l1_step, fast_settings(setup, chosen), chosen.monitor)


def fast_settings(setup: Setup, chosen: L1InversionSettings) -> np.ndarray:
    """[1] settings record of the control, with the gain of the fast estimator and the corner of the channel."""
    settings = settings_record(setup, None)
    c = settings[0]
    c.gamma[:], c.epsilon[:], c.channel_rate = chosen.fast_gamma, chosen.epsilon, chosen.control_rad_s
    c.lambda_min, c.lambda_max, c.filter_rate = chosen.lambda_min, chosen.lambda_max, chosen.filter_rad_s
    return settings

"""Adaptive augmentation of a baseline inversion: by L1 theory, and by a reference model.

`l1_inversion`: adaptation as fast as it likes, with a low-pass filter between it and the actuators. The paper divides the reference
by the estimate, u = r / lambda_hat, so the gain gamma sets at once how fast a loss is made up for, how much noise reaches the
actuators, and how fast and how surely a failure is detected. Here these are three parts:

* a **fast estimator** for control alone, lambda_hat' = Gamma (B_hat^-1 e) g(a, epsilon), projected onto [lambda_min, lambda_max]
  as in (13), but with the inverse of the mode in force, so that released rates do not disturb it;
* a **low-pass filter in the control channel**, u = r + v with v' = k (r - lambda_hat u). Nothing is divided. From r to the effect
  lambda u this is lambda (s + k) / (s + k lambda): exact when steady, and never more than 1 at high frequencies, so the estimate
  cannot raise the loop's gain there;
* a **slow monitor**: the diagnosis of the adaptive law (`controllers.diagnosis`), which shares nothing with the fast estimator.

It is the adaptive augmentation of a baseline control by L1 theory for an unknown input gain, with the integrator D(s) = 1/s
(Hovakimyan and Cao, L1 Adaptive Control Theory, SIAM 2010, ch. 2). As Gamma grows, lambda_hat u becomes the measured effect z, and
v' = k (r - z) is integral control on the measured rates: incremental inversion (`controllers.indi`).

`mrac` is model-reference adaptive control with projection and e-modification, as augmentation of the inversion (6): Lavretsky and
Wise, Robust and Adaptive Control with Aerospace Applications (Springer 2013): augmentation of a baseline control (ch. 10),
e-modification and projection (ch. 11), reference model with feedback of the error (ch. 13). The rates are

    x_c_dot = f_m + B_m a + Theta' phi,    phi = (1, angles, rotation, a)

with the modelled positions a and unknown Theta: what f_m and B_m leave out, a lost actuator included. The baseline is the
inversion, asked for Theta_hat' phi less (a). The reference model is what the design model makes of a, with Theta_hat, so that an
actuator's lag and stops are no error (hedging: Johnson and Calise, AIAA 2000-3969), and with the error e = x - x_ref fed back at
the rate l:

    x_ref_dot = f_m + B_m a + Theta_hat' phi + l e                       (b)
    Theta_hat_dot = Proj(Theta_hat, Gamma (phi e' - eta |e| Theta_hat))    (c)

P of Lyapunov's equation is diagonal here, 1 / 2 l with Q = 1, and is a part of Gamma. Nothing is flagged and no mode is switched.

Letters: those of `records`; h the adaptive part of `mrac` (`adaptation_dtype`).
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import numpy as np

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import command_actuators, write_diagnosis, write_telemetry
from testbed.controllers.config import L1InversionSettings, MracSettings
from testbed.controllers.diagnosis import DiagnosedController
from testbed.controllers.initial_records import settings_record
from testbed.controllers.inversion.allocation import allocate, allocate_and_command
from testbed.controllers.inversion.controller import InversionController
from testbed.controllers.inversion.law import (
    effect_ratio,
    measured_error,
    modified_inverse,
    pressure_ratio_of,
    regressor,
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


# Model reference adaptive control ---------------------------------------------------------------------------

ANGLE, ROTATION = 0.1, 0.5  # rad and rad/s that count as a regressor of size 1
TOLERANCE = 0.1
"""Share of its bound over which the projection takes the outward part of a change away."""
_OWN = 6  # regressors before the actuators
_SLOWER = 0.1  # airspeed, whose measurement is noisier


def adaptation_dtype(n: int) -> np.dtype:
    """`Theta` [4, 6 + n] a row for each rate, `bound` [4] of its norm, `phi` [6 + n]; `l` and `gamma` [4] rates of (b) and (c),
    `eta` of the e-modification; `x_ref` and `e` [4] reference model and error [rad/s, m/s]."""
    kind = np.float64
    rows = [(name, kind, (4,)) for name in ("bound", "l", "gamma", "x_ref", "e")]
    arrays = [("Theta", kind, (4, _OWN + n)), ("phi", kind, (_OWN + n,)), ("eta", kind)]
    return np.dtype((np.record, np.dtype([*rows, *arrays])))


@compiled
def theta_regressors(y, pressure_ratio, m, s, h):
    """phi: 1, angles, rotation and the effects of the actuators beyond the trim, each in a unit of its own."""
    h.phi[0], h.phi[1], h.phi[2] = 1.0, (y.alpha - m.alpha) / ANGLE, y.beta / ANGLE
    h.phi[3], h.phi[4], h.phi[5] = y.p / ROTATION, y.q / ROTATION, y.r / ROTATION
    for j in range(len(s.position)):
        h.phi[6 + j] = s.position[j] * effect_ratio(j, pressure_ratio, m) - m.trim_position[j]


@compiled
def theta_effect(i, h):
    """Theta_hat' phi of rate i."""
    total = 0.0
    for j in range(len(h.phi)):
        total += h.Theta[i, j] * h.phi[j]
    return total


@compiled
def adapt_theta_row(i, dt, h):
    """(c) for the parameters of one rate, with the regressors normalised by 1 + |phi|^2.

    Proj takes the outward part of the change away, the more the nearer the norm is to its bound: none of it at the bound less
    `TOLERANCE`, all at the bound.
    """
    n, size, squared, outward = len(h.phi), 1.0, 0.0, 0.0
    for j in range(n):
        size += h.phi[j] * h.phi[j]
        squared += h.Theta[i, j] * h.Theta[i, j]
        outward += h.Theta[i, j] * (h.phi[j] * h.e[i] - h.eta * abs(h.e[i]) * h.Theta[i, j])
    inner = h.bound[i] * (1.0 - TOLERANCE)
    excess = (squared - inner * inner) / (h.bound[i] * h.bound[i] - inner * inner)
    share = min(excess, 1.0) if excess > 0.0 and outward > 0.0 else 0.0
    for j in range(n):
        change = h.phi[j] * h.e[i] - h.eta * abs(h.e[i]) * h.Theta[i, j]  # phi e' less the e-modification
        change -= share * outward * h.Theta[i, j] / max(squared, 1e-12)  # Proj
        h.Theta[i, j] += dt * h.gamma[i] * change / size  # (c)


@compiled
def adapt_theta(y, pressure_ratio, m, c, s, h, w):
    """Advance reference model and parameters by one step; w.f is f_m."""
    regressor(pressure_ratio, m, s, w.phi)
    theta_regressors(y, pressure_ratio, m, s, h)
    w.e[0], w.e[1], w.e[2] = y.p, y.q, y.r
    w.e[3] = axial_speed(y)
    for i in range(4):
        h.e[i] = w.e[i] - h.x_ref[i]
        modelled = w.f[i] - m.offset[i] * pressure_ratio + theta_effect(i, h)
        for j in range(len(s.position)):
            modelled += w.phi[i, j]
        h.x_ref[i] += c.dt * (modelled + h.l[i] * h.e[i])  # (b)
        adapt_theta_row(i, c.dt, h)


@compiled
def mrac_step(step, parts):
    """One control step: adaptation, outer loops, inversion, commands; returns 0. The last part is the adaptive one."""
    states, setpoints, telemetry, models, settings, modes, memories, works, adaptations, _ = parts
    y, ref, w, h = states[step], setpoints[step], works[0], adaptations[0]
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    pressure_ratio, axial = pressure_ratio_of(y, m), axial_speed(y)
    advance_actuators(c.dt, axial, m, s)
    state_function(y, m, w.f)
    if step == 0:
        h.x_ref[0], h.x_ref[1], h.x_ref[2], h.x_ref[3] = y.p, y.q, y.r, axial
    adapt_theta(y, pressure_ratio, m, c, s, h, w)
    virtual_control(y, ref, m, c, k, s, w)
    for i in range(4):
        w.nu[i] -= theta_effect(i, h)  # (a)
    allocate_and_command(w.nu, pressure_ratio, axial, m, c, k, s, w)
    write_telemetry(telemetry[step], k.released, s)
    return 0


def mrac(setup: Setup) -> InversionController:
    """The controller; raises BadInput as `InversionController` does."""
    chosen = setup.settings_as(MracSettings)
    adaptation = np.zeros(1, adaptation_dtype(len(setup.actuators)))
    h = adaptation[0]
    h.l[:] = chosen.error_rad_s * np.array([1.0, 1.0, 1.0, _SLOWER])
    h.gamma[:], h.eta = chosen.adaptation * h.l**2, chosen.e_modification
    h.bound[:] = chosen.authority_max * np.abs(np.array(setup.model.input_matrix)[:4] * setup.scale).sum(
        axis=1
    )
    return InversionController(setup, settings_record(setup, None), mrac_step, (adaptation,))

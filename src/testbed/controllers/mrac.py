"""Model-reference adaptive control (MRAC) with projection and e-modification, as augmentation of the inversion (6).

Lavretsky and Wise, Robust and Adaptive Control with Aerospace Applications (Springer 2013): augmentation of a baseline control
(ch. 10), e-modification and projection (ch. 11), reference model with feedback of the error (ch. 13). The rates are

    x_c_dot = f_m + B_m a + Theta' phi,    phi = (1, angles, rotation, a)

with the modelled positions a and unknown Theta: what f_m and B_m leave out, a lost actuator included. The baseline is the
inversion, asked for Theta_hat' phi less (a). The reference model is what the design model makes of a, with Theta_hat, so that an
actuator's lag and stops are no error (hedging: Johnson and Calise, AIAA 2000-3969), and with the error e = x - x_ref fed back at
the rate l:

    x_ref_dot = f_m + B_m a + Theta_hat' phi + l e                       (b)
    Theta_hat_dot = Proj(Theta_hat, Gamma (phi e' - eta |e| Theta_hat))    (c)

P of Lyapunov's equation is diagonal here, 1 / 2 l with Q = 1, and is a part of Gamma. Nothing is flagged and no mode is switched.

Letters: those of `records`, and h the adaptive part (`adaptation_dtype`).
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import numpy as np

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import write_telemetry
from testbed.controllers.config import MracSettings
from testbed.controllers.initial_records import settings_record
from testbed.controllers.inversion.allocation import allocate_and_command
from testbed.controllers.inversion.controller import InversionController
from testbed.controllers.inversion.law import effect_ratio, pressure_ratio_of, regressor, state_function
from testbed.controllers.outer_loops import virtual_control
from testbed.controllers.setup import Setup

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
def regressors(y, pressure_ratio, m, s, h):
    """phi: 1, angles, rotation and the effects of the actuators beyond the trim, each in a unit of its own."""
    h.phi[0], h.phi[1], h.phi[2] = 1.0, (y.alpha - m.alpha) / ANGLE, y.beta / ANGLE
    h.phi[3], h.phi[4], h.phi[5] = y.p / ROTATION, y.q / ROTATION, y.r / ROTATION
    for j in range(len(s.position)):
        h.phi[6 + j] = s.position[j] * effect_ratio(j, pressure_ratio, m) - m.trim_position[j]


@compiled
def unknown(i, h):
    """Theta_hat' phi of rate i."""
    total = 0.0
    for j in range(len(h.phi)):
        total += h.Theta[i, j] * h.phi[j]
    return total


@compiled
def adapt_row(i, dt, h):
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
def adapt(y, pressure_ratio, m, c, s, h, w):
    """Advance reference model and parameters by one step; w.f is f_m."""
    regressor(pressure_ratio, m, s, w.phi)
    regressors(y, pressure_ratio, m, s, h)
    w.e[0], w.e[1], w.e[2] = y.p, y.q, y.r
    w.e[3] = axial_speed(y)
    for i in range(4):
        h.e[i] = w.e[i] - h.x_ref[i]
        modelled = w.f[i] - m.offset[i] * pressure_ratio + unknown(i, h)
        for j in range(len(s.position)):
            modelled += w.phi[i, j]
        h.x_ref[i] += c.dt * (modelled + h.l[i] * h.e[i])  # (b)
        adapt_row(i, c.dt, h)


@compiled
def mrac_step(step, parts):
    """One control step: adaptation, outer loops, inversion, commands; returns 0. The last part is the adaptive one."""
    states, setpoints, telemetry, models, settings, modes, memories, works, _, adaptations = parts
    y, ref, w, h = states[step], setpoints[step], works[0], adaptations[0]
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    pressure_ratio, axial = pressure_ratio_of(y, m), axial_speed(y)
    advance_actuators(c.dt, axial, m, s)
    state_function(y, m, w.f)
    if step == 0:
        h.x_ref[0], h.x_ref[1], h.x_ref[2], h.x_ref[3] = y.p, y.q, y.r, axial
    adapt(y, pressure_ratio, m, c, s, h, w)
    virtual_control(y, ref, m, c, k, s, w)
    for i in range(4):
        w.nu[i] -= unknown(i, h)  # (a)
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

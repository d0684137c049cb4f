"""Inversion with effectiveness from another estimator than the adaptive law's: recursive least squares, or interacting models.

`rls_inversion` has recursive least squares with exponential forgetting: adaptation alone. It minimises the sum of
exp(-age / forgetting_time) (z - Phi lambda)^2 / noise^2 over all rates and the past (Haykin, Adaptive Filter Theory, ch. 9; Astrom
and Wittenmark, Adaptive Control, sec. 2.2), where z = x_c_dot - f_m is the left side of (10). References are divided by the
estimates as in the adaptive law. Nothing is flagged, no mode is switched, and the model's own error is not estimated. Without
excitation P grows without bound under forgetting, so its variances are limited.

`imm_inversion` has an interacting multiple-model (IMM) estimator: one model for each failure, weighted by its probability (Blom and
Bar-Shalom, IEEE TAC 33 (1988) 780, used for actuators as by Zhang and Li, IEEE TAES 34 (1998) 1293). Each model says
z = Phi lambda + b + noise with effectiveness lambda of its own. The models are: as it is, and each actuator at each of two other
levels. What each model has to estimate is b, the design model's own error, as in `inversion.estimator`. From step to step the
models mix by a Markov chain.

The estimate of effectiveness is the mean of the models, weighted by their probabilities. When the model of a total loss has
been more probable than a limit for some time, the actuator is flagged, and the mode for that failure is put in force. From
then on "as it is" includes this loss, so that a second failure is looked for on top of the first. Only losses have models:
a jam has none.

Letters: those of `records`, and h the bank of models (`bank_dtype`).
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

import numpy as np

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.config import ImmInversionSettings, RlsInversionSettings
from testbed.controllers.initial_records import settings_record
from testbed.controllers.inversion.controller import InversionController
from testbed.controllers.inversion.estimator import (
    UNKNOWN_VARIANCE,
    project,
    update_by_rate,
    update_model_error_variance,
)
from testbed.controllers.inversion.law import TIMER_ROUNDING, pressure_ratio_of, state_function
from testbed.controllers.inversion.step import command_step, regression
from testbed.controllers.setup import Setup


@compiled
def forget(c, s):
    """Divide P by the forgetting factor exp(-dt / forgetting_time). Variances stay at or below `UNKNOWN_VARIANCE`: the row and
    the column of one that would pass it are scaled, so that P stays positive definite."""
    n = len(s.lambda_hat)
    growth = math.exp(c.dt / c.forgetting_time)
    for i in range(n):
        for j in range(n):
            s.P[i, j] *= growth
    for i in range(n):
        if s.P[i, i] > UNKNOWN_VARIANCE:
            factor = math.sqrt(UNKNOWN_VARIANCE / s.P[i, i])
            for j in range(n):
                s.P[i, j] *= factor
                s.P[j, i] *= factor


@compiled
def rls_step(step, parts):
    """Estimate, invert and command for one measured state; arguments as in `inversion.step.adaptive_step`; returns 0."""
    states, _, _, models, settings, _, memories, works, _ = parts
    y, m, c, s, w = states[step], models[0], settings[0], memories[0], works[0]
    advance_actuators(c.dt, axial_speed(y), m, s)
    state_function(y, m, w.f)
    regression(y, pressure_ratio_of(y, m), m, c, s, w)
    forget(c, s)
    for row in range(4):
        update_by_rate(row, w.z[row], w.phi[row], w.P_h, c, s)
    project(m, c, s)
    command_step(step, parts[:8])
    return 0


def rls_inversion(setup: Setup) -> InversionController:
    """The controller; raises BadInput as `InversionController` does."""
    chosen, settings = setup.settings_as(RlsInversionSettings), settings_record(setup, None)
    c = settings[0]
    c.estimates, c.forgetting_time, c.filter_rate = True, chosen.forgetting_s, chosen.filter_rad_s
    c.lambda_min, c.lambda_max = chosen.lambda_min, chosen.lambda_max
    return InversionController(setup, settings, rls_step)


# Interacting multiple models -------------------------------------------------------------------------------

PARTIAL = 0.4
"""Effectiveness in the model of a partial loss, and of a partial recovery."""
LOST, RECOVERED = 0.0, 1.0
"""Effectiveness in the model of a total loss, and in that of a total recovery."""
_RATE_KEYS = ("probability_min", "persistence", "failure_rate")


def bank_dtype(n: int) -> np.dtype:
    """The bank of k = 1 + 2 n models for n actuators: settings, then the state of each model.

    `effectiveness` [k, n] and `probability` [k] of each; `b` [k, 4] and `variance` [k, 4], its estimate of the design model's
    error and the variance of that; the same after mixing; `timer` [n] how long a flag or its removal has been probable [s].
    Model 0 is "as it is"; models 1 + 2 i and 2 + 2 i change actuator i totally and in part.
    """
    k, kind = 1 + 2 * n, np.float64
    fields = [(name, kind) for name in _RATE_KEYS]
    arrays = [
        ("effectiveness", kind, (k, n)),
        ("probability", kind, (k,)),
        ("expected", kind, (k,)),
        ("timer", kind, (n,)),
    ]
    arrays += [(name, kind, (k, 4)) for name in ("b", "variance", "mixed_b", "mixed_variance")]
    return np.dtype((np.record, np.dtype([*fields, *arrays])))


@compiled
def begin(c, s, h):
    """Begin with "as it is": flagged actuators lost, the others healthy; every other model is as improbable as possible."""
    n, k = len(s.failed), len(h.probability)
    for model in range(k):
        h.probability[model] = h.failure_rate * c.dt
        for i in range(n):
            h.effectiveness[model, i] = LOST if s.failed[i] else 1.0
    h.probability[0] = 1.0 - (k - 1) * h.failure_rate * c.dt
    for i in range(n):
        h.effectiveness[1 + 2 * i, i] = RECOVERED if s.failed[i] else LOST
        h.effectiveness[2 + 2 * i, i] = PARTIAL
        h.timer[i] = 0.0


@compiled
def mix(c, h):
    """Interaction: `expected` probability of each model by the Markov chain, and the mixture of estimates that it starts from."""
    k = len(h.probability)
    change = h.failure_rate * c.dt
    for j in range(k):
        h.expected[j] = change + (1.0 - k * change) * h.probability[j]
        for row in range(4):
            h.mixed_b[j, row], h.mixed_variance[j, row] = 0.0, 0.0
            for i in range(k):
                share = h.probability[i] * (change + (1.0 - k * change if i == j else 0.0)) / h.expected[j]
                h.mixed_b[j, row] += share * h.b[i, row]
            for i in range(k):
                share = h.probability[i] * (change + (1.0 - k * change if i == j else 0.0)) / h.expected[j]
                apart = h.b[i, row] - h.mixed_b[j, row]
                h.mixed_variance[j, row] += share * (h.variance[i, row] + apart * apart)


@compiled
def update(z, phi, c, s, h):
    """A Kalman step of each model for b, and the probabilities by the likelihood of what each did not predict."""
    k, n = h.effectiveness.shape
    fade, most = 1.0 - c.model_error_rate * c.dt, -math.inf
    for j in range(k):
        logarithm = math.log(h.expected[j])
        for row in range(4):
            b, drive = fade * h.mixed_b[j, row], 2.0 * c.model_error_rate * c.dt * s.model_error_variance[row]
            variance = fade * fade * h.mixed_variance[j, row] + drive
            error = z[row] - b
            for i in range(n):
                error -= phi[row, i] * h.effectiveness[j, i]
            expected = c.noise[row] * c.noise[row] / c.dt + variance
            h.b[j, row] = b + variance / expected * error
            h.variance[j, row] = variance - variance * variance / expected
            logarithm -= 0.5 * (error * error / expected + math.log(expected))
        h.probability[j] = logarithm
        most = max(most, logarithm)
    normalise(most, h)


@compiled
def normalise(most, h):
    """Turn the logarithms in `probability`, of which `most` is the largest, into probabilities that add up to 1."""
    total = 0.0
    for j in range(len(h.probability)):
        h.probability[j] = math.exp(h.probability[j] - most)  # at most 1: nothing overflows
        total += h.probability[j]
    for j in range(len(h.probability)):
        h.probability[j] /= total


@compiled
def conclude(c, s, h):
    """Estimates and flags from the probabilities; returns 1 if a flag changed."""
    changed = 0
    for i in range(len(s.lambda_hat)):
        s.lambda_hat[i] = 0.0
        for j in range(len(h.probability)):
            s.lambda_hat[i] += h.probability[j] * h.effectiveness[j, i]
        probable = h.probability[1 + 2 * i] > h.probability_min  # of a total loss, or of a recovery
        h.timer[i] = h.timer[i] + c.dt if probable else 0.0
        if h.timer[i] > h.persistence + TIMER_ROUNDING:
            s.failed[i] = 0 if s.failed[i] else 1
            changed = 1
    if changed:
        begin(c, s, h)
    return changed


@compiled
def imm_step(step, parts):
    """Estimate, flag, invert and command for one measured state; as `inversion.step.adaptive_step`, beside its bank."""
    states, _, _, models, settings, _, memories, works, banks, _ = parts
    y, m, c, s, w, h = states[step], models[0], settings[0], memories[0], works[0], banks[0]
    advance_actuators(c.dt, axial_speed(y), m, s)
    state_function(y, m, w.f)
    pressure_ratio = pressure_ratio_of(y, m)
    regression(y, pressure_ratio, m, c, s, w)
    update_model_error_variance(y, pressure_ratio, w.phi, m, c, s)
    mix(c, h)
    update(w.z, w.phi, c, s, h)
    if conclude(c, s, h):
        return 1
    command_step(step, parts[:8])
    return 0


def imm_inversion(setup: Setup) -> InversionController:
    """The controller; raises BadInput as `InversionController` does."""
    chosen, settings = setup.settings_as(ImmInversionSettings), settings_record(setup, None)
    settings[0].filter_rate = chosen.filter_rad_s
    settings[0].estimates = settings[0].monitors = True
    bank = np.zeros(1, bank_dtype(len(setup.actuators)))
    h = bank[0]
    h.probability_min, h.persistence = chosen.probability, chosen.persistence_s
    h.failure_rate = chosen.failure_rate_per_s
    controller = InversionController(setup, settings, imm_step, (bank,))
    begin(settings[0], controller.memory[0], h)
    return controller

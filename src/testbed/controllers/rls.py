"""Inversion with effectiveness estimated by recursive least squares with exponential forgetting: adaptation alone.

It minimises the sum of exp(-age / forgetting_time) (z - Phi lambda)^2 / noise^2 over all rates and the past (Haykin, Adaptive
Filter Theory, ch. 9; Astrom and Wittenmark, Adaptive Control, sec. 2.2), where z = x_c_dot - f_m is the left side of (10).
References are divided by the estimates as in the adaptive law. Nothing is flagged, no mode is switched, and the model's own
error is not estimated. Without excitation P grows without bound under forgetting, so its variances are limited.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.config import RlsInversionSettings
from testbed.controllers.initial_records import settings_record
from testbed.controllers.inversion.controller import InversionController
from testbed.controllers.inversion.estimator import UNKNOWN_VARIANCE, project, update_by_rate
from testbed.controllers.inversion.law import pressure_ratio_of, state_function
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
    command_step(step, parts)
    return 0


def rls_inversion(setup: Setup) -> InversionController:
    """The controller; raises BadInput as `InversionController` does."""
    chosen, settings = setup.settings_as(RlsInversionSettings), settings_record(setup, None)
    c = settings[0]
    c.estimates, c.forgetting_time, c.filter_rate = True, chosen.forgetting_s, chosen.filter_rad_s
    c.lambda_min, c.lambda_max = chosen.lambda_min, chosen.lambda_max
    return InversionController(setup, settings, rls_step)

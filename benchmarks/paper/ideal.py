"""The paper's ideal plant, equations (1) and (7), with the law that flies in the loop around it.

There is no aircraft here: x_c_dot = f(x) + B_c Lambda(t) a for a given B_c, Lambda(t) and f. The loop calls the compiled
functions of the flying law (`testbed.controllers.inversion.law`, `testbed.controllers.actuator_model`), so their behaviour can
be compared with what the paper proves. All actuators are surfaces with a scale of 1. An actuator without lag is ideal: its
position is its command, a = u.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from testbed.common.jit import compiled
from testbed.common.signals import STATE, record_dtype
from testbed.controllers.actuator_model import advance_servo
from testbed.controllers.inversion.law import (
    adapt,
    compensate,
    invert,
    measured_error,
    pressure_ratio_of,
    regressor,
    state_function,
)
from testbed.controllers.inversion.loss_detection import monitor
from testbed.controllers.records import (
    P_DOT,
    Q_DOT,
    R_DOT,
    memory_dtype,
    mode_dtype,
    model_dtype,
    settings_dtype,
    work_dtype,
)

UNLIMITED = 1e12
"""Stops and rate limit of an actuator without any. Not infinity, because the compiled servo calculates with it."""


@dataclass(frozen=True)
class IdealPlant:
    """x_c_dot = f(x) + B_c Lambda a, and what the design model has wrong about it.

    Attributes:
        B: [4, n] B_mc of the design model, n <= 4 and of full column rank.
        B_c: [4, n] the real input matrix; the model's where not given.
        A, bias: f of plant and model, by `law.state_function`; columns alpha, beta, p, q, r.
        bias_error: [4] f - f_m, constant (4.2).
        A_error: [4, 5] derivatives of f - f_m, the Jacobian of (38).
        airspeed: as a fraction of the reference airspeed; the effect of the surfaces is proportional to its square.
        lag, rate: [n] lag and rate limit of the real servos [rad/s, 1/s]; with lag 0 a servo is ideal.
        modelled: whether the design model has these servos too; if not, it takes them for ideal.
    """

    B: np.ndarray
    B_c: np.ndarray | None = None
    A: np.ndarray = field(default_factory=lambda: np.zeros((4, 5)))
    bias: np.ndarray = field(default_factory=lambda: np.zeros(4))
    bias_error: np.ndarray = field(default_factory=lambda: np.zeros(4))
    A_error: np.ndarray = field(default_factory=lambda: np.zeros((4, 5)))
    airspeed: float = 1.0
    lag: np.ndarray | float = 0.0
    rate: np.ndarray | float = UNLIMITED
    modelled: bool = True


@dataclass(frozen=True)
class Tuning:
    """Settings of the law (see `records.SETTINGS`); by default the bounds of the estimates are so wide that they have no effect."""

    gamma: float | np.ndarray = 2.0
    epsilon: float = 0.05
    dt_s: float = 0.005
    lambda_min: float = 1e-9
    lambda_max: float = 1e300
    threshold: float = 0.1
    recovery: float = 0.5
    persistence_s: float = 0.05
    recovery_s: float = 0.5


@dataclass(frozen=True)
class History:
    """What `IdealLoop.fly` recorded, one row per step. In one row, r gave u, u moved the actuator to a, and a caused e.

    Attributes:
        lambda_hat: [steps + 1, n] before each step, and after the last.
        e: [steps, 4] measured error (10) with the modelled actuators.
        r, u, a: [steps, n] reference, command and modelled position.
        failed: [steps, n] flags of the monitor after the step.
    """

    lambda_hat: np.ndarray
    e: np.ndarray
    r: np.ndarray
    u: np.ndarray
    a: np.ndarray
    failed: np.ndarray


@compiled
def move(dt, m, s):
    """Advance the positions by one step: servos with a lag by the flying actuator model, ideal ones to their commands at once."""
    for i in range(len(s.command)):
        if m.lag[i] > 0.0:
            advance_servo(i, dt, m, s)
        else:
            s.position[i] = min(max(s.command[i] / m.scale[i], m.low[i]), m.high[i])


@compiled
def invert_for(r, pressure_ratio, m, k, s, w):
    """(5) and (6): the desired rates that belong to a reference r [n], less f_m, and their inversion, which gives r again."""
    for i in range(4):
        x_dc_dot = w.f[i]
        for j in range(len(r)):
            x_dc_dot += m.B[i, j] * pressure_ratio * r[j]
        w.nu[i] = x_dc_dot - w.f[i]
    invert(w.nu, pressure_ratio, m, k, s)


@compiled
def plant_rates(effectiveness, disturbance, pressure_ratio, plant, p, f, x_c_dot):
    """(7), with a disturbance [4] as in (30), into x_c_dot [4]: f and B are the plant's, and so are the positions in p."""
    for i in range(4):
        x_c_dot[i] = f[i] + disturbance[i]
        for j in range(len(effectiveness)):
            x_c_dot[i] += plant.B[i, j] * pressure_ratio * effectiveness[j] * p.position[j]


@compiled
def ideal_loop(
    r,
    effectiveness,
    disturbance,
    y,
    models,
    settings,
    modes,
    memories,
    works,
    x_c_dot,
    lambda_hat,
    e_log,
    log,
):
    """Equations (5) to (14) in the paper's order, one row of r, Lambda and disturbance per step.

    Args:
        models, memories, works: two records each: first the controller's, then the plant's.
        x_c_dot: [4] working memory: the plant's rates.
        log: [steps, 4, n] filled with r, u, a and the monitor's flags.
    """
    m, plant, c, k, s, p = models[0], models[1], settings[0], modes[0], memories[0], memories[1]
    w, f_m, f = works[0], works[0].f, works[1].f
    n = len(s.u)
    pressure_ratio = pressure_ratio_of(y, m)
    for step in range(len(r)):
        state_function(y, m, f_m)
        state_function(y, plant, f)
        invert_for(r[step], pressure_ratio, m, k, s, w)
        compensate(m, c, k, s)
        for j in range(n):
            lambda_hat[step, j] = s.lambda_hat[j]
            s.command[j] = s.u[j] * m.scale[j]
            p.command[j] = s.command[j]
        move(c.dt, m, s)
        move(c.dt, plant, p)
        plant_rates(effectiveness[step], disturbance[step], pressure_ratio, plant, p, f, x_c_dot)
        for i in range(4):
            w.z[i] = x_c_dot[i] - f_m[i]
        regressor(pressure_ratio, m, s, w.phi)
        measured_error(w.z, w.phi, s, w.e)
        adapt(w.e, pressure_ratio, m, c, s)
        monitor(m, c, s)
        y.p += c.dt * x_c_dot[P_DOT]
        y.q += c.dt * x_c_dot[Q_DOT]
        y.r += c.dt * x_c_dot[R_DOT]
        for i in range(4):
            e_log[step, i] = w.e[i]
        for j in range(n):
            log[step, 0, j], log[step, 1, j] = s.r[j], s.u[j]
            log[step, 2, j], log[step, 3, j] = s.position[j], s.failed[j]
    for j in range(n):
        lambda_hat[len(r), j] = s.lambda_hat[j]


class IdealLoop:
    """The law in a loop with an ideal plant. It keeps its state, so that a long run can be made in pieces."""

    def __init__(
        self, plant: IdealPlant, tuning: Tuning, estimate: Sequence[float] | np.ndarray | float = 1.0
    ) -> None:
        self._n = n = plant.B.shape[1]
        self._models = np.zeros(2, model_dtype(n)).view(np.recarray)
        self._settings = np.zeros(1, settings_dtype(n)).view(np.recarray)
        self._modes = np.zeros(1, mode_dtype(n)).view(np.recarray)
        self._memories = np.zeros(2, memory_dtype(n)).view(np.recarray)
        self._works = np.zeros(2, work_dtype(n))
        self._x_c_dot = np.zeros(4)
        self._y = np.zeros(1, record_dtype(STATE)).view(np.recarray)
        self._y["airspeed"] = plant.airspeed
        models, settings = self._models, self._settings
        models["airspeed"], models["servo"], models["scale"] = 1.0, True, 1.0
        models["low"], models["high"], models["rate"] = -UNLIMITED, UNLIMITED, plant.rate
        models["A"] = [plant.A, plant.A + plant.A_error]
        models["bias"] = [plant.bias, plant.bias + plant.bias_error]
        models["B"] = [plant.B, plant.B if plant.B_c is None else plant.B_c]
        models["B_inv"] = np.linalg.pinv(plant.B)
        models["lag"][1] = plant.lag
        models["lag"][0] = plant.lag if plant.modelled else 0.0
        for name in ("gamma", "epsilon", "lambda_min", "lambda_max", "threshold", "recovery"):
            settings[name] = getattr(tuning, name)
        settings["dt"], settings["persistence"] = tuning.dt_s, tuning.persistence_s
        settings["recovery_time"] = tuning.recovery_s
        settings["divisor_min"] = tuning.lambda_min
        self._modes["B_hat_inv"], self._modes["available"] = models["B_inv"][0], True
        self._memories["lambda_hat"] = estimate

    def start_at(self, position: np.ndarray) -> None:
        """Put the servos, real and modelled, at rest at this scaled position [n]."""
        for name in ("position", "servo_input", "servo_lagged"):
            self._memories[name] = position

    def fly(
        self, r: np.ndarray, effectiveness: np.ndarray | float, disturbance: np.ndarray | float = 0.0
    ) -> History:
        """Follow the reference r [steps, n] with the plant's effectiveness [steps, n] and a disturbance of its rates [steps, 4].

        Effectiveness and disturbance may be anything that numpy broadcasts to these shapes, such as one number.
        """
        steps, n = r.shape
        lambda_hat, e, log = np.empty((steps + 1, n)), np.empty((steps, 4)), np.empty((steps, 4, n))
        ideal_loop(
            np.ascontiguousarray(r, dtype=float),
            np.array(np.broadcast_to(effectiveness, (steps, n)), dtype=float),
            np.array(np.broadcast_to(disturbance, (steps, 4)), dtype=float),
            self._y[0],
            self._models,
            self._settings,
            self._modes,
            self._memories,
            self._works,
            self._x_c_dot,
            lambda_hat,
            e,
            log,
        )
        return History(lambda_hat, e, log[:, 0], log[:, 1], log[:, 2], log[:, 3])


@dataclass(frozen=True)
class Approach:
    """One curve of figure 3.

    Attributes:
        gamma: adaptation gain, 1/s.
        sign: +1 for an approach from below (positive), -1 from above.
        time: [k] seconds, zero where the estimate is within 1 % of the truth, negative before.
        estimate: [k] lambda_hat / lambda.
    """

    gamma: float
    sign: int
    time: np.ndarray
    estimate: np.ndarray


def first_order(estimate: float, truth: float, rate: float, time: np.ndarray) -> np.ndarray:
    """Closed form of (19) for constant lambda and kappa, rate = gamma kappa: (20), (22) and (23)."""
    return truth + (estimate - truth) * np.exp(-rate * time)


def approach_trajectories(
    gammas: Sequence[float], within: float = 0.01, step: float = 1e-3, most: float = 0.99
) -> list[Approach]:
    """Curves of figure 3: the estimates of the flying law on the ideal plant, until they are within `within` of the truth.

    Args:
        gammas: adaptation gains [1/s].
        within: relative distance from the truth at time zero.
        step: gamma dt, the time step in units of the time constant.
        most: relative distance at which the curves begin.
    """
    curves = []
    steps = math.ceil(1.2 * math.log(most / within) / step)
    for gamma in gammas:
        dt = step / gamma
        # One plant gives both curves: the estimate of actuator 0 comes from below, that of actuator 1 from above.
        loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 0.01, dt), [1.0 - most, 1.0 + most, 1.0, 1.0])
        estimates = loop.fly(np.ones((steps, 4)), 1.0).lambda_hat
        for actuator, sign in ((0, 1), (1, -1)):
            estimate = estimates[:, actuator]
            last = int(np.argmax(np.abs(estimate - 1.0) <= within))
            # The distance decays exponentially, so its logarithm is interpolated to find when it crosses `within`.
            log = np.log(np.abs(estimate[last - 1 : last + 1] - 1.0) / within)
            crossing = (last - 1 + log[0] / (log[0] - log[1])) * dt
            curves.append(Approach(gamma, sign, np.arange(last + 1) * dt - crossing, estimate[: last + 1]))
    return curves

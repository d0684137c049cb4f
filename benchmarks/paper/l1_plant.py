"""`l1_inversion` and the paper's law at a constant reference: effects under noise of the functions that fly, for each actuator by
itself."""

from __future__ import annotations

import numpy as np

from paper.decoupling import REACHED
from paper.ideal import UNLIMITED, IdealLoop, IdealPlant, Tuning
from testbed.common.jit import compiled
from testbed.controllers.augmentation import adapt_fast, low_pass_channel
from testbed.controllers.records import memory_dtype, mode_dtype, model_dtype, settings_dtype

ACTUATORS = 4


@compiled
def l1_loop(truth, noise, models, settings, modes, memories, e, effects):
    """`l1_inversion` on ideal actuators with B_mc = I, one row of truth and noise per step; fills effects [steps, 4]."""
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    for step in range(len(truth)):
        low_pass_channel(m, c, k, s)
        for i in range(ACTUATORS):
            s.position[i] = s.u[i]
            effects[step, i] = truth[step] * s.u[i]
            e[i] = effects[step, i] + noise[step, i] - s.lambda_hat[i] * s.u[i]
        adapt_fast(e, 1.0, m, c, k, s)


def l1_effects(gamma: float, k: float, truth: np.ndarray, noise: np.ndarray, dt: float) -> np.ndarray:
    """[steps, 4] effects lambda u of four like actuators with r = 1, for effectiveness truth [steps] and noise [steps, 4].

    Args:
        gamma, k: gain of the fast estimator and corner of the control channel [1/s].
    """
    kinds = (model_dtype, settings_dtype, mode_dtype, memory_dtype)
    models, settings, modes, memories = (np.zeros(1, kind(ACTUATORS)).view(np.recarray) for kind in kinds)
    m, c, mode, s = models[0], settings[0], modes[0], memories[0]
    m.servo[:], m.low[:], m.high[:] = 1, -UNLIMITED, UNLIMITED
    c.dt, c.gamma[:], c.channel_rate, c.epsilon[:] = dt, gamma, k, 1e-9
    c.lambda_min, c.lambda_max = 1e-3, 1e3
    mode.available[:], mode.B_hat_inv[:] = 1, np.eye(ACTUATORS)
    s.lambda_hat[:], s.r[:], s.correction[:] = truth[0], 1.0, 1.0 / truth[0] - 1.0
    effects = np.empty((len(truth), ACTUATORS))
    l1_loop(truth, noise, models, settings, modes, memories, np.zeros(ACTUATORS), effects)
    return effects


def paper_effects(gamma: float, truth: np.ndarray, noise: np.ndarray, dt: float) -> np.ndarray:
    """The same of (13) with u = r / lambda_hat."""
    loop = IdealLoop(IdealPlant(np.eye(ACTUATORS)), Tuning(gamma, 1e-9, dt), truth[0])
    estimate = loop.fly(np.ones((len(truth), ACTUATORS)), np.tile(truth[:, None], (1, ACTUATORS)), noise)
    return np.asarray(truth[:, None] / estimate.lambda_hat[:-1])


def measured(gamma: float, k: float | None, seed: int = 7, dt: float = 0.005) -> tuple[float, float]:
    """T_5% [s] after a loss of 1 %, and variance over s / r^2 [1/s] in 960 s of faint white noise; k None is the paper's law."""

    def effects(truth: np.ndarray, noise: np.ndarray) -> np.ndarray:
        return paper_effects(gamma, truth, noise, dt) if k is None else l1_effects(gamma, k, truth, noise, dt)

    loss, s = 0.01, 1e-5
    truth = np.where(np.arange(4000) < 10, 1.0, 1.0 - loss)
    missing = np.abs(effects(truth, np.zeros((4000, ACTUATORS)))[10:, 0] - 1.0) / loss
    time = float(np.flatnonzero(missing > 1.0 - REACHED)[-1] + 1) * dt
    noise = np.random.default_rng(seed).normal(0.0, np.sqrt(s / dt), (48000, ACTUATORS))
    return time, float(effects(np.ones(48000), noise)[1000:].var() / s)

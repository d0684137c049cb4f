"""Effectiveness over time with its uncertainty: a Kalman filter and a smoother (Rauch, Tung, Striebel) over blocks of a log.

The states and their constants are those of the law's `estimator`: a random walk of each effectiveness, which begins at 1.
"""

from __future__ import annotations

import numpy as np

from testbed.controllers.inversion.estimator import HEALTHY_VARIANCE, UNKNOWN_VARIANCE


def smoothed(
    information: np.ndarray, towards: np.ndarray, walk: float, changes: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """([T, n] effectiveness, [T, n] its standard deviation).

    Args:
        information: [T, n, n] of each block, Phi' Phi of white columns.
        towards: [T, n] Phi' z.
        walk: standard deviation of a change within a block.
        changes: [T, n] whether the actuator begins to do something else: nothing is known of it then.
    """
    count, n = towards.shape
    before, after = np.zeros((count, n)), np.zeros((count, n))
    P_before, P_after = np.zeros((count, n, n)), np.zeros((count, n, n))
    x, P = np.ones(n), HEALTHY_VARIANCE * np.eye(n)
    for t in range(count):
        P = P + np.diag(np.where(changes[t], UNKNOWN_VARIANCE, walk * walk))
        before[t], P_before[t] = x, P
        gain = np.linalg.inv(np.eye(n) + P @ information[t])
        P = gain @ P
        P = 0.5 * (P + P.T)
        x = x + P @ (towards[t] - information[t] @ x)
        after[t], P_after[t] = x, P
    for t in range(count - 2, -1, -1):
        back = P_after[t] @ np.linalg.inv(P_before[t + 1])
        after[t] += back @ (after[t + 1] - before[t + 1])
        P_after[t] += back @ (P_after[t + 1] - P_before[t + 1]) @ back.T
    variance = np.diagonal(P_after, axis1=1, axis2=2)
    return after, np.sqrt(np.maximum(variance, 0.0))


def alone(information: np.ndarray, width: int) -> tuple[np.ndarray, np.ndarray]:
    """What the log itself says in a window about each block, without any belief before it.

    Returns:
        [T, n] the standard deviation of each effectiveness, and [T, n] the inflation of its variance by the other actuators: 1
        where no other moved like it, and large where several cannot be told apart.
    """
    kernel = np.ones(min(width, len(information)))
    sums = np.apply_along_axis(lambda x: np.convolve(x, kernel, "same"), 0, information)
    n = sums.shape[1]
    own = np.maximum(np.diagonal(sums, axis1=1, axis2=2), 1e-9)
    scale = 1.0 / np.sqrt(own)
    correlation = sums * scale[:, :, None] * scale[:, None, :] + 1e-9 * np.eye(n)
    inflation = np.maximum(np.diagonal(np.linalg.inv(correlation), axis1=1, axis2=2), 1.0)
    return np.sqrt(inflation / own), inflation

"""(13) alone, step by step, for the reference of one actuator that was flown in JSBSim.

Where this estimate is that of the flight, servo and sensor explain it. The rest comes from the flight, which reacts to the error.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from testbed.controllers.inversion.law import modified_inverse


@dataclass(frozen=True)
class Behind:
    """What is between one actuator's command and the error that the law sees.

    Attributes:
        lag: of the real servo [rad/s], 0 for none.
        modelled: lag of the model's servo [rad/s], 0 for the plain law.
        age: of the measured rates [s], unknown to the law.
        rate: limit of the real servo's rate [scaled/s], unknown to the law.
    """

    lag: float = 0.0
    modelled: float = 0.0
    age: float = 0.0
    rate: float = math.inf


def replay(
    r: np.ndarray,
    truth: np.ndarray,
    behind: Behind,
    gamma: float,
    epsilon: float,
    dt: float,
    start: float = 1.0,
) -> np.ndarray:
    """The estimate of one actuator by (13), step by step, for a reference that has been flown.

    It tells what of a flight's estimate is due to `behind`, and what to a reference that reacts to the error.

    Args:
        r, truth: [steps] reference and true effectiveness; before them both are as in the first step, and all is at rest.
        start: the estimate before the first step.

    Returns:
        [steps] estimates after each step.
    """
    a, lagged, a_m, u_before, estimate = (r[0] / start,) * 4 + (start,)
    late, estimates = [truth[0] * a] * round(behind.age / dt), np.empty(len(r))
    for step in range(len(r)):
        u = r[step] / estimate
        lagged, a_m = (
            _servo(w * dt, u, u_before, x) for w, x in ((behind.lag, lagged), (behind.modelled, a_m))
        )
        a += min(max(lagged - a, -behind.rate * dt), behind.rate * dt)
        late.append(truth[step] * a)
        error = late.pop(0) - estimate * a_m
        estimate *= math.exp(dt * gamma * modified_inverse(a_m, epsilon) * error / estimate)
        u_before, estimates[step] = u, estimate
    return estimates


def _servo(w_dt: float, u: float, u_before: float, a: float) -> float:
    """Position after one step of the bilinear lag of `actuator_model.advance_servo`; with w dt = 0 the command itself."""
    return (w_dt * (u + u_before) + (2.0 - w_dt) * a) / (2.0 + w_dt) if w_dt > 0.0 else u

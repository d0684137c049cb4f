"""Errors and faults of sensors, drawn for the whole flight before it begins."""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

import numpy as np

from testbed.common.jit import compiled
from testbed.common.random_streams import generator
from testbed.sensors.faults import SensorFault, Span
from testbed.sensors.settings import SensorModel


def drawn(
    channel: str, model: SensorModel, steps: int, rate_hz: float, seed: int
) -> tuple[float, np.ndarray]:
    """Scale factor of one channel [1], and the sum of its bias, drift, wander and noise in each step ([steps], in SI).

    Each part has its own random stream, so a change of one leaves the numbers of the others as they were. The errors of a
    longer flight begin with those of a shorter one.

    Args:
        channel: its name, which names its random streams.
    """

    def normal(part: str, size: int) -> np.ndarray:
        return generator(seed, f"sensors.{channel}.{part}").standard_normal(size)

    scale, error = 1.0 + model.scale_error, np.full(steps, model.si("bias"))
    if model.scale_error_sigma:
        scale += model.scale_error_sigma * float(normal("scale", 1)[0])
    if sigma := model.si("bias_sigma"):
        error += sigma * normal("bias", 1)
    if density := model.si("drift"):
        walk = np.cumsum(normal("drift", steps)) * density / math.sqrt(rate_hz)
        error[1:] += walk[:-1]
    if sigma := model.si("wander"):
        wander = normal("wander", steps)
        correlate(wander, math.exp(-1.0 / (rate_hz * model.wander_time_s)))
        error += sigma * wander
    if density := model.si("noise"):
        error += density * math.sqrt(rate_hz / 2.0) * normal("noise", steps)
    return scale, error


@compiled
def correlate(x, correlation):
    """Turn white noise, in place, into a first-order Gauss-Markov sequence of variance one:
    x[k] = c x[k-1] + sqrt(1 - c^2) noise[k], x[0] = noise[0].

    Args:
        x: [steps] standard normal noise, and result.
        correlation: c, the correlation of neighbouring steps, exp(-dt / correlation time).
    """
    fresh = math.sqrt(1.0 - correlation * correlation)
    for k in range(1, len(x)):
        x[k] = correlation * x[k - 1] + fresh * x[k]


def enter(
    fault: SensorFault, rate_hz: float, stream: np.random.Generator, offset: np.ndarray, state: np.ndarray
) -> None:
    """Enter a fault into one channel's columns [steps] of the layers OFFSET [SI] and FAULT (see `measurement`).

    Args:
        stream: of this fault and channel alone.
    """
    start, end = fault.window(rate_hz)
    window = slice(int(start), int(min(end, len(offset))))
    steps = np.arange(max(window.stop - window.start, 0)) + start - fault.at_s * rate_hz
    fault.enter(Span(steps, rate_hz, stream, offset[window], state[window]))

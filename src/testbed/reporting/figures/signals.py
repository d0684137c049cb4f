"""Dense signals as a band, where a line would be a blot."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

_DENSE = 0.35  # crossings of the signal's own spread in a part, from which on a line is a blot


class Band(NamedTuple):
    """A dense signal in parts of the time axis: [parts] middle of each in time, and the signal's extremes and mean there."""

    time_s: np.ndarray
    low: np.ndarray
    high: np.ndarray
    mean: np.ndarray


def band(time: np.ndarray, values: np.ndarray, span_s: float, parts: int) -> Band | None:
    """The signal as a band, where a line would be a blot; None where a line can be read.

    It is dense if, over the time it is drawn in, its path up and down is many times its spread (10 to 90 % of its values).

    Args:
        time: [rows] ascending [s].
        values: [rows] of the signal.
        span_s: length of the time axis [s].
        parts: into how many parts the time axis is divided, each some pixels wide.
    """
    each = round(len(values) * span_s / max(float(np.ptp(time)), 1e-9) / parts) if len(values) > 1 else 0
    if each < 8 or not np.all(np.isfinite(values)):
        return None
    spread = float(np.ptp(np.percentile(values, [10, 90])))
    if spread <= 0.0 or np.abs(np.diff(values)).sum() < _DENSE * 2.0 * len(values) / each * spread:
        return None
    first = np.arange(0, len(values) - each + 1, each)
    blocks = values[: len(first) * each].reshape(-1, each)
    middle = time[first + each // 2]
    return Band(middle, blocks.min(axis=1), blocks.max(axis=1), blocks.mean(axis=1))

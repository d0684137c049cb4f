"""Robustness: how far a signal is from breaking its limits, as one signed number.

That of signal temporal logic (Fainekos and Pappas, Robustness of temporal logic specifications, 2009; Donze and Maler, Robust
satisfaction of temporal logic over real-valued signals, 2010): an `and` is a minimum, an `or` a maximum, "always" a minimum over
time and "eventually" a maximum. It is negative where the limits are broken, and continuous in the signal.
"""

from __future__ import annotations

import numpy as np


def always(distances: np.ndarray) -> float:
    """Robustness of "inside in every row", of the distances [rows] to the limit, positive inside."""
    return float(np.min(distances))


def eventually(distances: np.ndarray) -> float:
    """Robustness of "inside in some row"."""
    return float(np.max(distances))


def never_outside_for(distances: np.ndarray, rows: int) -> float:
    """Robustness of "never outside for this many rows in succession": the least, over time, of the largest in so many rows.

    No less than 0 if there are fewer rows than that.
    """
    if len(distances) < rows:
        return max(0.0, eventually(distances))
    return always(_largest_of(distances, rows))


def _largest_of(values: np.ndarray, rows: int) -> np.ndarray:
    """The largest of each so many values in succession, from windows that double."""
    width = 1
    while width < rows:
        shift = min(width, rows - width)
        values = np.maximum(values[:-shift], values[shift:])
        width += shift
    return values

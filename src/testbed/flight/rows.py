"""Which rows of a log: the one at a time, and those in which a flag is up."""

from __future__ import annotations

import numpy as np

_SAME_TIME_S = 1e-9  # times this near are one: a row's time is a quotient, a user's a decimal number


def row_at(time_s: np.ndarray, instant_s: float) -> int:
    """First row at or after an instant [s]; the number of rows where the log ends before it.

    `time_s` [rows] is the log's time, ascending.
    """
    return int(np.searchsorted(time_s, instant_s - _SAME_TIME_S))


def row_spacing_s(time_s: np.ndarray) -> float:
    """Time between two rows of the log [s]; 0 in a log of one row."""
    return float(time_s[1] - time_s[0]) if len(time_s) > 1 else 0.0


def stretches(flag: np.ndarray) -> list[tuple[int, int]]:
    """[first row, row after the last) of each unbroken stretch of rows in which a flag [rows] of bools is up."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], flag, [False])).astype(np.int8)))
    return [(int(first), int(end)) for first, end in edges.reshape(-1, 2)]

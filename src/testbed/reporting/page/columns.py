"""The log for the page: fewer rows, 16 bits a number, deflated. `web/src/data.js` reads it.

A column that changes little between the rows that are kept has its value in each of these rows. A dense one, such as a rate in
turbulence, has the smallest and the largest value of each two stretches, in their order, so that its envelope is kept.
"""

from __future__ import annotations

import base64
import zlib
from collections.abc import Mapping
from typing import Any

import numpy as np

MOST_ROWS = 5500
"""Rows that are kept, at 110 s of flight 50 each second."""
_DENSE = 2.0  # a column is dense if thinning it takes away more than this factor of its total variation
_LEVELS = 65534  # the largest number that stands for a value; one more stands for no value


def packed(log: Mapping[str, np.ndarray]) -> tuple[dict[str, Any], str]:
    """What the page has to know of the columns: {rows, columns: [{name, low, step}]}; and their values as base64.

    A value is low + step * number; its error is at most half of a 65534th of the column's range.
    """
    n = len(log["time_s"])
    stride = -(-n // MOST_ROWS)
    kept = np.unique(np.append(np.arange(0, n, stride), n - 1))
    told, words = [], []
    for name, values in log.items():
        low, step, column = _numbers(_thinned(values, kept, stride if name != "time_s" else 1))
        told.append({"name": name, "low": low, "step": step})
        words.append(np.diff(column, prepend=np.uint16(0)))
    all_words = np.concatenate(words).astype("<u2").view(np.uint8)
    data = zlib.compress(all_words[0::2].tobytes() + all_words[1::2].tobytes(), 9)
    return {"rows": len(kept), "columns": told}, base64.b64encode(data).decode("ascii")


def _thinned(values: np.ndarray, kept: np.ndarray, stride: int) -> np.ndarray:
    """The values in the rows `kept`, or the envelope of a dense column."""
    few = values[kept]
    if stride == 1 or not np.all(np.isfinite(values)):
        return few
    if np.abs(np.diff(values)).sum() <= _DENSE * np.abs(np.diff(few)).sum():
        return few
    pairs = len(values) // (2 * stride)
    blocks = values[: pairs * 2 * stride].reshape(pairs, 2 * stride)
    low, high = blocks.argmin(axis=1), blocks.argmax(axis=1)
    first, second = np.minimum(low, high), np.maximum(low, high)
    rows = np.arange(pairs)
    few = few.copy()
    few[0 : 2 * pairs : 2], few[1 : 2 * pairs : 2] = blocks[rows, first], blocks[rows, second]
    return few


def _numbers(values: np.ndarray) -> tuple[float, float, np.ndarray]:
    """(low, step, numbers [rows] of 16 bits) of a column."""
    finite = values[np.isfinite(values)]
    low = float(finite.min()) if len(finite) else 0.0
    step = (float(finite.max()) - low) / _LEVELS if len(finite) else 0.0
    if not np.isfinite(step) or step == 0.0:
        step = 1.0
    numbers = np.full(len(values), _LEVELS + 1, dtype=np.uint16)
    known = np.isfinite(values)
    numbers[known] = np.clip(np.round((values[known] - low) / step), 0, _LEVELS).astype(np.uint16)
    return low, step, numbers

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
_NONE = 65535  # stands for no value
_LEVELS, _FEWER = 65534, 4094
"""Largest number that stands for a value; the same in a noisy column, whose last bits cannot be compressed."""
_NOISY_BYTES = 6000  # size of a deflated column from which on it counts as noisy


def packed(log: Mapping[str, np.ndarray]) -> tuple[dict[str, Any], str]:
    """What the page has to know of the columns: {rows, columns: [{name, low, step}]}; and their values as base64.

    A value is low + step * number; its error is at most half of a 65534th of the column's range, in a noisy column of a 4094th.
    """
    n = len(log["time_s"])
    stride = -(-n // MOST_ROWS)
    kept = np.unique(np.append(np.arange(0, n, stride), n - 1))
    told, words = [], []
    for name, values in log.items():
        few = _thinned(values, kept, stride if name != "time_s" else 1)
        low, step, column = _differences(few, _LEVELS)
        if len(_deflated(column)) > _NOISY_BYTES:
            low, step, column = _differences(few, _FEWER)
        told.append({"name": name, "low": low, "step": step})
        words.append(column)
    data = _deflated(np.concatenate(words))
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


def _deflated(words: np.ndarray) -> bytes:
    """16-bit numbers, all low bytes before all high bytes, which deflates better."""
    pairs = words.astype("<u2").view(np.uint8)
    return zlib.compress(pairs[0::2].tobytes() + pairs[1::2].tobytes(), 9)


def _differences(values: np.ndarray, levels: int) -> tuple[float, float, np.ndarray]:
    """(low, step, differences [rows] of 16 bits, modulo 2^16) of a column in which `levels` stands for the largest value."""
    known = np.isfinite(values)
    low = float(values[known].min()) if known.any() else 0.0
    step = (float(values[known].max()) - low) / levels if known.any() else 0.0
    step = step if np.isfinite(step) and step > 0.0 else 1.0
    numbers = np.full(len(values), _NONE, dtype=np.uint16)
    numbers[known] = np.clip(np.round((values[known] - low) / step), 0, levels).astype(np.uint16)
    return low, step, np.diff(numbers, prepend=np.uint16(0))

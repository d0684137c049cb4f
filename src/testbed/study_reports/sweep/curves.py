"""Curves of a sweep: the share that passes along each varied value, and the errors in time. Nothing here draws."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from testbed.common.angles import unwrapped_deg
from testbed.common.statistics import Proportion, proportion
from testbed.studies.folder import histories
from testbed.studies.verdicts import judged

if TYPE_CHECKING:
    import pandas as pd

_BINS = 10
_FLIGHTS_OF_A_BIN = 8
MOST_NAMES = 12
"""A varied value with more names than these is not drawn."""
_CHUNK = 2000  # error histories that are read at a time
_MOST = 20_000  # error histories from which quantiles are computed


class Point(NamedTuple):
    """The share of flights that pass near a value: `at` is their mean value, or a name."""

    at: float | str
    share: Proportion


class Band(NamedTuple):
    """Errors in time [points]: 5 % quantile, median, 95 % quantile, and those of the flight with the largest error."""

    low: np.ndarray
    median: np.ndarray
    high: np.ndarray
    largest: np.ndarray
    flight: int


def is_number(values: pd.Series) -> bool:
    """Whether a varied value has numbers, and more than one."""
    return values.dtype.kind in "fiu" and values.nunique() > 1


def is_choice(values: pd.Series) -> bool:
    """Whether a varied value has names, more than one and few enough to be drawn."""
    return values.dtype.kind not in "fiu" and 1 < values.astype(str).nunique() <= MOST_NAMES


def drawn_inputs(frame: pd.DataFrame, paths: list[str]) -> list[str]:
    """The varied values that can be drawn, those with numbers first."""
    numbers = [path for path in paths if is_number(frame[path])]
    return numbers + [path for path in paths if is_choice(frame[path])]


def pass_shares(rows: pd.DataFrame, path: str) -> list[Point]:
    """The share of flights that pass in each part of an input's values, or for each of its names.

    The parts have as equal numbers of flights as can be: ten, or fewer so that each has 8 flights. Of ten different numbers or
    fewer, such as those of a choice, each is a part.
    """
    passed = judged(rows["passed"])
    values = rows[path][passed.index]
    names = None if is_number(values) else values.astype(str)
    return [
        Point(
            float(values[part.index].mean()) if names is None else str(at),
            proportion(int(part.sum()), len(part)),
        )
        for at, part in passed.groupby(_parts(values) if names is None else names)
    ]


def _parts(values: pd.Series) -> pd.Series:
    """The part in which each number is."""
    import pandas as pd

    if values.nunique() <= _BINS:
        return values
    most = min(_BINS, max(2, len(values) // _FLIGHTS_OF_A_BIN))
    return pd.qcut(values, most, labels=False, duplicates="drop")


def error_band(folder: Path, flights: np.ndarray, channel: str) -> Band | None:
    """Errors in time of some flights; None without histories. Errors of heading go on beyond a half turn.

    Quantiles at each time are over the flights that are still flying. If there are more than 20 000 flights, an evenly
    spaced part of them is used. The largest error is that of all flights.

    Args:
        folder: the sweep folder.
        flights: their numbers k (see `Plan.task`).
        channel: one of `histories.CHANNELS`.
    """
    every = -(-len(flights) // _MOST)
    index = list(histories.CHANNELS).index(channel)
    sampled, largest, worst, number = [], -1.0, None, -1
    for first in range(0, len(flights), _CHUNK):
        chunk = flights[first : first + _CHUNK]
        data = histories.read(folder, chunk)[:, index]
        if channel.endswith("_deg"):
            data = unwrapped_deg(data)
        sampled.append(data[-first % every :: every])
        size = np.nan_to_num(np.abs(data), nan=-1.0).max(axis=1)
        if size.max() > largest:
            k = int(np.argmax(size))
            largest, worst, number = float(size[k]), data[k], int(chunk[k])
    if worst is None:
        return None
    data = np.concatenate(sampled)
    bands = np.full((3, data.shape[1]), np.nan)
    flying = np.isfinite(data).any(axis=0)
    bands[:, flying] = np.nanquantile(data[:, flying], [0.05, 0.5, 0.95], axis=0)
    return Band(bands[0], bands[1], bands[2], worst, number)

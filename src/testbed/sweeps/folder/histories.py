"""Error histories: three errors of each flight at 200 times, all in one file, histories.f32.

Every flight has a record of the same size, at a place given by its number. So the file is never rewritten, does not depend
on the order in which flights finish, and can be read in part.
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from testbed.common.angles import wrap_deg
from testbed.flight.flight import Flight

CHANNELS = {
    "altitude_error_m": ("altitude_m", "altitude_command_m"),
    "heading_error_deg": ("heading_deg", "heading_command_deg"),
    "airspeed_error_m_s": ("airspeed_m_s", "airspeed_command_m_s"),
}
"""Name of the error: (signal, its reference), both columns of the log."""
POINTS = 200
SHAPE = (len(CHANNELS), POINTS)
RECORD_BYTES = 4 * len(CHANNELS) * POINTS


def times_s(duration_s: float) -> np.ndarray:
    """[POINTS] times of the points [s] in a flight of this duration [s]."""
    return np.arange(POINTS) * (duration_s / POINTS)


def history(flight: Flight) -> bytes:
    """A flight's record: [channels, points] little-endian float32, in the units of CHANNELS; NaN after the flight's end."""
    result = np.full(SHAPE, np.nan, dtype="<f4")
    if len(flight.data):
        column = {name: flight.data[:, j] for j, name in enumerate(flight.columns)}
        rows = np.searchsorted(column["time_s"], times_s(flight.scenario.duration_s) - 1e-9)
        rows = rows[rows < len(flight.data)]
        for j, (signal, command) in enumerate(CHANNELS.values()):
            error = column[signal][rows] - column[command][rows]
            if signal.startswith("heading"):
                error = wrap_deg(error)
            result[j, : len(rows)] = error
    return result.tobytes()


class Histories:
    """histories.f32, open for writing."""

    def __init__(self, file: Path) -> None:
        self._handle = os.open(file, os.O_RDWR | os.O_CREAT, 0o666)

    def put(self, k: int, record: bytes) -> None:
        """Write the record of flight number k; raises OSError when the disk is full."""
        offset = k * RECORD_BYTES
        while record:
            written = os.pwrite(self._handle, record, offset)
            record, offset = record[written:], offset + written

    def close(self) -> None:
        """Flush the file to disk and close it."""
        try:
            os.fsync(self._handle)
        finally:
            os.close(self._handle)


def read(file: Path, flights: np.ndarray) -> np.ndarray:
    """[flights, channels, points] histories of the flights with these numbers; NaN for those that the file does not have."""
    result = np.full((len(flights), *SHAPE), np.nan, dtype=np.float32)
    size = file.stat().st_size if file.is_file() else 0
    there = flights < size // RECORD_BYTES
    if there.any():
        mapped = np.memmap(file, dtype="<f4", mode="r", shape=(size // RECORD_BYTES, *SHAPE))
        result[there] = mapped[flights[there]]
    return result

"""Time histories of every flight, thinned to 200 points: one fixed-size slot a flight in one file.

A slot is written where it belongs, so the file is never rewritten, grows with what is flown, can be mapped
into memory a part at a time, and is the same whatever order flights finish in.
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
POINTS = 200
SHAPE = (len(CHANNELS), POINTS)
SLOT_BYTES = 4 * len(CHANNELS) * POINTS


def times_s(duration_s: float) -> np.ndarray:
    """[POINTS] times of the points of a flight of this length."""
    return np.arange(POINTS) * (duration_s / POINTS)


def thinned(flight: Flight) -> bytes:
    """A flight's slot: float32 [channels, points]; NaN after the flight's end."""
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
    """The file of slots, for writing."""

    def __init__(self, file: Path) -> None:
        self._handle = os.open(file, os.O_RDWR | os.O_CREAT, 0o666)

    def put(self, k: int, slot: bytes) -> None:
        """Write flight k's slot; raises OSError when the disk is full."""
        offset = k * SLOT_BYTES
        while slot:
            written = os.pwrite(self._handle, slot, offset)
            slot, offset = slot[written:], offset + written

    def close(self) -> None:
        """Have it on disk."""
        try:
            os.fsync(self._handle)
        finally:
            os.close(self._handle)


def read(file: Path, flights: np.ndarray) -> np.ndarray:
    """[flights, channels, points] slots of these flights, mapped and copied; those never written are NaN."""
    result = np.full((len(flights), *SHAPE), np.nan, dtype=np.float32)
    size = file.stat().st_size if file.is_file() else 0
    there = flights < size // SLOT_BYTES
    if there.any():
        slots = np.memmap(file, dtype="<f4", mode="r", shape=(size // SLOT_BYTES, *SHAPE))
        result[there] = slots[flights[there]]
    return result

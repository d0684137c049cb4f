"""Error histories: three errors of each flight at 200 times."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from testbed.common.angles import wrap_deg
from testbed.flight.flight import Flight
from testbed.studies.folder import store
from testbed.studies.record import key_of

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
    """A flight's history: [channels, points] little-endian float32, in the units of CHANNELS; NaN after the flight's end."""
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


def read(folder: Path, flights: np.ndarray) -> np.ndarray:
    """[flights, channels, points] histories of a sweep's flights with these numbers; NaN for those that it does not have."""
    result = np.full((len(flights), *SHAPE), np.nan, dtype=np.float32)
    if store.exists(folder):
        with store.reading(folder) as stored:
            for row, k in enumerate(flights.tolist()):
                if len(data := stored.history(key_of(k))) == RECORD_BYTES:
                    result[row] = np.frombuffer(data, "<f4").reshape(SHAPE)
    return result

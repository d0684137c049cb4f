"""Error histories: a record a flight, where its number says."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from handmade import flight_of, level_log

from testbed.studies.folder import store
from testbed.studies.folder.logs import (
    HISTORY_BYTES,
    HISTORY_CHANNELS,
    HISTORY_POINTS,
    HISTORY_SHAPE,
    history,
    history_times_s,
    read_histories,
)
from testbed.studies.record import Record, key_of


def record(rows: int = 1000, heading_deg: float = 350.0) -> np.ndarray:
    """The history of a flight of 10 s that climbs from its altitude reference, of which so many rows are flown."""
    log = level_log()
    log["altitude_m"] = 100.0 + log["time_s"]
    log["heading_deg"][:], log["heading_command_deg"][:] = heading_deg, 350.0
    data = history(flight_of({name: column[:rows] for name, column in log.items()}))
    assert len(data) == HISTORY_BYTES
    return np.frombuffer(data, "<f4").reshape(HISTORY_SHAPE)


def test_errors_are_against_the_references_at_evenly_spaced_times() -> None:
    found = dict(zip(HISTORY_CHANNELS, record(), strict=True))
    np.testing.assert_allclose(found["altitude_error_m"], history_times_s(10.0), atol=0.01)
    assert not found["airspeed_error_m_s"].any() and len(history_times_s(10.0)) == HISTORY_POINTS


def test_heading_errors_are_the_short_way_round() -> None:
    heading = list(HISTORY_CHANNELS).index("heading_error_deg")
    for flown, error in ((10.0, 20.0), (330.0, -20.0), (350.0, 0.0)):
        assert (record(heading_deg=flown)[heading] == error).all()


def test_after_the_end_of_a_flight_there_is_nothing() -> None:
    found = record(rows=500)
    assert np.isfinite(found[:, :100]).all() and np.isnan(found[:, 100:]).all()


def test_a_history_is_found_by_its_number_whatever_was_written_first(tmp_path: Path) -> None:
    store.create(tmp_path, {})
    flights = store.opened(tmp_path)
    for k in (7, 2):
        flights.add(
            key_of(k), Record(k, 0, 1, {}, "completed", True), np.full(HISTORY_SHAPE, k, "<f4").tobytes()
        )
    flights.close()
    found = read_histories(tmp_path, np.array([2, 7, 9]))
    assert (found[0] == 2).all() and (found[1] == 7).all() and np.isnan(found[2]).all()
    assert np.isnan(read_histories(tmp_path / "none", np.array([0]))).all()

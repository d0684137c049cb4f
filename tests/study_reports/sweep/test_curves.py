"""Shares along an input, and bands of errors in time."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from testbed.common.angles import unwrapped_deg
from testbed.studies.folder import logs, store
from testbed.studies.record import Record, key_of
from testbed.study_reports.sweep.curves import drawn_inputs, error_band, pass_shares


def test_headings_go_on_beyond_a_half_turn() -> None:
    turning = np.arange(0.0, 720.0, 30.0)
    wrapped = (turning + 180.0) % 360.0 - 180.0
    ended = wrapped.copy()
    ended[10:] = np.nan
    found = unwrapped_deg(np.array([wrapped, ended]))
    assert found[0] == pytest.approx(turning)
    assert found[1, :10] == pytest.approx(turning[:10]) and np.isnan(found[1, 10:]).all()


def test_a_band_has_quantiles_of_those_still_flying_and_the_worst(tmp_path: Path) -> None:
    store.create(tmp_path, {})
    flights = store.opened(tmp_path)
    for k in range(21):
        record = np.full(logs.HISTORY_SHAPE, float(k - 10), dtype="<f4")
        record[:, 100:] = np.nan if k % 2 else float(k - 10)
        flown = Record(k, 0, 1, {}, "completed", True)
        flights.add(key_of(k), flown, record.tobytes())
    flights.close()
    band = error_band(tmp_path, np.arange(21), "altitude_error_m")
    assert band is not None
    assert [band[name][0] for name in ("low", "median", "high")] == pytest.approx([-9.0, 0.0, 9.0])
    assert band["median"][150] == pytest.approx(0.0)
    assert band["high"][150] == pytest.approx(np.quantile(np.arange(-10, 11, 2), 0.95))
    assert band["run"] in (0, 20) and abs(band["largest"][0]) == 10.0
    assert error_band(tmp_path, np.arange(21), "altitude_error_m", variants=7)["run"] == band["run"] // 7
    os.remove(tmp_path / store.NAME)
    none = error_band(tmp_path, np.arange(21), "altitude_error_m")
    assert none is None or none["median"] == [None] * logs.HISTORY_POINTS


def test_a_choice_of_numbers_has_a_share_for_each() -> None:
    frame = pd.DataFrame({"w20": [7.62] * 45 + [15.24] * 15, "passed": [True] * 40 + [False] * 20})
    found = [[at, share, n] for at, share, _, _, n in pass_shares(frame, "w20")]
    assert found == [[7.62, pytest.approx(40 / 45, rel=1e-3), 45], [15.24, 0.0, 15]]


def test_shares_of_numbers_and_of_names() -> None:
    frame = pd.DataFrame({"x": np.linspace(0, 1, 200), "name": ["a", "b"] * 100, "same": 1.0})
    frame["passed"] = (frame["x"] > 0.5) & (frame["name"] == "a")
    numbers = pass_shares(frame, "x")
    assert len(numbers) == 10 and sum(n for *_, n in numbers) == 200
    assert [share for _, share, *_ in numbers] == pytest.approx([0.0] * 5 + [0.5] * 5, abs=0.03)
    assert [(at, share, n) for at, share, _, _, n in pass_shares(frame, "name")] == [
        ("a", 0.5, 100),
        ("b", 0.0, 100),
    ]
    assert drawn_inputs(frame, ["name", "same", "x"]) == ["x", "name"]

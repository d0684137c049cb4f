"""What a flight needs of the plant is tried before the flight."""

from __future__ import annotations

from pathlib import Path

import pytest

from testbed.aircraft.description import load_aircraft
from testbed.common.cache import Cache
from testbed.inputs.problems import BadInput
from testbed.plant.start_check import check_start
from testbed.plant.trim import NoTrim

START = (200.0, 18.0, 300.0, 0.0)


def test_no_flight_begins_where_there_is_no_trim(vtail_copy: Path) -> None:
    with pytest.raises(NoTrim, match=r"no steady flight of vtail was found at 9 m/s"):
        check_start(load_aircraft(str(vtail_copy)), 200.0, 9.0, 300.0, 0.0)


def test_what_is_known_is_not_tried_again(
    vtail_copy: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    Cache.clear_all()
    aircraft = load_aircraft(str(vtail_copy))
    catalog = check_start(aircraft, *START)
    monkeypatch.setattr("testbed.plant.trim.trimmed_start", lambda *_: pytest.fail("trimmed again"))
    assert check_start(aircraft, *START) == catalog
    with pytest.raises(BaseException, match="trimmed again"):
        check_start(aircraft, 200.0, 18.5, 300.0, 0.0)


def test_a_design_model_that_is_none_is_bad_input(vtail_copy: Path) -> None:
    (vtail_copy / "design_model.json").write_text("{}")
    with pytest.raises(BadInput, match=r"design_model\.json: is no design model"):
        check_start(load_aircraft(str(vtail_copy)), *START)

"""ACMI read back by pyacmi; its events, which that skips, by the grammar of Tacview's documentation."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest
from pyacmi import Acmi

from testbed.aircraft.changes import ChangedAircraft
from testbed.flight.flight import Flight
from testbed.reporting.export import export
from testbed.reporting.export.place import Origin
from testbed.reporting.export.tracks import ACMI_HZ as RATE_HZ


@pytest.fixture
def file(flown: Flight, tmp_path: Path) -> Path:
    return export(flown, "acmi", tmp_path / "flight.acmi", Origin(47.0, 8.0))


def test_another_reader_sees_the_flight(flown: Flight, file: Path) -> None:
    acmi = Acmi()
    acmi.load_acmi(str(file))
    assert (acmi.file_type, acmi.file_version, acmi.title) == ("text/acmi/tacview", 2.2, "healthy")
    assert acmi.reference_time.isoformat() == "2000-01-01T00:00:00"
    aircraft = acmi.objects["1"]
    assert aircraft.name == "vtail" and aircraft.is_plane
    log = flown.log.set_index("time_s").loc[2.0]
    assert aircraft.altitude(2.0) == pytest.approx(log["altitude_m"], abs=0.006)
    for name, column in {"Roll": "roll_deg", "Pitch": "pitch_deg", "Yaw": "heading_deg"}.items():
        assert aircraft.get_value(name, 2.0) == pytest.approx(log[column], abs=0.006)
    assert float(aircraft.get_value("WindEast", 2.0)) == pytest.approx(5.0)
    assert aircraft.tas(2.0) == pytest.approx(log["airspeed_m_s"], rel=1e-3)
    east_m = (
        aircraft.longitude(2.0) - 8.0
    ) * 76096.0  # metres of a degree of longitude at 47 deg north on WGS 84
    assert east_m == pytest.approx(log["east_m"], rel=2e-3)


def test_every_line_follows_the_grammar(file: Path) -> None:
    head, version, *lines = file.read_text(encoding="utf-8-sig").splitlines()
    assert (head, version) == ("FileType=text/acmi/tacview", "FileVersion=2.2")
    value = r"(?:[^,\\]|\\.)*"
    line_of = re.compile(rf"#\d+\.\d+|[0-9a-f]+(?:,[A-Za-z0-9]+={value})+")
    assert not [line for line in lines if not line_of.fullmatch(line)]


def test_events_are_bookmarks_at_their_times(flown: Flight, file: Path) -> None:
    time, found = -1.0, {}
    for line in file.read_text(encoding="utf-8-sig").splitlines():
        if line.startswith("#"):
            assert float(line[1:]) >= time
            time = float(line[1:])
        elif line.startswith("0,Event=Bookmark|"):
            found[time] = line.removeprefix("0,Event=Bookmark|")
    assert len(found) >= 1 and "left ruddervator" in found[1.0]
    assert sorted(found) == pytest.approx(sorted({event["time_s"] for event in flown.events}), abs=1e-3)


def test_its_rate_is_what_a_viewer_needs(flown: Flight, file: Path) -> None:
    times = [line for line in file.read_text().splitlines() if line.startswith("#")]
    assert len(times) <= 3.0 * RATE_HZ + 1 + len(flown.events)


def test_a_changed_aircraft_has_its_changes_in_its_name(flown: Flight, tmp_path: Path) -> None:
    heavy = ChangedAircraft(name="vtail", mass_kg=6.0)
    changed = replace(flown, scenario=flown.scenario.model_copy(update={"aircraft": heavy}))
    text = export(changed, "acmi", tmp_path / "heavy.acmi").read_text(encoding="utf-8-sig")
    assert "Name=vtail with mass_kg 6.0," in text

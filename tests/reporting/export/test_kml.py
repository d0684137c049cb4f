"""KML read back by lxml, with the signs of a model's angles."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from lxml import etree

from testbed.flight.flight import Flight
from testbed.reporting.export import export
from testbed.reporting.export.place import Origin

_NAMES = {"k": "http://www.opengis.net/kml/2.2", "gx": "http://www.google.com/kml/ext/2.2"}


@pytest.fixture
def document(flown: Flight, tmp_path: Path) -> etree._Element:
    file = export(flown, "kml", tmp_path / "flight.kml", Origin(47.0, 8.0, 500.0))
    return etree.parse(str(file)).getroot()


def _numbers(document: etree._Element, path: str) -> np.ndarray:
    return np.array([[float(x) for x in e.text.split()] for e in document.iterfind(path, _NAMES)])


def test_the_track_has_times_places_and_angles(flown: Flight, document: etree._Element) -> None:
    times = [e.text for e in document.iterfind(".//gx:Track/k:when", _NAMES)]
    places, angles = (_numbers(document, f".//gx:Track/gx:{of}") for of in ("coord", "angles"))
    assert len(times) == len(places) == len(angles) == 30
    assert times[0] == "2000-01-01T00:00:00.000Z" and times[10] == "2000-01-01T00:00:01.000Z"
    assert places[0] == pytest.approx([8.0, 47.0, 500.0])
    log = flown.log.set_index("time_s").loc[2.0]
    east_m, north_m = (places[20, :2] - [8.0, 47.0]) * np.array([0.68358 * 111319.5, 111132.9])
    assert east_m == pytest.approx(log["east_m"], rel=3e-3)
    assert north_m == pytest.approx(log["north_m"], abs=0.02)
    assert places[20, 2] - 500.0 == pytest.approx(log["altitude_m"] - flown.log["altitude_m"][0], abs=0.01)
    # A model's tilt is nose down and its roll to the left: clockwise as seen from the tip of the axis.
    assert log["roll_deg"] > 1.0
    assert angles[20] == pytest.approx([log["heading_deg"], -log["pitch_deg"], -log["roll_deg"]], abs=1e-3)


def test_arrays_are_as_long_as_the_track(document: etree._Element) -> None:
    arrays = {
        e.get("name"): [float(v.text) for v in e.iterfind("gx:value", _NAMES)]
        for e in document.iterfind(".//gx:SimpleArrayData", _NAMES)
    }
    declared = [e.get("name") for e in document.iterfind(".//k:Schema/gx:SimpleArrayField", _NAMES)]
    assert list(arrays) == declared
    assert {len(values) for values in arrays.values()} == {30}
    assert arrays["wind_east_m_s"] == [5.0] * 30


def test_events_are_places_in_time(flown: Flight, document: etree._Element) -> None:
    named = {
        p.find("k:name", _NAMES).text: p for p in document.iterfind(".//k:Placemark[k:TimeStamp]", _NAMES)
    }
    assert len(named) >= 1
    first = named[next(name for name in named if "left ruddervator" in name)]
    assert first.find("k:TimeStamp/k:when", _NAMES).text == "2000-01-01T00:00:01.000Z"
    longitude = float(first.find("k:Point/k:coordinates", _NAMES).text.split(",")[0])
    assert longitude == pytest.approx(8.0 + flown.log.set_index("time_s")["east_m"][1.0] / 76096.0, abs=1e-6)

"""The track of a flight on the globe, for Tacview and for Google Earth.

ACMI 2.2 is text in UTF-8 (https://www.tacview.net/documentation/acmi/en/). Roll is positive to the right, pitch up, yaw from true
north, as in the log.

KML 2.2 is written with Google's extension gx:Track (https://developers.google.com/kml/documentation/kmlreference#gxtrack).

gx:angles are those of a model whose y axis is the nose: heading, tilt and roll, each positive clockwise as seen from the
tip of its axis. So tilt is nose down, roll is to the left, and both have the opposite sign of the log's.
"""

from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, datetime
from html import escape
from pathlib import Path
from typing import BinaryIO
from xml.etree import ElementTree as Xml

import numpy as np

from testbed.common.text import printable
from testbed.flight.flight import Flight
from testbed.reporting.export.place import EPOCH_S, Origin, Poses, poses, wind
from testbed.reporting.story import story
from testbed.reporting.words import describe

ACMI_HZ = 25.0
_AIRCRAFT = "1"  # identifier of the object
_HEAD = "FileType=text/acmi/tacview\nFileVersion=2.2\n0,ReferenceTime=2000-01-01T00:00:00Z\n"
_AIR = {"TAS": "airspeed_m_s", "AOA": "alpha_deg", "AOS": "beta_deg"}  # Tacview's own names


def acmi(flight: Flight, stream: BinaryIO, origin: Origin) -> None:
    """Write the flight at ACMI_HZ, with wind and actuators as properties of the aircraft and events as bookmarks."""
    text = "".join(f"{line}\n" for line in _lines(flight, poses(flight, origin, ACMI_HZ)))
    stream.write((_HEAD + text).encode("utf-8-sig"))


def _lines(flight: Flight, track: Poses) -> Iterator[str]:
    yield f"0,DataSource=testbed,Title={_escaped(flight.scenario.name)}"
    yield f"0,Category=Flight test,Comments={_escaped(' '.join(story(flight)))}"
    columns = _columns(flight)
    bookmarks = [(float(event["time_s"]), describe(event, flight)) for event in flight.events]
    yield f"{_AIRCRAFT},Type=Air+FixedWing,Name={_escaped(Path(str(flight.scenario.aircraft)).name)},Color=Blue"
    for k, row in enumerate(track.rows):
        while bookmarks and bookmarks[0][0] <= track.time_s[k]:
            yield from _bookmark(*bookmarks.pop(0))
        yield f"#{track.time_s[k]:.3f}"
        place = f"{track.longitude_deg[k]:.8f}|{track.latitude_deg[k]:.8f}|{track.altitude_m[k]:.2f}"
        attitude = f"{track.roll_deg[k]:.2f}|{track.pitch_deg[k]:.2f}|{track.heading_deg[k]:.2f}"
        known = [f"{name}={v:.4g}" for name, c in columns.items() if np.isfinite(v := flight.data[row, c])]
        yield ",".join([f"{_AIRCRAFT},T={place}|{attitude}", *known])
    for bookmark in bookmarks:
        yield from _bookmark(*bookmark)


def _bookmark(time_s: float, text: str) -> Iterator[str]:
    yield f"#{time_s:.3f}"
    yield f"0,Event=Bookmark|{_escaped(text.replace('|', '/'))}"


def _columns(flight: Flight) -> dict[str, int]:
    """Place in the log of each numeric property; names that Tacview does not know it keeps as raw telemetry."""
    names = {name: column for name, column in _AIR.items() if column in flight.columns}
    names |= {_camel(column.removesuffix("_m_s")): column for column in wind(flight)}
    for actuator in flight.actuators:
        names |= {_camel(f"{actuator}_{of}"): f"{actuator}_{of}" for of in ("position", "effectiveness")}
    return {name: flight.columns.index(column) for name, column in names.items()}


def _camel(column: str) -> str:
    return "".join(part.capitalize() for part in column.split("_"))


def _escaped(text: str) -> str:
    """A text as a property's value: commas, backslashes and ends of lines are escaped."""
    return printable(text).replace("\\", "\\\\").replace(",", "\\,").replace("\n", "\\\n")


KML_HZ = 10.0
_KML, _GX = "http://www.opengis.net/kml/2.2", "http://www.google.com/kml/ext/2.2"
_SCHEMA = "air"


def kml(flight: Flight, stream: BinaryIO, origin: Origin) -> None:
    """Write the flight's track at KML_HZ with attitude, air data and wind, and a place for each event."""
    Xml.register_namespace("", _KML)
    Xml.register_namespace("gx", _GX)
    track = poses(flight, origin, KML_HZ)
    root = Xml.Element(f"{{{_KML}}}kml")
    document = _add(root, "Document")
    _add(document, "name", printable(flight.scenario.name))
    _add(document, "description", escape(printable("\n".join(story(flight)))))  # readers show it as HTML
    columns = [c for c in ("airspeed_m_s", *wind(flight)) if c in flight.columns]
    schema = _add(document, "Schema", id=_SCHEMA)
    for column in columns:
        _add(schema, "SimpleArrayField", gx=True, name=column, type="float")
    _track(_placemark(document, "flight"), flight, track, columns)
    _events(document, flight, track)
    Xml.ElementTree(root).write(stream, encoding="utf-8", xml_declaration=True)


def _track(place: Xml.Element, flight: Flight, track: Poses, columns: list[str]) -> None:
    line = _add(place, "Track", gx=True)
    _add(line, "altitudeMode", "absolute")
    for time in track.time_s:
        _add(line, "when", _when(float(time)))
    for k in range(len(track.rows)):
        _add(line, "coord", _coordinates(track, k, " "), gx=True)
    for roll, pitch, heading in zip(track.roll_deg, track.pitch_deg, track.heading_deg, strict=True):
        _add(line, "angles", f"{heading:.3f} {-pitch:.3f} {-roll:.3f}", gx=True)
    data = _add(_add(line, "ExtendedData"), "SchemaData", schemaUrl=f"#{_SCHEMA}")
    for column in columns:
        array = _add(data, "SimpleArrayData", gx=True, name=column)
        for value in flight.column(column)[track.rows]:
            _add(array, "value", f"{value:.3f}", gx=True)


def _events(document: Xml.Element, flight: Flight, track: Poses) -> None:
    if not len(track.rows):
        return
    for event in flight.events:
        place = _placemark(document, printable(describe(event, flight)))
        _add(_add(place, "TimeStamp"), "when", _when(event["time_s"]))
        point = _add(place, "Point")
        _add(point, "altitudeMode", "absolute")
        k = min(int(np.searchsorted(track.time_s, event["time_s"] - 1e-9)), len(track.rows) - 1)
        _add(point, "coordinates", _coordinates(track, k, ","))


def _coordinates(track: Poses, k: int, between: str) -> str:
    place = (track.longitude_deg[k], track.latitude_deg[k])
    return between.join([*(f"{angle:.8f}" for angle in place), f"{track.altitude_m[k]:.2f}"])


def _placemark(document: Xml.Element, name: str) -> Xml.Element:
    place = _add(document, "Placemark")
    _add(place, "name", name)
    return place


def _when(time_s: float) -> str:
    return datetime.fromtimestamp(EPOCH_S + time_s, UTC).isoformat(timespec="milliseconds")[:-6] + "Z"


def _add(
    parent: Xml.Element, tag: str, text: str | None = None, gx: bool = False, **attributes: str
) -> Xml.Element:
    element = Xml.SubElement(parent, f"{{{_GX if gx else _KML}}}{tag}", attributes)
    element.text = text
    return element

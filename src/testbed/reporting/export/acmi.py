"""Tacview's ACMI 2.2, text in UTF-8 (https://www.tacview.net/documentation/acmi/en/).

Roll is positive to the right, pitch up, yaw from true north, as in the log.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

import numpy as np

from testbed.common.text import printable
from testbed.flight.flight import Flight
from testbed.reporting.export.place import Origin, Poses, poses, wind
from testbed.reporting.story import story
from testbed.reporting.words import describe

RATE_HZ = 25.0
_AIRCRAFT = "1"  # identifier of the object
_HEAD = "FileType=text/acmi/tacview\nFileVersion=2.2\n0,ReferenceTime=2000-01-01T00:00:00Z\n"
_AIR = {"TAS": "airspeed_m_s", "AOA": "alpha_deg", "AOS": "beta_deg"}  # Tacview's own names


def write(flight: Flight, stream: BinaryIO, origin: Origin) -> None:
    """Write the flight at RATE_HZ, with wind and actuators as properties of the aircraft and events as bookmarks."""
    text = "".join(f"{line}\n" for line in _lines(flight, poses(flight, origin, RATE_HZ)))
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

"""Where on earth a flight was, and how it stood there: what every format that shows a place is made from."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from testbed.flight.flight import Flight
from testbed.inputs.problems import BadInput, Problem

_EQUATOR_M, _FLATTENING = 6378137.0, 1.0 / 298.257223563  # WGS 84
EPOCH_S = 946684800
"""Unix time of 2000-01-01 00:00:00 UTC, at which every flight is said to start: nothing exported depends on the clock."""

POSE = ("time_s", "north_m", "east_m", "altitude_m", "roll_deg", "pitch_deg", "heading_deg")
"""Columns of the log that say where the aircraft was, and how it stood."""


@dataclass(frozen=True)
class Origin:
    """Where a flight starts: geodetic latitude and longitude [deg], and altitude above mean sea level [m].

    Without an altitude it is that of the log.
    """

    latitude_deg: float
    longitude_deg: float
    altitude_m: float | None = None


DEFAULT_ORIGIN = Origin(37.6188, -122.3754)
"""San Francisco airport: at sea level, and part of FlightGear's own scenery."""


def parse_origin(text: str) -> Origin:
    """The origin in `LAT,LON` or `LAT,LON,ALT`; raises BadInput."""
    try:
        latitude, longitude, *more = (float(part) for part in text.split(","))
        (altitude,) = more or (None,)
        if not all(map(math.isfinite, (latitude, longitude, altitude or 0.0))):
            raise ValueError
        if abs(latitude) >= 90.0 or abs(longitude) > 180.0:
            raise ValueError
    except ValueError:
        expected = "LAT,LON or LAT,LON,ALT in degrees and metres, as 37.62,-122.38,300; not a pole"
        raise BadInput([Problem(f"is no origin: {text}", "--origin", expected=expected)]) from None
    return Origin(latitude, longitude, altitude)


class Poses(NamedTuple):
    """Time and place [rows]; only rows of the log in which all are finite."""

    rows: np.ndarray
    """Their rows in the log."""
    time_s: np.ndarray
    north_m: np.ndarray
    east_m: np.ndarray
    latitude_deg: np.ndarray
    longitude_deg: np.ndarray
    altitude_m: np.ndarray
    """Above mean sea level."""
    roll_deg: np.ndarray
    pitch_deg: np.ndarray
    heading_deg: np.ndarray


def poses(flight: Flight, origin: Origin, rate_hz: float = math.inf) -> Poses:
    """Where the aircraft was, at no more than `rate_hz` rows a second.

    North and east of the origin become angles by the radii of curvature of the WGS 84 ellipsoid at the origin (meridian and
    prime vertical): 10 km away the error is some metres.
    """
    rows = thinned(flight, rate_hz)
    time, north, east, height, roll, pitch, heading = (flight.column(name)[rows] for name in POSE)
    altitude = height if origin.altitude_m is None else height - height[:1] + origin.altitude_m
    latitude, longitude = geodetic(origin, north, east, float(altitude[0]) if len(altitude) else 0.0)
    values = (time, north, east, latitude, longitude, altitude, roll, pitch, heading)
    finite = np.all(np.isfinite(values), axis=0)
    return Poses(rows[finite], *(v[finite] for v in values))


def geodetic(
    origin: Origin, north_m: np.ndarray, east_m: np.ndarray, altitude_m: float
) -> tuple[np.ndarray, np.ndarray]:
    """(latitude, longitude) [deg] of points north and east of an origin that is at this altitude [m]."""
    e2 = _FLATTENING * (2.0 - _FLATTENING)
    latitude = math.radians(origin.latitude_deg)
    w2 = 1.0 - e2 * math.sin(latitude) ** 2
    prime = _EQUATOR_M / math.sqrt(w2)
    meridian = prime * (1.0 - e2) / w2
    return (
        origin.latitude_deg + np.degrees(north_m / (meridian + altitude_m)),
        origin.longitude_deg + np.degrees(east_m / ((prime + altitude_m) * math.cos(latitude))),
    )


def thinned(flight: Flight, rate_hz: float) -> np.ndarray:
    """Rows of the log, evenly spaced, at no more than `rate_hz` a second."""
    every = max(1, math.ceil(flight.scenario.log_hz / rate_hz - 1e-9))
    return np.arange(0, len(flight.data), every)


def wind(flight: Flight) -> Iterator[str]:
    """The log's columns of wind; none in still air."""
    return (name for name in flight.columns if name.startswith("wind_"))

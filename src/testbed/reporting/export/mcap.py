"""MCAP with JSON messages and JSON schemas, for Foxglove (https://mcap.dev/spec, https://docs.foxglove.dev/docs/sdk/schemas).

Frame `world` is at the start of the flight: x east, y north, z up. Frame `aircraft`: x forward, y left, z up.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, BinaryIO

import numpy as np

from testbed.flight.flight import Flight
from testbed.inputs.problems import BadInput, Problem
from testbed.reporting.export.place import EPOCH_S, Origin, Poses, poses, thinned, wind
from testbed.reporting.export.units import units_of
from testbed.reporting.words import describe

RATE_HZ = 50.0
_LEVELS = {"injection": 3, "lost": 4, "false_alarm": 3}  # foxglove.Log: 2 info, 3 warning, 4 error
_ACTUATOR = (
    "reference", "command", "position", "effectiveness", "effectiveness_estimate", "failed", "belief", "believed_position",
)  # fmt: skip
_GROUPS = {
    "/state": (
        "airspeed_m_s", "climb_rate_m_s", "roll_deg", "pitch_deg", "heading_deg", "alpha_deg", "beta_deg",
        "p_deg_s", "q_deg_s", "r_deg_s",
    ),
    "/references": ("altitude_command_m", "airspeed_command_m_s", "heading_command_deg"),
}  # fmt: skip

_TIME = {
    "type": "object",
    "properties": {"sec": {"type": "integer"}, "nsec": {"type": "integer"}},
}
_NUMBER, _TEXT, _INTEGER = {"type": "number"}, {"type": "string"}, {"type": "integer"}


def _object(**properties: Any) -> dict[str, Any]:
    return {"type": "object", "properties": properties}


_SCHEMAS = {
    "foxglove.FrameTransform": _object(
        timestamp=_TIME,
        parent_frame_id=_TEXT,
        child_frame_id=_TEXT,
        translation=_object(x=_NUMBER, y=_NUMBER, z=_NUMBER),
        rotation=_object(x=_NUMBER, y=_NUMBER, z=_NUMBER, w=_NUMBER),
    ),
    "foxglove.LocationFix": _object(
        timestamp=_TIME,
        frame_id=_TEXT,
        latitude=_NUMBER,
        longitude=_NUMBER,
        altitude=_NUMBER,
        position_covariance={"type": "array", "items": _NUMBER},
        position_covariance_type=_INTEGER,
    ),
    "foxglove.Log": _object(
        timestamp=_TIME, level=_INTEGER, message=_TEXT, name=_TEXT, file=_TEXT, line=_INTEGER
    ),
}

_FOXGLOVE = {"/tf": "foxglove.FrameTransform", "/location": "foxglove.LocationFix", "/events": "foxglove.Log"}

Message = tuple[int, str, dict[str, Any]]
"""Time [ns], topic, contents."""


def write(flight: Flight, stream: BinaryIO, origin: Origin) -> None:
    """Write frames, location and the log's signals at RATE_HZ, and the events; raises BadInput without the package mcap."""
    try:
        from mcap.writer import Writer
    except ImportError:
        what = "mcap needs the package mcap"
        raise BadInput([Problem(what, "--to mcap", expected="pip install 'testbed[export]'")]) from None
    track, topics = poses(flight, origin, RATE_HZ), _topics(flight)
    messages = [*_motion(track), *_signals(flight, topics), *_events(flight)]
    writer = Writer(stream)
    writer.start(profile="", library="testbed")
    channel = _channels(writer, flight, topics)
    for sequence, (time, topic, contents) in enumerate(sorted(messages, key=lambda m: m[:2])):
        data = json.dumps(contents, allow_nan=False).encode()
        writer.add_message(channel(topic), time, data, time, sequence)
    writer.add_metadata("flight", {"scenario": flight.scenario.name, "outcome": str(flight.outcome)})
    writer.finish()


def _topics(flight: Flight) -> dict[str, dict[str, str]]:
    """{topic: {name in the message: column}} of the log's signals."""
    topics = {topic: {c: c for c in columns if c in flight.columns} for topic, columns in _GROUPS.items()}
    topics["/wind"] = {column: column for column in wind(flight)}
    for name in flight.actuators:
        told = {of: f"{name}_{of}" for of in _ACTUATOR}
        topics[f"/actuators/{name}"] = {of: column for of, column in told.items() if column in flight.columns}
    return {topic: columns for topic, columns in topics.items() if columns}


def _channels(writer: Any, flight: Flight, topics: Mapping[str, Mapping[str, str]]) -> Callable[[str], int]:
    """Register every topic with its schema; returns a function from topic to the channel's number."""
    units = units_of(flight)
    schemas = {
        topic: (
            topic.strip("/").replace("/", "."),
            _object(
                timestamp=_TIME, **{name: {**_NUMBER, "description": units[c]} for name, c in of.items()}
            ),
        )
        for topic, of in topics.items()
    }
    schemas |= {topic: (name, _SCHEMAS[name]) for topic, name in _FOXGLOVE.items()}
    numbers: dict[str, int] = {}
    for topic, (name, schema) in schemas.items():
        data = json.dumps({"title": name, **schema}).encode()
        numbers[topic] = writer.register_channel(
            topic, "json", writer.register_schema(name, "jsonschema", data)
        )
    return numbers.__getitem__


def _motion(track: Poses) -> Iterator[Message]:
    """The aircraft's frame in the world's, and its location."""
    rotations = rotation(track.roll_deg, track.pitch_deg, track.heading_deg)
    for k, time in enumerate(track.time_s):
        stamp, now = _stamp(float(time))
        place = (float(at[k]) for at in (track.east_m, track.north_m, track.altitude_m))
        frame = {
            "timestamp": stamp,
            "parent_frame_id": "world",
            "child_frame_id": "aircraft",
            "translation": dict(zip("xyz", place, strict=True)),
            "rotation": dict(zip("xyzw", rotations[k].tolist(), strict=True)),
        }
        yield now, "/tf", frame
        location = {
            "timestamp": stamp,
            "frame_id": "aircraft",
            "latitude": float(track.latitude_deg[k]),
            "longitude": float(track.longitude_deg[k]),
            "altitude": float(track.altitude_m[k]),
            "position_covariance": [0.0] * 9,
            "position_covariance_type": 0,
        }
        yield now, "/location", location


def _signals(flight: Flight, topics: Mapping[str, Mapping[str, str]]) -> Iterator[Message]:
    time = flight.column("time_s")
    for row in thinned(flight, RATE_HZ):
        stamp, now = _stamp(float(time[row]))
        for topic, of in topics.items():
            known = {name: v for name, c in of.items() if math.isfinite(v := float(flight.signals[c][row]))}
            yield now, topic, {"timestamp": stamp, **known}


def _events(flight: Flight) -> Iterator[Message]:
    for event in flight.events:
        stamp, now = _stamp(float(event["time_s"]))
        level = _LEVELS.get(event["kind"], 2)
        words = {"message": describe(event, flight), "name": event["kind"], "file": "", "line": 0}
        yield now, "/events", {"timestamp": stamp, "level": level, **words}


def rotation(roll_deg: np.ndarray, pitch_deg: np.ndarray, heading_deg: np.ndarray) -> np.ndarray:
    """[rows, 4] quaternions x, y, z, w that turn components in the aircraft's frame into the world's (see the module)."""
    # The same turns about axes that point the other way: pitch about left, yaw from east to the left.
    half = np.radians([roll_deg, -np.asarray(pitch_deg), 90.0 - np.asarray(heading_deg)]) / 2.0
    (cr, cp, cy), (sr, sp, sy) = np.cos(half), np.sin(half)
    return np.column_stack(
        [
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
            cr * cp * cy + sr * sp * sy,
        ]
    )


def _stamp(time_s: float) -> tuple[dict[str, int], int]:
    """A time of the flight as Foxglove's {sec, nsec}, and in ns since 1970."""
    now = EPOCH_S * 10**9 + round(time_s * 1e9)
    return {"sec": now // 10**9, "nsec": now % 10**9}, now

"""MCAP with JSON messages and JSON schemas, for Foxglove (https://mcap.dev/spec, https://docs.foxglove.dev/docs/sdk/schemas).

Frame `world` is at the start of the flight: x east, y north, z up. Frame `aircraft`: x forward, y left, z up.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from typing import Any, BinaryIO

import numpy as np

from testbed.flight.flight import Flight
from testbed.inputs.problems import BadInput, Problem
from testbed.reporting.export.place import EPOCH_S, Origin, Poses, poses, thinned, wind
from testbed.reporting.words import describe, units_of

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
_FOXGLOVE = {"/tf": "foxglove.FrameTransform", "/location": "foxglove.LocationFix", "/events": "foxglove.Log"}
"""Topics whose messages have one of Foxglove's schemas; those of the others have the topic's name."""
_TYPES = {bool: "boolean", int: "integer", float: "number", str: "string"}


Message = tuple[float, str, dict[str, Any]]
"""Time of the flight [s], topic, and what is said there then."""


def mcap(flight: Flight, stream: BinaryIO, origin: Origin) -> None:
    """Write frames, location and the log's signals at RATE_HZ, and the events; raises BadInput without the package mcap."""
    try:
        from mcap.writer import Writer
    except ImportError:
        what = "mcap needs the package mcap"
        raise BadInput([Problem(what, "--to mcap", expected="pip install 'testbed[export]'")]) from None
    track, topics = poses(flight, origin, RATE_HZ), _topics(flight)
    said = [*_motion(track), *_signals(flight, topics), *_events(flight)]
    channels: dict[str, int] = {}
    writer = Writer(stream)
    writer.start(profile="", library="testbed")
    for sequence, (time_s, topic, contents) in enumerate(sorted(said, key=lambda message: message[:2])):
        now = EPOCH_S * 10**9 + round(time_s * 1e9)
        stamped = {"timestamp": {"sec": now // 10**9, "nsec": now % 10**9}, **contents}
        if topic not in channels:
            schema = _schema({**stamped, **dict.fromkeys(topics.get(topic, ()), 0.0)})
            channels[topic] = _channel(writer, flight, topic, schema, topics)
        data = json.dumps(stamped, allow_nan=False).encode()
        writer.add_message(channels[topic], now, data, now, sequence)
    writer.add_metadata("flight", {"scenario": flight.scenario.name, "outcome": str(flight.outcome)})
    writer.finish()


def _topics(flight: Flight) -> dict[str, dict[str, str]]:
    """{topic: {name in the message: column}} of the log's signals."""
    topics = {topic: {c: c for c in columns} for topic, columns in _GROUPS.items()}
    topics["/wind"] = {column: column for column in wind(flight)}
    for name in flight.actuators:
        topics[f"/actuators/{name}"] = {of: f"{name}_{of}" for of in _ACTUATOR}
    there = {topic: {n: c for n, c in of.items() if c in flight.columns} for topic, of in topics.items()}
    return {topic: columns for topic, columns in there.items() if columns}


def _schema(example: Any) -> dict[str, Any]:
    """The JSON schema of values like this one."""
    if isinstance(example, Mapping):
        return {"type": "object", "properties": {name: _schema(value) for name, value in example.items()}}
    if isinstance(example, list):
        return {"type": "array", "items": _schema(example[0])}
    return {"type": _TYPES[type(example)]}


def _channel(
    writer: Any, flight: Flight, topic: str, schema: dict[str, Any], topics: Mapping[str, Mapping[str, str]]
) -> int:
    """Register a topic with its schema, in which each signal has its unit; returns its number."""
    units, name = units_of(flight), _FOXGLOVE.get(topic, topic.strip("/").replace("/", "."))
    for signal, column in topics.get(topic, {}).items():
        schema["properties"][signal]["description"] = units[column]
    data = json.dumps({"title": name, **schema}).encode()
    number: int = writer.register_channel(topic, "json", writer.register_schema(name, "jsonschema", data))
    return number


def _motion(track: Poses) -> Iterator[Message]:
    """The aircraft's frame in the world's, and its location."""
    places = np.column_stack([track.east_m, track.north_m, track.altitude_m]).tolist()
    rotations = rotation(track.roll_deg, track.pitch_deg, track.heading_deg).tolist()
    geodetic = np.column_stack([track.latitude_deg, track.longitude_deg, track.altitude_m]).tolist()
    unknown = {"position_covariance": [0.0] * 9, "position_covariance_type": 0}
    frames = {"parent_frame_id": "world", "child_frame_id": "aircraft"}
    for time, place, turn, on_earth in zip(track.time_s.tolist(), places, rotations, geodetic, strict=True):
        pose = {
            "translation": dict(zip("xyz", place, strict=True)),
            "rotation": dict(zip("xyzw", turn, strict=True)),
        }
        yield time, "/tf", {**frames, **pose}
        at = dict(zip(("latitude", "longitude", "altitude"), on_earth, strict=True))
        yield time, "/location", {"frame_id": "aircraft", **at, **unknown}


def _signals(flight: Flight, topics: Mapping[str, Mapping[str, str]]) -> Iterator[Message]:
    rows = thinned(flight, RATE_HZ)
    log = {name: values[rows].tolist() for name, values in flight.signals.items()}
    for k, time in enumerate(log["time_s"]):
        for topic, of in topics.items():
            yield time, topic, {name: v for name, c in of.items() if math.isfinite(v := log[c][k])}


def _events(flight: Flight) -> Iterator[Message]:
    for event in flight.events:
        words = {"message": describe(event, flight), "name": event["kind"], "file": "", "line": 0}
        yield float(event["time_s"]), "/events", {"level": _LEVELS.get(event["kind"], 2), **words}


def rotation(roll_deg: np.ndarray, pitch_deg: np.ndarray, heading_deg: np.ndarray) -> np.ndarray:
    """[rows, 4] quaternions x, y, z, w that turn components in the aircraft's frame into the world's (see the module)."""
    from scipy.spatial.transform import Rotation

    # The same turns about axes that point the other way: pitch about left, yaw from east to the left.
    angles = np.column_stack([90.0 - np.asarray(heading_deg), -np.asarray(pitch_deg), roll_deg])
    return np.asarray(Rotation.from_euler("ZYX", angles, degrees=True).as_quat())

"""ULog, the format of PX4's logs (https://docs.px4.io/main/en/dev_log/ulog_file_format.html), for PlotJuggler and pyulog.

What the sensors read has the topics and fields of PX4; the truth has those of its simulation, with `_groundtruth`. Each actuator
has a topic of its name, in the unit of the aircraft's YAML. Body axes are x forward, y right, z down; places are north, east, down.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from functools import partial
from typing import BinaryIO

import numpy as np

from testbed.flight.columns import reading
from testbed.flight.flight import Flight
from testbed.reporting.export.place import Origin
from testbed.reporting.words import describe

_MAGIC = b"ULog\x01\x12\x35\x01"
_ACTUATOR = ("reference", "command", "position", "effectiveness", "effectiveness_estimate", "failed")
_LEVELS = {"injection": b"4", "lost": b"3", "false_alarm": b"4"}  # of Linux: 3 error, 4 warning, 6 info
_TEXT = 60_000
_Topic = Mapping[str, np.ndarray]


def ulog(flight: Flight, stream: BinaryIO, _: Origin) -> None:
    """Write every row of the log whose time is known; topics are logged at the same times, in microseconds."""
    rows = np.isfinite(flight.column("time_s"))
    time_us = np.round(flight.column("time_s")[rows] * 1e6).astype("<u8")
    topics = {name: {f: v[rows] for f, v in fields.items()} for name, fields in _topics(flight).items()}
    stream.write(_MAGIC + struct.pack("<Q", int(time_us[0]) if len(time_us) else 0))
    stream.write(_message(b"B", bytes(40)))
    for key, value in {"sys_name": "testbed", "ver_hw": flight.scenario.slug}.items():
        declared = f"char[{len(value)}] {key}".encode()
        stream.write(_message(b"I", bytes([len(declared)]) + declared + value.encode()))
    for name, fields in topics.items():
        stream.write(_message(b"F", f"{name}:uint64_t timestamp;{_declared(fields)}".encode()))
    for number, name in enumerate(topics):
        stream.write(_message(b"A", struct.pack("<BH", 0, number) + name.encode()))
    each = [_data(number, time_us, fields) for number, fields in enumerate(topics.values())]
    stream.write(np.concatenate(each, axis=1).tobytes())  # as they would be logged: all topics at each time
    for event in flight.events:
        level, when = _LEVELS.get(str(event["kind"]), b"6"), struct.pack("<Q", round(event["time_s"] * 1e6))
        stream.write(_message(b"L", level + when + describe(event, flight).encode()[:_TEXT]))


def _topics(flight: Flight) -> dict[str, _Topic]:
    """{topic: {field: [rows, m]}}."""
    made = {
        **_motion(flight, measured=True),
        **{f"{n}_groundtruth": t for n, t in _motion(flight, measured=False).items()},
    }
    columns = flight.columns
    place = {"x": "north_m", "y": "east_m"}
    local = {field: flight.column(column)[:, None] for field, column in place.items()}
    local |= {"z": -flight.column("altitude_m")[:, None], "vz": -flight.column("climb_rate_m_s")[:, None]}
    made["vehicle_local_position_groundtruth"] = local
    if "u_dot_m_s2" in columns:
        made["body_acceleration"] = {"u_dot": flight.column("u_dot_m_s2")[:, None]}
    for name in flight.actuators:
        there = [of for of in _ACTUATOR if f"{name}_{of}" in columns]
        made[name] = {of: flight.column(f"{name}_{of}")[:, None] for of in there}
    return made


def _motion(flight: Flight, *, measured: bool) -> dict[str, _Topic]:
    of = partial(reading, flight.signals, measured=measured)
    return {
        "vehicle_attitude": {"q": _quaternion(of("roll"), of("pitch"), of("heading"))},
        "vehicle_angular_velocity": {"xyz": np.stack([of(axis) for axis in "pqr"], axis=1)},
        "airspeed_validated": {"true_airspeed_m_s": of("airspeed")[:, None]},
        "air_flow": {"alpha_rad": of("alpha")[:, None], "beta_rad": of("beta")[:, None]},
    }


def _quaternion(roll: np.ndarray, pitch: np.ndarray, heading: np.ndarray) -> np.ndarray:
    """[rows, 4] w x y z of the rotation from body axes to north, east, down, of yaw, pitch, roll in turn."""
    from scipy.spatial.transform import Rotation

    turned = Rotation.from_euler("ZYX", np.stack([heading, pitch, roll], axis=1)).as_quat()
    return turned[:, [3, 0, 1, 2]]  # scipy's w is the last


def _declared(fields: _Topic) -> str:
    sizes = {name: values.shape[1] for name, values in fields.items()}
    return "".join(f"float{f'[{size}]' if size > 1 else ''} {name};" for name, size in sizes.items())


def _data(number: int, time_us: np.ndarray, fields: _Topic) -> np.ndarray:
    """[rows, bytes] the messages of a topic."""
    values = np.concatenate(list(fields.values()), axis=1)
    made = np.zeros(
        len(time_us),
        [
            ("size", "<u2"),
            ("kind", "S1"),
            ("id", "<u2"),
            ("time", "<u8"),
            ("values", "<f4", values.shape[1:]),
        ],
    )
    made["size"], made["kind"], made["id"] = made.dtype.itemsize - 3, b"D", number
    made["time"], made["values"] = time_us, values
    return made.view(np.uint8).reshape(len(made), made.dtype.itemsize)


def _message(kind: bytes, content: bytes) -> bytes:
    return struct.pack("<H", len(content)) + kind + content

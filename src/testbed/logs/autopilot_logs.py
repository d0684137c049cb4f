"""ArduPilot's DataFlash logs (.BIN): columns by message and field, such as `IMU.GyrX`, or `IMU[1].GyrX` of the second sensor. And
PX4's (.ulg): by topic and field, such as `vehicle_angular_velocity.xyz[0]`, or `sensor_gyro[1].x` of the second.

Each message and topic has its own times. All are brought onto those of one, which the mapping names as `time`.

DataFlash is the format of ArduPilot's `LogStructure.h`: a file is a chain of messages, and those of one kind, FMT, declare the
others. pymavlink reads it too, but stores every message as a dict, writes a line for each byte that it cannot read, and ends with
errors of any kind.

Of a topic of PX4 with an attitude `q` there are also `roll`, `pitch` and `yaw` [rad].
"""

from __future__ import annotations

import io
import math
import re
import struct
from array import array
from collections.abc import Iterable, Mapping
from contextlib import redirect_stdout
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from testbed.inputs.problems import BadInput, Problem, guess
from testbed.logs.flight_log import bad

DATAFLASH = b"\xa3\x95"
"""How every message of ArduPilot begins; a byte with its kind follows."""
TIMES_US = {"TimeUS": 1.0, "TimeMS": 1e3}
"""Names of a message's own time, and microseconds in a unit of it; the second was ArduPilot's until 2015."""
_MESSAGE_NAME = re.compile(r"(\w{1,4})(?:\[(\d{1,3})\])?\.(\w{1,64})")
_GAP_US = 0.5e6
_MOST, _MOST_LOST = 20_000_000, 100_000
"""Messages that are read, and places at which a message is looked for in vain."""
_ARDUPILOT = "a DataFlash log of ArduPilot"
_FMT, _FMT_BYTES = 128, 89
_TYPES = {"b": "i1", "B": "u1", "M": "u1", "h": "<i2", "H": "<u2", "i": "<i4", "I": "<u4", "q": "<i8", "Q": "<u8", "g": "<f2",
          "f": "<f4", "d": "<f8", "c": "<i2", "C": "<u2", "e": "<i4", "E": "<u4", "L": "<i4", "n": "S4", "N": "S16", "Z": "S64",
          "a": "S64"}  # fmt: skip
_SCALES = {"c": 0.01, "C": 0.01, "e": 0.01, "E": 0.01, "L": 1e-7}
_COPTER = b"Copter V"
"""What the messages of a multicopter's program begin with; MOTB is what a mixer of motors writes, QTUN that of a quadplane."""
_INSTANCES = ("I", "Instance", "instance")


@dataclass(frozen=True)
class _Kind:
    """The messages of a kind: fields with their letters, the layout of its bytes, and where in the file each begins."""

    fields: dict[str, str]
    layout: np.dtype
    places: array[int] = field(default_factory=lambda: array("q"))

    @property
    def time(self) -> str | None:
        """The field that is the message's time."""
        return next((name for name in TIMES_US if name in self.fields), None)

    def values(self, content: bytes, name: str) -> np.ndarray:
        """[messages] a field; NaN where it is a text."""
        number = list(self.fields).index(name)
        dtype, start = self.layout[number], 3 + sum(self.layout[i].itemsize for i in range(number))
        if dtype.kind == "S":
            return np.full(len(self.places), np.nan)
        columns = np.arange(start, start + dtype.itemsize)
        found = np.frombuffer(content, np.uint8)[np.asarray(self.places)[:, None] + columns]
        return found.view(dtype)[:, 0].astype(float) * _SCALES.get(self.fields[name], 1.0)

    def instances(self, content: bytes) -> np.ndarray:
        """[messages] the number of the sensor that each is of; 0 where there is one."""
        name = next((each for each in _INSTANCES if each in self.fields), None)
        return np.zeros(len(self.places)) if name is None else self.values(content, name)


def dataflash_columns(file: Path, content: bytes, names: Iterable[str], time: str) -> dict[str, np.ndarray]:
    """The columns of these names on the times of the message of `time`; NaN where nothing was written for 0.5 s.

    Raises BadInput for what is no such log, a name that is none, and a message or field that the log has not.
    """
    asked = {name: parts(_MESSAGE_NAME, file, name, "MESSAGE.Field, such as IMU.GyrX") for name in names}
    kinds = {name: kind for name, kind in _kinds(file, content).items() if kind.places}
    said = kinds.get("MSG")
    texts = [content[at : at + said.layout.itemsize + 3] for at in said.places] if said else []
    if any(_COPTER in text for text in texts) or ("MOTB" in kinds and "QTUN" not in kinds):
        raise bad("is the log of a multicopter", file, expected="an aircraft with a wing")
    problems = []
    for name, (kind, _, wanted) in asked.items():
        if kind not in kinds or wanted not in kinds[kind].fields:
            what = f"has no field {wanted} of {kind}" if kind in kinds else f"has no message {kind}"
            known = kinds[kind].fields if kind in kinds else kinds
            word = wanted if kind in kinds else kind
            problems.append(Problem(f"{what}, for {name}", str(file), None, "", *guess(word, known)))
        elif kinds[kind].time is None:
            what = f"has no {next(iter(TIMES_US))} of {kind}, for {name}"
            problems.append(Problem(what, str(file), expected=_ARDUPILOT))
    if problems:
        raise BadInput(problems)
    found = {name: _of_message(file, content, name, kinds[kind], (number, wanted))
             for name, (kind, number, wanted) in asked.items()}  # fmt: skip
    return {name: onto(found[time][0], *each) for name, each in found.items()}


def _of_message(
    file: Path, content: bytes, name: str, kind: _Kind, which: tuple[int, str]
) -> tuple[np.ndarray, np.ndarray]:
    """(times [us], values) of a field of one sensor."""
    rows = kind.instances(content) == which[0]
    if not np.any(rows):
        raise bad("has no message of this sensor", file, name)
    assert kind.time is not None
    time_us = kind.values(content, kind.time) * TIMES_US[kind.time]
    values = kind.values(content, which[1])[rows]
    if which[1] == "Yaw" and np.all(np.isfinite(values)):
        values = np.unwrap(values, period=360.0)
    return time_us[rows], values


def parts(pattern: re.Pattern[str], file: Path, name: str, expected: str) -> tuple[str, int, str]:
    """(message or topic, number of the sensor, field) of a column's name; raises BadInput for one that is none."""
    found = pattern.fullmatch(name)
    if not found:
        raise bad(f"has no column {name[:80]!r}", file, expected=expected)
    return found[1], int(found[2] or 0), found[3]


def _kinds(file: Path, content: bytes) -> dict[str, _Kind]:
    """The kinds of messages by name, of a file that may be torn; raises BadInput for one that is no log, or has too many."""
    kinds, sizes = dict[int, tuple[str, _Kind]](), [0] * 256
    sizes[_FMT] = _FMT_BYTES
    at = lost = 0
    for _ in range(_MOST):
        size = sizes[content[at + 2]] if content[at : at + 2] == DATAFLASH and at + 2 < len(content) else 0
        if not size:
            lost, at = lost + 1, content.find(DATAFLASH, at + 1)
            if at < 0 or lost > _MOST_LOST:
                break
        elif at + size > len(content):
            break
        elif content[at + 2] == _FMT:
            _declare(content[at + 3 : at + size], kinds, sizes)
            at += size
        else:
            kinds[content[at + 2]][1].places.append(at)
            at += size
    else:
        raise bad(f"has more than {_MOST} messages", file, expected=_ARDUPILOT)
    if lost > _MOST_LOST or not any(kind.places for _, kind in kinds.values()):
        raise bad("cannot be read: is no chain of messages", file, expected=_ARDUPILOT)
    return dict(kinds.values())


def _declare(said: bytes, kinds: dict[int, tuple[str, _Kind]], sizes: list[int]) -> None:
    """Take in a kind that is declared for the first time, if what is said of it fits together."""
    number, size, *texts = struct.unpack("<BB4s16s64s", said)
    name, letters, fields = (each.split(b"\0")[0].decode("ascii", "replace") for each in texts)
    names = fields.split(",")
    if sizes[number] or len(names) != len(letters) or not set(letters) <= set(_TYPES):
        return
    layout = np.dtype([(f"f{i}", _TYPES[letter]) for i, letter in enumerate(letters)])
    if layout.itemsize + 3 == size and len(set(names)) == len(names):
        sizes[number] = size
        kinds[number] = name, _Kind(dict(zip(names, letters, strict=True)), layout)


def onto(base: np.ndarray, time_us: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Values at other times [us], by straight lines; NaN where none is near."""
    order = np.argsort(time_us, kind="stable")
    time_us, values = time_us[order], values[order]
    following = np.searchsorted(time_us, base)
    around = np.concatenate(
        [[-np.inf], time_us, [np.inf]]
    )  # nothing is near before the first and after the last
    near = np.minimum(base - around[following], around[following + 1] - base)
    return np.where(near < _GAP_US, np.interp(base, time_us, values), np.nan)


ULOG = b"ULog\x01\x12\x35"
"""How a file of PX4 begins."""
TIME = "timestamp"
_TOPIC_NAME = re.compile(r"([\w/-]{1,200}?)(?:\[(\d{1,3})\])?\.([\w.\[\]]{1,200})")
_PX4 = "a log of PX4"
_HEADER, _ULOG_KINDS, _FORMAT, _ADDED = 16, frozenset(b"ABCDFILMOPQRS"), ord("F"), ord("A")
_WINGLESS = {2: "quadcopter", 3: "coaxial helicopter", 4: "helicopter", 10: "rover", 11: "boat", 12: "submarine",
             13: "hexacopter", 14: "octocopter", 15: "tricopter"}  # fmt: skip
"""What PX4's parameter MAV_TYPE says, of what flies without a wing."""
_MOST_FIELDS = 10_000
_MOST_TOPICS, _LONGEST = 1000, 200  # whose names are suggested, and the longest of their messages [bytes]
_FIELD = re.compile(r"([\w/-]+)(?:\[(\d{1,18})\d*\])? [^;]*")


def ulog_columns(file: Path, content: bytes, names: Iterable[str], time: str) -> dict[str, np.ndarray]:
    """The columns of these names on the times of the topic of `time`; NaN where nothing was written for 0.5 s.

    Raises BadInput for what is no such log, a name that is none, and a topic or field that the log has not.
    """
    expected = "TOPIC.field, such as vehicle_angular_velocity.xyz[0]"
    asked = {name: parts(_TOPIC_NAME, file, name, expected) for name in names}
    series, known = _of_topics(file, content, {topic for topic, _, _ in asked.values()})
    problems = []
    for name, (topic, instance, wanted) in asked.items():
        fields = series.get((topic, instance))
        if fields is None:
            what = f"has no topic {topic}{' that can be read' if topic in known else ''}"
            near = ("", "") if topic in known else guess(topic, known)
            problems.append(Problem(f"{what}, for {name}", str(file), None, "", *near))
        elif TIME not in fields:
            problems.append(Problem(f"{topic} has no {TIME}, for {name}", str(file)))
        elif wanted not in fields:
            what = f"has no field {wanted} of {topic}, for {name}"
            problems.append(Problem(what, str(file), None, "", *guess(wanted, fields)))
    if problems:
        raise BadInput(problems)
    topic, instance, _ = asked[time]
    base = series[topic, instance][TIME]
    return {
        name: onto(base, series[t, i][TIME], series[t, i][wanted]) for name, (t, i, wanted) in asked.items()
    }


def _of_topics(
    file: Path, content: bytes, topics: set[str]
) -> tuple[dict[tuple[str, int], dict[str, np.ndarray]], list[str]]:
    """{(topic, instance): {field: [rows]}} of these topics, and the names of all that the log has."""
    try:
        from pyulog import ULog
    except ImportError:
        raise bad("needs pyulog: pip install 'testbed[logs]'", file) from None
    end, formats, known = _ulog_whole(content)
    if any(_ulog_size(name, formats) > _MOST_FIELDS for name in formats):
        what = f"has a format of more than {_MOST_FIELDS} fields, or of itself"
        raise bad(what, file, expected=_PX4)
    try:
        with redirect_stdout(io.StringIO()):  # it prints what it thinks of the file
            read = ULog(io.BytesIO(content[:end]), sorted(topics))
        found = {(each.name, int(each.multi_id)): _fields(each.data) for each in read.data_list}
        kind = _WINGLESS.get(int(read.initial_parameters.get("MAV_TYPE", 1)))
    except Exception as error:  # pyulog's own and Python's, of bytes that are no log
        words = f"cannot be read: {type(error).__name__}: {str(error)[:100]}"
        raise bad(words, file, expected=_PX4) from None
    if kind is not None:
        raise bad(f"is the log of a {kind}, by its MAV_TYPE", file, expected="an aircraft with a wing")
    return found, known


def _ulog_whole(content: bytes) -> tuple[int, dict[str, str], list[str]]:
    """Up to where the file is a chain of whole messages of known kinds, {format: its fields}, and the topics that it has.

    In what is no such chain pyulog may search for ever.
    """
    at, end, formats, topics = _HEADER, len(content), dict[str, str](), set[str]()
    while at + 3 <= end:
        following = at + 3 + content[at] + 256 * content[at + 1]
        if content[at + 2] not in _ULOG_KINDS or following > end:
            break
        if content[at + 2] == _FORMAT:
            name, _, fields = content[at + 3 : following].decode("utf-8", "replace").partition(":")
            formats[name] = f"{formats.get(name, '')};{fields}"
        if content[at + 2] == _ADDED and following - at < _LONGEST and len(topics) < _MOST_TOPICS:
            topics.add(content[at + 6 : following].decode("utf-8", "replace"))
        at = following
    return at, formats, sorted(topics)


def _ulog_size(name: str, formats: Mapping[str, str], sizes: dict[str, float] | None = None) -> float:
    """Number of fields of a format with those of the formats in it: pyulog makes a list of them all."""
    sizes = {} if sizes is None else sizes
    if name not in sizes:
        sizes[name] = math.inf  # until it is known: so of a format that has itself
        sizes[name] = sum(float(count or 1) * (_ulog_size(kind, formats, sizes) if kind in formats else 1.0)
                          for kind, count in _FIELD.findall(formats[name]))  # fmt: skip
    return sizes[name]


def _fields(data: Mapping[str, Any]) -> dict[str, np.ndarray]:
    made = {name: np.asarray(values, dtype=float) for name, values in data.items()}
    if all(f"q[{i}]" in made for i in range(4)):
        w, x, y, z = (made[f"q[{i}]"] for i in range(4))
        made["roll"] = np.arctan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y))
        made["pitch"] = np.arcsin(np.clip(2.0 * (w * y - z * x), -1.0, 1.0))
        made["yaw"] = np.unwrap(np.arctan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z)))
    return made

"""PX4's logs (.ulg): columns by topic and field, such as `vehicle_angular_velocity.xyz[0]`, or `sensor_gyro[1].x` of the second.

Of a topic with an attitude `q` there are also `roll`, `pitch` and `yaw` [rad]. All are brought onto the times of one topic, which
the mapping names as `time`.
"""

from __future__ import annotations

import io
import math
import re
from collections.abc import Iterable, Mapping
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

import numpy as np

from testbed.inputs.problems import BadInput, Problem, guess
from testbed.logs.dataflash import onto, parts
from testbed.logs.flight_log import bad

MAGIC = b"ULog\x01\x12\x35"
"""How a file begins."""
TIME = "timestamp"
_NAME = re.compile(r"([\w/-]{1,200}?)(?:\[(\d{1,3})\])?\.([\w.\[\]]{1,200})")
_EXPECTED = "a log of PX4"
_HEADER, _KINDS, _FORMAT, _ADDED = 16, frozenset(b"ABCDFILMOPQRS"), ord("F"), ord("A")
_WINGLESS = {2: "quadcopter", 3: "coaxial helicopter", 4: "helicopter", 10: "rover", 11: "boat", 12: "submarine",
             13: "hexacopter", 14: "octocopter", 15: "tricopter"}  # fmt: skip
"""What PX4's parameter MAV_TYPE says, of what flies without a wing."""
_MOST_FIELDS = 10_000
_MOST_TOPICS, _LONGEST = 1000, 200  # whose names are suggested, and the longest of their messages [bytes]
_FIELD = re.compile(r"([\w/-]+)(?:\[(\d{1,18})\d*\])? [^;]*")


def columns(file: Path, content: bytes, names: Iterable[str], time: str) -> dict[str, np.ndarray]:
    """The columns of these names on the times of the topic of `time`; NaN where nothing was written for 0.5 s.

    Raises BadInput for what is no such log, a name that is none, and a topic or field that the log has not.
    """
    expected = "TOPIC.field, such as vehicle_angular_velocity.xyz[0]"
    asked = {name: parts(_NAME, file, name, expected) for name in names}
    series, known = _series(file, content, {topic for topic, _, _ in asked.values()})
    problems = []
    for name, (topic, instance, field) in asked.items():
        fields = series.get((topic, instance))
        if fields is None:
            what = f"has no topic {topic}{' that can be read' if topic in known else ''}"
            near = ("", "") if topic in known else guess(topic, known)
            problems.append(Problem(f"{what}, for {name}", str(file), None, "", *near))
        elif TIME not in fields:
            problems.append(Problem(f"{topic} has no {TIME}, for {name}", str(file)))
        elif field not in fields:
            what = f"has no field {field} of {topic}, for {name}"
            problems.append(Problem(what, str(file), None, "", *guess(field, fields)))
    if problems:
        raise BadInput(problems)
    topic, instance, _ = asked[time]
    base = series[topic, instance][TIME]
    return {
        name: onto(base, series[t, i][TIME], series[t, i][field]) for name, (t, i, field) in asked.items()
    }


def _series(
    file: Path, content: bytes, topics: set[str]
) -> tuple[dict[tuple[str, int], dict[str, np.ndarray]], list[str]]:
    """{(topic, instance): {field: [rows]}} of these topics, and the names of all that the log has."""
    try:
        from pyulog import ULog
    except ImportError:
        raise bad("needs pyulog: pip install 'testbed[logs]'", file) from None
    end, formats, known = _whole(content)
    if any(_size(name, formats) > _MOST_FIELDS for name in formats):
        what = f"has a format of more than {_MOST_FIELDS} fields, or of itself"
        raise bad(what, file, expected=_EXPECTED)
    try:
        with redirect_stdout(io.StringIO()):  # it prints what it thinks of the file
            read = ULog(io.BytesIO(content[:end]), sorted(topics))
        found = {(each.name, int(each.multi_id)): _fields(each.data) for each in read.data_list}
        kind = _WINGLESS.get(int(read.initial_parameters.get("MAV_TYPE", 1)))
    except Exception as error:  # pyulog's own and Python's, of bytes that are no log
        words = f"cannot be read: {type(error).__name__}: {str(error)[:100]}"
        raise bad(words, file, expected=_EXPECTED) from None
    if kind is not None:
        raise bad(f"is the log of a {kind}, by its MAV_TYPE", file, expected="an aircraft with a wing")
    return found, known


def _whole(content: bytes) -> tuple[int, dict[str, str], list[str]]:
    """Up to where the file is a chain of whole messages of known kinds, {format: its fields}, and the topics that it has.

    In what is no such chain pyulog may search for ever.
    """
    at, end, formats, topics = _HEADER, len(content), dict[str, str](), set[str]()
    while at + 3 <= end:
        following = at + 3 + content[at] + 256 * content[at + 1]
        if content[at + 2] not in _KINDS or following > end:
            break
        if content[at + 2] == _FORMAT:
            name, _, fields = content[at + 3 : following].decode("utf-8", "replace").partition(":")
            formats[name] = f"{formats.get(name, '')};{fields}"
        if content[at + 2] == _ADDED and following - at < _LONGEST and len(topics) < _MOST_TOPICS:
            topics.add(content[at + 6 : following].decode("utf-8", "replace"))
        at = following
    return at, formats, sorted(topics)


def _size(name: str, formats: Mapping[str, str], sizes: dict[str, float] | None = None) -> float:
    """Number of fields of a format with those of the formats in it: pyulog makes a list of them all."""
    sizes = {} if sizes is None else sizes
    if name not in sizes:
        sizes[name] = math.inf  # until it is known: so of a format that has itself
        sizes[name] = sum(float(count or 1) * (_size(kind, formats, sizes) if kind in formats else 1.0)
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

"""PX4's logs (.ulg): columns by topic and field, such as `vehicle_angular_velocity.xyz[0]`, or `sensor_gyro[1].x` of the second.

Of a topic with an attitude `q` there are also `roll`, `pitch` and `yaw` [rad]. All are brought onto the times of one topic, which
the mapping names as `time`.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from testbed.inputs.problems import BadInput, Problem, guess
from testbed.logs.dataflash import onto

MAGIC = b"ULog\x01\x12\x35"
"""How a file begins."""
TIME = "timestamp"
_NAME = re.compile(r"([\w/-]{1,200}?)(?:\[(\d{1,3})\])?\.([\w.\[\]]{1,200})")
_EXPECTED = "a log of PX4"
_HEADER, _KINDS = 16, frozenset(b"ABCDFILMOPQRS")


def columns(file: Path, content: bytes, names: Iterable[str], time: str) -> dict[str, np.ndarray]:
    """The columns of these names on the times of the topic of `time`; NaN where nothing was written for 0.5 s.

    Raises BadInput for what is no such log, a name that is none, and a topic or field that the log has not.
    """
    asked = {name: _parts(file, name) for name in names}
    series = _series(file, content, {topic for topic, _, _ in asked.values()})
    for name, (topic, instance, field) in asked.items():
        if (topic, instance) not in series:
            known = sorted({each for each, _ in series})
            raise BadInput(
                [Problem(f"has no topic {topic}, for {name}", str(file), None, "", *guess(topic, known))]
            )
        if field not in (fields := series[topic, instance]):
            what = f"has no field {field} of {topic}, for {name}"
            raise BadInput([Problem(what, str(file), None, "", *guess(field, fields))])
    topic, instance, _ = asked[time]
    base = series[topic, instance][TIME]
    return {
        name: onto(base, series[t, i][TIME], series[t, i][field]) for name, (t, i, field) in asked.items()
    }


def _parts(file: Path, name: str) -> tuple[str, int, str]:
    found = _NAME.fullmatch(name)
    if not found:
        expected = "TOPIC.field, such as vehicle_angular_velocity.xyz[0]"
        raise BadInput([Problem(f"has no column {name[:80]!r}", str(file), expected=expected)])
    return found[1], int(found[2] or 0), found[3]


def _series(file: Path, content: bytes, topics: set[str]) -> dict[tuple[str, int], dict[str, np.ndarray]]:
    """{(topic, instance): {field: [rows]}} of these topics."""
    try:
        from pyulog import ULog
    except ImportError:
        raise BadInput([Problem("needs pyulog: pip install 'testbed[logs]'", str(file))]) from None
    try:
        read = ULog(io.BytesIO(content[: _whole(content)]), sorted(topics))
        found = {(each.name, int(each.multi_id)): _fields(each.data) for each in read.data_list}
    except (
        Exception
    ) as error:  # whatever pyulog says of bytes that are no log: it has errors of its own and Python's
        words = f"cannot be read: {type(error).__name__}: {str(error)[:100]}"
        raise BadInput([Problem(words, str(file), expected=_EXPECTED)]) from None
    if not found:
        declared = f"none of the topics {', '.join(sorted(topics))}"
        raise BadInput([Problem(f"has {declared}", str(file), expected=_EXPECTED)])
    return found


def _whole(content: bytes) -> int:
    """Up to where the file is a chain of whole messages of known kinds: pyulog may search for ever in what is none."""
    at, end = _HEADER, len(content)
    while at + 3 <= end:
        following = at + 3 + content[at] + 256 * content[at + 1]
        if content[at + 2] not in _KINDS or following > end:
            break
        at = following
    return at


def _fields(data: Mapping[str, Any]) -> dict[str, np.ndarray]:
    made = {name: np.asarray(values, dtype=float) for name, values in data.items()}
    if all(f"q[{i}]" in made for i in range(4)):
        w, x, y, z = (made[f"q[{i}]"] for i in range(4))
        made["roll"] = np.arctan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y))
        made["pitch"] = np.arcsin(np.clip(2.0 * (w * y - z * x), -1.0, 1.0))
        made["yaw"] = np.arctan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
    return made

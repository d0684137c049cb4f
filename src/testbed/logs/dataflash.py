"""ArduPilot's DataFlash logs (.BIN): columns by message and field, such as `IMU.GyrX`, or `IMU[1].GyrX` of the second sensor.

Each message has its own times. All are brought onto those of one message, which the mapping names as `time`.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from testbed.inputs.problems import BadInput, Problem, guess

MAGIC = b"\xa3\x95"
"""How every message begins."""
TIME = "TimeUS"
_NAME = re.compile(r"(\w{1,4})(?:\[(\d{1,3})\])?\.(\w{1,64})")
_GAP_US = 0.5e6
_MOST = 20_000_000  # messages


def columns(file: Path, names: Iterable[str], time: str) -> dict[str, np.ndarray]:
    """The columns of these names on the times of the message of `time`; NaN where nothing was written for 0.5 s.

    Raises BadInput for what is no such log, a name that is none, and a message or field that the log has not.
    """
    asked = {name: _parts(file, name) for name in names}
    series, fields = _series(file, {kind for kind, _, _ in asked.values()})
    for name, (kind, instance, field) in asked.items():
        if field not in fields.get(kind, ()):
            what = f"has no field {field} of {kind}" if kind in fields else f"has no message {kind}"
            known = fields.get(kind, fields)
            raise BadInput([Problem(f"{what}, for {name}", str(file), None, "", *guess(field, known))])
        if (kind, instance) not in series:
            raise BadInput([Problem(f"has no message {kind} of this sensor", str(file), path=name)])
    base = _values(series, asked[time], TIME)
    found = {}
    for name, parts in asked.items():
        found[name] = onto(base, _values(series, parts, TIME), _values(series, parts, parts[2]))
    return found


def _parts(file: Path, name: str) -> tuple[str, int, str]:
    found = _NAME.fullmatch(name)
    if not found:
        raise BadInput(
            [Problem(f"has no column {name[:80]!r}", str(file), expected="MESSAGE.Field, such as IMU.GyrX")]
        )
    return found[1], int(found[2] or 0), found[3]


def _series(
    file: Path, kinds: set[str]
) -> tuple[dict[tuple[str, int], list[dict[str, Any]]], dict[str, list[str]]]:
    """The messages of these kinds by kind and sensor, and the fields of every kind that the log declares."""
    try:
        from pymavlink.DFReader import DFReader_binary
    except ImportError:
        what = "needs pymavlink: pip install 'testbed[logs]'"
        raise BadInput([Problem(what, str(file))]) from None
    found: dict[tuple[str, int], list[dict[str, Any]]] = {}
    try:
        log = DFReader_binary(str(file))
        fields = {each.name: list(each.columns) for each in log.formats.values()}
        for _ in range(_MOST):
            message = log.recv_match(type=list(kinds))
            if message is None:
                break
            values = message.to_dict()
            number = next((values[key] for key in ("I", "Instance", "instance") if key in values), 0)
            found.setdefault((message.get_type(), int(number)), []).append(values)
    except (
        ValueError,
        KeyError,
        TypeError,
        AttributeError,
        IndexError,
        OSError,
        struct.error,
        UnicodeError,
    ) as error:
        words = f"cannot be read: {type(error).__name__}: {str(error)[:100]}"
        raise BadInput([Problem(words, str(file), expected="a DataFlash log of ArduPilot")]) from None
    if TIME not in fields.get("IMU", [TIME]) or not found:
        raise BadInput(
            [
                Problem(
                    f"has no message {', '.join(sorted(kinds))}",
                    str(file),
                    expected="a DataFlash log of ArduPilot",
                )
            ]
        )
    return found, fields


def _values(
    series: dict[tuple[str, int], list[dict[str, Any]]], parts: tuple[str, int, str], field: str
) -> np.ndarray:
    kind, instance, _ = parts
    return np.array([float(each.get(field, np.nan)) for each in series[kind, instance]])


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

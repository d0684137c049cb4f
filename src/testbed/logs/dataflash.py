"""ArduPilot's DataFlash logs (.BIN): columns by message and field, such as `IMU.GyrX`, or `IMU[1].GyrX` of the second sensor.

Each message has its own times. All are brought onto those of one message, which the mapping names as `time`. The format is that of
ArduPilot's `LogStructure.h`: a file is a chain of messages, and those of one kind, FMT, declare the others. pymavlink reads it too,
but stores every message as a dict, writes a line for each byte that it cannot read, and ends with errors of any kind.
"""

from __future__ import annotations

import re
import struct
from array import array
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from testbed.inputs.problems import BadInput, Problem, guess
from testbed.logs.flight_log import bad

MAGIC = b"\xa3\x95"
"""How every message begins; a byte with its kind follows."""
TIMES_US = {"TimeUS": 1.0, "TimeMS": 1e3}
"""Names of a message's own time, and microseconds in a unit of it; the second was ArduPilot's until 2015."""
_NAME = re.compile(r"(\w{1,4})(?:\[(\d{1,3})\])?\.(\w{1,64})")
_GAP_US = 0.5e6
_MOST, _MOST_LOST = 20_000_000, 100_000
"""Messages that are read, and places at which a message is looked for in vain."""
_EXPECTED = "a DataFlash log of ArduPilot"
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


def columns(file: Path, content: bytes, names: Iterable[str], time: str) -> dict[str, np.ndarray]:
    """The columns of these names on the times of the message of `time`; NaN where nothing was written for 0.5 s.

    Raises BadInput for what is no such log, a name that is none, and a message or field that the log has not.
    """
    asked = {name: parts(_NAME, file, name, "MESSAGE.Field, such as IMU.GyrX") for name in names}
    kinds = {name: kind for name, kind in _kinds(file, content).items() if kind.places}
    if _is_copter(content, kinds):
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
            problems.append(Problem(what, str(file), expected=_EXPECTED))
    if problems:
        raise BadInput(problems)
    found = {name: _series(file, content, name, kinds[kind], (number, wanted))
             for name, (kind, number, wanted) in asked.items()}  # fmt: skip
    return {name: onto(found[time][0], *each) for name, each in found.items()}


def _is_copter(content: bytes, kinds: Mapping[str, _Kind]) -> bool:
    said = kinds.get("MSG")
    texts = [content[at : at + said.layout.itemsize + 3] for at in said.places] if said else []
    return any(_COPTER in text for text in texts) or ("MOTB" in kinds and "QTUN" not in kinds)


def _series(
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
        size = sizes[content[at + 2]] if content[at : at + 2] == MAGIC and at + 2 < len(content) else 0
        if not size:
            lost, at = lost + 1, content.find(MAGIC, at + 1)
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
        raise bad(f"has more than {_MOST} messages", file, expected=_EXPECTED)
    if lost > _MOST_LOST or not any(kind.places for _, kind in kinds.values()):
        raise bad("cannot be read: is no chain of messages", file, expected=_EXPECTED)
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

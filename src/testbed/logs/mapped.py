"""CSV, Parquet, DataFlash and ULog logs, by a mapping file: which column is what, in which unit, and with which sign."""

from __future__ import annotations

import io
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import Field, field_validator

from testbed.aircraft.description import Aircraft
from testbed.common.units import GRAVITY_M_S2, METRES_PER_SECOND_PER_KNOT
from testbed.inputs.base import Number, Settings, Text, refuse
from testbed.inputs.input_file import MEGABYTE, read_bytes
from testbed.inputs.problems import BadInput, Issue, Problem, guess, unknown
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import Source, read
from testbed.logs import autopilot_logs
from testbed.logs.flight_log import (
    GLOBE,
    MOST_ROWS,
    NEEDED,
    OPTIONAL,
    PLACE,
    FlightLog,
    bad,
    even,
    flown,
    shown,
)

LARGEST = 2000 * MEGABYTE
"""Largest log that is read [bytes]."""
_MOST_COLUMNS = 5000
_NO_LOG = {
    b"\x1f\x8b": "is packed by gzip",
    b"PK\x03\x04": "is a zip archive or a spreadsheet",
    b"\xff\xfe": "is text in UTF-16",
    b"\xfe\xff": "is text in UTF-16",
}
"""What a file begins with that often holds a log, and is none itself."""
_EXPECTED = "a CSV, Parquet, DataFlash (.BIN) or ULog (.ulg) log"
_DEG = np.pi / 180.0
_UNITS: dict[str, float] = {
    "s": 1.0, "ms": 1e-3, "us": 1e-6, "rad": 1.0, "deg": _DEG, "rad_s": 1.0, "deg_s": _DEG, "m_s": 1.0,
    "kt": METRES_PER_SECOND_PER_KNOT, "m": 1.0, "m_s2": 1.0, "g": GRAVITY_M_S2, "throttle": 1.0, "percent": 0.01, "N": 1.0,
}  # fmt: skip
"""Factor to SI of each unit."""
_KINDS = {"time": ("s", "ms", "us"), "p": ("rad_s", "deg_s"), "q": ("rad_s", "deg_s"), "r": ("rad_s", "deg_s"),
          "airspeed": ("m_s", "kt"), "north": ("m",), "east": ("m",), "altitude": ("m",),
          "u_dot": ("m_s2", "g"), "force_x": ("m_s2", "g")}  # fmt: skip
_BEYOND = 3.0
"""Times a surface's limits: angles that are beyond for most of the time are no commands of it."""
_ANGLES, _ENGINE = ("rad", "deg"), ("throttle", "percent", "N")


class Column(Settings):
    """A column of the log: its value is `(number - zero) * scale`, in `unit`."""

    column: Text
    """Name in the log."""
    unit: str
    """Unit of the value."""
    zero: Number = 0.0
    """Number that stands for a value of 0, such as 1500 of a servo's pulses."""
    scale: Number = 1.0
    """Value for each number beyond that; negative where the log's sign is the other one."""

    @field_validator("scale")
    @classmethod
    def _says_something(cls, scale: float) -> float:
        if scale == 0.0:
            raise refuse("is 0, so that every value would be 0", "another number")
        return scale


class ColumnMap(Settings):
    """The keys of a mapping file."""

    time: Column
    """The time base, one for all columns."""
    signals: dict[Text, Column]
    """What sensors read, in the frames of `testbed.common.signals`: body axes x forward, y right, z down."""
    actuators: dict[Text, Column] = Field(min_length=1)
    """What each actuator of the aircraft was commanded."""

    @property
    def columns(self) -> dict[tuple[str, ...], Column]:
        """Each column by its keys."""
        found: dict[tuple[str, ...], Column] = {("time",): self.time}
        found |= {("signals", name): column for name, column in self.signals.items()}
        return found | {("actuators", name): column for name, column in self.actuators.items()}


def _wrong(mapping: ColumnMap, aircraft: Aircraft) -> Iterator[Issue]:
    for name in sorted(set(aircraft.actuators) - set(mapping.actuators)):
        yield Issue(("actuators",), f"has no {name}, an actuator of {aircraft.name}")
    for name in mapping.actuators:
        if name not in (own := aircraft.actuators):
            yield unknown(("actuators", name), f"is no actuator of {aircraft.name}", name, own)
    for name in mapping.signals:
        if name not in (known := (*NEEDED, *OPTIONAL, *PLACE, *GLOBE)):
            yield unknown(("signals", name), f"is no signal that is used: {shown(name)}", name, known)
    needed = (*PLACE[2:], *GLOBE) if set(GLOBE) & set(mapping.signals) else PLACE
    lacks = sorted(set(needed) - set(mapping.signals))
    if lacks and {*PLACE, *GLOBE} & set(mapping.signals):
        what = f"has no {' and no '.join(lacks)}, without which there is no replay"
        yield Issue(("signals",), what, f"none of {', '.join((*PLACE, *GLOBE))}, or all that are needed")
    taken: dict[str, tuple[str, ...]] = {}
    for path, column in mapping.columns.items():
        if column.unit not in (units := _units(path, aircraft)):
            yield Issue((*path, "unit"), f"is {column.unit}", f"one of {', '.join(units)}")
        first = taken.setdefault(column.column, path)
        if first != path and "actuators" not in (first[0], path[0]):  # one output may move two surfaces
            what = f"is {shown(column.column)}, as {'.'.join(first)} is"
            yield Issue((*path, "column"), what, "a column of its own")


def _units(path: tuple[str, ...], aircraft: Aircraft) -> tuple[str, ...]:
    """Those that fit the column at these keys."""
    if path[0] != "actuators":
        return _KINDS.get(path[-1], _ANGLES)
    if path[1] not in aircraft.actuators:
        return tuple(_UNITS)
    return _ANGLES if aircraft.actuators[path[1]].kind == "servo" else _ENGINE


def read_table(file: Path, mapping_file: Path, aircraft: Aircraft) -> FlightLog:
    """The log of a file. Raises BadInput for every problem in the mapping file, and for what is no log, lacks a column, or cannot
    be a flight."""
    source = read(mapping_file)
    mapping = validated(ColumnMap, source)
    if wrong := [source.problem(*issue) for issue in _wrong(mapping, aircraft)]:
        raise BadInput(wrong)
    wanted = sorted({column.column for column in mapping.columns.values()})
    columns = _columns(file, wanted, source, mapping.time.column)
    signals = {name: _value(columns, column) for name, column in mapping.signals.items()}
    commands = {}
    for name, actuator in aircraft.actuators.items():
        commands[name] = _command(file, mapping.actuators[name], columns, actuator.limits)
    positions = np.array([mapping.actuators[name].unit == "N" for name in commands])
    time_s = _value(columns, mapping.time)
    log = even(str(file), time_s, signals, commands, positions, lambda s: shown(mapping.signals[s].column))
    return flown(log, aircraft.envelope.airspeed_min_m_s or 0.0, aircraft.name)


def _command(
    file: Path, column: Column, columns: Mapping[str, np.ndarray], limits: tuple[float, float]
) -> np.ndarray:
    """A command of an actuator with these limits [deg or throttle]; as a throttle from 0 to 1, where what is below is an output
    that is switched off, as before arming. Raises BadInput for what is none, such as a servo's pulses in degrees."""
    values = _value(columns, column)
    if not np.any(np.isfinite(values)):
        raise bad("has no numbers: no actuator's output", file, column.column)
    if column.unit == "N":
        return values
    low, high = np.nanmin(values), np.nanmax(values)
    if column.unit in _ANGLES:
        most = max(map(abs, limits))
        if np.nanmedian(np.abs(values)) <= _BEYOND * most * _DEG:
            return values
        what = f"goes from {low / _DEG:.4g} to {high / _DEG:.4g} deg"
        expected = f"about -{most:g} to {most:g}"
    else:
        if high <= 1.05 and not (low < -0.05 and high < 0.05):
            return np.maximum(values, 0.0)
        what, expected = f"goes from {low:.3g} to {high:.3g} as a throttle", "0 to 1"
    raise bad(what, file, shown(column.column), f"{expected}; see zero and scale")


def _value(columns: Mapping[str, np.ndarray], column: Column) -> np.ndarray:
    with np.errstate(over="ignore", invalid="ignore"):  # what is too large is refused later
        return np.asarray((columns[column.column] - column.zero) * column.scale * _UNITS[column.unit])


def _columns(file: Path, names: list[str], source: Source, time: str) -> dict[str, np.ndarray]:
    """The columns of these names, as numbers; what is no number is NaN."""
    import pyarrow as pa
    import pyarrow.csv
    import pyarrow.parquet as pq

    content = read_bytes(file, LARGEST, _EXPECTED)
    if not content.strip():
        raise bad("is empty", file, expected=_EXPECTED)
    if what := next((words for start, words in _NO_LOG.items() if content.startswith(start)), ""):
        raise bad(what, file, expected=_EXPECTED)
    if content.startswith(autopilot_logs.DATAFLASH):
        return autopilot_logs.dataflash_columns(file, content, names, time)
    if content.startswith(autopilot_logs.ULOG):
        return autopilot_logs.ulog_columns(file, content, names, time)
    try:
        if content[:4] == b"PAR1":
            parquet = pq.ParquetFile(io.BytesIO(content))
            _refuse_large(file, parquet.metadata.num_rows, parquet.metadata.num_columns)
            _refuse_missing(file, names, parquet.schema_arrow.names, source)
            for name in names:
                _refuse_words(file, name, parquet.schema_arrow.field(name).type)
            table = parquet.read(columns=names)
        else:
            head = content[:100_000].partition(b"\n")[0].decode("utf-8")
            there = pa.csv.read_csv(io.BytesIO(head.encode() + b"\n")).column_names
            _refuse_large(file, content.count(b"\n"), len(there))
            if len(there) < 2:
                raise bad("is no table: its first line has one column", file, expected=_EXPECTED)
            _refuse_missing(file, names, there, source)
            options = pa.csv.ConvertOptions(include_columns=names, strings_can_be_null=True)
            table = pa.csv.read_csv(io.BytesIO(content), convert_options=options)
        return {name: _numbers(file, name, table[name]) for name in names}
    except (pa.ArrowException, ValueError, KeyError, OSError) as error:
        words = str(error).splitlines()[0][:200]
        raise bad(f"cannot be read: {words}", file, expected=_EXPECTED) from None


def _refuse_large(file: Path, rows: int, columns: int) -> None:
    if rows > MOST_ROWS or columns > _MOST_COLUMNS:
        expected = f"at most {MOST_ROWS} rows and {_MOST_COLUMNS} columns"
        raise bad(f"has {rows} rows and {columns} columns", file, expected=expected)


def _refuse_words(file: Path, name: str, kind: Any) -> None:
    """Refuse a column that is no numbers; of a Parquet file before it is read, where few bytes can stand for any size of others."""
    import pyarrow as pa

    if not (pa.types.is_null(kind) or pa.types.is_integer(kind) or pa.types.is_floating(kind)):
        raise bad(f"has {kind}", file, shown(name), "numbers")


def _refuse_missing(file: Path, names: list[str], there: list[str], source: Source) -> None:
    """Raise BadInput for columns that are not there, or more than once."""
    twice = [f"has {there.count(name)} columns {shown(name)!r}" for name in names if there.count(name) > 1]
    problems = [Problem(what, str(file), expected="one") for what in twice]
    for name in (each for each in names if each not in there):
        # a blank at either end would not be seen
        known = (shown(each) if each == each.strip() else repr(shown(each)) for each in there)
        what = f"has no column {shown(name)!r}, which {source.file} names"
        problems.append(Problem(what, str(file), None, "", *guess(name, known)))
    if problems:
        raise BadInput(problems)


def _numbers(file: Path, name: str, column: Any) -> np.ndarray:
    import pyarrow as pa

    if pa.types.is_null(column.type):
        return np.full(len(column), np.nan)
    _refuse_words(file, name, column.type)
    return np.asarray(column.cast(pa.float64(), safe=False).to_numpy(zero_copy_only=False), dtype=float)

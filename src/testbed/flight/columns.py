"""The log of a flight: the names of its columns, how they are made from what the loop recorded, and how to find rows."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from testbed.air.config import COLUMNS as WIND
from testbed.aircraft.description import Aircraft
from testbed.common.signals import BELIEFS, GUARDED, RATES, SETPOINT, STATE, TELEMETRY, Belief
from testbed.common.units import DEGREES_PER_RADIAN as _DEG
from testbed.inputs.problems import did_you_mean
from testbed.scenario.load import Scenario
from testbed.sensors.channels import CHANNELS, SI
from testbed.sensors.channels import log_columns as sensor_columns

Log = Mapping[str, np.ndarray]
"""A log: its columns by name, each [rows]."""
Events = Sequence[Mapping[str, Any]]
"""What happened, in order of time: {time_s, kind, ...}."""
_SAME_TIME_S = 1e-9  # times this close are equal: rows are at k / rate, which may differ from a decimal number by rounding
_TRUTH = (
    ("north_m", "north", 1.0), ("east_m", "east", 1.0), ("altitude_m", "altitude", 1.0),
    ("airspeed_m_s", "airspeed", 1.0), ("climb_rate_m_s", "climb_rate", 1.0),
    ("roll_deg", "roll", _DEG), ("pitch_deg", "pitch", _DEG), ("heading_deg", "heading", _DEG),
    ("alpha_deg", "alpha", _DEG), ("beta_deg", "beta", _DEG),
    ("p_deg_s", "p", _DEG), ("q_deg_s", "q", _DEG), ("r_deg_s", "r", _DEG),
)  # fmt: skip
_REFERENCES = (
    ("altitude_command_m", "altitude", 1.0),
    ("airspeed_command_m_s", "airspeed", 1.0),
    ("heading_command_deg", "heading", _DEG),
)
ALWAYS_KNOWN = ("time_s", *(name for name, *_ in (*_TRUTH, *_REFERENCES)))
"""Columns that every log has, whatever flew, with a number in each row unless the flight diverged."""
_OF_ACTUATOR = (
    "reference", "command", "position", "effectiveness", "effectiveness_estimate", "failed", "belief", "believed_position",
)  # fmt: skip
"""How the columns of each actuator end."""
_SCALED = ("reference", "command", "believed_position")
"""Those that are recorded divided by the actuator's `scale`."""
_RATE_UNITS = {"p_dot": "deg_s2", "q_dot": "deg_s2", "r_dot": "deg_s2", "u_dot": "m_s2"}
_SAID = (
    *(f"_{name}" for name in (*TELEMETRY, BELIEFS[0])),
    "_released",
    "_stuck",
    *(f"_desired_{u}" for u in set(_RATE_UNITS.values())),
)
"""How the columns end that the controller fills."""


class Recorded(NamedTuple):
    """What the loop recorded, one row for each control step; in SI and radians except positions (see `truth`)."""

    truth: np.ndarray
    """[steps, 17 + 2 n] `STATE`; then the position of each of n actuators, in the unit of the aircraft's YAML; then the
    effectiveness of each."""
    measured: np.ndarray
    """[steps, 17] `STATE` as the sensors gave it to the controller."""
    references: np.ndarray
    """[steps, 6] `SETPOINT`: what the controller is to follow."""
    telemetry: np.ndarray
    """[steps, `telemetry_width`] each quantity of `TELEMETRY` for all actuators, desired rates and released flags by `RATES`, each
    quantity of `BELIEFS` for all actuators, and flags of `GUARDED`."""


class _Column(NamedTuple):
    """A column of the log: its array in `Recorded`, the column `place` of that array, and the factor to the log's unit.

    Values of a `wrapped` column, a heading, are from 0 to 360 deg.
    """

    name: str
    array: str
    place: int
    factor: float = 1.0
    wrapped: bool = False


_BLOCK = 1024  # control steps at a time, few enough for their rows to stay in the processor's cache
_MOST_READ = 1 << 16  # rows between two calls of a reader of `Columns`
_MOST_KEPT = 4  # columns that were read last: some are read again and again
_TIME = _Column("time_s", "", 0)  # computed from the row's number


def columns(aircraft: Aircraft) -> tuple[str, ...]:
    """Names of the columns that every log has."""
    return tuple(column.name for column in _columns(aircraft))


def all_columns(aircraft: Aircraft, scenario: Scenario) -> tuple[str, ...]:
    """Names of the log's columns in a scenario: those of real sensors and of moving air come last."""
    sensors = () if scenario.sensors.is_ideal else (*sensor_columns(), *map(stuck_column, GUARDED))
    return (*columns(aircraft), *sensors, *(() if scenario.atmosphere.is_calm else WIND))


def stuck_column(sensor: str) -> str:
    """Name of the column of a flag that is 1 while the controller takes this one of `GUARDED` for stuck."""
    return f"{sensor}_stuck"


def stuck_sensors(recorded: Recorded) -> dict[str, np.ndarray]:
    """The columns of these flags, which logs with real sensors have."""
    flags = recorded.telemetry[:, -len(GUARDED) :].T
    return dict(zip(map(stuck_column, GUARDED), flags, strict=True))


def table(
    aircraft: Aircraft, rate_hz: float, recorded: Recorded, more: Iterable[np.ndarray] = ()
) -> np.ndarray:
    """[columns, rows] the log in its units: the columns that every log has, then each of `more` [rows].

    Each column is contiguous in memory, because the log is read, judged, drawn and written by columns.
    """
    steps, usual, others = len(recorded.truth), tuple(_columns(aircraft)), tuple(more)
    data = np.empty((len(usual) + len(others), steps))
    for start in range(0, steps, _BLOCK):
        rows = slice(start, min(start + _BLOCK, steps))
        for place, column in enumerate(usual):
            data[place, rows] = _values(column, rate_hz, recorded, rows)
    for place, values in enumerate(others, len(usual)):
        data[place] = values
    return data


class Columns(Mapping[str, np.ndarray]):
    """The columns that every log has by name, each [rows] computed when it is read: all of a long flight are a gigabyte."""

    def __init__(
        self, aircraft: Aircraft, rate_hz: float, recorded: Recorded, read: Callable[[], object], every: int
    ) -> None:
        """`read` is called whenever some control steps of `recorded` have been read; a row is each `every`-th of them."""
        self._columns = {column.name: column for column in _columns(aircraft)}
        self._rate_hz, self._recorded, self._read, self._every = rate_hz, recorded, read, every
        self._kept = lru_cache(_MOST_KEPT)(self._computed)

    def __getitem__(self, name: str) -> np.ndarray:
        return self._kept(name)

    def _computed(self, name: str) -> np.ndarray:
        column = self._columns[name]
        every, steps = self._every, len(self._recorded.truth)
        values = np.empty(-(-steps // every))
        for start in range(0, len(values), _MOST_READ):
            rows = values[start : start + _MOST_READ]
            first = start * every
            rows[:] = _values(
                column, self._rate_hz, self._recorded, slice(first, first + len(rows) * every, every)
            )
            self._read()
        return values

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)


def reader(aircraft: Aircraft, rate_hz: float, recorded: Recorded, name: str) -> Callable[[int], float]:
    """A function that gives the value of one column at a control step, in the log's unit, while a flight is recorded."""
    (column,) = (column for column in _columns(aircraft) if column.name == name)
    return lambda step: float(_values(column, rate_hz, recorded, slice(step, step + 1))[0])


class Row(Mapping[str, float]):
    """One control step of an array of `Recorded` by the names and in its units; numbers are read when asked for."""

    def __init__(self, columns: Mapping[str, _Column], values: np.ndarray, time_s: float) -> None:
        """`columns` are those of `row_columns`, `values` the array's row."""
        self._columns, self._values, self.time_s = columns, values, time_s

    def __getitem__(self, name: str) -> float:
        if name == _TIME.name:
            return self.time_s
        column = self._columns.get(name)
        if column is None:
            close = did_you_mean(name, self)
            raise KeyError(
                f"no {name!r}"
                + (f", did you mean {close!r}?" if close else f", expected one of {', '.join(self)}")
            )
        value = float(self._values[column.place]) * column.factor
        return value % 360.0 if column.wrapped else value

    def __iter__(self) -> Iterator[str]:
        yield _TIME.name
        yield from self._columns

    def __len__(self) -> int:
        return 1 + len(self._columns)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({dict(self)})"


def row_columns(aircraft: Aircraft) -> dict[str, dict[str, _Column]]:
    """For each array of `Recorded`, the columns of a `Row` of it by name.

    Those of the measured state have the names of the true ones, and the rates.
    """
    usual = list(_columns(aircraft))
    found = {array: {c.name: c for c in usual if c.array == array} for array in Recorded._fields}
    state = {name: _Column(name, "measured", STATE.index(of), factor) for name, of, factor in _TRUTH}
    return {**found, "measured": state | found["measured"]}


def _values(column: _Column, rate_hz: float, recorded: Recorded, rows: slice) -> np.ndarray:
    if column is _TIME:
        return np.arange(rows.start, rows.stop, rows.step) / rate_hz
    values: np.ndarray = getattr(recorded, column.array)[rows, column.place] * column.factor
    return np.mod(values, 360.0) if column.wrapped else values


def _columns(aircraft: Aircraft) -> Iterator[_Column]:
    """The columns that every log has, in their order."""
    n = len(aircraft.actuators)
    desired = len(TELEMETRY) * n
    released = desired + len(RATES)
    # The array in which each quantity of the actuators is, and where it begins in a row.
    begins = {what: ("telemetry", n * i) for i, what in enumerate(TELEMETRY)}
    begins |= {what: ("telemetry", released + len(RATES) + n * i) for i, what in enumerate(BELIEFS)}
    begins |= {"position": ("truth", len(STATE)), "effectiveness": ("truth", len(STATE) + n)}
    yield _TIME
    for name, of, factor in _TRUTH:
        yield _Column(name, "truth", STATE.index(of), factor)
    for name, of, factor in _REFERENCES:
        yield _Column(name, "references", SETPOINT.index(of), factor, wrapped=of == "heading")
    for i, rate in enumerate(RATES):
        unit = _RATE_UNITS[rate]
        factor = 1.0 if rate == "u_dot" else _DEG
        yield _Column(f"{rate}_{unit}", "measured", STATE.index(rate), factor)
        yield _Column(f"{rate}_desired_{unit}", "telemetry", desired + i, factor)
    for i, rate in enumerate(RATES):
        yield _Column(f"{rate}_released", "telemetry", released + i)
    for i, (name, actuator) in enumerate(aircraft.actuators.items()):
        for what in _OF_ACTUATOR:
            array, first = begins[what]
            yield _Column(f"{name}_{what}", array, first + i, actuator.scale if what in _SCALED else 1.0)


def row_at(time_s: np.ndarray, instant_s: float) -> int:
    """First row at or after an instant [s]; the number of rows if the log ends before the instant.

    `time_s` [rows] is the log's time, ascending.
    """
    return int(np.searchsorted(time_s, instant_s - _SAME_TIME_S))


def row_spacing_s(time_s: np.ndarray) -> float:
    """Time between two rows of the log [s]; 0 in a log of one row."""
    return float(time_s[1] - time_s[0]) if len(time_s) > 1 else 0.0


def stretches(flag: np.ndarray) -> list[tuple[int, int]]:
    """(first row, row after the last) of each unbroken stretch of rows in which a flag [rows] of bools is true."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], flag, [False])).astype(np.int8)))
    return [(int(first), int(end)) for first, end in edges.reshape(-1, 2)]


def stays_from(flag: np.ndarray, first: int, end: int) -> int | None:
    """First row of `first` to `end` from which a flag [rows] of bools is true until `end`; None if it is false in the last row."""
    false = np.flatnonzero(~flag[first:end])
    row = first + int(false[-1]) + 1 if len(false) else first
    return row if row < end else None


def reading(log: Log, name: str, measured: bool = True) -> np.ndarray:
    """[rows] one of `signals.STATE` as its sensor read it, if that is asked for and sensors were not ideal, else the truth [SI]."""
    unit = next(channel.unit for channel in CHANNELS if channel.reads == name)
    column = f"{name}_measured_{unit}"
    return log[column if measured and column in log else f"{name}_{unit}"] * SI[unit]


def unsaid(log: Log) -> set[str]:
    """Columns of which the controller said nothing in the whole flight: they cannot be judged.

    Where an actuator is held is said by who says what it takes the actuator for, also while none is held.
    """
    silent = {name for name, values in log.items() if name.endswith(_SAID) and np.isnan(values).all()}
    ends, of = (f"_{name}" for name in BELIEFS)
    held = {name.removesuffix(ends) + of for name in silent if name.endswith(ends)}
    return silent | (held & log.keys())


def beliefs(log: Log, actuators: Iterable[str]) -> list[dict[str, Any]]:
    """What the controller took each actuator for: {time_s, until_s, actuator, belief, position} of each stretch, by time.

    `belief` is a word of `signals.Belief`. `position` is where a held actuator was thought to be, in its unit, and NaN for others:
    the median of the stretch, since the first estimate is rough, and at the end the actuator may move again. Nothing is in the
    list of a controller that says nothing, nor of a log that was written before there were beliefs.
    """
    time_s, found = log["time_s"], []
    for actuator in actuators:
        code, position = (log.get(f"{actuator}_{what}", np.full(len(time_s), math.nan)) for what in BELIEFS)
        for word in Belief:
            for first, end in stretches(code == word):
                found.append(
                    {
                        "time_s": float(time_s[first]),
                        "until_s": float(time_s[end - 1]),
                        "actuator": actuator,
                        "belief": word.name,
                        "position": float(np.median(position[first:end])),
                    }
                )
    return sorted(found, key=lambda belief: (belief["time_s"], belief["actuator"]))

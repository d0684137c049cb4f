"""A flight log as the diagnosis needs it: on one even base of time, in SI, with what could not be read marked and said.

Only what a real log has is in it: what sensors read and what was commanded.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from testbed.common.signals import STATE
from testbed.common.text import printable
from testbed.inputs.problems import BadInput, Problem

MOST_ROWS = 5_000_000
"""Rows of a log that are read: seven hours at 200 Hz."""
LEAST_S = 10.0
"""A shorter log says nothing."""
_LEAST_HZ, _MOST_HZ = 50.0, 200.0
"""Rates of the even base of time: a slower log is interpolated, as servos are faster."""
_GAP_S = 0.5
"""What is missing for longer is not interpolated."""
NEEDED = ("airspeed", "p", "q", "r", "roll", "pitch")
"""Signals without which there is no diagnosis."""
OPTIONAL = ("alpha", "beta", "u_dot", "force_x")
PLACE, GLOBE = ("north", "east", "altitude", "heading"), ("latitude", "longitude")
"""Where the aircraft was, for the replay alone; on the globe in place of north and east."""
_EARTH_M, _FARTHEST_M = 6371e3, 1e6
_LARGEST = {"p": 12.0, "q": 12.0, "r": 12.0, "roll": 6.4, "pitch": 1.6, "alpha": 1.6, "beta": 1.6, "airspeed": 400.0,
            "u_dot": 300.0, "force_x": 300.0}  # fmt: skip
"""Sizes [SI] that 99 % of a signal stay below, whatever flew."""
_LARGEST_COMMAND = 1e7
"""The same of a command: the thrust of the largest engines [N], and more."""
_SPIKE = 10.0
"""A value so many times as large is no reading, and is taken for missing."""
_FLIES_M_S = 1.0
"""An airspeed that some percent of the log of a flight are above."""


@dataclass(frozen=True)
class FlightLog:
    """The log of one flight.

    Attributes:
        name: what is diagnosed.
        time_s: [rows], even.
        states: [rows, 17] `signals.STATE`; NaN in what the log does not have.
        commands: [rows, n] in the actuators' order: rad, throttle, or as `as_positions` [n] says the position [rad or N].
        known: [rows] where nothing was missing.
        remarks: sentences about what was mended or is missing.
        truth: what only a simulated flight knows, for pictures alone: [rows] by name of the actuator, what it does for its command.
        failures_s: when something truly broke.
        place: [rows] north, east, altitude [m] and heading [rad]; empty where the log has not all of them.
    """

    name: str
    time_s: np.ndarray
    states: np.ndarray
    commands: np.ndarray
    as_positions: np.ndarray
    known: np.ndarray
    remarks: tuple[str, ...] = ()
    truth: Mapping[str, np.ndarray] = field(default_factory=dict)
    failures_s: tuple[float, ...] = ()
    place: Mapping[str, np.ndarray] = field(default_factory=dict)

    @property
    def step_s(self) -> float:
        """Time between two rows [s]."""
        return float(self.time_s[1] - self.time_s[0])


def even(
    name: str,
    time_s: np.ndarray,
    signals: Mapping[str, np.ndarray],
    commands: Mapping[str, np.ndarray],
    as_positions: np.ndarray,
    column_of: Callable[[str], str] = lambda signal: signal,
) -> FlightLog:
    """The log of signals [rows] in SI by `NEEDED`, `OPTIONAL`, `PLACE` and `GLOBE`, and of commands [rows] by actuator.

    Args:
        column_of: where the user finds a signal, for messages.

    Raises:
        BadInput: too short or too long, times that are none, a signal that is missing, or in another unit.
    """
    if lacks := [each for each in NEEDED if each not in signals]:
        raise BadInput(Problem("is not in the log", name, path=each) for each in lacks)
    where = {each: values for each, values in signals.items() if each in (*PLACE, *GLOBE)}
    signals = {each: values for each, values in signals.items() if each not in where}
    rows, remarks = _ascending(name, time_s)
    if problems := _impossible(name, time_s[rows], {n: v[rows] for n, v in signals.items()}, column_of):
        raise BadInput(problems)
    if problems := list(_oversized(name, commands, {}, str)):
        raise BadInput(problems)
    before, usual_s = time_s[rows], float(np.median(np.diff(time_s[rows])))
    step_s = 1.0 / min(max(1.0 / usual_s, _LEAST_HZ), _MOST_HZ)
    if (before[-1] - before[0]) / step_s > MOST_ROWS:
        raise bad(f"lasts {before[-1] - before[0]:.0f} s", name, expected="a shorter log")
    after = np.arange(before[0], before[-1], step_s)
    known = np.ones(len(after), dtype=bool)
    columns: dict[str, np.ndarray] = {}
    for signal, values in {**signals, **commands}.items():
        most = _SPIKE * _LARGEST.get(signal, _LARGEST_COMMAND)
        read = np.where(np.abs(values[rows]) <= most, values[rows], np.nan)
        columns[signal], there = _onto(after, before, read, held=signal in commands)
        known &= there
    missing = float(np.mean(~known))
    if missing > 0.0:
        remarks.append(f"In {100 * missing:.1f} % of the time something is missing; nothing is said there.")
    states = _states(columns, step_s)
    lacks = [signal for signal in ("alpha", "beta") if signal not in signals]
    if lacks:
        remarks.append(
            f"The log has no {' and no '.join(lacks)}: the trim's is taken, which is less accurate."
        )
    if not {"u_dot", "force_x"} & set(signals):
        remarks.append(
            "The log has no acceleration along the body: propellers are seen by their moments alone."
        )
    made = np.stack([columns[actuator] for actuator in commands], axis=1)
    place = _place(after, before, {each: values[rows] for each, values in where.items()})
    return FlightLog(name, after, states, made, as_positions, known, tuple(remarks), place=place)


def _place(after: np.ndarray, before: np.ndarray, where: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The place at other times, by straight lines through whatever is missing; a globe without a fix says zero and zero."""
    columns = dict(where)
    if set(GLOBE) <= set(where):
        latitude, longitude = (where[name] for name in GLOBE)
        seen = np.isfinite(latitude + longitude) & ((latitude != 0.0) | (longitude != 0.0))
        if not np.any(seen):
            return {}
        first = int(np.argmax(seen))
        with np.errstate(over="ignore"):  # what is too far is left out below
            east = math.cos(latitude[first]) * (longitude - longitude[first])
            for name, turned in (("north", latitude - latitude[first]), ("east", east)):
                columns[name] = np.where(seen, _EARTH_M * turned, np.nan)
    made = {}
    for name in PLACE:
        values = columns.get(name, np.full(len(before), np.nan))
        finite = np.isfinite(values) & (np.abs(values) < _FARTHEST_M)
        if not np.any(finite):
            return {}
        known = np.unwrap(values[finite]) if name == "heading" else values[finite]
        made[name] = np.interp(after, before[finite], known)
    return made


def flown(log: FlightLog, least_m_s: float, aircraft: str) -> FlightLog:
    """The log with nothing known where it is too slow to fly: on the ground wheels hold what actuators would turn.

    Raises BadInput if less than LEAST_S are flown.
    """
    slow = log.known & ~(log.states[:, STATE.index("airspeed")] >= least_m_s)
    known = log.known & ~slow
    if (known_s := np.sum(known) * log.step_s) < LEAST_S:
        airspeed = f"is above {least_m_s:g} m/s, the least airspeed of {aircraft}, for {known_s:.0f} s"
        what, path = (
            (airspeed, "airspeed") if np.any(slow) else (f"has all that is needed for {known_s:.0f} s", "")
        )
        raise bad(what, log.name, path, f"at least {LEAST_S:g} s of flight")
    if not np.any(slow):
        return log
    said = f"In {100 * np.mean(slow):.1f} % of the time the airspeed is below {least_m_s:g} m/s; nothing is said there."
    return replace(log, known=known, remarks=(*log.remarks, said))


def _impossible(
    name: str, time_s: np.ndarray, signals: Mapping[str, np.ndarray], column_of: Callable[[str], str]
) -> list[Problem]:
    """Signals of a size that no aircraft has, and turning rates that do not fit the attitude."""
    found = [*_oversized(name, signals, _LARGEST, column_of)]
    if not found and not np.nanpercentile(signals["airspeed"], 99.0) > _FLIES_M_S:
        what, path = f"is never above {_FLIES_M_S:g} m/s", column_of("airspeed")
        found.append(Problem(what, name, path=path, expected="an aircraft that flies; is its sign right?"))
    for rate, angle in (("p", "roll"), ("q", "pitch")):
        if not found and len(time_s) > 100:
            ratio = _ratio(time_s, signals[rate], signals[angle])
            if ratio > 10.0 or ratio < 0.1:
                what, about = (
                    f"is {ratio:.3g} times the rate of {column_of(angle)}",
                    "about 1 (57.3 is a unit of degrees)",
                )
                found.append(Problem(what, name, path=column_of(rate), expected=about))
    return found


def _oversized(
    name: str,
    signals: Mapping[str, np.ndarray],
    largest: Mapping[str, float],
    column_of: Callable[[str], str],
) -> Iterator[Problem]:
    """Signals without a number, and those that are above their largest value in more than one percent of the log."""
    for signal, values in signals.items():
        if not np.any(np.isfinite(values)):
            yield Problem("has no numbers", name, path=column_of(signal))
            continue
        size = float(np.percentile(np.abs(values[~np.isnan(values)]), 99.0, method="higher"))
        if size > (most := largest.get(signal, _LARGEST_COMMAND)):
            expected = f"less than {most:g}; is its unit right?"
            yield Problem(f"is up to {size:.3g} in SI", name, path=column_of(signal), expected=expected)


def _ratio(time_s: np.ndarray, rate: np.ndarray, angle: np.ndarray) -> float:
    """Size of a turning rate over that of its angle's, both over a second; 1 where neither moves."""
    step = max(round(1.0 / max(float(np.median(np.diff(time_s))), 1e-3)), 1)
    turned = np.cumsum(np.nan_to_num(rate[1:]) * np.diff(time_s))
    by_rate, by_angle = turned[step:] - turned[:-step], np.unwrap(np.nan_to_num(angle))[1:]
    by_angle = by_angle[step:] - by_angle[:-step]
    sizes = [float(np.percentile(np.abs(each - np.median(each)), 90.0)) for each in (by_rate, by_angle)]
    return 1.0 if max(sizes) < 0.02 else sizes[0] / max(sizes[1], 1e-6)


def _ascending(name: str, time_s: np.ndarray) -> tuple[np.ndarray, list[str]]:
    """Rows whose time is finite and after all before it, and what is to be said of the others."""
    finite = np.isfinite(time_s)
    best = np.maximum.accumulate(np.where(finite, time_s, -np.inf))
    kept = finite & np.concatenate([[True], time_s[1:] > best[:-1]])
    rows = np.flatnonzero(kept)
    if len(rows) < 0.9 * len(time_s) or len(rows) < 2:
        what = f"goes forward in {len(rows)} of {len(time_s)} rows"
        raise bad(what, name, "time", "times that increase, of one clock")
    steps = np.diff(time_s[rows])
    span, usual = float(time_s[rows[-1]] - time_s[rows[0]]), float(np.median(steps))
    if span < LEAST_S or not 0.001 <= usual <= 0.5:
        what = f"goes from {time_s[rows[0]]:.6g} to {time_s[rows[-1]]:.6g} s in steps of {usual:.3g} s"
        raise bad(what, name, "time", f"at least {LEAST_S:g} s, at 2 to 1000 Hz; is its unit right?")
    if float(np.sum(steps[steps > 60.0])) > 0.5 * span:
        raise bad("jumps for most of its length", name, "time", "one clock")
    remarks = []
    if len(rows) < len(time_s):
        count = len(time_s) - len(rows)
        remarks.append(f"The clock goes back or stands still in {count} rows, which are left out.")
    return rows, remarks


def _onto(
    after: np.ndarray, before: np.ndarray, values: np.ndarray, held: bool
) -> tuple[np.ndarray, np.ndarray]:
    """(values, where they are known) on other times: interpolated, or `held` from the last row, as commands are."""
    finite = np.isfinite(values)
    if not np.any(finite):
        return np.full(len(after), np.nan), np.zeros(len(after), dtype=bool)
    time_s, values = before[finite], values[finite]
    last = np.clip(np.searchsorted(time_s, after + 1e-9, side="right") - 1, 0, len(time_s) - 1)
    following = np.clip(last + 1, 0, len(time_s) - 1)
    there = (time_s[following] - time_s[last] <= _GAP_S) & (np.abs(after - time_s[last]) <= _GAP_S)
    return values[last] if held else np.interp(after, time_s, values), there


def _states(columns: Mapping[str, np.ndarray], step_s: float) -> np.ndarray:
    found = {**columns, **{f"{rate}_dot": np.gradient(columns[rate], step_s) for rate in "pqr"}}
    missing = np.full(len(columns["p"]), np.nan)
    return np.stack([found.get(signal, missing) for signal in STATE], axis=1)


def bad(what: str, log: object, path: str = "", expected: str = "") -> BadInput:
    """The exception of one problem with a log, at a column or signal `path`."""
    return BadInput([Problem(what, str(log), path=path, expected=expected)])


def shown(name: object) -> str:
    """A name of the log's, fit for a message."""
    return printable(str(name))[:80]

"""The metrics, and what they are computed from: a flight's log, events and actuators, with functions that several metrics use.

They say how well altitude, airspeed and heading followed their references, before and after failures, and what it cost the
actuators; whether the monitor flagged the actuators that were broken, and only those; how long axes were given up; how true
estimates were.

The speed of the effectiveness estimates is compared with the first-order lag of the paper's equations (21) and (22).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np

from testbed.flight.breakage import LOST, broken, failure_times_s, lost, recoveries, tracking_error
from testbed.flight.columns import row_at, row_spacing_s, stays_from, stretches
from testbed.flight.events import at_stops
from testbed.flight.flight import Flight, Outcome
from testbed.scenario.load import Scenario


@dataclass(frozen=True, eq=False)
class Readings:
    """What metrics read of one flight.

    Attributes:
        log: columns by name, each [rows], in the log's units.
        events: as in `Flight.events`.
        actuators: as in `Flight.actuators`.
        gamma: adaptation rate of each actuator by name [1/s], equation (13); empty if the controller has none.
        survived: whether the aircraft was flown to the end.
    """

    log: Mapping[str, np.ndarray]
    events: Sequence[Mapping[str, Any]]
    actuators: Mapping[str, Mapping[str, Any]]
    gamma: Mapping[str, float] = field(default_factory=dict)
    survived: bool = True

    @property
    def time_s(self) -> np.ndarray:
        return self.log["time_s"]

    @property
    def step_s(self) -> float:
        """Time between rows [s]."""
        return row_spacing_s(self.time_s)

    def error(self, quantity: str) -> np.ndarray:
        """[rows] altitude, airspeed or heading minus its reference [m, m/s, deg]; headings the short way round."""
        return tracking_error(self.log, quantity)

    def of_kind(self, kind: str) -> list[Mapping[str, Any]]:
        """Events of one kind."""
        return [event for event in self.events if event["kind"] == kind]

    def failure_times_s(self) -> list[float]:
        """Times at which failures began, each once, in order [s]."""
        return failure_times_s(self.events)

    def first_failed_row(self) -> int:
        """First row from the start of the first failure on; the number of rows if there was no failure."""
        times = self.failure_times_s()
        return self.row_at(times[0]) if times else len(self.time_s)

    def row_at(self, time_s: float) -> int:
        """First row at or after a time [s]; the number of rows if the log ends before it."""
        return row_at(self.time_s, time_s)


def readings(flight: Flight) -> Readings:
    """Readings of a finished flight, from the rows that were logged.

    If fewer rows were logged than control steps were flown (`log_hz`), metrics from these readings are less exact than the
    flight's own, which were computed from every step.
    """
    return Readings(
        log=flight.signals,
        events=flight.events,
        actuators=flight.actuators,
        gamma={} if flight.flown_by else adaptation_rates(flight.scenario, flight.actuators),
        survived=flight.outcome is Outcome.completed,
    )


def adaptation_rates(scenario: Scenario, actuators: Mapping[str, Mapping[str, Any]]) -> dict[str, float]:
    """gamma of equation (13) for each actuator [1/s]; empty if the controller has none.

    The setting is one number for all actuators, or one for each kind of actuator.
    """
    gamma = scenario.controller.model_dump().get("gamma")
    if gamma is None:
        return {}
    if not isinstance(gamma, Mapping):
        return dict.fromkeys(actuators, float(gamma))
    return {name: float(gamma.get(facts["kind"], math.nan)) for name, facts in actuators.items()}


_UNITS = {"altitude": "m", "heading": "deg", "airspeed": "m/s"}
SETTLED = {"altitude": 1.0, "heading": 2.0, "airspeed": 0.5}
"""A quantity has settled when it stays this close to its reference [m, deg, m/s]. Whether the aircraft has recovered is
decided in `flight.breakage`, with limits that also suit turbulence."""


def survived(readings: Readings) -> float:
    """1 if the aircraft was flown to the end, 0 if it was lost [-]."""
    return float(readings.survived)


def _error_rms(readings: Readings, quantity: str) -> float:
    """It does not use a dot product, whose last digit depends on the number of BLAS threads."""
    error = readings.error(quantity)
    return math.sqrt(float(np.square(error).mean())) if len(error) else math.nan


def roll_excursion_failed_deg(readings: Readings) -> float:
    """Largest bank angle, either way, since the first failure [deg]; NaN without a failure."""
    return _largest(readings.log["roll_deg"][readings.first_failed_row() :])


def beta_excursion_failed_deg(readings: Readings) -> float:
    """Largest sideslip, either way, since the first failure [deg]; NaN without a failure."""
    return _largest(readings.log["beta_deg"][readings.first_failed_row() :])


def recovery_s(readings: Readings) -> float:
    """Time from the start of the last failure until altitude and heading stay within 5 m and 15 deg of their references [s].

    As `flight.breakage` has it: they have to stay there for at least 5 s, and to the end of the flight. NaN if they never do.
    """
    times = readings.failure_times_s()
    each = recoveries(readings.log, times, readings.survived)
    recovered = each[-1][1] if each else None
    return math.nan if recovered is None else recovered - times[-1]


def _recovery(readings: Readings, quantity: str) -> float:
    """Time to settle [s]: 0 if the quantity never left SETTLED; NaN without a failure, or if the aircraft was lost."""
    times = readings.failure_times_s()
    if not times or not readings.survived:
        return math.nan
    # NaN compares as false, so it does not count as settled.
    inside = np.abs(readings.error(quantity)) <= SETTLED[quantity]
    row = stays_from(inside, readings.row_at(times[-1]), len(inside))
    return math.nan if row is None else float(readings.time_s[row]) - times[-1]


def _largest(values: np.ndarray) -> float:
    return float(max(values.max(), -values.min())) if len(values) else math.nan


def _of_each(
    name: str, meaning: str, value: Callable[[Readings, str], float]
) -> Iterator[Callable[[Readings], float]]:
    """The metric of altitude, of heading and of airspeed; {quantity}, {unit} and {limit} in its name and meaning are replaced."""
    for quantity, unit in _UNITS.items():

        def metric(readings: Readings, quantity: str = quantity) -> float:
            return value(readings, quantity)

        metric.__name__ = name.format(quantity=quantity, unit=unit.replace("/", "_"))
        metric.__doc__ = meaning.format(quantity=quantity, unit=unit, limit=f"{SETTLED[quantity]:g} {unit}")
        yield metric


_ERROR = "distance of {quantity} from its reference"
FOLLOWING = (
    survived,
    *_of_each(
        "{quantity}_error_max_{unit}",
        f"Largest {_ERROR}, over the whole flight [{{unit}}].",
        lambda r, q: _largest(r.error(q)),
    ),
    *_of_each("{quantity}_error_rms_{unit}", f"Root mean square {_ERROR}, over the whole flight [{{unit}}].", _error_rms),
    *_of_each(
        "{quantity}_error_end_{unit}",
        f"{_ERROR.capitalize()} in the last row of the log [{{unit}}].",
        lambda r, q: _largest(r.error(q)[-1:]),
    ),
    *_of_each(
        "{quantity}_excursion_healthy_{unit}",
        f"Largest {_ERROR} before the first failure [{{unit}}].",
        lambda r, q: _largest(r.error(q)[: r.first_failed_row()]),
    ),
    *_of_each(
        "{quantity}_excursion_failed_{unit}",
        f"Largest {_ERROR} since the first failure [{{unit}}]; NaN without a failure.",
        lambda r, q: _largest(r.error(q)[r.first_failed_row() :]),
    ),
    roll_excursion_failed_deg, beta_excursion_failed_deg, recovery_s,
    *_of_each(
        "{quantity}_recovery_s",
        "Time from the start of the last failure until {quantity} stays within {limit} of its reference [s]; NaN if never.",
        _recovery,
    ),
)  # fmt: skip


def control_effort_per_s(readings: Readings) -> float:
    """Integral of the squared rates of all commands, each in units of its actuator's scale [1/s].

    Computed as the sum over actuators and rows of (change of command / scale)^2 / (time between rows). A step of a command
    therefore counts for more if the control step is shorter. NaN if an actuator's scale is not known.
    """
    total = 0.0
    for name, facts in readings.actuators.items():
        change = np.diff(readings.log[f"{name}_command"])
        total += float(np.square(change).sum()) / float(facts.get("scale", math.nan)) ** 2
    return total / readings.step_s if readings.step_s else math.nan


def saturated_time_s(readings: Readings) -> float:
    """Time during which the command of some actuator that is not flagged is at a stop, to 0.1 % of its travel [s].

    NaN if an actuator's stops are not known.
    """
    saturated = np.zeros(len(readings.time_s), dtype=bool)
    for name, facts in readings.actuators.items():
        if "limits" not in facts:
            return math.nan
        at_low, at_high = at_stops(readings.log[f"{name}_command"], *facts["limits"])
        saturated |= (at_low | at_high) & ~(readings.log[f"{name}_failed"] > 0.0)
    return float(np.count_nonzero(saturated) * readings.step_s)


EFFORT = (control_effort_per_s, saturated_time_s)


NOTICEABLE_S = 2.0
"""An actuator that is lost for longer than this [s] has to be flagged."""
_RELEASED = "_released"


def detection_delay_s(readings: Readings) -> float:
    """Longest time from when an actuator broke until it was first flagged [s]; NaN without a detection."""
    first: dict[tuple[str, int], float] = {}
    for event in readings.of_kind("detection"):  # a second flag for the same breakage is not a new detection
        breakage = (event["actuator"], round((event["time_s"] - event["delay_s"]) * 1e3))
        first[breakage] = min(first.get(breakage, math.inf), event["delay_s"])
    return max(first.values(), default=math.nan)


def missed_detections(readings: Readings) -> float:
    """Losses of an actuator (effectiveness 0.1 or less for over 2 s) during which it was never flagged [count]."""
    return float(
        sum(
            not readings.log[f"{actuator}_failed"][start:end].any()
            for actuator in readings.actuators
            for start, end in stretches(lost(readings.log, actuator))
            if (end - start) * readings.step_s > NOTICEABLE_S
        )
    )


def false_alarms(readings: Readings) -> float:
    """Flags of actuators that were not broken when they were flagged [count]."""
    return float(len(readings.of_kind("false_alarm")))


def wrong_blames(readings: Readings) -> float:
    """False alarms while another actuator was broken: the failure was attributed to the wrong actuator [count]."""
    alarms = readings.of_kind("false_alarm")
    return float(sum(_another_broken(readings, alarm["actuator"], alarm["time_s"]) for alarm in alarms))


def isolation_fraction(readings: Readings) -> float:
    """Share of all flags that were raised for a broken actuator [0 to 1]; NaN without a flag."""
    right, wrong = len(readings.of_kind("detection")), len(readings.of_kind("false_alarm"))
    return right / (right + wrong) if right + wrong else math.nan


def goal_switches(readings: Readings) -> float:
    """Number of times that an axis was given up or taken back [count]; one or two for a lost actuator, more is chatter."""
    return float(sum(np.count_nonzero(np.diff(flag)) for flag in _released(readings)))


def released_time_s(readings: Readings) -> float:
    """Time with at least one axis given up [s]."""
    flags = _released(readings)
    return float(np.count_nonzero(sum(flags[1:], flags[0])) * readings.step_s) if flags else 0.0


def _released(readings: Readings) -> list[np.ndarray]:
    return [column for name, column in readings.log.items() if name.endswith(_RELEASED)]


def _another_broken(readings: Readings, blamed: str, time_s: float) -> bool:
    """Whether any actuator other than the one flagged is broken at this time [s]."""
    # With `log_hz` the last row may be before the event.
    row = min(readings.row_at(time_s), len(readings.time_s) - 1)
    injections = readings.of_kind("injection")
    others = (actuator for actuator in readings.actuators if actuator != blamed)
    return any(broken(readings.log, actuator, injections)[row] for actuator in others)


OF_FLAGS = (detection_delay_s, missed_detections, false_alarms, wrong_blames, isolation_fraction)
OF_RELEASES = (goal_switches, released_time_s)


BAND = 0.05
"""An estimate has settled when its error is within this fraction of the step of the true effectiveness."""
_STEP = 0.05  # a larger change of true effectiveness from one row to the next is a step
_TIME_CONSTANTS = 3.0  # after ln 20 = 3.0 time constants a first-order lag is within 5 % of its end


def estimate_error_rms(readings: Readings) -> float:
    """Root mean square error of the effectiveness estimate, for the worst actuator [1 is healthy]."""
    return _worst_actuator(math.sqrt(float(np.square(error).mean())) for error in _estimate_errors(readings))


def estimate_error_end(readings: Readings) -> float:
    """Error of the effectiveness estimate in the log's last row, for the worst actuator [1 is healthy]."""
    return _worst_actuator(abs(float(error[-1])) for error in _estimate_errors(readings))


def estimate_settling_s(readings: Readings) -> float:
    """Longest time from a step of true effectiveness until the estimate stays within 5 % of it [s]; NaN if never.

    5 % means 5 % of the step. The estimate has to stay there until the next step or the end of the flight. NaN also if
    there was no step. Steps to 0.1 or less do not count: a lost actuator has to be flagged, which `detection_delay_s`
    measures, and its estimate does not matter.
    """
    return _worst_actuator(time for _, time in _settlings(readings))


def estimate_settling_ratio(readings: Readings) -> float:
    """Longest settling time divided by 3/gamma, which the paper's first-order lag (22) predicts [-]; 1 is as predicted.

    As `estimate_settling_s`, with the gamma of each actuator.
    """
    gamma = readings.gamma
    return _worst_actuator(
        time * gamma.get(name, math.nan) / _TIME_CONSTANTS for name, time in _settlings(readings)
    )


def _estimate_errors(readings: Readings) -> Iterator[np.ndarray]:
    for name in readings.actuators:
        yield readings.log[f"{name}_effectiveness_estimate"] - readings.log[f"{name}_effectiveness"]


def _settlings(readings: Readings) -> Iterator[tuple[str, float]]:
    """(actuator, settling time [s]) of each step of true effectiveness; NaN if the estimate never settles."""
    for name, error in zip(readings.actuators, _estimate_errors(readings), strict=True):
        truth = readings.log[f"{name}_effectiveness"]
        change = np.abs(np.diff(truth))
        steps = np.flatnonzero(change > _STEP) + 1
        for start, end in pairwise([*steps, len(truth)]):
            if truth[start] > LOST:
                inside = np.abs(error) <= BAND * change[start - 1]
                row = stays_from(inside, start, end)
                yield name, math.nan if row is None else (row - start) * readings.step_s


def _worst_actuator(values: Iterator[float]) -> float:
    """The largest; NaN if any of them is NaN, or if there are none."""
    each = list(values)
    return max(each) if each and not any(map(math.isnan, each)) else math.nan


OF_ESTIMATES = (estimate_error_rms, estimate_error_end, estimate_settling_s, estimate_settling_ratio)

"""How well altitude, airspeed and heading followed their references, before and after failures; and what it cost the actuators."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np

from testbed.flight.breakage import recoveries
from testbed.flight.columns import stays_from
from testbed.flight.events import at_stops
from testbed.metrics.flight_view import Readings

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
TABLE = (
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

"""How well altitude, airspeed and heading followed their references, before and after failures."""

from __future__ import annotations

import math

import numpy as np

from testbed.flight.recovery import recoveries
from testbed.metrics.flight_view import Readings, settled_after

SETTLED = {"altitude": 1.0, "heading": 2.0, "airspeed": 0.5}
"""A quantity has settled when it stays this close to its reference [m, deg, m/s]. Whether the aircraft has recovered is
decided in `flight.recovery`, with limits that also suit turbulence."""


def survived(readings: Readings) -> float:
    """1 if the aircraft was flown to the end, 0 if it was lost [-]."""
    return float(readings.survived)


def altitude_error_max_m(readings: Readings) -> float:
    """Largest distance of altitude from its reference, over the whole flight [m]."""
    return _largest(readings.error("altitude"))


def heading_error_max_deg(readings: Readings) -> float:
    """Largest distance of heading from its reference, over the whole flight [deg]."""
    return _largest(readings.error("heading"))


def airspeed_error_max_m_s(readings: Readings) -> float:
    """Largest distance of airspeed from its reference, over the whole flight [m/s]."""
    return _largest(readings.error("airspeed"))


def altitude_error_rms_m(readings: Readings) -> float:
    """Root mean square distance of altitude from its reference, over the whole flight [m]."""
    return _rms(readings.error("altitude"))


def heading_error_rms_deg(readings: Readings) -> float:
    """Root mean square distance of heading from its reference, over the whole flight [deg]."""
    return _rms(readings.error("heading"))


def airspeed_error_rms_m_s(readings: Readings) -> float:
    """Root mean square distance of airspeed from its reference, over the whole flight [m/s]."""
    return _rms(readings.error("airspeed"))


def altitude_error_end_m(readings: Readings) -> float:
    """Distance of altitude from its reference in the last row of the log [m]."""
    return _largest(readings.error("altitude")[-1:])


def heading_error_end_deg(readings: Readings) -> float:
    """Distance of heading from its reference in the last row of the log [deg]."""
    return _largest(readings.error("heading")[-1:])


def airspeed_error_end_m_s(readings: Readings) -> float:
    """Distance of airspeed from its reference in the last row of the log [m/s]."""
    return _largest(readings.error("airspeed")[-1:])


def altitude_excursion_healthy_m(readings: Readings) -> float:
    """Largest distance of altitude from its reference before the first failure [m]."""
    return _largest(readings.error("altitude")[: readings.first_failed_row()])


def heading_excursion_healthy_deg(readings: Readings) -> float:
    """Largest distance of heading from its reference before the first failure [deg]."""
    return _largest(readings.error("heading")[: readings.first_failed_row()])


def airspeed_excursion_healthy_m_s(readings: Readings) -> float:
    """Largest distance of airspeed from its reference before the first failure [m/s]."""
    return _largest(readings.error("airspeed")[: readings.first_failed_row()])


def altitude_excursion_failed_m(readings: Readings) -> float:
    """Largest distance of altitude from its reference since the first failure [m]; NaN without a failure."""
    return _largest(readings.error("altitude")[readings.first_failed_row() :])


def heading_excursion_failed_deg(readings: Readings) -> float:
    """Largest distance of heading from its reference since the first failure [deg]; NaN without a failure."""
    return _largest(readings.error("heading")[readings.first_failed_row() :])


def airspeed_excursion_failed_m_s(readings: Readings) -> float:
    """Largest distance of airspeed from its reference since the first failure [m/s]; NaN without a failure."""
    return _largest(readings.error("airspeed")[readings.first_failed_row() :])


def roll_excursion_failed_deg(readings: Readings) -> float:
    """Largest bank angle, either way, since the first failure [deg]; NaN without a failure."""
    return _largest(readings.log["roll_deg"][readings.first_failed_row() :])


def beta_excursion_failed_deg(readings: Readings) -> float:
    """Largest sideslip, either way, since the first failure [deg]; NaN without a failure."""
    return _largest(readings.log["beta_deg"][readings.first_failed_row() :])


def recovery_s(readings: Readings) -> float:
    """Time from the start of the last failure until altitude and heading stay within 5 m and 15 deg of their references [s].

    As `flight.recovery` has it: they have to stay there for at least 5 s, and to the end of the flight. NaN if they never do.
    """
    times = readings.failure_times_s()
    found = recoveries(readings.log, times, readings.survived)
    recovered = found[-1][1] if found else None
    return math.nan if recovered is None else recovered - times[-1]


def altitude_recovery_s(readings: Readings) -> float:
    """Time from the start of the last failure until altitude stays within 1 m of its reference [s]; NaN if never."""
    return _recovery(readings, "altitude")


def heading_recovery_s(readings: Readings) -> float:
    """Time from the start of the last failure until heading stays within 2 deg of its reference [s]; NaN if never."""
    return _recovery(readings, "heading")


def airspeed_recovery_s(readings: Readings) -> float:
    """Time from the start of the last failure until airspeed stays within 0.5 m/s of its reference [s]; NaN if never."""
    return _recovery(readings, "airspeed")


def _recovery(readings: Readings, quantity: str) -> float:
    """Time to settle [s]: 0 if the quantity never left SETTLED; NaN without a failure, or if the aircraft was lost."""
    times = readings.failure_times_s()
    if not times or not readings.survived:
        return math.nan
    # NaN compares as false, so it does not count as settled.
    inside = np.abs(readings.error(quantity)) <= SETTLED[quantity]
    row = settled_after(~inside, readings.row_at(times[-1]))
    return math.nan if row is None else float(readings.time_s[row]) - times[-1]


def _largest(values: np.ndarray) -> float:
    return float(max(values.max(), -values.min())) if len(values) else math.nan


def _rms(values: np.ndarray) -> float:
    """Root mean square. It does not use a dot product, whose last digit depends on the number of BLAS threads."""
    return math.sqrt(float(np.square(values).mean())) if len(values) else math.nan


TABLE = (
    survived,
    altitude_error_max_m, heading_error_max_deg, airspeed_error_max_m_s,
    altitude_error_rms_m, heading_error_rms_deg, airspeed_error_rms_m_s,
    altitude_error_end_m, heading_error_end_deg, airspeed_error_end_m_s,
    altitude_excursion_healthy_m, heading_excursion_healthy_deg, airspeed_excursion_healthy_m_s,
    altitude_excursion_failed_m, heading_excursion_failed_deg, airspeed_excursion_failed_m_s,
    roll_excursion_failed_deg, beta_excursion_failed_deg,
    recovery_s, altitude_recovery_s, heading_recovery_s, airspeed_recovery_s,
)  # fmt: skip

"""Whether the monitor noticed what broke, blamed the right actuator, and gave up axes only when it had to."""

from __future__ import annotations

import math

import numpy as np

from testbed.metrics.flight_view import TRULY_LOST, Readings

NOTICEABLE_S = 2.0
"""A loss that lasts longer than this ought to be flagged."""
_RELEASED = "_released"


def detection_delay_s(readings: Readings) -> float:
    """Longest time from an actuator's loss to its first being flagged [s]; NaN without a detection."""
    first: dict[tuple[str, int], float] = {}
    for event in readings.of_kind("detection"):  # flagged again in one loss is not a new detection
        loss = (event["actuator"], round((event["time_s"] - event["delay_s"]) * 1e3))
        first[loss] = min(first.get(loss, math.inf), event["delay_s"])
    return max(first.values(), default=math.nan)


def missed_detections(readings: Readings) -> float:
    """Times that an actuator was lost (effectiveness 0.1 or less) for over 2 s and not flagged [count]."""
    return float(
        sum(
            not readings.log[f"{actuator}_failed"][start:end].any()
            for actuator in readings.actuators
            for start, end in readings.losses(actuator)
            if (end - start) * readings.step_s > NOTICEABLE_S
        )
    )


def false_alarms(readings: Readings) -> float:
    """Times that an actuator was flagged that was not broken [count]."""
    return float(len(readings.of_kind("false_alarm")))


def wrong_blames(readings: Readings) -> float:
    """False alarms while another actuator was broken: noticed, but the wrong one blamed [count]."""
    alarms = readings.of_kind("false_alarm")
    return float(sum(_another_broken(readings, alarm["actuator"], alarm["time_s"]) for alarm in alarms))


def isolation_fraction(readings: Readings) -> float:
    """Flags that blamed an actuator that was broken, of all flags [0 to 1]; NaN without any."""
    right, wrong = len(readings.of_kind("detection")), len(readings.of_kind("false_alarm"))
    return right / (right + wrong) if right + wrong else math.nan


def goal_switches(readings: Readings) -> float:
    """Times that an axis was given up or taken back [count]; a loss takes one or two, more is chatter."""
    return float(sum(np.count_nonzero(np.diff(flag)) for flag in _released(readings)))


def released_time_s(readings: Readings) -> float:
    """Time flown with at least one axis given up [s]."""
    flags = _released(readings)
    return float(np.count_nonzero(sum(flags[1:], flags[0])) * readings.step_s) if flags else 0.0


def _released(readings: Readings) -> list[np.ndarray]:
    return [column for name, column in readings.log.items() if name.endswith(_RELEASED)]


def _another_broken(readings: Readings, blamed: str, time_s: float) -> bool:
    """Whether any actuator but this one is lost, or in a failure of another type than effectiveness."""
    row = readings.row_at(time_s)
    others = [name for name in readings.actuators if name != blamed]
    if any(readings.log[f"{name}_effectiveness"][row] <= TRULY_LOST for name in others):
        return True
    active: dict[object, bool] = {}
    for event in readings.of_kind("injection"):
        other_kind = event["actuator"] in others and event["type"] != "effectiveness"
        if other_kind and event["time_s"] <= time_s:
            active[event["failure"]] = event["active"]
    return any(active.values())


TABLE = (
    detection_delay_s, missed_detections, false_alarms, wrong_blames, isolation_fraction,
    goal_switches, released_time_s,
)  # fmt: skip

"""How slow a servo and how late a sensor each law withstands, for `section4_bandwidth.py`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from flights import Record, fly_all

Values = dict[str, Any]
TAILS = ("left_ruddervator", "right_ruddervator")
MODEL_LAG, LOSS_S = 30.0, 20.0
"""Lag of a tail's servo by the aircraft's file [rad/s]; time of a loss."""
RATES_ALONE = ("gyro", "accelerometer")
ALL = (*RATES_ALONE, "attitude", "airspeed", "alpha", "beta")
"""All that the measured rates and f_m are made of."""
BASE = """\
name: bandwidth
aircraft: vtail
duration_s: 30
initial: {altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
controller: {type: adaptive_inversion, preset: paper}
"""


def slow(lag: float) -> list[Values]:
    """Failures that make both tails' servos slow from the start."""
    if lag >= MODEL_LAG:
        return []
    return [{"type": "lag", "actuator": name, "at_s": 0, "lag_rad_s": lag} for name in TAILS]


def late(age: float, sensors: Sequence[str] = ALL) -> Values:
    """Sensors of this age [s]."""
    return {"sensors": {name: {"delay_s": age} for name in sensors}}


LAWS: Mapping[str, Values] = {
    "the paper, plain": {"type": "adaptive_inversion", "preset": "paper", "ablate": ["actuator_model"]},
    "the paper, compensated": {"type": "adaptive_inversion", "preset": "paper"},
    "the paper, with the default's released axis": {
        "type": "adaptive_inversion",
        "preset": "paper",
        "released": "auto",
    },
    "default": {"type": "adaptive_inversion"},
    "indi, monitored": {"type": "indi", "monitor": True},
    "l1_inversion": {"type": "l1_inversion"},
}
SLOWER = (30.0, 20.0, 15.0, 12.0, 10.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 2.0)
LIMITED = (200.0, 100.0, 60.0, 40.0, 30.0, 20.0, 15.0, 12.0, 10.0, 8.0, 6.0, 4.0, 3.0, 2.0)
OLDER = (0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1, 0.12, 0.15, 0.2)
ROUTE = {
    "duration_s": 60,
    "command_rates": {"heading_deg_s": 4, "altitude_m_s": 1},
    "commands": [
        {"at_s": 8, "heading_deg": 120}, {"at_s": 22, "altitude_m": 310}, {"at_s": 30, "heading_deg": 90}
    ],
}  # fmt: skip
ALTITUDE_M, HEADING_DEG = 5.0, 15.0


def rate_limited(rate: float) -> list[Values]:
    """Failures that limit the rate of both tails' servos [deg/s] from the start."""
    return [{"type": "rate_limit", "actuator": name, "at_s": 0, "value": rate} for name in TAILS]


def withstood(jobs: int | None) -> dict[str, tuple[float, float, float]]:
    """For each law the slowest servo [rad/s], the lowest rate limit [deg/s] and the oldest sensors [s] with which it holds, and all
    easier ones too."""
    weak = {"type": "effectiveness", "actuator": TAILS[0], "at_s": LOSS_S, "value": 0.3}
    planned = [
        (1, {**ROUTE, "controller": settings, **values})
        for settings in LAWS.values()
        for values in (
            *({"failures": [*slow(lag), weak]} for lag in SLOWER),
            *({"failures": [*rate_limited(rate), weak]} for rate in LIMITED),
            *({"failures": [weak], **late(age)} for age in OLDER),
        )
    ]
    flown = iter(fly_all(BASE, planned, jobs))

    def last(values: Sequence[float]) -> float:
        return last_held(values, [next(flown) for _ in values])

    return {name: (last(SLOWER), last(LIMITED), last(OLDER)) for name in LAWS}


def last_held(values: Sequence[float], records: Sequence[Record]) -> float:
    """The last value before the first that is not held; NaN if the first is not."""
    last = math.nan
    for value, record in zip(values, records, strict=True):
        if not held(record):
            break
        last = value
    return last


def held(record: Record) -> bool:
    """Flown to the end, near its references from the start on, with no healthy actuator flagged."""
    found = record["metrics"]
    near = found["altitude_error_max_m"] <= ALTITUDE_M and found["heading_error_max_deg"] <= HEADING_DEG
    return bool(record["outcome"] == "completed" and near and not found["false_alarms"])

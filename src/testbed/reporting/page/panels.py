"""What the page draws together: groups of panels, each with its series, limits, and the bands of the requirements."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from testbed.common.angles import wrap_deg
from testbed.flight.columns import row_at, stretches
from testbed.flight.flight import Flight
from testbed.flight.recovery import UNITS, tracking_error
from testbed.reporting.story import title
from testbed.scenario.requirement import Requirement

_SHOWN = {"m": "m", "m_s": "m/s", "deg": "deg"}
_LEAST = {"altitude": 0.2, "airspeed": 0.2, "heading": 0.5}  # an axis shows at least this much
_RATES = {"p_dot": "deg_s2", "q_dot": "deg_s2", "r_dot": "deg_s2", "u_dot": "m_s2"}

Panel = dict[str, Any]


def error_columns(log: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Columns that the page adds to the log: the error of each quantity that follows a reference."""
    return {f"{q}_error_{unit}": tracking_error(log, q) for q, unit in UNITS.items()}


def groups(flight: Flight, log: Mapping[str, np.ndarray], estimates: bool) -> list[dict[str, Any]]:
    """{name, title, folded, panels} of each group; a group without panels is left out.

    Args:
        log: columns by name, each [rows], with those of `error_columns`.
        estimates: whether the controller estimated effectiveness.
    """
    made = [
        ("errors", "Errors against the references", False, _errors(flight, log)),
        ("effectiveness", "Effectiveness, true and believed", False, _effectiveness(flight, estimates)),
        ("actuators", "Actuators", False, _actuators(flight)),
        ("attitude", "Attitude and air", False, _attitude(log)),
        ("rates", "Controlled rates", True, _rates(log)),
    ]
    return [
        {"name": name, "title": of, "folded": folded, "panels": panels}
        for name, of, folded, found in made
        if (panels := list(found))
    ]


def _series(*told: tuple[str, str, str]) -> list[dict[str, str]]:
    return [{"column": column, "label": label, "style": style} for column, label, style in told]


def _errors(flight: Flight, log: Mapping[str, np.ndarray]) -> Iterator[Panel]:
    for quantity, unit in UNITS.items():
        column = f"{quantity}_error_{unit}"
        yield {
            "title": f"{quantity} minus reference [{_SHOWN[unit]}]",
            "series": _series((column, "error", "truth")),
            "least": _LEAST[quantity],
            **_verdicts(
                flight, f"{quantity}_{unit}", f"{quantity}_command_{unit}", log[column], log["time_s"]
            ),
        }


def _verdicts(
    flight: Flight, signal: str, reference: str, error: np.ndarray, time: np.ndarray
) -> dict[str, list[dict[str, Any]]]:
    """Bands of the requirements on this error, and the stretches in which it is outside of them."""
    bands, missed = [], []
    for requirement, verdict in zip(flight.scenario.requirements, flight.requirements, strict=False):
        if requirement.signal != signal or requirement.within is None or requirement.of != reference:
            continue
        begin, end = _window(requirement, float(time[-1]))
        limit = requirement.within
        bands.append(
            {"from_s": begin, "until_s": end, "low": -limit, "high": limit, "passed": verdict["passed"]}
        )
        rows = slice(row_at(time, begin), row_at(time, end))
        longest = requirement.never_for_longer_than_s or 0.0
        if requirement.eventually and verdict["passed"]:
            continue
        outside = ~(np.abs(wrap_deg(error[rows]) if signal.startswith("heading") else error[rows]) <= limit)
        for first, last in stretches(outside):
            since, until = time[rows][first], time[rows][last - 1]
            if until - since < longest:
                continue
            missed.append({"from_s": float(since), "until_s": float(until)})
    return {"bands": bands, "missed": missed}


def _window(requirement: Requirement, end_s: float) -> tuple[float, float]:
    return requirement.begins_s, end_s if requirement.until_s is None else requirement.until_s


def _effectiveness(flight: Flight, estimates: bool) -> Iterator[Panel]:
    for name in flight.actuators:
        told = [(f"{name}_effectiveness", "true", "truth")]
        if estimates:
            told.append((f"{name}_effectiveness_estimate", "believed", "belief"))
        yield {"title": title(name), "series": _series(*told), "limits": [0.0, 1.0], "range": [-0.1, 1.2]}


def _actuators(flight: Flight) -> Iterator[Panel]:
    for name, facts in flight.actuators.items():
        yield {
            "title": f"{title(name)} [{facts.get('unit', '')}]",
            "series": _series(
                (f"{name}_position", "position", "truth"), (f"{name}_command", "command", "command")
            ),
            "limits": list(facts.get("limits", ())),
            "least": 0.02 * float(np.ptp(facts["limits"])) if "limits" in facts else 1.0,
        }


def _attitude(log: Mapping[str, np.ndarray]) -> Iterator[Panel]:
    yield {
        "title": "bank, pitch [deg]",
        "series": _series(("roll_deg", "bank", "truth"), ("pitch_deg", "pitch", "second")),
        "least": 2.0,
    }
    yield {
        "title": "sideslip, angle of attack [deg]",
        "series": _series(("beta_deg", "sideslip", "truth"), ("alpha_deg", "angle of attack", "second")),
        "least": 2.0,
    }
    wind = [c for c in ("wind_north_m_s", "wind_east_m_s", "wind_down_m_s") if c in log]
    if wind:
        styles = ("truth", "second", "third")
        told = [(column, column.split("_")[1], style) for column, style in zip(wind, styles, strict=True)]
        yield {"title": "wind over the ground [m/s]", "series": _series(*told), "least": 1.0}


def _rates(log: Mapping[str, np.ndarray]) -> Iterator[Panel]:
    for axis, unit in _RATES.items():
        measured, desired = f"{axis}_{unit}", f"{axis}_desired_{unit}"
        if measured in log and desired in log:
            shown = unit.replace("_s2", "/s2")
            told = _series((measured, "measured", "truth"), (desired, "desired", "command"))
            yield {"title": f"{axis} [{shown}]", "series": told, "least": 1.0}

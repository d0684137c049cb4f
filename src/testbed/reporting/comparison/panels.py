"""The panels of a comparison: each quantity with all flights in it, and their differences from the first."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from testbed.flight.flight import Flight
from testbed.flight.recovery import UNITS, failure_times_s, tracking_error
from testbed.reporting.comparison.differences import minus, on_grid
from testbed.reporting.story import has_estimates, title
from testbed.reporting.sweep_page.curves import unwrapped

_SHOWN = {"m": "m", "m_s": "m/s", "deg": "deg"}
_LEAST = {"altitude": 0.2, "airspeed": 0.2, "heading": 0.5}  # an axis shows at least this much
_ATTITUDE = {
    "roll_deg": "bank [deg]",
    "pitch_deg": "pitch [deg]",
    "beta_deg": "sideslip [deg]",
    "alpha_deg": "angle of attack [deg]",
}
_STYLES = 6  # in sweep.css


def columns_of(flights: Sequence[Flight]) -> dict[str, np.ndarray]:
    """The columns of all flights on one time grid, that of the longest: `1:roll_deg` is of the second flight."""
    longest = max(flights, key=lambda flight: flight.end_time_s)
    time = longest.data[:, longest.columns.index("time_s")]
    log: dict[str, np.ndarray] = {"time_s": time}
    for i, flight in enumerate(flights):
        own = {name: on_grid(time, flight, name) for name in flight.columns if name != "time_s"}
        for quantity, unit in UNITS.items():
            if f"{quantity}_{unit}" in own and f"{quantity}_command_{unit}" in own:
                own[f"{quantity}_error_{unit}"] = _without_jumps(tracking_error(own, quantity), unit)
        log |= {f"{i}:{name}": values for name, values in own.items()}
    for i in range(1, len(flights)):
        for quantity, unit in UNITS.items():
            name = f"{quantity}_{unit}"
            if f"0:{name}" in log and f"{i}:{name}" in log:
                log[f"{i}:{name}-0"] = _without_jumps(minus(log[f"{i}:{name}"], log[f"0:{name}"], name), unit)
    return log


def _without_jumps(values: np.ndarray, unit: str) -> np.ndarray:
    """A difference of headings goes on beyond a half turn; any other is as it is."""
    return unwrapped(values[None])[0] if unit == "deg" else values


def panels(
    flights: Sequence[Flight], names: Sequence[str], log: Mapping[str, np.ndarray]
) -> list[dict[str, Any]]:
    """{name, title, folded, panels} of each group, as `web/src/panels.js` draws them."""
    failures = sorted({t for flight in flights for t in failure_times_s(flight.events)})
    actuators = {name: facts for flight in flights for name, facts in flight.actuators.items()}
    positions = {f"{a}_position": f"{title(a)} [{facts.get('unit', '')}]" for a, facts in actuators.items()}
    made = [
        ("errors", "Errors against the references", False, _errors(names, log)),
        ("differences", f"Differences from {names[0]}", False, _differences(names, log)),
        ("attitude", "Attitude", False, _of_all(_ATTITUDE, names, log, 2.0)),
        ("effectiveness", "Effectiveness: the first flight's true one, and what is believed", False,
         _effectiveness(flights, actuators, names, log)),
        ("positions", "Positions of the actuators", len(flights) > 3,
         _of_all(positions, names, log, 1.0)),
    ]  # fmt: skip
    return [
        {
            "name": name,
            "title": of,
            "folded": folded,
            "panels": [panel | {"failures": failures} for panel in found],
        }
        for name, of, folded, shown in made
        if (found := list(shown))
    ]


def _series(column: str, names: Sequence[str], log: Mapping[str, np.ndarray]) -> list[dict[str, str]]:
    return [
        {"column": f"{i}:{column}", "label": name, "style": f"v{i % _STYLES}"}
        for i, name in enumerate(names)
        if f"{i}:{column}" in log
    ]


def _errors(names: Sequence[str], log: Mapping[str, np.ndarray]) -> Iterator[dict[str, Any]]:
    for quantity, unit in UNITS.items():
        if series := _series(f"{quantity}_error_{unit}", names, log):
            yield {
                "title": f"{quantity} minus reference [{_SHOWN[unit]}]",
                "series": series,
                "least": _LEAST[quantity],
            }


def _differences(names: Sequence[str], log: Mapping[str, np.ndarray]) -> Iterator[dict[str, Any]]:
    for quantity, unit in UNITS.items():
        if series := _series(f"{quantity}_{unit}-0", names, log):
            yield {"title": f"{quantity} [{_SHOWN[unit]}]", "series": series, "least": _LEAST[quantity]}


def _of_all(
    titles: Mapping[str, str], names: Sequence[str], log: Mapping[str, np.ndarray], least: float
) -> Iterator[dict[str, Any]]:
    for column, text in titles.items():
        if series := _series(column, names, log):
            yield {"title": text, "series": series, "least": least}


def _effectiveness(
    flights: Sequence[Flight],
    actuators: Mapping[str, Any],
    names: Sequence[str],
    log: Mapping[str, np.ndarray],
) -> Iterator[dict[str, Any]]:
    known = []
    for flight in flights:
        own = dict(zip(flight.columns, flight.data.T, strict=True))
        known.append(has_estimates(own, flight.actuators))
    for actuator in actuators:
        series = [
            one
            for one in _series(f"{actuator}_effectiveness_estimate", names, log)
            if known[int(one["column"].split(":")[0])]
        ]
        if f"0:{actuator}_effectiveness" in log:
            series.insert(0, {"column": f"0:{actuator}_effectiveness", "label": "true", "style": "truth"})
        if series:
            yield {"title": title(actuator), "series": series, "limits": [0.0, 1.0], "range": [-0.1, 1.2]}

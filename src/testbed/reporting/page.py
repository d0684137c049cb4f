"""What the script of a flight's page is given: the log's columns, the flight's phases, and the panels. It is built from `web/`.

`packed`, which `web/src/data.js` reads, keeps fewer rows, 16 bits a number, deflated. A column that changes little between the rows
that are kept has its value in each of these rows. A dense one, such as a rate in turbulence, has the smallest and the largest
value of each two stretches, in their order, so that its envelope is kept.
"""

from __future__ import annotations

import base64
import math
import zlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from testbed.aircraft.conventional_shape import conventional
from testbed.common.angles import wrap_deg
from testbed.common.signals import Belief
from testbed.flight.breakage import ActiveFailure, failure_times_s, failures_of, noticed_s
from testbed.flight.columns import row_at, stretches
from testbed.flight.flight import Flight
from testbed.reporting.panels import GROUPS, TRACKED, Panel, has_estimates
from testbed.scenario.requirement import Requirement

MOST_ROWS = 5500
"""Rows that are kept, at 110 s of flight 50 each second."""
_DENSE = 2.0  # a column is dense if thinning it takes away more than this factor of its total variation
_NONE = 65535  # stands for no value
_LEVELS, _FEWER = 65534, 4094
"""Largest number that stands for a value; the same in a noisy column, whose last bits cannot be compressed."""
_NOISY_BYTES = 6000  # size of a deflated column from which on it counts as noisy
_REPLAYED = ("north_m", "east_m", "altitude_m", "airspeed_m_s", "roll_deg", "pitch_deg", "heading_deg")
SHOWN = ("errors", "effectiveness", "actuators", "own", "attitude", "rates")
"""The groups of `reporting.panels` on the page of a flight."""
_NOTES = 2  # of a panel that its title has, the last ones
_STYLES = {"position": "truth", "reference": "command"}
"""Styles of the figures that are another on the page."""


def packed(log: Mapping[str, np.ndarray]) -> tuple[dict[str, Any], str]:
    """What the page has to know of the columns: {rows, columns: [{name, low, step}]}; and their values as base64.

    A value is low + step * number; its error is at most half of a 65534th of the column's range, in a noisy column of a 4094th.
    """
    n = len(log["time_s"])
    stride = -(-n // MOST_ROWS)
    kept = np.unique(np.append(np.arange(0, n, stride), n - 1))
    told, words = [], []
    for name, values in log.items():
        few = _thinned(values, kept, stride if name != "time_s" else 1)
        low, step, column = _differences(few, _LEVELS)
        if len(_deflated(column)) > _NOISY_BYTES:
            low, step, column = _differences(few, _FEWER)
        told.append({"name": name, "low": low, "step": step})
        words.append(column)
    data = _deflated(np.concatenate(words))
    return {"rows": len(kept), "columns": told}, base64.b64encode(data).decode("ascii")


def _thinned(values: np.ndarray, kept: np.ndarray, stride: int) -> np.ndarray:
    """The values in the rows `kept`, or the envelope of a dense column."""
    few = values[kept]
    if stride == 1 or not np.all(np.isfinite(values)):
        return few
    if np.abs(np.diff(values)).sum() <= _DENSE * np.abs(np.diff(few)).sum():
        return few
    pairs = len(values) // (2 * stride)
    blocks = values[: pairs * 2 * stride].reshape(pairs, 2 * stride)
    low, high = blocks.argmin(axis=1), blocks.argmax(axis=1)
    first, second = np.minimum(low, high), np.maximum(low, high)
    rows = np.arange(pairs)
    few = few.copy()
    few[0 : 2 * pairs : 2], few[1 : 2 * pairs : 2] = blocks[rows, first], blocks[rows, second]
    return few


def _deflated(words: np.ndarray) -> bytes:
    """16-bit numbers, all low bytes before all high bytes, which deflates better."""
    pairs = words.astype("<u2").view(np.uint8)
    return zlib.compress(pairs[0::2].tobytes() + pairs[1::2].tobytes(), 9)


def _differences(values: np.ndarray, levels: int) -> tuple[float, float, np.ndarray]:
    """(low, step, differences [rows] of 16 bits, modulo 2^16) of a column in which `levels` stands for the largest value."""
    known = np.isfinite(values)
    low = float(values[known].min()) if known.any() else 0.0
    step = (float(values[known].max()) - low) / levels if known.any() else 0.0
    step = step if np.isfinite(step) and step > 0.0 else 1.0
    numbers = np.full(len(values), _NONE, dtype=np.uint16)
    numbers[known] = np.clip(np.round((values[known] - low) / step), 0, levels).astype(np.uint16)
    return low, step, np.diff(numbers, prepend=np.uint16(0))


def can_be_replayed(log: Mapping[str, np.ndarray]) -> bool:
    """Whether a log says where the aircraft was and how it lay, in more than one row: else there is no picture of it."""
    return len(log["time_s"]) > 1 and all(name in log for name in _REPLAYED)


def drawn(flight: Flight, log: Mapping[str, np.ndarray]) -> dict[str, Any]:
    """Phases, failures, actuators, the words of beliefs, and the shape, as `web/src/scene.js` and `timeline.js` read them."""
    planned_s = flight.scenario.duration_s
    return {
        "phases": phases(flight.events, flight.end_time_s, planned_s, noticed_s(flight)),
        "failures_s": failure_times_s(flight.events),
        "actuators": flight.actuators,
        "beliefs": {belief.value: belief.name for belief in Belief},
        "estimates": has_estimates(log, flight.actuators),
        "shape": (flight.shape or conventional()).model_dump(),
    }


def phases(
    events: Sequence[Mapping[str, Any]], end_s: float, planned_s: float, noticed_s: Sequence[float]
) -> list[dict[str, Any]]:
    """{name, from_s, until_s} of each phase, in order, without gaps.

    From a failure on the flight is `unnoticed` until it is noticed, and `flagged` from then on. Once it has left the limits of a
    recovery and come back to stay, it is `recovered`, not before it has noticed if it ever does. A flight that never left them is
    `held` from where it noticed the failure, and `unseen` all the time if it never did: it held without noticing.
    Once a failure ends that was none of these, the phase is what is left of the earlier ones: `flagged` if what is broken was
    noticed, `unnoticed` if not, `healthy` if nothing is broken.
    A flight that ended early is `lost` from its end to where it should have ended (`planned_s`). `noticed_s` are the times at which
    something broken was noticed, in order.
    """
    found: list[tuple[float, str]] = [(0.0, "healthy")]
    failures = failures_of(events)
    for begin, end in pairwise([*failure_times_s(events), end_s]):
        noticed = next((time for time in noticed_s if begin <= time < end), None)
        back = next((e for e in events if e["kind"] == "recovered" and begin <= e["time_s"] < end), None)
        found.append((begin, "unnoticed"))
        if noticed is not None:
            found.append((noticed, "flagged"))
        if back is not None:
            since = back["time_s"] if noticed is None else max(back["time_s"], noticed)
            within = "unseen" if noticed is None else "held"
            found.append((since, "recovered" if back["after_s"] else within))
        if noticed is None and back is None:
            for time in sorted({failure.until_s for failure in failures if begin < failure.until_s < end}):
                name = _phase_of([f for f in failures if f.from_s <= time < f.until_s], events, time)
                found.extend([(time, name)] if name != "unnoticed" else [])
    made = [
        {"name": name, "from_s": begin, "until_s": end}
        for (begin, name), (end, _) in pairwise([*found, (end_s, "")])
        if end > begin
    ]
    if any(event["kind"] == "lost" for event in events):
        made.append({"name": "lost", "from_s": end_s, "until_s": max(planned_s, end_s)})
    return made


def _phase_of(broken: Sequence[ActiveFailure], events: Sequence[Mapping[str, Any]], time_s: float) -> str:
    """The phase that the failures make which are active after this time: `flagged` if each one's actuator was, since it began."""
    if not broken:
        return "healthy"
    flags = [(e["actuator"], e["time_s"]) for e in events if e["kind"] == "detection"]
    noticed = (any(who == f.actuator and f.from_s <= t <= time_s for who, t in flags) for f in broken)
    return "flagged" if all(noticed) else "unnoticed"


def groups(flight: Flight, log: Mapping[str, np.ndarray]) -> list[dict[str, Any]]:
    """{name, title, folded, panels} of each group that has panels, from the columns of `panels.shown_log`."""
    made = [
        group_of(name, GROUPS[name].title, GROUPS[name].folded, GROUPS[name].of(flight)) for name in SHOWN
    ]
    for panel in made[0]["panels"]:
        panel |= _verdicts(flight, panel["series"][0]["column"], log)
    return [group for group in made if group["panels"]]


def group_of(name: str, title: str, folded: bool, panels: Iterable[Panel]) -> dict[str, Any]:
    """A group for the page's script."""
    drawn = [_drawn(panel) for panel in panels]
    return {"name": name, "title": title, "folded": folded, "panels": drawn}


def _drawn(panel: Panel) -> dict[str, Any]:
    notes = (
        f"{words} from {since:.1f} {'s on' if math.isinf(until) else f'to {until:.1f} s'}"
        for since, until, words in panel.notes[-_NOTES:]
    )
    said: dict[str, Any] = {
        "title": "; ".join([panel.heading, *notes]),
        "series": [
            {"column": each.column, "label": each.label, "style": _STYLES.get(each.style, each.style)}
            for each in panel.series
            if each.on_page
        ],
        "least": panel.least,
        "limits": list(panel.levels or ()),
    }
    return said if panel.span is None else {**said, "range": list(panel.span)}


def _verdicts(flight: Flight, column: str, log: Mapping[str, np.ndarray]) -> dict[str, list[dict[str, Any]]]:
    """Bands of the requirements on an error, and the stretches in which it is outside of them."""
    of = next(of for of in TRACKED.values() if of.error == column)
    time, error, end_s = log["time_s"], log[column], float(log["time_s"][-1])
    bands: list[dict[str, Any]] = []
    missed: list[dict[str, Any]] = []
    for requirement, verdict in zip(flight.scenario.requirements, flight.requirements, strict=False):
        limit = requirement.within
        if limit is None or requirement.of != of.reference:
            continue
        begin, end = requirement.begins_s, end_s if requirement.until_s is None else requirement.until_s
        bands.append(
            {"from_s": begin, "until_s": end, "low": -limit, "high": limit, "passed": verdict["passed"]}
        )
        if not (requirement.eventually and verdict["passed"]):
            rows = slice(row_at(time, begin), row_at(time, end))
            missed += _missed(
                requirement, time[rows], wrap_deg(error[rows]) if of is TRACKED["heading"] else error[rows]
            )
    return {"bands": bands, "missed": missed}


def _missed(requirement: Requirement, time: np.ndarray, error: np.ndarray) -> Iterator[dict[str, float]]:
    """The stretches outside of a requirement that are longer than it allows."""
    longest = requirement.never_for_longer_than_s or 0.0
    outside = ~(np.abs(error) <= float(requirement.within or 0.0))
    for first, last in stretches(outside):
        if time[last - 1] - time[first] >= longest:
            yield {"from_s": float(time[first]), "until_s": float(time[last - 1])}

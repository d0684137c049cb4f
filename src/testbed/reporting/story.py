"""A flight told in a few sentences: what failed, what the controller made of it, how far off it got, and how it ended.

Everything is read from the log and the events; nothing here decides anything about the flight.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from testbed.common.signals import BELIEFS, Belief
from testbed.flight.breakage import (
    DWELL_S,
    RECOVERED,
    ActiveFailure,
    broken,
    failures_of,
    noticed_s,
    signs,
    unnoticed,
)
from testbed.flight.columns import beliefs, row_at, row_spacing_s, stays_from, stretches
from testbed.flight.events import LIMITS
from testbed.flight.flight import Flight
from testbed.metrics import Readings, readings
from testbed.reporting.panels import has_estimates
from testbed.reporting.words import believed, broke, joined, title

AXES = {
    "p_dot": "roll acceleration",
    "q_dot": "pitch acceleration",
    "r_dot": "yaw acceleration",
    "u_dot": "forward acceleration",
}
"""What is given up with each axis."""
_TRACKED = {"altitude": "m", "heading": "deg"}
_BANDS = (0.1, 0.3, 1.0, 3.0, 5.0, 10.0, 15.0)  # what "settled within" may say, in m or deg
_LAST = 0.25  # share of the time since a failure from which the final state is judged
_LONGER = 3  # times that is a drift to be seen in
_MOST = 3  # failures that are told one by one
_BRIEF_S = 0.1  # beliefs that were held for less are not told, unless they were the last
_STEEP_DEG = 30.0  # of bank or pitch, worth a word when the aircraft is lost
_STAYED = (
    f"altitude stayed within {RECOVERED['altitude']:g} m and heading within {RECOVERED['heading']:g} deg"
)


def story(flight: Flight) -> list[str]:
    """Lines of one or more sentences each: the failures, the controller, the errors, and the end."""
    view = readings(flight)
    parts = [_failures(flight), _controller(view), _errors(view), _end(flight, view)]
    return [" ".join(sentences) for sentences in map(list, parts) if sentences]


def diagnoses(flight: Flight) -> list[str]:
    """What the controller itself said during the flight, such as why altitude cannot be held."""
    said = [e for e in flight.events if e["kind"] == "diagnosis"]
    return [
        f"controller at {event['time_s']:.1f} s{_held_for(flight, event)}: {event['text']}" for event in said
    ]


def _held_for(flight: Flight, said: Mapping[str, Any]) -> str:
    """How long it flew as it said it would with some actuators failed, where that was too short to be flown so.

    That is while it gave up these and no others: what it takes for reversed is used again, though it is flagged.
    """
    failed, is_of_failed, _ = said["text"].partition(" failed: ")
    names, log = failed.split(", "), flight.signals
    if not is_of_failed or not set(names) <= flight.actuators.keys():
        return ""
    rows = row_at(log["time_s"], said["time_s"])
    so = np.full(len(log["time_s"]) - rows, True)
    for name in flight.actuators:
        used = (
            log[f"{name}_belief"][rows:] == Belief.reversed if f"{name}_belief" in flight.columns else False
        )
        so &= ((log[f"{name}_failed"][rows:] > 0.0) & ~used) == (name in names)
    begins = int(np.argmax(so))
    ends = np.flatnonzero(~so[begins:])
    lasted_s = float(ends[0]) * row_spacing_s(log["time_s"]) if so.any() and len(ends) else 0.0
    return f", for {lasted_s:.1f} s" if 0.0 < lasted_s < DWELL_S else ""


def _failures(flight: Flight) -> Iterator[str]:
    """What was broken, actuators and sensors, in order of time."""
    failures = failures_of(flight.events)
    faults = [e for e in flight.events if e["kind"] == "sensor_fault" and e["active"]]
    if not failures:
        yield "No actuator was broken." if faults else "Nothing was broken."
    told = [(each.from_s, _failure(flight, each)) for each in failures[:_MOST]]
    told += [(event["time_s"], _fault(flight, event)) for event in faults[:_MOST]]
    yield from (sentence for _, sentence in sorted(told, key=lambda each: each[0]))
    for one, several, times in (
        ("failure", "failures", [failure.from_s for failure in failures]),
        ("fault of a sensor", "faults of sensors", [event["time_s"] for event in faults]),
    ):
        if more := times[_MOST:]:
            said = f"{one} followed," if len(more) == 1 else f"{several} followed, the last"
            yield f"{len(more)} more {said} at {more[-1]:.1f} s."


def _failure(flight: Flight, failure: ActiveFailure) -> str:
    why = "had no effect on the aircraft" if failure.stayed else "did not stay as written"
    late = f" This {why}." if failure.verified is False else ""
    until = f", until {failure.until_s:.1f} s" if failure.until_s < math.inf else ""
    return f"At {failure.from_s:.1f} s {broke(flight, failure.number)}{until}.{late}"


def _fault(flight: Flight, begun: Mapping[str, Any]) -> str:
    fault = flight.scenario.sensors.faults[begun["fault"]]
    late = "" if begun["verified"] else " This changed no reading."
    ended = fault.until_s is not None and fault.until_s < flight.end_time_s
    until = f", until {fault.until_s:.1f} s" if ended else ""
    return f"At {begun['time_s']:.1f} s the sensor {title(fault.sensor)} {fault.words()}{until}.{late}"


def _controller(view: Readings) -> Iterator[str]:
    """What the controller noticed and gave up."""
    times, notices, false = view.failure_times_s(), view.of_kind("detection"), view.of_kind("false_alarm")
    if times and not notices:
        yield _unnoticed(view, bool(false))
    for begin_s, end_s in pairwise([*times, float(view.time_s[-1]) + view.step_s]):
        yield from _noticed(view, begin_s, end_s, notices)
    yield from _used_on(view)
    yield from _missed(view)
    yield from _flagged_still(view)
    if has_estimates(view.log, view.actuators):
        yield from _estimates(view)
    if false:
        who = joined(list(dict.fromkeys(f"the {title(e['actuator'])}" for e in false)))
        gave_up = _gave_up([axis for event in false for axis in _released(view, event)])
        first = f"{who}, first at {false[0]['time_s']:.1f} s"
        yield f"It wrongly flagged {joined([first, *gave_up])}."
    yield from _used_again(view)


def _unnoticed(view: Readings, false_alarms: bool) -> str:
    """Why there is no detection."""
    if false_alarms:
        return "The controller flagged nothing while it was broken."
    if any(np.isfinite(view.log[f"{name}_failed"]).any() for name in view.actuators):
        return "The controller flagged nothing as failed."
    return "This controller never flags an actuator."


def _noticed(
    view: Readings, begin_s: float, end_s: float, notices: Sequence[Mapping[str, Any]]
) -> Iterator[str]:
    """The sentence from some failures to the next ones: detections with their delays, axes given up, sideslip."""
    flags = [e for e in notices if begin_s <= e["time_s"] < end_s]
    here = {e["actuator"]: e for e in reversed(flags)}
    if here:
        first = [
            f"{_noticing(view, e, notices)}{_taken_for(view, e, end_s)}" for e in reversed(here.values())
        ]
        gave_up = _gave_up([axis for event in flags for axis in _released(view, event)])
        yield f"The controller {joined([*first, *gave_up, *_sideslip(view, begin_s, end_s)])}."


def _noticing(view: Readings, notice: Mapping[str, Any], notices: Sequence[Mapping[str, Any]]) -> str:
    """What it did when it flagged an actuator: noticed how long after it broke, or flagged again what it had noticed before.

    When it broke is said if more than one failure can be meant.
    """
    name, now_s, delay_s = notice["actuator"], notice["time_s"], notice["delay_s"]
    since_s = now_s - delay_s
    if any(e["actuator"] == name and since_s <= e["time_s"] < now_s for e in notices):
        return f"flagged the {title(name)} again at {now_s:.1f} s"
    began = {f.from_s for f in failures_of(view.events) if f.actuator == name}
    if sum(time <= now_s for time in began) < 2:
        return f"noticed the {title(name)} after {delay_s:.2f} s"
    what = "failure" if any(math.isclose(since_s, time) for time in began) else "loss"
    return f"noticed the {title(name)} {delay_s:.2f} s after its {what} at {since_s:.1f} s"


def _taken_for(view: Readings, notice: Mapping[str, Any], end_s: float) -> str:
    """What the controller took a noticed actuator for, at first and at last before the next failure."""
    name = notice["actuator"]
    mended_s = [
        f.until_s for f in failures_of(view.events) if f.actuator == name and f.from_s <= notice["time_s"]
    ]
    end_s = min(end_s, max((t for t in mended_s if t > notice["time_s"]), default=end_s))
    end, columns = view.row_at(end_s), ("time_s", *(f"{name}_{of}" for of in BELIEFS))
    until = {column: view.log[column][:end] for column in columns if column in view.log}
    own = [b for b in beliefs(until, [name]) if notice["time_s"] <= b["until_s"] and b["belief"] != "works"]
    own = [b for b in own if b["until_s"] - b["time_s"] >= _BRIEF_S or b is own[-1]]
    if not own:
        return ""
    first, last = own[0], own[-1]
    said = f"{believed(last, view.actuators)}{_truly_at(view, last)}"
    if first["belief"] == last["belief"]:
        return f" (as {said})"
    return f" (as {believed(first | {'position': math.nan}, view.actuators)}, from {last['time_s']:.1f} s on as {said})"


def _truly_at(view: Readings, belief: Mapping[str, Any]) -> str:
    """Where an actuator that is taken for held really was, if it was broken then."""
    name, row = belief["actuator"], view.row_at(belief["until_s"])
    if not math.isfinite(belief["position"]) or not broken(view.log, name, view.of_kind("injection"))[row]:
        return ""
    return f", true {view.log[f'{name}_position'][row]:.1f} {view.actuators[name].get('unit', '')}".rstrip()


def _missed(view: Readings) -> Iterator[str]:
    """The failures that were not noticed, where others were."""
    failures = [f for f in failures_of(view.events) if f.actuator and f.verified]
    missed = unnoticed(view.log, failures)
    if 0 < len(missed) < len(failures):
        which = joined([f"of the {title(f.actuator)} at {f.from_s:.1f} s" for f in missed])
        yield f"It did not notice the failure{'s' if missed[1:] else ''} {which}."


def _flagged_still(view: Readings) -> Iterator[str]:
    """The actuators that work again, and are flagged at the end."""
    ends: dict[str, float] = {}
    for failure in failures_of(view.events):
        ends[failure.actuator] = max(ends.get(failure.actuator, 0.0), failure.until_s)
    for name in view.actuators:
        flagged = view.log.get(f"{name}_failed")
        if flagged is not None and ends.get(name, math.inf) < view.time_s[-1] and flagged[-1] > 0.0:
            yield f"At the end it still flagged the {title(name)}, which worked again."


def _used_on(view: Readings) -> Iterator[str]:
    """What the controller took actuators for at last that it never flagged: late, offset, reversed."""
    for name in view.actuators:
        own = signs(view.log, [name])
        if own and not np.any(view.log[f"{name}_failed"] > 0.0):
            last, end_s = own[-1], own[-1]["until_s"]
            until = "on" if end_s >= view.time_s[-1] else f"to {end_s + view.step_s:.1f} s"
            taken = believed(last, view.actuators)
            yield f"It took the {title(name)} for {taken} from {last['time_s']:.1f} s {until}, and used it."


def _used_again(view: Readings) -> Iterator[str]:
    """The actuators whose flags were taken back for more than a moment, each with when it was so last."""
    found: list[tuple[int, str]] = []
    for name in view.actuators:
        flags = stretches(view.log[f"{name}_failed"] > 0.0)
        nexts = [*(first for first, _ in flags), len(view.time_s)][1:]
        for (_, end), until in list(zip(flags, nexts, strict=True))[::-1]:
            if (until - end) * view.step_s >= _BRIEF_S:
                on = "on" if until == len(view.time_s) else f"to {view.time_s[until]:.1f} s"
                found.append((end, f"the {title(name)} again from {view.time_s[end]:.1f} s {on}"))
                break
    if found:
        yield f"It used {joined([said for _, said in sorted(found)])}."


def _gave_up(axes: Sequence[str]) -> list[str]:
    return [f"gave up {joined([AXES[axis] for axis in dict.fromkeys(axes)])}"] if axes else []


def _released(view: Readings, flag: Mapping[str, Any]) -> list[str]:
    """The axes that were released because of a flag: not before it, and for most of the time until the next flag."""
    flags = [e["time_s"] for e in view.events if e["kind"] in ("detection", "false_alarm")]
    until = min((t for t in flags if t > flag["time_s"]), default=math.inf)
    first, end = view.row_at(flag["time_s"]), view.row_at(until)
    fell = np.flatnonzero(~(view.log[f"{flag['actuator']}_failed"][first:end] > 0.0))
    end = first + int(fell[0]) if len(fell) and fell[0] > 0 else end
    return [
        e["axis"]
        for e in view.events
        if e["kind"] == "release"
        and e["axis"] in AXES
        and flag["time_s"] <= e["time_s"] < until
        and (released := view.log[f"{e['axis']}_released"])[first:end].mean() >= 0.5
        and not released[max(first - 1, 0)]
    ]


def _sideslip(view: Readings, begin_s: float, end_s: float) -> list[str]:
    beta = view.log["beta_deg"][_tail(slice(view.row_at(begin_s), view.row_at(end_s)))]
    if end_s - begin_s < DWELL_S or not view.survived or abs(beta.mean()) < max(0.5, 2.0 * beta.std()):
        return []
    return [f"flew on with {abs(beta.mean()):.1f} deg of sideslip"]


def _estimates(view: Readings) -> Iterator[str]:
    """Final estimate of each actuator that ends neither healthy nor lost and was not flagged."""
    for name in view.actuators:
        true, estimate = (view.log[f"{name}_{what}"] for what in ("effectiveness", "effectiveness_estimate"))
        flagged = view.log[f"{name}_failed"][-1] > 0.0
        if 0.1 < true[-1] < 0.95 and np.isfinite(estimate[-1]) and not flagged:
            yield f"At the end it estimated {100 * estimate[-1]:.0f} % for the {title(name)} (true {100 * true[-1]:.0f} %)."


def _errors(view: Readings) -> Iterator[str]:
    """The worst errors since the first failure and, if enough time has passed, whether they settled."""
    first = min(view.first_failed_row(), len(view.time_s) - 1) if view.failure_times_s() else 0
    worst = {q: float(np.abs(view.error(q)[first:]).max()) for q in _TRACKED}
    turned = np.unwrap(view.error("heading")[first:], period=360.0)
    round_ = " (it turned all the way round)" if np.ptp(turned) >= 360.0 else ""
    since = f" since {view.time_s[first]:.1f} s" if first else ""
    yield f"Worst{since}: {_amount(worst['altitude'])} m of altitude, {_amount(worst['heading'])} deg of heading{round_}."
    if view.survived and view.time_s[-1] - view.time_s[first] >= DWELL_S:
        yield from _settled(view, slice(first, len(view.time_s)), worst)
        yield from _speed(view, first)


def _settled(view: Readings, rows: slice, worst: Mapping[str, float]) -> Iterator[str]:
    """From when on each error stayed within the smallest band that it ends in, or how fast it still drifts."""
    bands, others, since = [], [], 0
    for quantity, unit in _TRACKED.items():
        error = view.error(quantity)
        end = float(np.abs(error[_tail(rows)]).max())
        band = next((b for b in _BANDS if end <= b), math.inf)
        if band > RECOVERED[quantity]:
            yield _drift(view, quantity, unit, rows)
        elif worst[quantity] > band:
            since = max(since, stays_from(~(np.abs(error) > band), rows.start, len(error)) or 0)
            bands.append(f"{band:g} {unit}")
        else:
            others.append(f"; {quantity} stayed within {band:g} {unit}")
    if bands:
        yield f"Settled within {' and '.join(bands)} by {math.ceil(view.time_s[since]):.0f} s{''.join(others)}."


def _drift(view: Readings, quantity: str, unit: str, rows: slice) -> str:
    """Where an error that did not settle ended; with its drift, if it also went that way over three times as long as the tail."""
    error, tail = view.error(quantity), _tail(rows)
    long = slice(max(rows.start, tail.stop - _LONGER * (tail.stop - tail.start)), tail.stop)
    (rate, drift, swing, reach), (slow, long_drift, long_swing, _) = (
        _line(view.time_s[part], np.unwrap(error[part], period=360.0) if unit == "deg" else error[part])
        for part in (tail, long)
    )
    end = float(error[rows.stop - 1])
    side = ("too low", "too high") if quantity == "altitude" else ("left of it", "right of it")
    off = f"{quantity.capitalize()} did not settle: {_amount(abs(end))} {unit} {side[end > 0.0]} at the end"
    if swing > drift:
        return f"{off}, swinging over a range of {_amount(reach)} {unit}."
    lasts = slow * rate > 0.0 and long_swing <= 0.5 * long_drift  # less than a whole turn of a swing
    return f"{off}, drifting by {_amount(rate, signed=True)} {unit}/s." if lasts else f"{off}."


def _line(time: np.ndarray, values: np.ndarray) -> tuple[float, float, float, float]:
    """The line through values [rows]: its rate, how far it goes, how widely the values swing about it; and their whole range."""
    rate, start = np.polyfit(time - time[0], values, 1)
    swing = np.ptp(values - start - rate * (time - time[0]))
    return float(rate), float(abs(rate) * (time[-1] - time[0])), float(swing), float(np.ptp(values))


def _speed(view: Readings, first: int) -> Iterator[str]:
    """A lasting difference of airspeed from its reference: a mean, since in turbulence the last row alone says little."""
    error = view.error("airspeed")[_tail(slice(first, len(view.time_s)))]
    mean = float(error.mean()) if len(error) else 0.0
    if abs(mean) >= max(0.5, float(error.std())):
        side = "faster" if mean > 0 else "slower"
        last = len(error) * view.step_s
        yield f"On average it flew {abs(mean):.1f} m/s {side} than its reference in the last {last:.1f} s."


def _end(flight: Flight, view: Readings) -> Iterator[str]:
    """Recovered, held, held without noticing, not recovered, or lost and why."""
    for event in view.of_kind("lost"):
        yield from _lost(flight, event)
    times = view.failure_times_s()
    if not times or not view.survived:
        return
    back = next((e for e in view.of_kind("recovered") if e["time_s"] >= times[-1]), None)
    if back is None:
        yield _not_recovered(view, times[-1])
        return
    latest = [f for f in failures_of(flight.events) if f.from_s == times[-1]]
    unseen = all(time < times[-1] for time in noticed_s(flight)) and unnoticed(view.log, latest) == latest
    if back["after_s"] > 0.0:
        after = f"{back['after_s']:.1f} s after the failure{', which it did not notice' if unseen else ''}"
        yield f"Recovered {after}: within {_within(RECOVERED)} from then on."
    else:
        since = " since the last failure" if times[0] < times[-1] else ""
        held = f"Held{since}, not noticed" if unseen else f"It held{since}"
        yield f"{held}: {_STAYED} of their references."


def _not_recovered(view: Readings, failed_s: float) -> str:
    """The sentence of a flight without a recovery since its last failure, which may only have been too late for one."""
    end = len(view.time_s)
    tail = _tail(slice(min(view.first_failed_row(), end - 1), end))
    if left := [q for q in _TRACKED if np.abs(view.error(q)[tail]).max() > RECOVERED[q]]:
        return f"Not recovered: it did not stay within {_within(left)}."
    first = min(view.row_at(failed_s), end - 1)  # it may be after the last row
    if all(np.abs(view.error(q)[first:]).max() <= RECOVERED[q] for q in _TRACKED):
        return f"So far it held: {_STAYED} of their references, but less than {DWELL_S:g} s were flown after the failure."
    return (
        f"Not recovered: it was back within {_within(RECOVERED)} for less than {DWELL_S:g} s before the end."
    )


def _within(quantities: Iterable[str]) -> str:
    return " and ".join(f"{RECOVERED[q]:g} {_TRACKED[q]} of {q}" for q in quantities)


def _lost(flight: Flight, event: Mapping[str, Any]) -> Iterator[str]:
    reached = [
        f"{LIMITS[m['limit']][0]} of {m['value']:.1f} {m['unit']} passed its limit of {m['allowed']:g} {m['unit']}"
        for m in event["limits"]
    ]
    yield f"Lost at {event['time_s']:.1f} s: {joined(reached) or 'it ' + flight.outcome.sentence}{_attitude(flight, event)}."
    asked = [f"the {title(a['actuator'])} for its {a['stop']}est" for a in event["at_stop"]]
    if asked:
        yield f"In the second before, the controller asked {joined(asked)}."


def _attitude(flight: Flight, event: Mapping[str, Any]) -> str:
    """Bank and pitch at the end, where they are steep; a bank beyond its limit has been said."""
    pitch, roll = (flight.signals[f"{angle}_deg"][-1] for angle in ("pitch", "roll"))
    steep = {f"nose {'up' if pitch > 0 else 'down'}": abs(pitch)}
    if all(m["limit"] != "roll_max_deg" for m in event["limits"]):
        steep = {"of bank": abs(roll), **steep}
    said = [f"{angle:.0f} deg {words}" for words, angle in steep.items() if angle > _STEEP_DEG]
    return f", at {joined(said)}" if said else ""


def _tail(rows: slice) -> slice:
    """The last part of some rows."""
    return slice(rows.stop - math.ceil(_LAST * (rows.stop - rows.start)), rows.stop)


def _amount(value: float, signed: bool = False) -> str:
    """A number rounded to what it means: two digits after the point below 10, none above 100."""
    digits = 2 if abs(value) < 10 else 1 if abs(value) < 100 else 0
    return f"{value:{'+' if signed else ''}.{digits}f}"

"""Words and numbers that all that is shown of flights shares: actuators' names, what broke, each event; and what is not known."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence, Sized
from typing import Any

from testbed.common.units import endings, unit
from testbed.failures import Failure
from testbed.flight.breakage import RECOVERED, stayed
from testbed.flight.flight import Flight

_REMARKS = {True: "", False: " (HAD NO EFFECT)", None: " (not observable)"}
"""Whether a failure did what it should, if not."""


VERDICTS = {False: "NOT MET", None: "not judged", True: "met"}
"""Words for whether a requirement was met, in the order in which tables have them."""


DIGITS = 12
"""Digits that are shown of a SHA-256."""


def title(name: str) -> str:
    """The name of an actuator, or of a way in which a flight ended, in words."""
    return name.replace("_", " ")


def joined(parts: Sequence[str]) -> str:
    """`a, b and c`."""
    return " and ".join(filter(None, (", ".join(parts[:-1]), *parts[-1:])))


def count(number: int, of: str) -> str:
    """`1 flight`, `2 flights`."""
    return f"{number} {of}" if number == 1 else f"{number} {of}s"


def passing(requirements: Sized) -> str:
    """What it is to pass: `all requirements`, or `flown to the end` where nothing more is asked."""
    return "all requirements" if len(requirements) else "flown to the end"


def broke(flight: Flight, number: int) -> str:
    """What the failure of this number in the scenario did: `the left tail kept 20 % of its effect`."""
    failure: Failure = flight.scenario.failures[number]
    name = failure.actuator or ""
    facts = flight.actuators.get(name, {})
    kind = str(facts.get("kind", "servo"))
    unit = str(facts.get("unit", "deg")) if kind == "servo" else "of throttle"
    return f"{f'the {title(name)} ' if name else ''}{failure.words(kind, unit)}"


def units_of(flight: Flight) -> dict[str, str]:
    """{column: unit} of the log; "1" for what has none, such as an effectiveness or a flag."""
    known = {
        f"{name}_{of}": str(facts.get("unit", ""))
        for name, facts in flight.actuators.items()
        for of in ("reference", "command", "position", "believed_position")
    }
    return {column: known.get(column) or unit(column) or "1" for column in flight.columns}


def setting(path: str) -> str:
    """A setting by its dotted path, in words: `failures.0.from_deg` is `failure 1: from [deg]`."""
    said: list[tuple[str, str]] = []
    for part in path.split("."):
        if part.isdigit() and said:
            name, of = said[-1]
            said[-1] = (f"{name.removesuffix('s')} {int(part) + 1}", of)
        else:
            of = unit(part)
            ending = title(next((end for end in endings(of) if part.endswith(end)), "")) if of else ""
            said.append((title(part).removesuffix(ending), of))
    return ": ".join(f"{name} [{of}]" if of else name for name, of in said)


_TAKEN_FOR = {"doubted": "doubtful", "swings": "swinging"}
"""The words for what a controller takes an actuator for, where they are not the names of `signals.Belief`."""


def believed(belief: Mapping[str, Any], actuators: Mapping[str, Mapping[str, Any]]) -> str:
    """What the controller took an actuator for, as `Flight.beliefs` has it: `lost`, `held at 8.1 deg`."""
    word, unit = belief["belief"], actuators[belief["actuator"]].get("unit", "")
    at = f" at {belief['position']:.1f} {unit}".rstrip() if math.isfinite(belief["position"]) else ""
    return _TAKEN_FOR.get(word, word) + at


def kind_of(event: Mapping[str, Any]) -> str:
    """What kind of event it is, in words: what never left its limits was held."""
    kind = str(event["kind"])
    return "held" if kind == "recovered" and not event["after_s"] else title(kind)


def describe(event: Mapping[str, Any], flight: Flight) -> str:
    """An event in words: `left tail kept 20 % of its effect`."""
    kind, who = event["kind"], title(str(event.get("actuator") or ""))
    match kind:
        case "release":
            return f"{event['axis']} released"
        case "diagnosis":
            return str(event["text"])
        case "recovered" if event["after_s"]:
            return f"recovered {event['after_s']:.1f} s after the failure"
        case "recovered":
            return f"held within {RECOVERED['altitude']:g} m and {RECOVERED['heading']:g} deg"
        case "lost":
            return "aircraft lost"
        case "detection":
            return f"{who} flagged after {event['delay_s']:.2f} s"
        case "false_alarm":
            return f"FALSE ALARM: {who}"
        case "injection" if event.get("active", True):
            said = broke(flight, event.get("failure", 0)).removeprefix("the ")
            return said + (
                _REMARKS[event.get("verified", True)] if stayed(event) else " (DID NOT STAY AS WRITTEN)"
            )
        case "injection":
            what = f"{event.get('type', 'failure')} ends"
            return f"{who}: {what}" if who else what
        case "sensor_fault" if event["active"]:
            fault = flight.scenario.sensors.faults[event["fault"]]
            return f"sensor {title(fault.sensor)} {fault.words()}{_REMARKS[event['verified']]}"
        case "sensor_fault":
            return f"sensor {title(event['sensor'])}: {event['type']} ends"
    return f"{kind} {who}".strip()


def number(value: Any, form: str = ".4g", absent: str = "-") -> str:
    """A number as text; `absent` for None, NaN and infinity. A text is returned as it is."""
    if isinstance(value, str):
        return value
    if value is None or not math.isfinite(value):
        return absent
    return str(value) if isinstance(value, int) else format(value, form)


def rounded(value: float | None) -> str:
    """A number with three digits, and 0 for what is only rounding."""
    return "0" if value is not None and abs(value) < 1e-6 else number(value, ".3g")


def interval(known: Mapping[str, Any], of: str = "estimate", form: str = ".3f") -> str:
    """`0.970 (0.957 to 0.979)`: the estimate `known[of]` with its interval, `low` to `high`; each may be None.

    `not judged` where none of the flights was.
    """
    if known.get("not_judged") and not known["n"]:
        return "not judged"
    low, high = number(known["low"], form), number(known["high"], form)
    return f"{number(known[of], form)} ({low} to {high})"

"""Draw one flight of a suite, with dice that `plan` seeds. Nothing here flies; drawn are a scenario's values, by its keys."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np

from testbed.aircraft.description import Aircraft, AnyActuator
from testbed.common.units import GRAVITY_M_S2
from testbed.failures import TABLE as FAILURES
from testbed.failures.base import travel_of
from testbed.studies.benchmark.model import SHARES, Craft, FailureEntry, Suite
from testbed.studies.drawing.distributions import Distribution

Values = dict[str, Any]
Item = TypeVar("Item")
_AXES = ("forward", "right", "down")


@dataclass(frozen=True)
class Drawn:
    """A flight that was drawn: values of the scenario by key, and what it is counted as, {factor: group}."""

    values: Values
    groups: Mapping[str, str]


class Dice:
    """Draws one thing after the other from a stream of random numbers."""

    def __init__(self, random: np.random.Generator) -> None:
        self._random = random

    def of(self, distribution: Distribution) -> Any:
        """A value of a distribution; numbers have six digits, so that a scenario can be read."""
        value = distribution.quantiles(np.array([self._random.random()]))[0]
        return _short(value) if isinstance(value, float) else value

    def happens(self, share: float) -> bool:
        return bool(self._random.random() < share)

    def among(self, items: Sequence[Item], weights: Iterable[float] | None = None) -> Item:
        """One of some things, by their weights."""
        steps = np.cumsum([1.0] * len(items) if weights is None else list(weights))
        place = np.searchsorted(steps, self._random.random() * steps[-1], side="right")
        return items[min(int(place), len(items) - 1)]

    def within(self, low: float, high: float) -> float:
        return _short(low + (high - low) * self._random.random())


def drawn(suite: Suite, dice: Dice, name: str, craft: Craft, aircraft: Aircraft) -> Drawn:
    """A flight of an aircraft that was drawn already. It may turn out to be no valid scenario."""
    airspeed, altitude = dice.within(*craft.airspeed_m_s), dice.within(*craft.altitude_m)
    initial = {"altitude_m": altitude, "airspeed_m_s": airspeed, "heading_deg": dice.within(0.0, 360.0)}
    truth, slow = _truth(suite, dice, name, craft, aircraft)
    failures, families, course = _failures(suite, dice, aircraft)
    weather, atmosphere = _atmosphere(suite, dice, craft, airspeed, failures)
    model = dice.among(list(suite.sensors), suite.sensors.values())
    fault = _sensor_fault(suite, dice) if model != "ideal" else None
    values = {
        "aircraft": truth,
        "duration_s": suite.duration_s,
        "rate_hz": suite.rate_hz,
        "initial": initial,
        **_references(suite, dice, craft, initial),
        "failures": [*slow, *failures],
        "sensors": {"model": model, "faults": [fault]} if fault else model,
        "atmosphere": atmosphere,
        "requirements": suite.limits.requirements(craft.span_m, airspeed),
    }
    groups = {
        "aircraft": name,
        "failures": families,
        "course": course,
        "weather": weather,
        "gust": _gust_group(atmosphere, failures),
        "sensors": f"{model}, one fails" if fault else model,
        "truth": "as designed" if isinstance(truth, str) and not slow else "another than designed",
    }
    return Drawn(values, groups)


def _truth(
    suite: Suite, dice: Dice, name: str, craft: Craft, aircraft: Aircraft
) -> tuple[str | Values, list[Values]]:
    """The scenario's aircraft, and what slows its servos."""
    place, truth = craft.placed(name), suite.truth
    if truth is None or not dice.happens(truth.share):
        return place, []
    changes: Values = {}
    mass, shift, coefficients, slow = (dice.happens(0.5) for _ in range(4))
    if mass and craft.mass_kg is not None:
        changes["mass_kg"] = _short(craft.mass_kg * dice.of(truth.mass))
    if shift and craft.chord_m is not None:
        changes["cg_shift_x_m"] = _short(craft.chord_m * dice.of(truth.cg_shift))
    if coefficients and craft.coefficients:
        changes["coefficients"] = {each: dice.of(truth.coefficient) for each in craft.coefficients}
    servos = [each for each in aircraft.actuators.values() if each.kind == "servo"]
    factor = dice.of(truth.servo)
    held = {f"{each.prefix}/servo-lag-rad_sec": _short(each.lag_rad_s * factor) for each in servos}
    slowed: list[Values] = [{"type": "property", "at_s": 0.0, "set": held}] if slow else []
    return {"name": place, **changes} if changes else place, slowed


def _references(suite: Suite, dice: Dice, craft: Craft, initial: Values) -> Values:
    """Commands and the rates at which their references move."""
    said, now, airspeed = suite.references, dict(initial), initial["airspeed_m_s"]
    commands = []
    for at_s in sorted({round(dice.of(said.at_s), 1) for _ in range(dice.of(said.legs))}):
        change = dice.of(said.altitude_s) * airspeed
        low, high = craft.altitude_m
        if not low <= now["altitude_m"] + change <= high:
            change = -change
        now["altitude_m"] = _short(now["altitude_m"] + change)
        now["heading_deg"] = _short((now["heading_deg"] + dice.of(said.heading_deg)) % 360.0)
        low, high = craft.airspeed_m_s
        now["airspeed_m_s"] = _short(min(max(airspeed * dice.of(said.airspeed), low), high))
        commands.append({"at_s": at_s, **now})
    turn = math.degrees(GRAVITY_M_S2 * math.tan(math.radians(dice.of(said.bank_deg))) / airspeed)
    rates = {"heading_deg_s": _short(turn), "altitude_m_s": _short(dice.of(said.slope) * airspeed)}
    return {"commands": commands, "command_rates": rates}


def _atmosphere(
    suite: Suite, dice: Dice, craft: Craft, airspeed: float, failures: Sequence[Values]
) -> tuple[str, Values]:
    """The weather's name, and the scenario's `atmosphere`."""
    name = dice.among(list(suite.weather), (each.weight for each in suite.weather.values()))
    weather, air = suite.weather[name], Values()
    if weather.turbulence_w20_m_s is not None:
        air["turbulence_w20_m_s"] = _short(craft.w20_factor * dice.of(weather.turbulence_w20_m_s))
    if weather.wind_m_s is not None:
        speed, towards = dice.of(weather.wind_m_s), 2.0 * math.pi * dice.within(0.0, 1.0)
        air["wind_m_s"] = [_short(speed * math.cos(towards)), _short(speed * math.sin(towards)), 0.0]
    gusts = suite.gusts
    if gusts is not None and dice.happens(gusts.share):
        at_s = dice.within(1.0, suite.duration_s - 1.0)
        if dice.happens(gusts.with_failure) and failures:
            at_s = min(each["at_s"] for each in failures)
        velocity = airspeed * dice.of(gusts.magnitude) * (1.0 if dice.happens(0.5) else -1.0)
        axis = dice.among(_AXES)
        vector = [_short(velocity) if each == axis else 0.0 for each in _AXES]
        air["gusts"] = [{"at_s": at_s, "magnitude_m_s": vector, "duration_s": dice.of(gusts.duration_s)}]
    return name, air


def _gust_group(atmosphere: Values, failures: Sequence[Values]) -> str:
    begins = [each["at_s"] for each in atmosphere.get("gusts", ())]
    if not begins:
        return "none"
    first = min((each["at_s"] for each in failures), default=math.inf)
    return "with the first failure" if begins[0] == first else "at any time"


def _sensor_fault(suite: Suite, dice: Dice) -> Values | None:
    """A fault of a sensor; None in the flights that have none."""
    said = suite.sensor_faults
    if said is None or not dice.happens(said.share):
        return None
    entry = dice.among(said.faults, (each.weight for each in said.faults))
    at_s = dice.of(said.at_s)
    fault = {"type": entry.type, "sensor": entry.sensor, "at_s": at_s}
    fault |= {key: dice.of(value) for key, value in entry.values.items()}
    return fault | _end(dice, at_s, said.ends, said.lasts_s, suite.duration_s)


def _failures(suite: Suite, dice: Dice, aircraft: Aircraft) -> tuple[list[Values], str, str]:
    """The failures in order of time; their families; and whether they last, end or come back, or follow each other."""
    said, made, families = suite.failures, list[Values](), list[str]()
    count = 0 if said is None else dice.of(said.count)
    if said is None or not count:
        return [], "none", "healthy"
    at_s, actuator, together = dice.of(said.first_s), None, True
    courses = ["lasting"]
    for n in range(count):
        if n and not dice.happens(said.together):
            at_s, together = _short(at_s + dice.of(said.after_s)), False
        actuator = actuator if n and dice.happens(said.same) else None
        entry, actuator = _who(dice, said.types, aircraft, actuator)
        failure = {"type": entry.type, "at_s": at_s, **_filled(dice, entry, aircraft, actuator)}
        if FAILURES[entry.type].undone:
            failure |= _end(dice, at_s, said.ends, said.lasts_s, suite.duration_s)
        made.append(failure)
        families.append(entry.family)
        if "until_s" in failure:
            courses.append("ends")
            back_s = _short(failure["until_s"] + dice.of(said.back_after_s))
            if dice.happens(said.back) and back_s < suite.duration_s - 1.0:
                courses.append("comes back")
                made.append({**{k: v for k, v in failure.items() if k != "until_s"}, "at_s": back_s})
    how = courses[-1] if count == 1 else f"{count} {'at once' if together else 'in turn'}"
    if count > 1 and len(courses) > 1:
        how += ", some end"
    return made, families[0] if count == 1 else "several", how


def _who(
    dice: Dice, entries: Sequence[FailureEntry], aircraft: Aircraft, actuator: str | None
) -> tuple[FailureEntry, str]:
    """How something fails, and which actuator: the one given, or any that can fail so."""
    fit = [(each, able) for each in entries if (able := [*_able(each, aircraft, actuator)])]
    entry, able = dice.among(fit, (each.weight for each, _ in fit))
    return entry, dice.among(able)


def _able(entry: FailureEntry, aircraft: Aircraft, actuator: str | None) -> Iterator[str]:
    """The actuators that can fail so: of all, or of the one given."""
    for name, each in aircraft.actuators.items():
        wanted = entry.of in (None, "servo" if each.kind == "servo" else "motor")
        if wanted and each.kind in FAILURES[entry.type].kinds and actuator in (None, name):
            yield name


def _filled(dice: Dice, entry: FailureEntry, aircraft: Aircraft, actuator: str) -> Values:
    """The keys of a failure besides its type and its times."""
    values = {key: dice.of(value) for key, value in entry.values.items()}
    if entry.type == "property":
        prefixes = [aircraft.actuators[each].prefix for each in _able(entry, aircraft, None)]
        return {"set": {f"{prefix}/{key}": value for prefix in prefixes for key, value in values.items()}}
    shares = SHARES.get(entry.type, {})
    broken = aircraft.actuators[actuator]
    return {"actuator": actuator} | {
        key: _scaled(broken, shares[key], value) if key in shares else value for key, value in values.items()
    }


def _scaled(actuator: AnyActuator, share_of: str, share: float) -> float:
    """A share of an actuator's travel, rate or lag, in its own unit (see SHARES)."""
    low, high = travel_of(actuator)
    value = {
        "place": low + share * (high - low),
        "travel": share * (high - low),
        "speed": min(share * (high - low), actuator.rate_limit),
        "rate": share * actuator.rate_limit,
        "lag": share * (actuator.lag_rad_s or 0.0),  # only a servo's is asked for, and every servo has one
    }
    return _short(value[share_of])


def _end(dice: Dice, at_s: float, ends: float, lasts_s: Distribution, duration_s: float) -> Values:
    """`until_s` of what ends before the flight does."""
    until_s = _short(at_s + dice.of(lasts_s))
    return {"until_s": until_s} if dice.happens(ends) and until_s < duration_s else {}


def _short(value: float) -> float:
    return float(f"{value:.6g}")

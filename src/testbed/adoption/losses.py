"""What an adopted aircraft keeps of steady flight after the total loss of each actuator, from a trim search on the truth."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass

from testbed.aircraft.description import Aircraft
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import NoTrim, Search, Trim, trim

_HZ = 120.0
_LEVEL, _LEVEL_ANY_SPEED = ("alpha", "beta", "roll"), ("alpha", "beta", "roll", "airspeed")
_ANY_PATH = (*_LEVEL_ANY_SPEED, "path_angle")

_MOST_DEG = {"roll": 30.0, "beta": 15.0, "path_angle": 30.0}
"""A steady flight with more than one of these is none that a pilot or controller could use."""


@dataclass(frozen=True)
class Kept:
    """The steady flight that is left without one actuator: `trim`, or None where none was found."""

    actuator: str
    trim: Trim | None

    def __str__(self) -> str:
        """In words, with airspeed, path, roll and sideslip."""
        if self.trim is None:
            return f"{self.actuator}: no steady flight was found"
        state = self.trim.state
        path = math.degrees(state["path_angle"])
        what = "level flight" if abs(path) < 0.05 else f"a path of {path:.1f} deg"
        angles = ", ".join(f"{name} {math.degrees(state[name]):.1f} deg" for name in ("roll", "beta"))
        return f"{self.actuator}: {what} at {state['airspeed']:.4g} m/s, {angles}"


def losses(aircraft: Aircraft, reference: Trim) -> list[Kept]:
    """Of each actuator, the first steady flight found without it: level if there is one, at the reference airspeed or near it."""
    return [Kept(name, _without(aircraft, i, reference)) for i, name in enumerate(aircraft.actuators)]


def _without(aircraft: Aircraft, i: int, reference: Trim) -> Trim | None:
    """Steady flight: level at the reference airspeed if there is one, else at another, else with any path.

    A search that finds none takes longest. So the one with most freedom is made early: where it finds none, no other would; and
    where it finds one, the others begin there.
    """
    loss = _Loss(Plant(aircraft, _HZ), i, reference)
    powered = _has_propulsion_without(aircraft, i)
    found = loss.roughly(_LEVEL, reference, thorough=False) if powered else None
    if found is None or not _usable(found):
        widest = loss.roughly(_ANY_PATH, reference)
        if widest is None:
            return None
        level = loss.roughly(_LEVEL_ANY_SPEED, widest) if powered else None
        same_speed = loss.roughly(_LEVEL, level, thorough=False) if level else None
        choices = (same_speed, level, widest)
        found = next((each for each in choices if each is not None and _usable(each)), None)
    return None if found is None else loss.exactly(found)


class _Loss:
    """An aircraft without one of its actuators."""

    def __init__(self, plant: Plant, i: int, reference: Trim) -> None:
        self._plant = plant
        self._held = {i: reference.commands[i]}
        plant[f"{list(plant.aircraft.actuators.values())[i].prefix}/effectiveness"] = 0.0

    def roughly(self, angles: tuple[str, ...], near: Trim, thorough: bool = True) -> Trim | None:
        """A steady flight with these angles and speeds free, searched for from one near it, or None."""
        with suppress(NoTrim):
            return self._steady(angles, Search(near).rough(thorough))
        return None

    def exactly(self, near: Trim) -> Trim | None:
        """The same steady flight to the last digit, or None."""
        at, state = self._plant.aircraft.reference, near.state
        path = ("path_angle",) if state["path_angle"] else ()
        speed = ("airspeed",) if path or state["airspeed"] != at.airspeed_m_s else ()
        with suppress(NoTrim):
            return self._steady((*_LEVEL, *speed, *path), Search(near, thorough=False))
        return None

    def _steady(self, angles: Sequence[str], search: Search) -> Trim:
        at = self._plant.aircraft.reference
        return trim(self._plant, at.airspeed_m_s, at.altitude_m, held=self._held, free=angles, search=search)


def _usable(found: Trim) -> bool:
    return all(abs(found.state[name]) < math.radians(most) for name, most in _MOST_DEG.items())


def _has_propulsion_without(aircraft: Aircraft, i: int) -> bool:
    return any(each.kind != "servo" for k, each in enumerate(aircraft.actuators.values()) if k != i)

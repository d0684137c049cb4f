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
_LEVEL = (("alpha", "beta", "roll"), ("alpha", "beta", "roll", "airspeed"))
_ANY_PATH = (("alpha", "beta", "roll", "airspeed", "path_angle"),)

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
    """Steady flight: level at the reference airspeed if there is one, else at another, else with any path."""
    plant = Plant(aircraft, _HZ)
    plant[f"{list(aircraft.actuators.values())[i].prefix}/effectiveness"] = 0.0
    for angles in (_LEVEL if _has_propulsion_without(aircraft, i) else ()) + _ANY_PATH:
        with suppress(NoTrim):
            roughly = _steady(plant, i, reference, angles, Search(reference).rough())
            if all(abs(roughly.state[name]) < math.radians(most) for name, most in _MOST_DEG.items()):
                return _steady(plant, i, reference, angles, Search(roughly))
    return None


def _steady(plant: Plant, i: int, reference: Trim, angles: Sequence[str], search: Search) -> Trim:
    """Steady flight with the lost actuator's command as it was; raises NoTrim."""
    at = plant.aircraft.reference
    held = {i: reference.commands[i]}
    return trim(plant, at.airspeed_m_s, at.altitude_m, held=held, free=angles, search=search)


def _has_propulsion_without(aircraft: Aircraft, i: int) -> bool:
    return any(each.kind != "servo" for k, each in enumerate(aircraft.actuators.values()) if k != i)

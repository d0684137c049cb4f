"""Which functions of an aircraft's XML make a coefficient of its design model.

They are read in JSBSim while the airframe is held at its trim and one state or actuator is a step to either side, as in
`plant.identification`: what a function adds to the axis then is its part of the coefficient.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from testbed.aircraft.description import Aircraft
from testbed.aircraft.model_files.used import ModelFiles
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import settle_at
from testbed.plant.thrust_stand import changed, stand_physics_hz
from testbed.plant.trim import Trim, command_steps, trim

LEAST_SHARE = 0.1
"""Of a coefficient, below which a function is not named."""
REST = "thrust and lever arms"
"""What no function of the axis makes: engines, external reactions, and forces that act beside the centre of gravity."""
_STATES = {"alpha": 0.005, "beta": 0.005, "p": 0.01, "q": 0.01, "r": 0.01}  # rad, rad/s
_STEPS = {"servo": 0.005, "motor": 0.01, "engine": 0.05}  # rad or throttle
_TOTALS = {"Cl": "moments/l-total-lbsft", "Cm": "moments/m-total-lbsft", "Cn": "moments/n-total-lbsft",
           "CX": "forces/fbx-total-lbs"}  # fmt: skip
_AXES = {"Cl": ("ROLL",), "Cm": ("PITCH",), "Cn": ("YAW",), "CX": ("LIFT", "DRAG", "AXIAL", "X")}


class Maker(NamedTuple):
    """A function of the XML, its axis, and its share of a coefficient's size, 0 to 1."""

    function: str
    axis: str
    share: float

    def __str__(self) -> str:
        where = f"{self.function} ({self.axis})" if self.axis else self.function
        return f"{where} {100 * self.share:.0f} %"


def makers(aircraft: Aircraft, names: Iterable[str]) -> dict[str, tuple[Maker, ...]]:
    """Of each coefficient, such as `Cm_alpha` or `Cn_rudder`, the functions that make it, those with the largest part first.

    Raises BadInput where the aircraft cannot be trimmed at its reference.
    """
    wanted = list(names)
    if not wanted:
        return {}
    plant, at = Plant(aircraft, stand_physics_hz(aircraft)), aircraft.reference
    level = trim(plant, at.airspeed_m_s, at.altitude_m)
    functions = {axis: _functions(aircraft, axis) for axes in _AXES.values() for axis in axes}
    return {name: _of(plant, level, functions, *name.split("_", 1)) for name in wanted}


def _functions(aircraft: Aircraft, axis: str) -> list[str]:
    """Names of the functions of an axis; one without a name is no property, and counts as REST."""
    files = ModelFiles(aircraft.folder, aircraft.model)
    section = files.section("aerodynamics")
    axes = [] if section is None else files.children(section, "axis")
    found = [f for each in axes if each.attributes.get("name") == axis for f in each.all("function")]
    return [f.attributes["name"] for f in found if "name" in f.attributes]


def _of(
    plant: Plant, level: Trim, functions: Mapping[str, list[str]], symbol: str, moved: str
) -> tuple[Maker, ...]:
    sides, actuators = list[dict[tuple[str, str], float]](), list(plant.aircraft.actuators)
    state, commands = {"p": 0.0, "q": 0.0, "r": 0.0, **level.state}, level.commands
    if moved in _STATES:
        cases = [({**state, moved: state[moved] + sign * _STATES[moved]}, commands) for sign in (1.0, -1.0)]
    else:
        i, actuator = actuators.index(moved), plant.aircraft.actuators[moved]
        steps = command_steps(actuator, commands[i], _STEPS[actuator.kind])
        cases = [(state, tuple(changed(commands, i, step))) for step in steps]
    for held, given in cases:
        settle_at(plant, held, given)
        sides.append(_read(plant, functions, symbol, held["alpha"]))
    parts = {key: abs(sides[0][key] - sides[1][key]) for key in sides[0]}
    size = sum(parts.values()) or math.inf
    made = [Maker(*key, part / size) for key, part in parts.items() if part >= LEAST_SHARE * size]
    return tuple(sorted(made, key=lambda each: -each.share))


def _read(
    plant: Plant, functions: Mapping[str, list[str]], symbol: str, alpha: float
) -> dict[tuple[str, str], float]:
    """{(function, axis): what it adds to the coefficient's force [lbf] or moment [lbf ft]} in body axes."""
    turned = {"LIFT": math.sin(alpha), "DRAG": -math.cos(alpha), "AXIAL": -1.0}
    made = {
        (name, axis): turned.get(axis, 1.0) * plant[name]
        for axis in _AXES[symbol]
        for name in functions[axis]
    }
    return made | {(REST, ""): plant[_TOTALS[symbol]] - sum(made.values())}

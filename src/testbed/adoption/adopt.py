"""The steps of an adoption, in a process of its own, from a model to an aircraft's folder; `entry` starts it. The last is the card:
trim, modes of motion, input matrix, axes, and what each loss leaves."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from testbed.adoption.draft import Draft, make_draft, refused
from testbed.adoption.files import write_first_flight, write_folder, write_yaml
from testbed.adoption.source import Source
from testbed.aircraft.description import Aircraft, Engine, load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, DesignModel
from testbed.aircraft.model_files.check import model_problems
from testbed.common.signals import RATES
from testbed.common.writing import write
from testbed.controllers.inversion.degraded_aircraft import motion
from testbed.controllers.inversion.modes import enumerate_modes
from testbed.controllers.inversion.steady_flights import jacobian
from testbed.controllers.records import REGULATOR_STATE
from testbed.controllers.released_axes import released_from_start
from testbed.controllers.setup import own_axes, stops
from testbed.inputs.problems import BadInput
from testbed.plant.first_load import trust
from testbed.plant.identification import identify
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import settle_at
from testbed.plant.thrust_stand import stand_physics_hz
from testbed.plant.trim import NoTrim, Search, Trim, command_range, trim

_USE_MAX = 0.7  # of an actuator's travel to either side, in the reference trim
_THROTTLE_MIN, _THROTTLE_MAX = 0.05, 0.92
_STEADY = 1e-4  # of engines, while a condition is sought
_LONGITUDINAL, _LATERAL = ("airspeed", "alpha", "q", "pitch"), ("beta", "p", "r", "roll")
_NO_MOTION = 1e-9
_HZ = 120.0
_LEVEL, _LEVEL_ANY_SPEED = ("alpha", "beta", "roll"), ("alpha", "beta", "roll", "airspeed")
_ANY_PATH = (*_LEVEL_ANY_SPEED, "path_angle")

_MOST_DEG = {"roll": 30.0, "beta": 15.0, "path_angle": 30.0}
"""A steady flight with more than one of these is none that a pilot or controller could use."""


def adopt(source: Source, folder: Path) -> str:
    """Write an aircraft's folder from a model, and return its card; raises BadInput with what is missing, without a folder."""
    with tempfile.TemporaryDirectory() as scratch:
        draft = make_draft(source, Path(scratch) / "bench")
        place = Path(scratch) / folder.name
        write_folder(draft, place)
        write_first_flight(draft, place)
        aircraft, found = _condition(draft, place)
        model = identify(aircraft, near=found)
        model.save(place / DESIGN_MODEL)
        text = card(aircraft, model, found, losses(aircraft, found))
        for file in sorted(each for each in place.rglob("*") if each.is_file()):
            write(folder / file.relative_to(place), file.read_bytes(), within=folder)
    return text


def _condition(draft: Draft, folder: Path) -> tuple[Aircraft, Trim]:
    """Write the YAML with the first condition at which the aircraft flies steadily, well within its travel."""
    why, guess = "", [(0.0, draft.start.thrust_n / len(draft.propulsors)) for _ in draft.propulsors]
    for speed in draft.speeds_m_s():
        write_yaml(draft, folder, speed, guess)
        aircraft = _loaded(folder)
        plant = Plant(aircraft, stand_physics_hz(aircraft))
        try:
            found = trim(plant, speed, draft.size.altitude_m)
        except NoTrim:
            why = why or "no steady flight was found at any airspeed from 1.25 to 3.4 times its stall's"
            continue
        used = _use(aircraft, found)
        if used is None:
            write_yaml(draft, folder, speed, _thrusts(plant, found))
            return _loaded(folder), found
        why = used
    weak = f"its engines' {draft.start.thrust_n:.0f} N at full throttle do not hold it in level flight"
    raise refused(draft.source, why or weak)


def _loaded(folder: Path) -> Aircraft:
    """The aircraft in a folder; this process may load its model, because it is one that may end."""
    aircraft = load_aircraft(str(folder))
    problems = model_problems(aircraft)
    if problems:
        raise BadInput(problems)
    trust(aircraft)
    return aircraft


def _use(aircraft: Aircraft, found: Trim) -> str | None:
    """What a trim uses too much of; None if nothing."""
    for (name, actuator), command in zip(aircraft.actuators.items(), found.commands, strict=True):
        low, high = command_range(actuator)
        if isinstance(actuator, Engine):
            share = (command - low) / (high - low)
            if not _THROTTLE_MIN <= share <= _THROTTLE_MAX:
                return f"steady flight takes {share:.0%} of the throttle of {name}"
        elif not _USE_MAX * low <= command <= _USE_MAX * high:
            return f"steady flight takes {max(command / low, command / high):.0%} of the travel of {name}"
    return None


def _thrusts(plant: Plant, found: Trim) -> list[tuple[float, float]]:
    """Thrust of each engine at its lowest and highest throttle [N]."""
    thrusts = []
    for i, actuator in enumerate(plant.aircraft.actuators.values()):
        if isinstance(actuator, Engine):
            ends = []
            for throttle in actuator.throttle:
                commands = [throttle if j == i else command for j, command in enumerate(found.commands)]
                settle_at(plant, found.state, commands, steady=_STEADY)
                ends.append(plant.position(i))
            thrusts.append((ends[0], ends[1]))
    return thrusts


@dataclass(frozen=True)
class Motion:
    """One mode: its name, and its eigenvalue, with the positive imaginary part of a pair [1/s]."""

    name: str
    eigenvalue: complex

    def __str__(self) -> str:
        """In words: `short period: 4.1 rad/s, damping 0.61`, or a time constant, or the time in which it doubles."""
        real, size = self.eigenvalue.real, abs(self.eigenvalue)
        doubles = f", doubles in {math.log(2.0) / real:.3g} s" if real > _NO_MOTION else ""
        if self.eigenvalue.imag:
            return f"{self.name}: {size:.3g} rad/s, damping {-real / size:.2f}{doubles}"
        if size < _NO_MOTION:
            return f"{self.name}: neutral"
        return f"{self.name}: time constant {1.0 / size:.3g} s{doubles}"


def modes_of(model: DesignModel, path_angle: float = 0.0) -> list[Motion]:
    """The longitudinal and lateral modes about a trim on a path [rad] with surfaces and thrust held, fastest first."""
    return [
        *_named(_eigenvalues(model, _LONGITUDINAL, path_angle), ("short period", "phugoid"), "pitch"),
        *_named(_eigenvalues(model, _LATERAL, path_angle), ("dutch roll", "roll and spiral"), "roll"),
    ]


def _named(eigenvalues: list[complex], pairs: tuple[str, str], first: str) -> list[Motion]:
    """Names: of pairs by their speed; of single ones roll or pitch, then spiral or what is left of a pair that has none."""
    found, waiting = [], list(pairs)
    singles = (
        f"{first} mode",
        "spiral" if first == "roll" else "second pitch mode",
        "third mode",
        "fourth mode",
    )
    alone = iter(singles)
    if first == "pitch" and len(eigenvalues) == 3 and abs(eigenvalues[0].imag) == 0.0:
        waiting = [pairs[1]]
    for value in eigenvalues:
        found.append(Motion(waiting.pop(0) if value.imag and waiting else next(alone), value))
    return found


def _eigenvalues(model: DesignModel, states: tuple[str, ...], path_angle: float) -> list[complex]:
    """One of each pair, fastest first, of the motion in these states with the others at the trim."""
    positions, effectiveness = np.array(model.trim), np.ones(len(model.trim))
    at_trim = {
        "airspeed": model.airspeed_m_s,
        "alpha": model.alpha_rad,
        "pitch": model.alpha_rad + path_angle,
    }
    x = np.array([at_trim.get(name, 0.0) for name in REGULATOR_STATE])
    rows = [REGULATOR_STATE.index(name) for name in states]
    matrix = jacobian(lambda x: motion(model, x, positions, effectiveness), x)[np.ix_(rows, rows)]
    upper = [complex(value) for value in np.linalg.eigvals(matrix) if value.imag >= 0.0]
    return sorted(upper, key=abs, reverse=True)


def card(aircraft: Aircraft, model: DesignModel, level: Trim, kept: Sequence[Kept]) -> str:
    """The whole card, in lines."""
    modes = modes_of(model, level.state["path_angle"])
    sections = [
        _head(aircraft, level),
        ["modes, with surfaces and thrust held", *(f"  {mode}" for mode in modes)],
        _inputs(aircraft, model),
        _axes(aircraft, model),
        ["steady flight of the truth without one actuator", *(f"  without {each}" for each in kept)],
    ]
    return "\n\n".join("\n".join(lines) for lines in sections)


def _head(aircraft: Aircraft, level: Trim) -> list[str]:
    state, at = level.state, aircraft.reference
    path = math.degrees(state["path_angle"])
    flight = "level" if abs(path) < 0.05 else f"path {path:.1f} deg"
    lines = [f"{aircraft.name}: {aircraft.description}"]
    lines += [
        f"trim at {at.airspeed_m_s:.4g} m/s, {at.altitude_m:g} m: {flight}, alpha {math.degrees(state['alpha']):.1f} deg"
    ]
    for (name, actuator), position, command in zip(
        aircraft.actuators.items(), level.positions, level.commands, strict=True
    ):
        share = "" if actuator.kind == "servo" else f" at throttle {command:.2f}"
        lines.append(
            f"  {name:<16} {position:9.4g} {actuator.unit:3} of {actuator.limits[0]:g} to {actuator.limits[1]:g}{share}"
        )
    return lines


def _scale(aircraft: Aircraft) -> np.ndarray:
    """[n] rad or N of one scaled unit of each actuator."""
    units = (math.radians(1.0) if a.kind == "servo" else 1.0 for a in aircraft.actuators.values())
    return np.array([a.scale * unit for a, unit in zip(aircraft.actuators.values(), units, strict=True)])


def _inputs(aircraft: Aircraft, model: DesignModel) -> list[str]:
    """B_m in units of the actuators' scales, and the condition number of its controlled rows."""
    matrix = np.array(model.input_matrix)[:4] * _scale(aircraft)
    rows = [RATES.index(axis) for axis in aircraft.axes]
    lines = ["rates by one `scale` of each actuator [rad/s2; u_dot m/s2]"]
    lines.append("  " + " " * 6 + "".join(f"{name[:12]:>14}" for name in aircraft.actuators))
    for row in rows:
        lines.append(f"  {RATES[row]:<6}" + "".join(f"{value:14.4f}" for value in matrix[row]))
    return [*lines, f"  condition number {np.linalg.cond(matrix[rows]):.3g}"]


def _axes(aircraft: Aircraft, model: DesignModel) -> list[str]:
    """Which axes are given up from the start, for want of authority in gusts, and after each loss."""
    absent = [axis for axis in RATES if axis not in aircraft.axes]
    control = own_axes(aircraft)
    now = released_from_start(model, stops(aircraft), control.priorities)
    lines = ["axes that are given up, because the actuators cannot control them"]
    lines += [f"  always: {', '.join(absent)}, for want of an actuator"] if absent else []
    lines += [f"  from the start: {', '.join(now) or 'none'}"]
    modes = enumerate_modes(model, _scale(aircraft), control, (*absent, *now))
    for i, name in enumerate(aircraft.actuators) if len(aircraft.actuators) > 1 else ():
        more = [axis for axis in modes[(i,)].released if axis not in absent]
        lines += [f"  without {name}: {', '.join(more)}"] if more else []
    return lines


# What is kept of steady flight after the total loss of each actuator, from a trim search on the truth -------------


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
    where it finds one, the others begin there. What is found roughly is then found to the last digit, if engines
    become steady enough for that.
    """
    plant, at = Plant(aircraft, _HZ), aircraft.reference
    actuators = list(aircraft.actuators.values())
    plant[f"{actuators[i].prefix}/effectiveness"] = 0.0

    def steady(angles: tuple[str, ...], search: Search) -> Trim | None:
        with suppress(NoTrim):
            held = {i: reference.commands[i]}
            return trim(plant, at.airspeed_m_s, at.altitude_m, held=held, free=angles, search=search)
        return None

    powered = any(each.kind != "servo" for k, each in enumerate(actuators) if k != i)
    found = steady(_LEVEL, Search(reference).rough(thorough=False)) if powered else None
    if found is None or not _usable(found):
        widest = steady(_ANY_PATH, Search(reference).rough())
        if widest is None:
            return None
        level = steady(_LEVEL_ANY_SPEED, Search(widest).rough()) if powered else None
        same_speed = steady(_LEVEL, Search(level).rough(thorough=False)) if level else None
        choices = (same_speed, level, widest)
        found = next((each for each in choices if each is not None and _usable(each)), None)
    if found is None:
        return None
    path = ("path_angle",) if found.state["path_angle"] else ()
    speed = ("airspeed",) if path or found.state["airspeed"] != at.airspeed_m_s else ()
    return steady((*_LEVEL, *speed, *path), Search(found, thorough=False)) or found


def _usable(found: Trim) -> bool:
    return all(abs(found.state[name]) < math.radians(most) for name, most in _MOST_DEG.items())

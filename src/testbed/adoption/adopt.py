"""The steps of an adoption, in a process of its own, from a model to an aircraft's folder; `entry` starts it."""

from __future__ import annotations

import tempfile
from pathlib import Path

from testbed.adoption.card import card, losses
from testbed.adoption.draft import Draft, make_draft, refused
from testbed.adoption.files import write_first_flight, write_folder, write_yaml
from testbed.adoption.source import Source
from testbed.aircraft.description import Aircraft, Engine, load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL
from testbed.aircraft.model_files.check import model_problems
from testbed.common.writing import write
from testbed.inputs.problems import BadInput
from testbed.plant.first_load import trust
from testbed.plant.identification import identify
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import settle_at
from testbed.plant.thrust_stand import stand_physics_hz
from testbed.plant.trim import NoTrim, Trim, command_range, trim

_USE_MAX = 0.7  # of an actuator's travel to either side, in the reference trim
_THROTTLE_MIN, _THROTTLE_MAX = 0.05, 0.92
_STEADY = 1e-4  # of engines, while a condition is sought


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

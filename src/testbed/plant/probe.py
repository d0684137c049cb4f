"""The process of the first load: `python -m testbed.plant.probe` loads one aircraft, starts it, and answers on stdout.

It reads {folder, aircraft} as JSON from stdin. Each answer is one line of JSON, and the last one counts: {problems} or
{properties}. It is small, may write no file, and is expected to die of some models.
"""

from __future__ import annotations

import json
import math
import os
import re
import sys
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from testbed.aircraft.description import Aircraft
from testbed.aircraft.model_files.check import in_yaml, model_files
from testbed.aircraft.model_files.safe_xml import Element
from testbed.aircraft.model_files.used import model_file
from testbed.inputs.problems import BadInput, Issue, Problem, did_you_mean
from testbed.plant.first_load import LONGEST_S, trust
from testbed.plant.jsbsim import NoProperty, Plant, loaded
from testbed.plant.properties import command_property, position_property

_PHYSICS_HZ = 200.0
_STEPS = 20
"""Steps that the model is run for: late references of functions are looked up in the first."""
_NAME = re.compile(r"[A-Za-z_][\w\[\]/.:-]*$")
_MASSES = ("inertia/mass-slugs", "inertia/ixx-slugs_ft2", "inertia/iyy-slugs_ft2", "inertia/izz-slugs_ft2")
_CHANNEL = "channel"
_WORDS = 300
"""Longest text of JSBSim's that is repeated [characters]."""
_MEMORY_BYTES = 4_000_000_000
"""Most memory of this process; a delay of a thousand million steps would take all that there is."""


def main() -> int:
    """Answer for one aircraft; returns the exit status, 0 if it can be flown."""
    _hold_back()
    request = json.load(sys.stdin)
    aircraft = Aircraft.model_validate(request["aircraft"])
    aircraft._folder = Path(request["folder"])
    trust(aircraft)
    try:
        catalog = _started(aircraft)
    except BadInput as error:
        _say_problems(list(error.problems))
        return 1
    _say({"properties": catalog})
    return 0


def _started(aircraft: Aircraft) -> dict[str, bool]:
    """The properties of the model, after it was loaded and run; raises BadInput with what was found."""
    fdm, _ = loaded(aircraft, _PHYSICS_HZ)
    manager = fdm.get_property_manager()
    missing = list(_missing_blocks(aircraft, manager, fdm))
    if missing:
        raise BadInput(in_yaml(aircraft, missing))
    suspects = list(_missing_references(aircraft, manager, fdm))
    _say_problems(suspects)  # the last words if JSBSim ends the process now
    try:
        plant = Plant(aircraft, _PHYSICS_HZ)
        _run(plant)
    except Exception as error:
        what = f"JSBSim says {str(error).strip() or type(error).__name__}"
        raise BadInput(suspects or [_of_model(aircraft, what[:_WORDS])]) from None
    impossible = [*_impossible(plant), *_missing_later(plant)]
    if impossible:
        raise BadInput(impossible)
    return plant.catalog()


def _names(fdm: Any) -> list[str]:
    return [row.rpartition(" (")[0].strip() for row in fdm.get_property_catalog()]


def _missing_blocks(aircraft: Aircraft, manager: Any, fdm: Any) -> Iterator[Issue]:
    """Actuators whose `prefix` or number leads to no property of the model: what a plant reads and writes of each."""
    for name, actuator in aircraft.actuators.items():
        wanted = [
            command_property(actuator),
            position_property(actuator)[0],
            f"{actuator.prefix}/effectiveness",
        ]
        gone = [each for each in wanted if not manager.hasNode(each)]
        if gone:
            path = ("actuators", name, "prefix")
            yield Issue(path, f"the model has no property {gone[0]}", suggestion=_prefix_like(gone[0], fdm))


def _prefix_like(name: str, fdm: Any) -> str:
    """The prefix of the property that is most like a name, among those that end as it does."""
    _, _, tail = name.rpartition("/")
    return did_you_mean(name, (each for each in _names(fdm) if each.endswith(f"/{tail}"))).removesuffix(
        f"/{tail}"
    )


def _missing_references(aircraft: Aircraft, manager: Any, fdm: Any) -> Iterator[Problem]:
    """Properties that functions and components of the model read, and that no part of it has."""
    names: list[str] = []
    for element in model_files(aircraft).elements():
        for name in _read_by(element):
            if not manager.hasNode(name):
                names = names or _names(fdm)
                yield element.problem(
                    f"no part of the model has a property {name}", suggestion=did_you_mean(name, names)
                )


def _missing_later(plant: Plant) -> Iterator[Problem]:
    """Properties that the model has not been asked for yet, in a branch that was not taken, and does not have.

    Outside the flight control JSBSim ends the process when it comes to such a branch; inside it raises an error.
    """
    for element in model_files(plant.aircraft).elements():
        if _CHANNEL in element.path.split("/"):
            continue
        for name in _read_by(element):
            try:
                plant.getter(name)
            except NoProperty:
                near = did_you_mean(name, plant.catalog())
                yield element.problem(f"no part of the model has a property {name}", suggestion=near)


def _read_by(element: Element) -> Iterator[str]:
    """Names of properties that an element reads; those with `#`, which stands for an engine's number, are left out."""
    if element.tag in ("property", "p", "independentVar", "input") and "value" not in element.attributes:
        name = element.text.lstrip("-")
        if _NAME.match(name) and not element.children:
            yield name


def _run(plant: Plant) -> None:
    """Put the model into flight at its reference, and run it."""
    at = plant.aircraft.reference
    state = {"airspeed": at.airspeed_m_s, "altitude": at.altitude_m, "alpha": 0.0, "pitch": 0.0}
    plant.place(state)
    plant.settle(_STEPS)
    for _ in range(_STEPS):
        plant.step()


def _impossible(plant: Plant) -> Iterator[Problem]:
    """Masses that no body has, and signals that are not finite after the model was run."""
    for name in _MASSES:
        value = plant[name]
        if not (math.isfinite(value) and value > 0):
            yield _of_model(plant.aircraft, f"{name} of the whole model is {value:g}", "more than 0")
    if not all(map(math.isfinite, plant.read())):
        yield _of_model(
            plant.aircraft, f"its state is not finite after {_STEPS} steps at the aircraft's reference"
        )


def _hold_back() -> None:
    """Let this process write no file, leave no core, and end by itself if its parent is gone."""
    try:
        import resource
    except ImportError:  # not on this system
        return
    limits = {
        resource.RLIMIT_FSIZE: 0, resource.RLIMIT_CORE: 0, resource.RLIMIT_CPU: LONGEST_S, resource.RLIMIT_AS: _MEMORY_BYTES,
    }  # fmt: skip
    for what, most in limits.items():
        _, hard = resource.getrlimit(what)
        most = most if hard == resource.RLIM_INFINITY else min(most, hard)
        resource.setrlimit(what, (most, hard))  # only the lower one says by its signal that time was short


def _say(answer: dict[str, Any]) -> None:
    print(json.dumps(answer), flush=True)


def _say_problems(problems: list[Problem]) -> None:
    _say({"problems": [asdict(problem) for problem in problems]})


def _of_model(aircraft: Aircraft, what: str, expected: str = "") -> Problem:
    return Problem(what, str(model_file(aircraft.folder, aircraft.model)), expected=expected)


if __name__ == "__main__":
    status = main()
    sys.stdout.flush()
    os._exit(status)  # at once: JSBSim's destructors are no part of the answer

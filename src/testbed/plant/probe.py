"""The child process of the first load: `python -m testbed.plant.probe` loads one aircraft and starts it.

It is asked with {folder, aircraft}, and answers {problems} or {properties}; the last answer counts. It is small, may write no
file, and is expected to die of some models.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from testbed.aircraft.description import Aircraft
from testbed.aircraft.model_files.check import in_yaml
from testbed.aircraft.model_files.safe_xml import Element
from testbed.aircraft.model_files.used import ModelFiles
from testbed.common import child
from testbed.inputs.problems import BadInput, Issue, Problem, did_you_mean
from testbed.plant.first_load import LONGEST, trust
from testbed.plant.jsbsim import Plant, catalog_of, loaded
from testbed.plant.properties import command_property, position_property

_PHYSICS_HZ = 200.0
_STEPS = 20
"""Steps that the model is run for: late references of functions are looked up in the first."""
_NAME = re.compile(r"[A-Za-z_][\w\[\]/.:-]*$")
_MASSES = ("inertia/mass-slugs", "inertia/ixx-slugs_ft2", "inertia/iyy-slugs_ft2", "inertia/izz-slugs_ft2")
_CHANNEL = "channel"


def _probed(request: dict[str, Any]) -> Iterator[child.Answer]:
    """The answers for one aircraft."""
    aircraft = Aircraft.model_validate(request["aircraft"])
    aircraft._folder = Path(request["folder"])
    trust(aircraft)
    try:
        yield from _started(aircraft)
    except BadInput as error:
        yield _said(list(error.problems))


def _started(aircraft: Aircraft) -> Iterator[child.Answer]:
    """The properties of the model, after it was loaded and run; raises BadInput with what was found."""
    fdm = loaded(aircraft, _PHYSICS_HZ)
    manager = fdm.get_property_manager()
    missing = list(_missing_blocks(aircraft, manager, fdm))
    if missing:
        raise BadInput(in_yaml(aircraft, missing))
    suspects = list(_missing_references(aircraft, manager.hasNode, lambda: catalog_of(fdm)))
    yield _said(suspects)  # the last words if JSBSim ends the process now
    try:
        plant = Plant(aircraft, _PHYSICS_HZ)
        _run(plant)
    except Exception as error:
        what = f"JSBSim says {str(error).strip() or type(error).__name__}"
        raise BadInput(suspects or [Problem(what[:LONGEST], str(aircraft.model_file))]) from None
    impossible = [
        *_impossible(plant),
        *_missing_references(aircraft, plant.has, plant.catalog, control=False),
    ]
    if impossible:
        raise BadInput(impossible)
    yield {"properties": plant.catalog()}


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
    return did_you_mean(name, (each for each in catalog_of(fdm) if each.endswith(f"/{tail}"))).removesuffix(
        f"/{tail}"
    )


def _missing_references(
    aircraft: Aircraft, has: Callable[[str], object], names: Callable[[], Iterable[str]], control: bool = True
) -> Iterator[Problem]:
    """Properties that functions and components of the model read, and that no part of it has.

    Once the model has run there may be more, in branches that were not taken. Outside the flight control JSBSim ends the process
    when it comes to one; inside it raises an error, so `control` False leaves them out.
    """
    known: list[str] = []
    for element in ModelFiles(aircraft.folder, aircraft.model).elements():
        for name in _read_by(element) if control or _CHANNEL not in element.path.split("/") else ():
            if not has(name):
                known = known or list(names())
                near = did_you_mean(name, known)
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
    file = str(plant.aircraft.model_file)
    for name in _MASSES:
        value = plant[name]
        if not (math.isfinite(value) and value > 0):
            yield Problem(f"{name} of the whole model is {value:g}", file, expected="more than 0")
    if not all(map(math.isfinite, plant.read())):
        yield Problem(f"its state is not finite after {_STEPS} steps at the aircraft's reference", file)


def _said(problems: list[Problem]) -> child.Answer:
    return {"problems": [asdict(problem) for problem in problems]}


if __name__ == "__main__":
    child.answer(_probed)

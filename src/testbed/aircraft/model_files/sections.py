"""Whether each section that JSBSim needs is there, and whether engines, propellers and motors are complete."""

from __future__ import annotations

from collections.abc import Iterator

from testbed.aircraft.model_files.safe_xml import Element
from testbed.aircraft.model_files.used import ModelFiles
from testbed.inputs.problems import Problem

_NEEDED = ("metrics", "mass_balance", "ground_reactions", "aerodynamics")
ENGINES = (
    "piston_engine", "turbine_engine", "turboprop_engine", "rocket_engine", "electric_engine", "brushless_dc_motor",
)  # fmt: skip
"""Tags of engines' files."""
_THRUSTERS = ("propeller", "nozzle", "rotor", "direct")
_MOTOR_PARTS = ("maxvolts", "velocityconstant", "coilresistance", "noloadcurrent")
_UNITS = {
    "ixx": ("SLUG*FT2", "KG*M2"), "diameter": ("FT", "IN", "M", "CM"), "maxvolts": ("VOLTS",),
    "coilresistance": ("OHMS",), "noloadcurrent": ("AMPERES",),
}  # fmt: skip
"""Units that JSBSim converts, of parts of propellers and motors."""
_PROPELLER_PARTS, _PROPELLER_TABLES = ("ixx", "diameter", "numblades"), ("C_THRUST", "C_POWER")


def incomplete(files: ModelFiles) -> Iterator[Problem]:
    """Sections that JSBSim needs and that are not there, and engines that it cannot make."""
    root = files.root
    if root is None:
        return
    for tag in _NEEDED:
        if root.first(tag) is None:
            yield root.problem(
                f"has no <{tag}>", "a section that JSBSim needs; it may be empty" * (tag == _NEEDED[2])
            )
    for engine in files.inside("propulsion", "engine"):
        yield from _engine(files, engine)
    yield from _parts(files)


def _engine(files: ModelFiles, engine: Element) -> Iterator[Problem]:
    if not _has_one(files, engine, ENGINES):
        yield engine.problem("has no engine", f"its file, with one of {', '.join(ENGINES)}")
    thrusters = files.children(engine, "thruster")
    if not thrusters:
        yield engine.problem("has no <thruster>", "a propeller, nozzle, rotor or direct thruster")
    elif not _has_one(files, thrusters[0], _THRUSTERS):
        yield thrusters[0].problem("has no thruster", f"its file, with one of {', '.join(_THRUSTERS)}")


def _parts(files: ModelFiles) -> Iterator[Problem]:
    """Parts of propellers and motors that JSBSim takes for granted: without a table it ends the process."""
    for element in files.elements():
        if element.tag == "propeller" and element.children:
            yield from _lacking(element, _PROPELLER_PARTS)
            names = [table.attributes.get("name") for table in element.all("table")]
            for name in _PROPELLER_TABLES:
                if names.count(name) != 1:
                    yield element.problem(f"has {names.count(name)} tables {name}", "one")
        elif element.tag == "brushless_dc_motor":
            yield from _lacking(element, _MOTOR_PARTS)


def _lacking(element: Element, tags: tuple[str, ...]) -> Iterator[Problem]:
    for tag in tags:
        part = element.first(tag)
        if part is None:
            yield element.problem(f"has no <{tag}>", "a number that JSBSim needs")
            continue
        unit = part.attributes.get("unit", "")
        if unit and unit not in _UNITS.get(tag, (unit,)):
            yield part.problem(f"has unit={unit!r}", f"one of {', '.join(_UNITS[tag])}")


def _has_one(files: ModelFiles, element: Element, tags: tuple[str, ...]) -> bool:
    """Whether an element has a child with one of these tags, or names a file that is one. Files that are refused count."""
    if "file" in element.attributes and element not in files.content:
        return True  # what is wrong with the file has been said
    return files.described(element, tags) is not None

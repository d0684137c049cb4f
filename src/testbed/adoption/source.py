"""The model to adopt: found by name or folder, and read into one tree without references to other files; and the files of its
engines."""

from __future__ import annotations

import importlib.util
import os
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from testbed.aircraft.model_files.numbers import finite
from testbed.aircraft.model_files.safe_xml import not_xml, read_bytes
from testbed.common.writing import write_new
from testbed.inputs.problems import BadInput, Problem, did_you_mean

FOREIGN = "fg/"
"""Beginning of the names that replace names with a leading slash, which only FlightGear provides."""

_READ_BY_NAME = ("system", "autopilot", "flight_control", "metrics", "mass_balance", "ground_reactions")
_SECTIONS = (*_READ_BY_NAME, "external_reactions", "buoyant_forces", "propulsion", "aerodynamics")
_DROPPED = ("input", "output")  # of a model or section: JSBSim's sockets and files


@dataclass(frozen=True)
class Source:
    """A JSBSim model as its author wrote it.

    Attributes:
        name: of its folder and its XML file.
        folder: where its files are.
        root: JSBSim's root folder, whose `engine` and `systems` folders models share.
    """

    name: str
    folder: Path
    root: Path

    @property
    def file(self) -> Path:
        """The model's XML."""
        return self.folder / f"{self.name}.xml"


_MODEL = "a model of the jsbsim package or the folder of a model"


def package_root() -> Path:
    """JSBSim's root folder: that of the jsbsim package, with `aircraft`, `engine` and `systems`."""
    found = importlib.util.find_spec("jsbsim")
    if found is None or found.origin is None:
        raise BadInput([Problem("the jsbsim package is not installed")])
    return Path(found.origin).parent


def find_source(model: str, root: Path) -> Source:
    """A model of the jsbsim package, whose root folder is given, by its name, or any model by its folder; raises BadInput."""
    if not model:
        raise BadInput([Problem("no model is given", expected=_MODEL)])
    packaged = root / "aircraft" / model
    named = "/" not in model and model not in (".", "..")
    folder = packaged if named and packaged.is_dir() else Path(os.path.realpath(model))
    source = Source(folder.name, folder, root)
    if source.file.is_file():
        return source
    if folder.is_dir():
        raise BadInput([Problem(f"has no {folder.name}.xml, which JSBSim would load", str(folder))])
    raise BadInput([_unknown(model, root)])


def _unknown(model: str, root: Path) -> Problem:
    """The problem of a model that is nowhere, with the packaged one that was probably meant, or else with all of them."""
    files = (root / "aircraft").glob("*/*.xml")
    names = sorted((file.stem for file in files if file.stem == file.parent.name), key=str.casefold)
    close = did_you_mean(model, names)
    expected = (
        _MODEL if close else f"the folder of a model, or a model of the jsbsim package: {', '.join(names)}"
    )
    return Problem(f"no model {model!r}", expected=expected, suggestion=close)


def read_whole(source: Source) -> ET.Element:
    """The model's `fdm_config` with the contents of every section's `file=` in its place, without `input` and `output`.

    Raises BadInput when a file is missing, is not XML, or is no model.
    """
    tree = parsed(source.file)
    if tree.tag != "fdm_config":
        raise BadInput(
            [Problem(f"is <{tree.tag}>", str(source.file), expected="a JSBSim model, <fdm_config>")]
        )
    _inline(tree, source)
    for element in tree.iter():
        if element.tag in ("fdm_config", *_SECTIONS):  # elsewhere they are those of a component
            for dropped in [each for each in element if each.tag in _DROPPED]:
                element.remove(dropped)
    for element in tree.iter("property"):
        if finite(element.get("value", "0")) is None:
            element.set("value", "0")  # as JSBSim reads it
    declare(tree, dict.fromkeys(sorted(set(_made_local(tree))), 0.0))
    return tree


def parsed(file: Path) -> ET.Element:
    """The root element of a file; raises BadInput when it is not XML."""
    contents = read_bytes(file)
    try:
        return ET.fromstring(contents)
    except ET.ParseError as error:
        raise BadInput([not_xml(file, contents, error.code, error.position[0])]) from None
    except (UnicodeDecodeError, LookupError, ValueError) as error:
        raise BadInput([Problem(f"is not XML: {error}", str(file))]) from None


def _inline(tree: ET.Element, source: Source, levels: int = 2) -> None:
    """Put each section's file in its place, and in that those of its parts. What the element itself holds, such as properties,
    comes before it. Files that those name are left to JSBSim: they may lead in a circle, or double with each level."""
    places = (source.folder, source.folder / "Systems", source.root / "systems")
    for section in [each for each in tree if each.tag in _SECTIONS and each.get("file")]:
        content = parsed(found_in(places, section.attrib.pop("file"), source))
        if "name" in content.attrib:
            section.attrib.setdefault("name", content.attrib["name"])
        section.extend(list(content))
        if levels > 1:
            _inline(section, source, levels - 1)


def found_in(places: Iterable[Path], name: str, source: Source) -> Path:
    """The XML file of this name in the first of these folders that has one; raises BadInput when none does."""
    named = [place / (name if name.endswith(".xml") else f"{name}.xml") for place in places]
    if (file := next(filter(Path.is_file, named), None)) is not None:
        return file
    where = ", ".join(str(file.parent) for file in named)
    raise BadInput([Problem(f"names the file {name}, which is in none of {where}", str(source.file))])


def _made_local(tree: ET.Element) -> Iterator[str]:
    """Replace names with a leading slash by names below `FOREIGN`, and yield each that no component provides."""
    provided = set()
    for element in tree.iter():
        for key in ("name", "value"):
            if element.get(key, "").lstrip("-").startswith("/"):
                element.set(key, _local(element.get(key, "")))
                provided |= {element.get(key, "")} if key == "name" else set()
        text = element.text or ""
        if "/" in text and any(word.lstrip("-").startswith("/") for word in text.split()):
            words = [_local(word) for word in text.split()]
            element.text = " ".join(words)
    names = {
        word.lstrip("-") for each in tree.iter() for word in (each.text or "").split() if FOREIGN in word
    }
    yield from (name for name in names if name.startswith(FOREIGN) and name not in provided)


def _local(word: str) -> str:
    bare = word.lstrip("-")
    return word[: len(word) - len(bare)] + FOREIGN + bare.lstrip("/") if bare.startswith("/") else word


def declare(tree: ET.Element, values: dict[str, float]) -> None:
    """Add properties to the model's first system, which is made for them."""
    if not values:
        return
    system = tree.find("system[@name='adopted: declared']")
    if system is None:
        system = ET.Element("system", {"name": "adopted: declared"})
        first = next(
            (i for i, each in enumerate(tree) if each.tag in ("system", "autopilot", "flight_control")),
            len(tree),
        )
        tree.insert(first, system)
    for name, value in values.items():
        ET.SubElement(system, "property", {"value": f"{value:g}"}).text = name


def engine_files(tree: ET.Element, source: Source) -> list[Path]:
    """Files of all engines and thrusters, each once."""
    named = [each for each in tree.iter() if each.tag in ("engine", "thruster") and each.get("file")]
    return list(dict.fromkeys(file_of(each, source) for each in named))


def write_engines(tree: ET.Element, source: Source, folder: Path) -> None:
    """Copy those files into `Engines` in a model's new folder."""
    (folder / "Engines").mkdir(parents=True)
    for file in engine_files(tree, source):
        write_new(folder / "Engines" / file.name, file.read_bytes())


def file_of(element: ET.Element, source: Source) -> Path:
    """The file of an engine or thruster, where JSBSim looks for it; raises BadInput when there is none."""
    folder = source.folder
    places = (folder / "Engines", folder / "engine", folder, source.root / "engine")
    return found_in(places, element.get("file", ""), source)

"""The files that a JSBSim model uses, found in the aircraft's folder as JSBSim finds them, but never outside it."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator
from functools import partial
from pathlib import Path, PurePosixPath

from testbed.aircraft.model_files.safe_xml import MAX_DEPTH, Element, read_xml
from testbed.inputs.problems import BadInput, Problem, collect, did_you_mean

_ENGINES = ("Engines", "engines", "Engine", "engine")
_SYSTEMS = ("Systems", "systems")
_SECTIONS = (
    "aerodynamics", "autopilot", "buoyant_forces", "external_reactions", "flight_control", "ground_reactions",
    "mass_balance", "metrics",
)  # fmt: skip
FOLDERS: dict[str, tuple[str, ...]] = {
    **dict.fromkeys(_SECTIONS, (".",)),
    "engine": _ENGINES,
    "thruster": _ENGINES,
    "propulsion": (".", *_ENGINES),
    "system": (".", *_SYSTEMS),
}
"""Folders inside the aircraft's in which JSBSim looks for the file of an element, by its tag, in this order."""
ENGINES = (
    "piston_engine", "turbine_engine", "turboprop_engine", "rocket_engine", "electric_engine", "brushless_dc_motor",
)  # fmt: skip
"""Tags of engines' files."""


class ModelFiles:
    """The files of one model: it and every file that it names. What cannot be used becomes a problem, and the rest is read.

    Args:
        folder: of the aircraft.
        model: name of the model: MODEL.xml in the folder.

    Attributes:
        root: the element `fdm_config` of the model itself; None if it cannot be read.
        content: root of the file that each element with `file=` names.
        problems: files that cannot be used.
    """

    def __init__(self, folder: Path, model: str) -> None:
        self.content: dict[Element, Element] = {}
        self.problems: list[Problem] = []
        self._folder, self._read = folder.resolve(), dict[Path, Element | None]()
        file = collect(self.problems, lambda: self._own(model))
        self.root = None if file is None else self._open(file)
        if self.root is not None:
            self._follow(self.root, 0)

    @property
    def roots(self) -> list[Element]:
        """The root of every file, each once."""
        return [root for root in dict.fromkeys((self.root, *self.content.values())) if root is not None]

    def elements(self) -> Iterator[Element]:
        """Every element of every file."""
        for root in self.roots:
            yield from root.walk()

    def children(self, element: Element, tag: str) -> list[Element]:
        """The children with this tag, those in the file that the element names included."""
        there = self.content.get(element)
        return element.all(tag) + (there.all(tag) if there is not None else [])

    def described(self, element: Element, tags: Collection[str]) -> Element | None:
        """What describes an engine or thruster: the root of its file or a child, with one of these tags; None if nothing does."""
        there = self.content.get(element)
        inside = [] if there is None else [there, *there.children]
        return next((each for each in (*inside, *element.children) if each.tag in tags), None)

    def section(self, tag: str) -> Element | None:
        """The section of the model with this tag."""
        return None if self.root is None else self.root.first(tag)

    def inside(self, section: str, tag: str) -> list[Element]:
        """The children with this tag of a section, in the order of JSBSim's numbers: engines of `propulsion`, for example."""
        there = self.section(section)
        return [] if there is None else self.children(there, tag)

    def _own(self, model: str) -> Path:
        """The model's own file; raises BadInput if it is not there or may not be read."""
        file = self._folder / f"{model}.xml"
        if not _inside(self._folder, file) or file.parent != self._folder:
            what = f"the model {model!r} is outside the aircraft's folder"
            yaml = self._folder / f"{self._folder.name}.yaml"
            raise BadInput([Problem(what, str(yaml), path="model", expected="a name without a path")])
        if not os.path.exists(file):  # not `file.exists()`, which raises OSError for a name that is too long
            close = did_you_mean(model, (each.stem for each in sorted(self._folder.glob("*.xml"))))
            raise BadInput([Problem("there is no such file", str(file), suggestion=close)])
        return file

    def _follow(self, root: Element, depth: int) -> None:
        """Read the files that the elements of one file name."""
        for element in root.walk():
            if "file" not in element.attributes:
                continue
            file = collect(self.problems, partial(self._named, element))
            new = file is not None and file not in self._read
            content = None if file is None else self._open(file)
            if content is not None:
                self.content[element] = content
                if new and depth < MAX_DEPTH:
                    self._follow(content, depth + 1)

    def _named(self, element: Element) -> Path:
        """The file that an element names, as JSBSim would find it; raises BadInput if it may not be read."""
        name = element.attributes["file"].strip()
        places = FOLDERS.get(element.tag)
        path = PurePosixPath(name.replace("\\", "/"))
        if places is None:
            raise element.refused("names a file, which JSBSim reads for other elements only")
        if not name or path.is_absolute() or ".." in path.parts:
            what = f"file={name!r} leaves the aircraft's folder"
            raise element.refused(what, "the name of a file inside it")
        suffixed = name if name.endswith(".xml") else f"{name}.xml"
        for place in places:
            file = self._folder / place / suffixed
            if os.path.exists(file):
                if _inside(self._folder, file):
                    return file.resolve()
                what = f"file={name!r} is a link that leaves the aircraft's folder"
                raise element.refused(what, "a file inside it")
        wanted = PurePosixPath(places[0]) / f"{name}.xml"
        known = [each.stem for place in places for each in sorted((self._folder / place).glob("*.xml"))]
        what = f"file={name!r}: there is no such file in the aircraft's folder"
        expected = f"{wanted}; JSBSim's shared folders are not read, `testbed adopt` copies from them"
        raise element.refused(what, expected, did_you_mean(name, known))

    def _open(self, file: Path) -> Element | None:
        if file not in self._read:
            self._read[file] = collect(self.problems, lambda: read_xml(file))
        return self._read[file]


def _inside(folder: Path, file: Path) -> bool:
    """Whether a file, with links followed, is inside a folder."""
    return file.resolve().is_relative_to(folder)

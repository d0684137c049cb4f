"""The files that a JSBSim model uses, found in the aircraft's folder as JSBSim finds them, but never outside it."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from testbed.aircraft.model_files.safe_xml import MAX_DEPTH, Element, read_xml
from testbed.inputs.problems import BadInput, Problem, did_you_mean

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


@dataclass
class ModelFiles:
    """The files of one model.

    Attributes:
        root: the element `fdm_config` of the model itself; None if it cannot be read.
        content: root of the file that each element with `file=` names.
        problems: files that cannot be used.
    """

    root: Element | None = None
    content: dict[Element, Element] = field(default_factory=dict)
    problems: list[Problem] = field(default_factory=list)

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

    def section(self, tag: str) -> Element | None:
        """The section of the model with this tag."""
        return None if self.root is None else self.root.first(tag)


def read_model(folder: Path, model: str) -> ModelFiles:
    """Read the model and every file that it names; what cannot be used becomes a problem, and the rest is read."""
    found = ModelFiles()
    folder = folder.resolve()
    file = folder / f"{model}.xml"
    if not _inside(folder, file) or file.parent != folder:
        what = f"the model {model!r} is outside the aircraft's folder"
        yaml = folder / f"{folder.name}.yaml"
        found.problems.append(Problem(what, str(yaml), path="model", expected="a name without a path"))
    elif not os.path.exists(file):  # not `file.exists()`, which raises OSError for a name that is too long
        close = did_you_mean(model, (each.stem for each in sorted(folder.glob("*.xml"))))
        found.problems.append(Problem("there is no such file", str(file), suggestion=close))
    else:
        _Walk(folder, found).begin(file)
    return found


class _Walk:
    def __init__(self, folder: Path, found: ModelFiles) -> None:
        self._folder, self._found, self._read = folder, found, dict[Path, Element | None]()

    def begin(self, file: Path) -> None:
        root = self._open(file)
        self._found.root = root
        if root is not None:
            self._follow(root, 0)

    def _follow(self, root: Element, depth: int) -> None:
        """Read the files that the elements of one file name."""
        for element in root.walk():
            if "file" not in element.attributes:
                continue
            file = self._named(element)
            new = file is not None and file not in self._read
            content = None if file is None else self._open(file)
            if content is not None:
                self._found.content[element] = content
                if new and depth < MAX_DEPTH:
                    self._follow(content, depth + 1)

    def _named(self, element: Element) -> Path | None:
        """The file that an element names, as JSBSim would find it; None, with a problem, if it may not be read."""
        name, problems = element.attributes["file"].strip(), self._found.problems
        places = FOLDERS.get(element.tag)
        path = PurePosixPath(name.replace("\\", "/"))
        if places is None:
            problems.append(element.problem("names a file, which JSBSim reads for other elements only"))
            return None
        if not name or path.is_absolute() or ".." in path.parts:
            problems.append(
                element.problem(f"file={name!r} leaves the aircraft's folder", "the name of a file inside it")
            )
            return None
        suffixed = name if name.endswith(".xml") else f"{name}.xml"
        for place in places:
            file = self._folder / place / suffixed
            if os.path.exists(file):
                if _inside(self._folder, file):
                    return file.resolve()
                problems.append(
                    element.problem(
                        f"file={name!r} is a link that leaves the aircraft's folder", "a file inside it"
                    )
                )
                return None
        problems.append(self._missing(element, name, places))
        return None

    def _missing(self, element: Element, name: str, places: tuple[str, ...]) -> Problem:
        wanted = PurePosixPath(places[0]) / f"{name}.xml"
        known = [each.stem for place in places for each in sorted((self._folder / place).glob("*.xml"))]
        what = f"file={name!r}: there is no such file in the aircraft's folder"
        expected = f"{wanted}; JSBSim's shared folders are not read, `testbed adopt` copies from them"
        return element.problem(what, expected, did_you_mean(name, known))

    def _open(self, file: Path) -> Element | None:
        if file not in self._read:
            try:
                self._read[file] = read_xml(file)
            except BadInput as error:
                self._found.problems += error.problems
                self._read[file] = None
        return self._read[file]


def _inside(folder: Path, file: Path) -> bool:
    """Whether a file, with links followed, is inside a folder."""
    return file.resolve().is_relative_to(folder)

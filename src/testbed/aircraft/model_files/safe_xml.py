"""Read XML of unknown origin: elements with their lines; no entities, nothing fetched, nothing larger or deeper than a model is."""

from __future__ import annotations

import stat
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from xml.parsers import expat
from xml.parsers.expat import errors

from testbed.inputs.problems import BadInput, Problem

MAX_BYTES = 8_000_000
"""Largest file that is read; the largest of JSBSim's own models has 124 kB."""
MAX_DEPTH = 100
"""Most elements inside each other. JSBSim reads functions recursively."""
MAX_ELEMENTS = 200_000
MAX_ATTRIBUTES = 1000
"""Most attributes of one element, of which JSBSim reads fewer than ten."""


@dataclass(frozen=True, eq=False)
class Element:
    """One XML element: its place, attributes, the text directly inside it, and its children."""

    tag: str
    file: Path
    line: int
    parent: Element | None = field(repr=False)
    attributes: dict[str, str] = field(default_factory=dict)
    children: list[Element] = field(default_factory=list, repr=False)
    pieces: list[str] = field(default_factory=list, repr=False)

    @property
    def text(self) -> str:
        """The text directly inside, without surrounding space."""
        return "".join(self.pieces).strip()

    @property
    def path(self) -> str:
        """The tags from the root to this element: `fdm_config/propulsion/engine`."""
        return f"{self.parent.path}/{self.tag}" if self.parent else self.tag

    def all(self, tag: str) -> list[Element]:
        """The children with this tag."""
        return [child for child in self.children if child.tag == tag]

    def first(self, tag: str) -> Element | None:
        """The first child with this tag, which is the one that JSBSim reads; None if there is none."""
        return next((child for child in self.children if child.tag == tag), None)

    def walk(self) -> Iterator[Element]:
        """This element and all inside it, in the order of the file."""
        waiting = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting += reversed(element.children)

    def problem(self, what: str, expected: str = "", suggestion: str = "") -> Problem:
        """A problem with this element, with its file and line."""
        return Problem(what, str(self.file), self.line, self.path, expected, suggestion)

    def refused(self, what: str, expected: str = "", suggestion: str = "") -> BadInput:
        """The exception of this one problem."""
        return BadInput([self.problem(what, expected, suggestion)])


def read_xml(file: Path) -> Element:
    """The root element of an XML file; raises BadInput with the line when it is not safe, well-formed XML."""
    return _Reader(file).read(read_bytes(file))


def read_bytes(file: Path) -> bytes:
    """The contents of a regular file of at most MAX_BYTES; raises BadInput when it is anything else."""
    try:
        seen = file.stat()
        if not stat.S_ISREG(seen.st_mode):
            raise BadInput([Problem("is no regular file", str(file), expected="a file of the JSBSim model")])
        if seen.st_size > MAX_BYTES:
            what = f"has {seen.st_size / 1e6:.1f} MB"
            raise BadInput([Problem(what, str(file), expected=f"at most {MAX_BYTES / 1e6:g} MB")])
        return file.read_bytes()
    except OSError as error:
        raise BadInput([Problem(f"cannot be read: {error.strerror}", str(file))]) from None


def not_xml(file: Path, contents: bytes, code: int, line: int) -> Problem:
    """The problem of a file that expat cannot read: that it was cut off, or else what expat says."""
    what = errors.messages[code]
    if what in _CUT and b"<" in contents:
        what = "the file ends too early"
    return Problem(f"is not XML: {what}", str(file), line)


_CUT = (
    errors.XML_ERROR_NO_ELEMENTS, errors.XML_ERROR_UNCLOSED_TOKEN, errors.XML_ERROR_PARTIAL_CHAR,
    errors.XML_ERROR_UNCLOSED_CDATA_SECTION,
)  # fmt: skip


class _Reader:
    """Builds the elements of one file from what the parser reports."""

    def __init__(self, file: Path) -> None:
        self._file, self._open, self._count = file, list[Element](), 0
        self._root: Element | None = None
        self._parser: Any = expat.ParserCreate()
        self._parser.buffer_text = True
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = lambda tag: self._open.pop()
        self._parser.CharacterDataHandler = lambda text: self._open[-1].pieces.append(text)
        self._parser.StartDoctypeDeclHandler = self._doctype

    def read(self, contents: bytes) -> Element:
        try:
            self._parser.Parse(contents, True)
        except expat.ExpatError as error:
            raise BadInput([not_xml(self._file, contents, error.code, error.lineno)]) from None
        except (LookupError, ValueError) as error:  # an encoding that Python does not have
            raise BadInput([Problem(f"is not XML: {error}", str(self._file), 1)]) from None
        assert self._root is not None  # else the parser has complained
        return self._root

    def _refuse(self, what: str, expected: str) -> BadInput:
        return BadInput([Problem(what, str(self._file), self._parser.CurrentLineNumber, expected=expected)])

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self._count += 1
        if self._count > MAX_ELEMENTS:
            raise self._refuse("has more elements", f"at most {MAX_ELEMENTS}")
        if len(attributes) > MAX_ATTRIBUTES:
            raise self._refuse(f"has {len(attributes)} attributes", f"at most {MAX_ATTRIBUTES}")
        if len(self._open) >= MAX_DEPTH:
            raise self._refuse("is nested deeper", f"at most {MAX_DEPTH} elements inside each other")
        parent = self._open[-1] if self._open else None
        element = Element(tag, self._file, self._parser.CurrentLineNumber, parent, attributes)
        if parent is None:
            self._root = element
        else:
            parent.children.append(element)
        self._open.append(element)

    def _doctype(self, *_: object) -> None:
        raise self._refuse(
            "has a document type declaration (<!DOCTYPE), which can define entities",
            "plain elements, with the entities written out; `testbed adopt` does so",
        )

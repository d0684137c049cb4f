"""Numbers in a model: every one that JSBSim takes for granted is there, is a number, and is finite."""

from __future__ import annotations

import math
from collections.abc import Iterator

from testbed.aircraft.model_files.safe_xml import Element
from testbed.aircraft.model_files.used import ModelFiles
from testbed.inputs.problems import Problem

_NUMERIC = frozenset(
    [
        "value",
        "v",
        "x",
        "y",
        "z",
        "roll",
        "pitch",
        "yaw",
        "radius",
        "ixx",
        "iyy",
        "izz",
        "ixy",
        "ixz",
        "iyz",
        "emptywt",
        "weight",
        "wingarea",
        "wingspan",
        "chord",
        "htailarea",
        "htailarm",
        "vtailarea",
        "vtailarm",
        "diameter",
        "numblades",
        "maxvolts",
        "velocityconstant",
        "coilresistance",
        "noloadcurrent",
        "power",
        "capacity",
        "contents",
        "milthrust",
        "maxthrust",
        "bypassratio",
    ]
)
"""Elements that hold one number and nothing else."""
_AXES = ("x", "y", "z")


def finite(text: str) -> float | None:
    """A number as JSBSim reads it, or None if the text is not one, or not finite."""
    try:
        number = float(text) if "_" not in text else math.nan
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def not_numbers(files: ModelFiles) -> Iterator[Problem]:
    """Values and entries of tables that are not finite numbers, in any of the files."""
    for element in files.elements():
        if element.tag == "tableData":
            yield from _table(element)
        elif _holds_a_number(element) and finite(element.text) is None:
            what = f"is {element.text!r}" if element.text else "is empty"
            yield element.problem(what[:100], "a finite number")
        if "value" in element.attributes and element.tag == "property":
            value = element.attributes["value"].strip()
            if value and finite(value) is None:
                yield element.problem(f"has value={value!r}"[:100], "a finite number")


def _holds_a_number(element: Element) -> bool:
    """Whether an element must be one number: by its tag, and without elements or a reference to a property inside."""
    return element.tag in _NUMERIC and not element.children and not _in_a_note(element)


def _in_a_note(element: Element) -> bool:
    inside: Element | None = element
    while inside is not None:
        if inside.tag in ("fileheader", "documentation", "description"):
            return True
        inside = inside.parent
    return False


def _table(element: Element) -> Iterator[Problem]:
    for offset, row in enumerate(element.text.splitlines()):
        for word in row.split():
            if finite(word) is None:
                yield element.problem(f"has {word!r} in row {offset + 1}"[:100], "finite numbers")
                return

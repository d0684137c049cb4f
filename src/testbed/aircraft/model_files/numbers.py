"""Numbers in a model: every one that JSBSim takes for granted is there, is a number, and is finite."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from testbed.aircraft.model_files.safe_xml import Element
from testbed.aircraft.model_files.used import ModelFiles
from testbed.inputs.problems import Problem

_NUMERIC = frozenset((
    "value", "v", "x", "y", "z", "roll", "pitch", "yaw", "radius", "ixx", "iyy", "izz", "ixy", "ixz", "iyz",
    "emptywt", "weight", "wingarea", "wingspan", "chord", "htailarea", "htailarm", "vtailarea", "vtailarm", "diameter",
    "numblades", "maxvolts", "velocityconstant", "coilresistance", "noloadcurrent", "power", "capacity", "contents",
    "milthrust", "maxthrust", "bypassratio",
))  # fmt: skip
"""Elements that hold one number and nothing else."""
_LONGEST_TABLE = 1_000_000
"""Most characters of one table; JSBSim takes longer than a first load may for seven million, and its own models have 10 000."""


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
    """A table of numbers, whose rows are of equal length and whose keys ascend: JSBSim can end the process for others."""
    if len(element.text) > _LONGEST_TABLE:
        yield element.problem(f"has {len(element.text)} characters", f"at most {_LONGEST_TABLE}")
        return
    rows = [row.split() for row in element.text.splitlines() if row.strip()]
    for i, row in enumerate(rows):
        for word in row:
            if finite(word) is None:
                yield element.problem(f"has {word!r} in row {i + 1}"[:100], "finite numbers")
                return
    yield from _shape(element, [[float(word) for word in row] for row in rows])


def _shape(element: Element, rows: list[list[float]]) -> Iterator[Problem]:
    lengths = [len(row) for row in rows]
    if not rows:
        return  # JSBSim says so itself, if it uses the table
    if set(lengths) == {2}:
        yield from _ascending(element, [row[0] for row in rows], "the keys of its rows")
    elif set(lengths[1:]) == {lengths[0] + 1}:
        yield from _ascending(element, rows[0], "the keys of its columns")
        yield from _ascending(element, [row[0] for row in rows[1:]], "the keys of its rows")
    else:
        i = next((i for i, length in enumerate(lengths[1:], 2) if length != lengths[1]), 1)
        yield element.problem(f"has {lengths[i - 1]} numbers in row {i}", "as many as in the other rows")


def _ascending(element: Element, keys: list[float], which: str) -> Iterator[Problem]:
    for before, after in pairwise(keys):
        if after <= before:
            yield element.problem(f"has {after:g} after {before:g} in {which}", "ascending keys")
            return

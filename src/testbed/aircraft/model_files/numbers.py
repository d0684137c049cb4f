"""Numbers in a model: every one that JSBSim takes for granted is there, is a number, and is finite; and a body can have its mass
and its moments of inertia."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

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
_NOTES = frozenset(("fileheader", "documentation", "description"))
_LONGEST_TABLE = 1_000_000
"""Most characters of one table; JSBSim takes longer than a first load may for seven million, and its own models have 10 000."""


_MOMENTS, _PRODUCTS = ("ixx", "iyy", "izz"), ("ixy", "ixz", "iyz")
TRIANGLE_EXCESS_MAX = 2.0
"""Largest ratio of a principal moment of inertia to the sum of the other two.

For a rigid body it is at most 1. Ten of JSBSim's own 63 models exceed that, the Concorde by most, 1.65: they are flown all
the same, so the limit is beyond them and catches a moment in the wrong unit or place.
"""


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
    return element.tag in _NUMERIC and not element.children and _NOTES.isdisjoint(element.path.split("/"))


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


# Mass and moments of inertia --------------------------------------------------------------------------------------


def unphysical(files: ModelFiles) -> Iterator[Problem]:
    """Masses that are not positive and inertias that no body has."""
    section = files.section("mass_balance")
    if section is None:
        return
    weights, points = files.children(section, "emptywt"), files.children(section, "pointmass")
    if not weights and not points:
        yield section.problem("has no <emptywt>", "the weight of the empty aircraft")
    for weight in weights:
        yield from _more_than_zero(weight)
    for point in points:
        for weight in point.all("weight"):
            value = finite(weight.text)
            if value is not None and value < 0:
                yield weight.problem(f"is {value:g}", "0 or more")
    yield from _inertia(files, section)


def _more_than_zero(element: Element) -> Iterator[Problem]:
    value = finite(element.text)
    if value is not None and value <= 0:
        yield element.problem(f"is {value:g}", "more than 0")


def _inertia(files: ModelFiles, section: Element) -> Iterator[Problem]:
    moments = [files.children(section, name) for name in _MOMENTS]
    for name, found in zip(_MOMENTS, moments, strict=True):
        if not found and not files.children(section, "pointmass"):
            yield section.problem(f"has no <{name}>", "the moment of inertia about each axis")
        for moment in found:
            yield from _more_than_zero(moment)
    values = [_number(files, section, name) for name in (*_MOMENTS, *_PRODUCTS)]
    if all(values[:3]) and min(values[:3]) > 0:
        yield from _tensor(section, *values)


def _number(files: ModelFiles, section: Element, name: str) -> float:
    found = files.children(section, name)
    return (finite(found[0].text) if found else None) or 0.0


def _tensor(
    section: Element, xx: float, yy: float, zz: float, xy: float, xz: float, yz: float
) -> Iterator[Problem]:
    least, middle, most = np.linalg.eigvalsh([[xx, -xy, -xz], [-xy, yy, -yz], [-xz, -yz, zz]])
    if least <= 0:
        what = "has products of inertia that are too large: a principal moment of inertia is not positive"
        yield section.problem(what, "the inertia of a body")
    elif most > TRIANGLE_EXCESS_MAX * (least + middle):
        what = (
            f"has a principal moment of inertia {most / (least + middle):.3g} times the sum of the other two"
        )
        yield section.problem(what, f"at most {TRIANGLE_EXCESS_MAX:g} times (a rigid body has at most 1)")

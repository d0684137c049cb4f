"""Whether a body can have the mass and the moments of inertia of a model."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from testbed.aircraft.model_files.numbers import finite
from testbed.aircraft.model_files.safe_xml import Element
from testbed.aircraft.model_files.used import ModelFiles
from testbed.inputs.problems import Problem

_MOMENTS, _PRODUCTS = ("ixx", "iyy", "izz"), ("ixy", "ixz", "iyz")
TRIANGLE_EXCESS_MAX = 2.0
"""Largest ratio of a principal moment of inertia to the sum of the other two.

For a rigid body it is at most 1. Ten of JSBSim's own 63 models exceed that, the Concorde by most, 1.65: they are flown all
the same, so the limit is beyond them and catches a moment in the wrong unit or place.
"""


def unphysical(files: ModelFiles) -> Iterator[Problem]:
    """Masses that are not positive and inertias that no body has."""
    section = files.section("mass_balance")
    if section is None:
        return
    weights = files.children(section, "emptywt")
    if not weights and not point_masses(files):
        yield section.problem("has no <emptywt>", "the weight of the empty aircraft")
    for weight in weights:
        yield from _more_than_zero(weight)
    for point in files.children(section, "pointmass"):
        for weight in point.all("weight"):
            value = finite(weight.text)
            if value is not None and value < 0:
                yield weight.problem(f"is {value:g}", "0 or more")
    yield from _inertia(files, section)


def point_masses(files: ModelFiles) -> int:
    """Number of point masses of the model."""
    section = files.section("mass_balance")
    return 0 if section is None else len(files.children(section, "pointmass"))


def _more_than_zero(element: Element) -> Iterator[Problem]:
    value = finite(element.text)
    if value is not None and value <= 0:
        yield element.problem(f"is {value:g}", "more than 0")


def _inertia(files: ModelFiles, section: Element) -> Iterator[Problem]:
    moments = [files.children(section, name) for name in _MOMENTS]
    for name, found in zip(_MOMENTS, moments, strict=True):
        if not found and not point_masses(files):
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

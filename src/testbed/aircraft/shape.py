"""What an aircraft looks like: surfaces, bodies and propulsors, for the replay of a flight. Nothing that flies depends on it.

Positions are in body axes from about the centre of gravity: x forward, y right, z down [m].
"""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from testbed.common.cache import Cache
from testbed.inputs.base import Number, Positive, Settings, Text
from testbed.inputs.input_file import read_text
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import parsed

Point = tuple[Number, Number, Number]
Sense = Literal[-1, 1]
FILE = "shape.yaml"
"""The file in an aircraft's folder."""


class Panel(Settings):
    """A flat quadrilateral. That of an actuator turns about its first edge, with the trailing edge going down when positive."""

    points: tuple[Point, Point, Point, Point]
    """Corners in order; for a moving surface the hinge's inner and outer end, then the trailing edge from outside in."""
    actuator: Text | None = None
    """The actuator that moves it."""
    sense: Sense = 1
    """-1 if a positive position moves the trailing edge up; of an upright surface, to the right."""


class Body(Settings):
    """A fuselage, boom or nacelle: a cylinder with round ends."""

    start: Point
    end: Point
    radius_m: Positive


class Propulsor(Settings):
    """A propeller's disc or an engine's exit, with the arrow of its thrust."""

    at: Point
    diameter_m: Positive
    actuator: Text | None = None
    jet: Literal[True] | None = None
    """Whether it has no blades."""


class Shape(Settings):
    """The aircraft's looks."""

    span_m: Positive = 2.0
    panels: tuple[Panel, ...] = ()
    bodies: tuple[Body, ...] = ()
    propulsors: tuple[Propulsor, ...] = ()


_shapes: Cache[Shape] = Cache(16)
"""By a file's text; kept, because reading YAML takes a third of the time of a short flight."""


def load_shape(folder: Path) -> Shape | None:
    """The shape in an aircraft's folder; None if it has none. Raises BadInput with everything wrong in the file."""
    file = folder / FILE
    if not file.is_file():
        return None
    text = read_text(file)
    return _shapes.get((text, file), lambda: validated(Shape, parsed(text, str(file))))

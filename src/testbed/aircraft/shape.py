"""What an aircraft looks like: surfaces, bodies and propulsors, for the replay of a flight. Nothing that flies depends on it.

Positions are in body axes from about the centre of gravity: x forward, y right, z down [m].
"""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Literal

from testbed.inputs.base import Number, Positive, Settings, Text
from testbed.inputs.input_file import read_text
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import parsed

Point = tuple[Number, Number, Number]
FILE = "shape.yaml"
"""The file in an aircraft's folder."""
_UNKNOWN_SPAN_M = 2.0


class Panel(Settings):
    """A flat quadrilateral. That of an actuator turns about its first edge, with the trailing edge going down when positive."""

    points: tuple[Point, Point, Point, Point]
    """Corners in order; for a moving surface the hinge's inner and outer end, then the trailing edge from outside in."""
    actuator: Text | None = None
    """The actuator that moves it."""
    sense: Literal[-1, 1] = 1
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


class Shape(Settings):
    """The aircraft's looks."""

    span_m: Positive = 2.0
    panels: tuple[Panel, ...] = ()
    bodies: tuple[Body, ...] = ()
    propulsors: tuple[Propulsor, ...] = ()


def load_shape(folder: Path) -> Shape | None:
    """The shape in an aircraft's folder; None if it has none. Raises BadInput with everything wrong in the file."""
    file = folder / FILE
    return _shape(read_text(file), str(file)) if file.is_file() else None


@lru_cache(maxsize=16)
def _shape(text: str, file: str) -> Shape:
    """The shape that a file's text describes; kept, because reading YAML takes a third of the time of a short flight."""
    return validated(Shape, parsed(text, file))


def generic(span_m: float = 0.0) -> Shape:
    """A conventional aircraft of this span, on which nothing moves; of 2 m if the span is not known."""
    span_m = span_m or _UNKNOWN_SPAN_M
    half, c = 0.5 * span_m, 0.16 * span_m

    def flat(x: float, y: float, depth: float, width: float, z: float = 0.0) -> Panel:
        return Panel(points=((x, y, z), (x, y + width, z), (x - depth, y + width, z), (x - depth, y, z)))

    fin_x, nose, tail = -0.42 * span_m, 0.3 * span_m, -0.55 * span_m
    fin = ((fin_x, 0, 0), (fin_x - 0.05 * span_m, 0, -0.16 * span_m), (tail, 0, -0.16 * span_m), (tail, 0, 0))
    return Shape(
        span_m=span_m,
        panels=(
            flat(0.3 * c, 0.0, c, half),
            flat(0.3 * c, -half, c, half),
            flat(fin_x, -0.18 * span_m, 0.6 * c, 0.36 * span_m),
            Panel(points=fin),
        ),
        bodies=(Body(start=(nose, 0, 0), end=(tail, 0, 0), radius_m=0.035 * span_m),),
    )

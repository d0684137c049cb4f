"""What an aircraft without a shape file looks like: a conventional one of its span, whose surfaces are drawn by what they do.

A surface that mostly rolls is an aileron, one that mostly pitches an elevator, one that mostly yaws a rudder. With `left` or
`right` in its name it is on that side only. So a replay shows every surface move the way that it acts, but not where it really is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache

import numpy as np

from testbed.aircraft.design_model import DesignModel
from testbed.aircraft.shape import Body, Panel, Point, Propulsor, Sense, Shape

_UNKNOWN_SPAN_M = 2.0
_SOME = 0.1
"""Least share of the most effective surface's effect that a surface is drawn for: flaps and air brakes are not."""
_CHORD, _HINGE = 0.16, 0.72  # of the wing: over span, and place of the hinge over the chord
_LEFT, _RIGHT = -1.0, 1.0
_OTHER: dict[Sense, Sense] = {1: -1, -1: 1}
_ROLES = ((1, "elevator"), (0, "aileron"), (2, "rudder"))
"""Row of the input matrix and role, the first of those that a surface has alike: both of a pair of ruddervators are elevators."""

Roles = Mapping[str, tuple[str, Sense]]
"""Role and sense (see `Panel`) of surfaces by their names."""


@lru_cache(maxsize=16)
def drawn_by_effect(model: DesignModel, span_m: float = 0.0) -> Shape:
    """The shape of the aircraft of a design model; of 2 m if the span is not known."""
    motors = [name for name, kind in zip(model.actuators, model.kinds, strict=True) if kind != "servo"]
    return conventional(span_m, roles(model), motors)


def conventional(span_m: float = 0.0, surfaces: Roles = {}, motors: Sequence[str] = ()) -> Shape:  # noqa: B006 - read only
    """A conventional aircraft; what none of these surfaces moves stands still."""
    span_m = span_m or _UNKNOWN_SPAN_M
    panels = [*_wing(surfaces), *_tail(surfaces)]
    scaled = [panel.model_copy(update={"points": _times(span_m, panel.points)}) for panel in panels]
    nose, tail = _times(span_m, ((0.3, 0, 0), (-0.55, 0, 0)))
    return Shape(
        span_m=span_m,
        panels=tuple(scaled),
        bodies=(Body(start=nose, end=tail, radius_m=0.035 * span_m),),
        propulsors=tuple(_propulsors(motors, span_m)),
    )


def _times(span_m: float, points: tuple[Point, ...]) -> tuple[Point, ...]:
    return tuple((x * span_m, y * span_m, z * span_m) for x, y, z in points)


def roles(model: DesignModel) -> Roles:
    """The role of each surface: its largest effect, as a share of the largest of any surface."""
    surfaces = [j for j, kind in enumerate(model.kinds) if kind == "servo"]
    effect = np.array(model.input_matrix)[:3, surfaces]
    share = np.abs(effect) / np.maximum(np.abs(effect).max(axis=1, keepdims=True, initial=0.0), 1e-12)
    found: dict[str, tuple[str, Sense]] = {}
    for k, j in enumerate(surfaces):
        row, role = max(_ROLES, key=lambda each: round(share[each[0], k], 2))
        if share[row, k] > _SOME:
            found[model.actuators[j]] = role, 1 if effect[row, k] < 0.0 else -1
    return found


def _moving(surfaces: Roles, role: str, side: float = 0.0) -> tuple[str | None, Sense]:
    """The surface with this role on a side, and its sense; None if there is none."""
    for name, (own, sense) in surfaces.items():
        other = {_LEFT: "right", _RIGHT: "left"}.get(side, "\0")
        if own == role and other not in name:
            return name, sense
    return None, 1


def _wing(surfaces: Roles) -> Iterator[Panel]:
    """A trailing edge down on the left wing rolls right: the sense of an aileron is that of the right wing."""
    front, back = 0.3 * _CHORD, -0.7 * _CHORD
    hinge = front - _HINGE * _CHORD
    for side in (_LEFT, _RIGHT):
        name, sense = _moving(surfaces, "aileron", side)
        yield _flat(front, hinge, 0.0, 0.5 * side)
        yield _flat(hinge, back, 0.0, 0.25 * side)
        yield _flat(hinge, back, 0.25 * side, 0.5 * side, name, sense if side == _RIGHT else _OTHER[sense])


def _tail(surfaces: Roles) -> Iterator[Panel]:
    front, hinge, back = -0.42, -0.49, -0.53
    for side in (_LEFT, _RIGHT):
        yield _flat(front, hinge, 0.0, 0.18 * side)
        yield _flat(hinge, back, 0.0, 0.18 * side, *_moving(surfaces, "elevator", side))
    top, sweep = -0.16, -0.04
    name, sense = _moving(surfaces, "rudder")
    yield Panel(points=((front, 0, 0), (front + sweep, 0, top), (hinge, 0, top), (hinge, 0, 0)))
    yield Panel(
        points=((hinge, 0, 0), (hinge, 0, top), (back - 0.01, 0, top), (back, 0, 0)),
        actuator=name,
        sense=sense,
    )


def _flat(
    front: float, back: float, inner: float, outer: float, name: str | None = None, sense: Sense = 1
) -> Panel:
    corners = ((front, inner, 0), (front, outer, 0), (back, outer, 0), (back, inner, 0))
    return Panel(points=corners, actuator=name, sense=sense)


def _propulsors(motors: Sequence[str], span_m: float) -> Iterator[Propulsor]:
    """One at the nose; several along the wing in their order, which is from left to right in JSBSim's models."""
    for name, y in zip(motors, np.linspace(-0.2, 0.2, len(motors)), strict=True):
        at = (0.31, 0.0, 0.0) if len(motors) == 1 else (0.08, float(y), 0.02)
        yield Propulsor(at=_times(span_m, (at,))[0], diameter_m=0.12 * span_m, actuator=name)

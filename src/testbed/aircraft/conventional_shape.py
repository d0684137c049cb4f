"""What an aircraft without a shape file looks like: drawn by the sizes in its JSBSim files, its surfaces by what they do.

A surface that mostly rolls is an aileron, one that mostly pitches an elevator, one that mostly yaws a rudder. With `left` or
`right` in its name it is on that side only. So a replay shows every surface move the way that it acts, but not where it really is.
Proportions that no file has (chord of a tail, radius of a fuselage) are those of common aircraft.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from testbed.aircraft.description import Aircraft
from testbed.aircraft.design_model import DesignModel
from testbed.aircraft.looks import Looks, Power, looks_of
from testbed.aircraft.shape import Body, Panel, Point, Propulsor, Sense, Shape, load_shape

_UNKNOWN_SPAN_M = 2.0
_SOME = 0.1
"""Least share of the most effective surface's effect that a surface is drawn for: flaps and air brakes are not."""
_ASPECT = 7.0  # of a wing whose area is not known
_TAIL, _FIN = 0.17, 0.1  # of the wing's area, where a tail's is not known
_HINGE = 0.72  # place of a hinge over the chord
_SWEEP = 0.5  # how far back the tip of a jet's wing is, over the half span
_SLENDER, _WIDEST = 0.052, 0.075  # radius of a fuselage over its length, and at most over the span
_LEFT, _RIGHT = -1.0, 1.0
_OTHER: dict[Sense, Sense] = {1: -1, -1: 1}
_ROLES = ((1, "elevator"), (0, "aileron"), (2, "rudder"))
"""Row of the input matrix and role, the first of those that a surface has alike: both of a pair of ruddervators are elevators."""

Roles = Mapping[str, tuple[str, Sense]]
"""Role and sense (see `Panel`) of surfaces by their names."""


def shape_of(aircraft: Aircraft, model: DesignModel, span_m: float | None = None) -> Shape:
    """The shape in the aircraft's folder, or else one that is drawn by the effects of its actuators and the looks of its model."""
    span_m = model.span_m if span_m is None else span_m
    return load_shape(aircraft.folder) or drawn_by_effect(model, span_m or 0.0, looks_of(aircraft))


@lru_cache(maxsize=16)
def drawn_by_effect(model: DesignModel, span_m: float = 0.0, looks: Looks | None = None) -> Shape:
    """The shape of the aircraft of a design model; of 2 m if the span is not known."""
    motors = [name for name, kind in zip(model.actuators, model.kinds, strict=True) if kind != "servo"]
    return conventional(span_m, roles(model), motors, looks)


def conventional(
    span_m: float = 0.0,
    surfaces: Roles = {},  # noqa: B006 - read only
    motors: Sequence[str] = (),
    looks: Looks | None = None,
) -> Shape:
    """An aircraft of these looks, by default a common one; what none of these surfaces moves stands still."""
    span_m = span_m or _UNKNOWN_SPAN_M
    seen = replace(looks or Looks(span_m), span_m=span_m)
    if not seen.engines:
        seen = replace(seen, engines=tuple(_along_the_wing(motors, span_m)))
    frame = _Frame(seen)
    panels = (*_wings(frame, surfaces), *_tail(frame, surfaces))
    return Shape(
        span_m=span_m,
        panels=tuple(each.model_copy(update={"points": tuple(map(_point, each.points))}) for each in panels),
        bodies=tuple(_bodies(frame)),
        propulsors=tuple(_propulsor(power, frame) for power in seen.engines),
    )


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


class _Frame:
    """The lines of an aircraft: its looks, its nose and tail, the radius of its fuselage, whether it is swept as jets are, and
    whether its wing carries the elevators, where the files give it no tail."""

    def __init__(self, looks: Looks) -> None:
        span, ahead = looks.span_m, [looks.eye_x_m + 0.06 * looks.span_m if looks.eye_x_m else 0.0]
        along = [x for x, *_ in looks.contacts]
        middle = [e.at[0] for e in looks.engines if abs(e.at[1]) < 0.05 * span]
        arm = looks.tail_arm_m if looks.tail_arm_m > 0.2 * span else 0.0
        self.looks = looks
        self.nose_m = max(*ahead, *along, *middle, 0.0) or 0.3 * span
        self.tail_m = min(*along, -1.15 * arm, 0.0) or -0.55 * span
        self.radius_m = min(_SLENDER * (self.nose_m - self.tail_m), _WIDEST * span)
        self.swept = any(not e.diameter_m for e in looks.engines)
        self.tailless = bool(looks.wing_m2) and looks.tail_m2 < 0.01 * looks.wing_m2
        self.wing_m2 = looks.wing_m2 or span**2 / _ASPECT

    @property
    def levels(self) -> list[float]:
        """How far down each wing is [m], the uppermost first: where its ends are, else where the air acts."""
        reach = 1.05 * self.radius_m
        found: list[float] = []
        for _, _, z in sorted(self.looks.tips, key=lambda tip: tip[2]):
            if not found or z - found[-1] > 2.0 * self.radius_m:
                found.append(z)
        return found if len(found) > 1 else [min(max((found or [self.looks.wing_at[2]])[0], -reach), reach)]


def _wings(frame: _Frame, surfaces: Roles) -> Iterator[Panel]:
    """A trailing edge down on the left wing rolls right: the sense of an aileron is that of the right wing."""
    levels = frame.levels
    wing = _wing(frame, len(levels))
    for i, z in enumerate(levels):
        for side in (_LEFT, _RIGHT):
            name, sense = _moving(surfaces, "aileron", side) if i == 0 else (None, 1)
            flap = _moving(surfaces, "elevator", side) if frame.tailless else (None, 1)
            yield wing.strip((0.0, 1.0), (0.0, _HINGE), side, z)
            yield wing.strip((0.0, 0.5), (_HINGE, 1.0), side, z, *flap)
            yield wing.strip(
                (0.5, 1.0), (_HINGE, 1.0), side, z, name, sense if side == _RIGHT else _OTHER[sense]
            )


def _wing(frame: _Frame, count: int) -> _Plane:
    """Each of so many wings; one of low aspect ratio on a jet is a delta, with a straight trailing edge."""
    span = frame.looks.span_m
    mean = frame.wing_m2 / span / count
    delta = frame.swept and span < 4.0 * mean
    taper = 0.7 if not frame.swept else 0.2 if delta else 0.35
    root = 2.0 * mean / (1.0 + taper)
    back = 0.5 * span * _SWEEP if frame.swept else 0.0
    back = max(back, 0.75 * root * (1.0 - taper)) if delta else back
    centre = min(max(frame.looks.wing_at[0], -0.25 * mean), 0.25 * mean)
    return _Plane(centre + 0.25 * mean + 0.45 * back, root, taper, back, span)


@dataclass(frozen=True)
class _Plane:
    """A wing or tail of straight edges: its root begins at `front` and is `root` long, its tips are `back` further behind."""

    front: float
    root: float
    taper: float
    back: float
    span: float

    def strip(
        self, across: tuple[float, float], along: tuple[float, float], side: float, z: float,
        name: str | None = None, sense: Sense = 1,
    ) -> Panel:  # fmt: skip
        """A part of one half, from shares of the half span and of the chord."""

        def at(share: float, along: float) -> Point:
            chord = self.root * (1.0 - (1.0 - self.taper) * share)
            return (self.front - self.back * share - along * chord, 0.5 * self.span * share * side, z)

        (inner, outer), (front, back) = across, along
        points = (at(inner, front), at(outer, front), at(outer, back), at(inner, back))
        return Panel(points=points, actuator=name, sense=sense)


def _tail(frame: _Frame, surfaces: Roles) -> Iterator[Panel]:
    area = frame.looks.tail_m2 or _TAIL * frame.wing_m2
    span = math.sqrt((3.0 if frame.swept else 4.0) * area)
    back, end = 0.3 * span if frame.swept else 0.0, frame.tail_m + 0.3 * frame.radius_m
    if not frame.tailless:
        plane = _Plane(end + area / span + 0.5 * back, area / span, 1.0, back, span)
        for side in (_LEFT, _RIGHT):
            yield plane.strip((0.0, 1.0), (0.0, _HINGE), side, 0.0)
            yield plane.strip((0.0, 1.0), (_HINGE, 1.0), side, 0.0, *_moving(surfaces, "elevator", side))
    yield from _fin(frame, end, *_moving(surfaces, "rudder"))


def _fin(frame: _Frame, end: float, name: str | None, sense: Sense) -> Iterator[Panel]:
    area = frame.looks.fin_m2 or _FIN * frame.wing_m2
    height = math.sqrt(1.3 * area)
    chord, back = 1.2 * area / height, (0.7 if frame.swept else 0.25) * height
    foot, top = -0.4 * frame.radius_m, -0.4 * frame.radius_m - height

    def at(along: float, up: float) -> Point:
        """Of a fin whose chord becomes two thirds as long at its top."""
        length = chord * (1.0 - up / 3.0)
        return (end + chord - back * up - along * length, 0.0, top if up else foot)

    yield Panel(points=(at(0, 0), at(0, 1), at(_HINGE, 1), at(_HINGE, 0)))
    yield Panel(points=(at(_HINGE, 0), at(_HINGE, 1), at(1, 1), at(1, 0)), actuator=name, sense=sense)


def _bodies(frame: _Frame) -> Iterator[Body]:
    """Fuselage, hull, nacelles, and wheels that stay out."""
    r, span = frame.radius_m, frame.looks.span_m
    yield _body((frame.nose_m, 0, 0), (frame.tail_m, 0, 0), r)
    if frame.looks.hull:
        yield _body((0.9 * frame.nose_m, 0, 0.9 * r), (0.3 * frame.tail_m, 0, 0.9 * r), 0.75 * r)
        for side in (_LEFT, _RIGHT):
            yield _body(
                (0.05 * span, 0.36 * side * span, 1.2 * r),
                (-0.05 * span, 0.36 * side * span, 1.2 * r),
                0.3 * r,
            )
    for power in frame.looks.engines:
        x, y, z = power.at
        if abs(y) > r:
            yield _body((x, y, z), (x - 3.0 * r, y, z), (0.45 if power.diameter_m else 0.55) * r)
    for x, y, z in frame.looks.wheels:
        yield _body((x, y - 0.1 * r, z - 0.3 * r), (x, y + 0.1 * r, z - 0.3 * r), 0.3 * r)


def _body(start: Point, end: Point, radius_m: float) -> Body:
    return Body(start=_point(start), end=_point(end), radius_m=_round(radius_m))


def _propulsor(power: Power, frame: _Frame) -> Propulsor:
    x, y, z = power.at
    if power.diameter_m:
        most = min(power.diameter_m, 0.6 * frame.looks.span_m)
        return Propulsor(at=_point((x, y, z)), diameter_m=_round(most), actuator=power.actuator)
    behind = x - 3.0 * frame.radius_m if abs(y) > frame.radius_m else frame.tail_m - 0.02 * frame.looks.span_m
    exit_m = (1.0 if abs(y) > frame.radius_m else 1.3) * frame.radius_m
    return Propulsor(at=_point((behind, y, z)), diameter_m=_round(exit_m), actuator=power.actuator, jet=True)


def _along_the_wing(motors: Sequence[str], span_m: float) -> Iterator[Power]:
    """One at the nose; several along the wing in their order, which is from left to right in JSBSim's models."""
    for name, y in zip(motors, np.linspace(-0.2, 0.2, len(motors)), strict=True):
        at = (0.31, 0.0, 0.0) if len(motors) == 1 else (0.08, float(y), 0.02)
        yield Power((at[0] * span_m, at[1] * span_m, at[2] * span_m), name, 0.12 * span_m)


def _point(point: Point) -> Point:
    x, y, z = (_round(value) for value in point)
    return (x, y, z)


def _round(value: float) -> float:
    """To what a picture shows: the files of a flight do not depend on the last digits of a machine."""
    return round(float(value), 4) + 0.0

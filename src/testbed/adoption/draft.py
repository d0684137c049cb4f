"""The first half of an adoption, on the bench: what the model is made of, and the model with our blocks in it."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from testbed.adoption.bench import HZ, SPEEDS, Bench, Size, drag_n, measure_size, one_line, write
from testbed.adoption.blocks import cut, prefix_of, set_property
from testbed.adoption.controls import Surface, find_surfaces, surface_groups
from testbed.adoption.engines import LEAST_THRUST, MakeBench, Start, find_start, full_thrust, gear_up, run
from testbed.adoption.propulsors import TURBINE, Propulsor, find_propulsors, write_engines
from testbed.adoption.source import Source, declare, read_whole
from testbed.adoption.wiring import STICKS
from testbed.inputs.problems import BadInput, Problem
from testbed.plant.jsbsim import EngineError

_HIGH_M, _LOW_M = 3000.0, 1000.0  # altitudes of turbines' flight, and of all others'
_SMALL_SPAN_M = 4.0  # below it an aircraft has the servos of a model aircraft
_SERVO, _MODEL_SERVO = (20.0, math.radians(60.0)), (30.0, math.radians(300.0))
"""Lag [rad/s] and rate limit [rad/s] where the model has none: Stevens and Lewis's F-16 (20.2 rad/s, 60 to 120 deg/s), and a
hobby servo (60 deg in 0.2 s)."""
_ANY_SPEED_M_S = 80.0
_NEEDED = ("metrics", "mass_balance", "aerodynamics")
_PROBE_RAD = 0.02
_EXCESS = 1.02  # of full thrust over drag, without which an airspeed is not tried


class Servo(NamedTuple):
    """A surface with its servo: lag and rate limit [rad/s], those of the surface's `dynamics` or defaults."""

    surface: Surface
    lag_rad_s: float
    rate_rad_s: float


@dataclass(frozen=True)
class Draft:
    """What the bench shows of a model, the model with blocks, and what makes benches of that."""

    source: Source
    tree: ET.Element
    servos: tuple[Servo, ...]
    propulsors: tuple[Propulsor, ...]
    size: Size
    start: Start
    make: MakeBench

    def speeds_m_s(self) -> Iterator[float]:
        """Airspeeds to try for the reference, the usual one first; the engines' thrust exceeds the drag at each by a margin.

        To find out takes as long as to start the engines, so each is looked at when it is its turn.
        """
        for share in SPEEDS:
            speed = float(f"{share * self.size.stall_m_s:.4g}")
            if self.propulsors:
                bench = _in_flight(self.make, self.size, speed)
                thrust_n = full_thrust(bench, self.propulsors, self.start.steps)
            if not self.propulsors or thrust_n > _EXCESS * drag_n(bench, self.size.alpha_at(speed)):
                yield speed


def make_draft(source: Source, folder: Path) -> Draft:
    """Read the model and put blocks into it, with scratch files in a folder; raises BadInput with what is missing."""
    tree = read_whole(source)
    for section in _NEEDED:
        if tree.find(section) is None:
            raise refused(source, f"it has no <{section}>")
    propulsors = find_propulsors(tree, source)
    whole = _maker(source, folder / "whole", tree)
    bench = whole()
    if bench.missing:
        declare(tree, dict.fromkeys(bench.missing, 0.0))
        bench = whole()
    bench.place(_ANY_SPEED_M_S, _LOW_M)
    run(bench, [gear_up()])
    size = measure_size(bench, _HIGH_M if any(each.kind == TURBINE for each in propulsors) else _LOW_M)
    if size is None:
        raise refused(source, "its wing gives no lift")
    bench.place(SPEEDS[0] * size.stall_m_s, size.altitude_m)
    servos = tuple(_with_servo(each, size) for each in find_surfaces(tree, bench))
    if not servos:
        raise refused(source, _no_surface(tree))
    adopted = cut(tree, servos, propulsors)
    make = _maker(source, folder / "adopted", adopted)
    _let_float(adopted, make, servos, size)
    start = find_start(lambda: _in_flight(make, size), propulsors)
    if propulsors and start.thrust_n < LEAST_THRUST * size.weight_n:
        weak = f"{start.thrust_n:.3g} N at full throttle, for a weight of {size.weight_n:.4g} N"
        raise refused(source, f"no known way to start its engines gives thrust to fly with: {weak}")
    return Draft(source, adopted, servos, tuple(propulsors), size, start, make)


def _maker(source: Source, folder: Path, tree: ET.Element) -> MakeBench:
    """Makes benches of one model, written into a scratch folder when one is made; BadInput then has JSBSim's words."""
    write_engines(tree, source, folder)

    def made() -> Bench:
        write(folder, source.name, tree)
        try:
            return Bench(folder, source.name)
        except EngineError as error:
            raise refused(source, f"JSBSim does not load it: {one_line(str(error))}") from None

    return made


def refused(source: Source, why: str) -> BadInput:
    """The one sentence that says why a model cannot be adopted."""
    return BadInput([Problem(f"{source.name} cannot be adopted: {why}", str(source.file))])


def _in_flight(make: MakeBench, size: Size, airspeed_m_s: float | None = None) -> Bench:
    """A new bench with the model in level flight, at the usual airspeed if none is given."""
    speed = airspeed_m_s or SPEEDS[0] * size.stall_m_s
    bench = make()
    bench.place(speed, size.altitude_m, size.alpha_at(speed))
    return bench


def _with_servo(surface: Surface, size: Size) -> Servo:
    lag, rate = _MODEL_SERVO if size.span_m < _SMALL_SPAN_M else _SERVO
    found = surface.dynamics
    return Servo(surface, found.lag_rad_s or lag, found.rate_rad_s or rate)


def _no_surface(tree: ET.Element) -> str:
    """Why no surface was found, with the names to look for."""
    read = ", ".join(f"fcs/{base}" for base in surface_groups(tree)) or "none"
    return (
        "its aerodynamics read no position that turns it and follows a stick of its flight control "
        f"({', '.join(STICKS.values())}); positions that they read: {read}"
    )


def _let_float(tree: ET.Element, make: MakeBench, servos: tuple[Servo, ...], size: Size) -> None:
    """Set how far each surface follows the air when its linkage is gone, from the turn that it causes most of.

    A free surface trails behind its hinge: with the wind from below its trailing edge goes up, from the right it goes left. A
    trailing edge up behind the wing pitches the nose up, one to the left turns it left, one up on the left wing rolls to the left.
    Surfaces of roll that the model moves as a pair do not float: the two sides would go up together.
    """
    bench = _in_flight(make, size)
    turns = bench.reader([f"accelerations/{axis}dot-rad_sec2" for axis in "qrp"])
    for servo in servos:
        p, ends = prefix_of(servo.surface.name), []
        for angle in (_PROBE_RAD, -_PROBE_RAD):
            bench.set({f"{p}/linkage-bias-rad": angle})
            bench.settle(2.0 / HZ)
            ends.append(turns())
        bench.set({f"{p}/linkage-bias-rad": 0.0})
        name, follows = _floating(servo.surface.name, *(up - down for up, down in zip(*ends, strict=True)))
        set_property(tree, f"{p}/{name}", follows + 0.0)


def _floating(name: str, pitch: float, yaw: float, roll: float) -> tuple[str, float]:
    """Property and value of a surface's floating, from the turns that a positive deflection causes."""
    most = max(map(abs, (pitch, yaw, roll)))
    if abs(pitch) == most:
        return "float-alpha", math.copysign(1.0, pitch)
    if abs(yaw) == most:
        return "float-beta", -math.copysign(1.0, yaw)
    side = {"left": -1.0, "right": 1.0}.get(name.split("_")[0], 0.0)
    return "float-alpha", side * math.copysign(1.0, roll)

"""The first half of an adoption, on the bench: what the model is made of, the model with our blocks in it, and the settings with
which its engines give the most thrust."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from testbed.adoption.bench import HZ, SPEEDS, Bench, Size, drag_n, measure_size, one_line, write
from testbed.adoption.blocks import cut, prefix_of, set_property
from testbed.adoption.controls import (
    ELECTRIC,
    TURBINE,
    Propulsor,
    Surface,
    find_propulsors,
    find_surfaces,
    surface_groups,
)
from testbed.adoption.source import Source, declare, read_whole, write_engines
from testbed.adoption.wiring import STICKS
from testbed.aircraft.description import StartStep
from testbed.common.units import NEWTONS_PER_POUND
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
_FUEL_S = 3.0  # in which collector tanks fill
_RUN_UP_S = 25.0  # pistons and turboprops need as long from the starter to full thrust
_WINDOW_S, _WINDOWS, _STEADY = 5.0, 12, 0.01  # the largest rotors take half a minute
_GEAR_S = 10.0
"""Longest travel of a gear in the jsbsim package [s]."""
_CLEAN = {"gear/gear-cmd-norm": 0.0, "gear/gear-pos-norm": 0.0}
_GEAR_UP = StartStep(set=_CLEAN, run_s=_GEAR_S)
"""Raises the gear, if it can be."""
_MIXTURES, _ADVANCES, _LEAN = (0.85, 0.7), (0.7, 0.4), (0.7, 1.0)
_START_THROTTLE = 0.6  # as in the first guess of a trim
_LEAST_THRUST = 0.025
"""Thrust by weight: less than this at full throttle is no engine that runs."""
_BETTER = 1.02  # a setting replaces the usual one if it gives this much of its thrust

Way = Callable[[Sequence[Propulsor], float, float], tuple[StartStep, ...]]
"""A way to start, with a mixture and a propeller lever."""

MakeBench = Callable[[], Bench]
"""Makes a new bench; for a start, with the adopted model held in flight, throttles closed."""

_KEEP_FUEL = {"propulsion/fuel_freeze": 1.0}
"""Mass then stays as it is. Not from the first instant, because an engine with an empty collector tank would starve; and not
late, because one whose pumps stand still would run its collector tank dry."""


class Servo(NamedTuple):
    """A surface with its servo: lag and rate limit [rad/s], those of the surface's `dynamics` or defaults."""

    surface: Surface
    lag_rad_s: float
    rate_rad_s: float


@dataclass(frozen=True)
class Start:
    """How a model is made ready to fly: `steps`, and `thrust_n` of all engines together at full throttle after them."""

    steps: tuple[StartStep, ...]
    thrust_n: float = 0.0


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
                thrust_n = _full_thrust(bench, self.propulsors, self.start.steps)
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
    _run(bench, [_GEAR_UP])
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
    start = _find_start(lambda: _in_flight(make, size), propulsors)
    if propulsors and start.thrust_n < _LEAST_THRUST * size.weight_n:
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


def _find_start(make: MakeBench, propulsors: Sequence[Propulsor]) -> Start:
    """The start with which the engines give most thrust, of the first known way that gives enough; else the best of all ways.

    Each setting is tried on a new bench, because some stop an engine for good.
    """
    if not propulsors:
        return Start((_GEAR_UP,))
    least = _LEAST_THRUST * make()["inertia/weight-lbs"] * NEWTONS_PER_POUND
    simple = all(each.kind in (TURBINE, *ELECTRIC) for each in propulsors)
    best = Start(())
    for way in (_at_once,) if simple else (_by_starter, _told):
        usual = _tried(make, propulsors, way, 1.0, 1.0)
        if usual.thrust_n < least:
            usual = _tried(make, propulsors, way, *_LEAN)
        if usual.thrust_n >= least:
            return usual if way is _at_once else _tuned(make, propulsors, way, usual)
        best = max(best, usual, key=lambda start: start.thrust_n)
    return best


def _tried(
    make: MakeBench, propulsors: Sequence[Propulsor], way: Way, mixture: float, advance: float
) -> Start:
    steps = way(propulsors, mixture, advance)
    return Start(steps, _full_thrust(make(), propulsors, steps))


def _tuned(make: MakeBench, propulsors: Sequence[Propulsor], way: Way, usual: Start) -> Start:
    """The start with the propeller's lever, then the mixture, of the greatest thrust."""
    best, best_advance = usual, 1.0
    for advance in _ADVANCES:
        tried = _tried(make, propulsors, way, 1.0, advance)
        if tried.thrust_n > _BETTER * best.thrust_n:
            best, best_advance = tried, advance
    for mixture in _MIXTURES:
        tried = _tried(make, propulsors, way, mixture, best_advance)
        best = tried if tried.thrust_n > _BETTER * best.thrust_n else best
    return best


def _full_thrust(bench: Bench, propulsors: Sequence[Propulsor], steps: Sequence[StartStep]) -> float:
    """Thrust of all engines at full throttle [N], in flight, after a start."""
    bench.set({f"{prefix_of(each.name)}/command-norm": _START_THROTTLE for each in propulsors})
    _run(bench, steps)
    bench.set({f"{prefix_of(each.name)}/command-norm": each.throttle[1] for each in propulsors})
    read = bench.reader([f"propulsion/engine[{each.number}]/thrust-lbs" for each in propulsors])
    thrust = sum(read())
    for _ in range(_WINDOWS):
        bench.settle(_WINDOW_S)
        before, thrust = thrust, sum(read())
        if abs(thrust - before) < _STEADY * abs(thrust):
            break
    return thrust * NEWTONS_PER_POUND


def _run(bench: Bench, steps: Sequence[StartStep]) -> None:
    """Carry out a start on a bench."""
    for step in steps:
        bench.set(step.set)
        bench.settle(step.run_s)


def _at_once(propulsors: Sequence[Propulsor], mixture: float, advance: float) -> tuple[StartStep, ...]:
    """A turbine runs when it is told to, an electric engine always."""
    running = {f"propulsion/engine[{each.number}]/set-running": 1.0 for each in propulsors}
    return _fuelled({**_CLEAN, **running})


def _by_starter(propulsors: Sequence[Propulsor], mixture: float, advance: float) -> tuple[StartStep, ...]:
    levers = {}
    for each in propulsors:
        levers[f"fcs/mixture-cmd-norm[{each.number}]"] = mixture
        levers[f"fcs/advance-cmd-norm[{each.number}]"] = advance
    return _fuelled({**_CLEAN, **levers, "propulsion/starter_cmd": 1.0})


def _told(propulsors: Sequence[Propulsor], mixture: float, advance: float) -> tuple[StartStep, ...]:
    """By the starter, then by JSBSim's own command to run, with which other engines would stop."""
    running = StartStep(set={"propulsion/set-running": -1.0}, run_s=_RUN_UP_S)
    return (*_by_starter(propulsors, mixture, advance), running)


def _fuelled(begun: dict[str, float]) -> tuple[StartStep, ...]:
    """Steps that begin with these properties, and keep the fuel as soon as collector tanks are full."""
    return StartStep(set=begun, run_s=_FUEL_S), StartStep(set=_KEEP_FUEL, run_s=_RUN_UP_S)

"""Start the engines of a model on the bench, and find the settings with which they give the most thrust."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from testbed.adoption.bench import Bench
from testbed.adoption.blocks import prefix_of
from testbed.adoption.propulsors import ELECTRIC, TURBINE, Propulsor
from testbed.aircraft.description import StartStep
from testbed.common.units import NEWTONS_PER_POUND

_FUEL_S = 3.0  # in which collector tanks fill
_RUN_UP_S = 25.0  # pistons and turboprops need as long from the starter to full thrust
_WINDOW_S, _WINDOWS, _STEADY = 5.0, 12, 0.01  # the largest rotors take half a minute
_GEAR_S = 10.0
"""Longest travel of a gear in the jsbsim package [s]."""
_CLEAN = {"gear/gear-cmd-norm": 0.0, "gear/gear-pos-norm": 0.0}
_MIXTURES, _ADVANCES, _LEAN = (0.85, 0.7), (0.7, 0.4), (0.7, 1.0)
_START_THROTTLE = 0.6  # as in the first guess of a trim
LEAST_THRUST = 0.025
"""Thrust by weight: less than this at full throttle is no engine that runs."""
_BETTER = 1.02  # a setting replaces the usual one if it gives this much of its thrust

Way = Callable[[Sequence[Propulsor], float, float], tuple[StartStep, ...]]
"""A way to start, with a mixture and a propeller lever."""

MakeBench = Callable[[], Bench]
"""Makes a new bench; for a start, with the adopted model held in flight, throttles closed."""

_KEEP_FUEL = {"propulsion/fuel_freeze": 1.0}
"""Mass then stays as it is. Not from the first instant, because an engine with an empty collector tank would starve; and not
late, because one whose pumps stand still would run its collector tank dry."""


@dataclass(frozen=True)
class Start:
    """How a model is made ready to fly: `steps`, and `thrust_n` of all engines together at full throttle after them."""

    steps: tuple[StartStep, ...]
    thrust_n: float = 0.0


def find_start(make: MakeBench, propulsors: Sequence[Propulsor]) -> Start:
    """The start with which the engines give most thrust, of the first known way that gives enough; else the best of all ways.

    Each setting is tried on a new bench, because some stop an engine for good.
    """
    if not propulsors:
        return Start((gear_up(),))
    least = LEAST_THRUST * make()["inertia/weight-lbs"] * NEWTONS_PER_POUND
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
    return Start(steps, full_thrust(make(), propulsors, steps))


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


def full_thrust(bench: Bench, propulsors: Sequence[Propulsor], steps: Sequence[StartStep]) -> float:
    """Thrust of all engines at full throttle [N], in flight, after a start."""
    bench.set({f"{prefix_of(each.name)}/command-norm": _START_THROTTLE for each in propulsors})
    run(bench, steps)
    bench.set({f"{prefix_of(each.name)}/command-norm": each.throttle[1] for each in propulsors})
    read = bench.reader([f"propulsion/engine[{each.number}]/thrust-lbs" for each in propulsors])
    thrust = sum(read())
    for _ in range(_WINDOWS):
        bench.settle(_WINDOW_S)
        before, thrust = thrust, sum(read())
        if abs(thrust - before) < _STEADY * abs(thrust):
            break
    return thrust * NEWTONS_PER_POUND


def run(bench: Bench, steps: Sequence[StartStep]) -> None:
    """Carry out a start on a bench."""
    for step in steps:
        bench.set(step.set)
        bench.settle(step.run_s)


def gear_up() -> StartStep:
    """Raise the gear, if it can be."""
    return StartStep(set=_CLEAN, run_s=_GEAR_S)


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

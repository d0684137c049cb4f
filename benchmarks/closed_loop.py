"""What a flight costs in time, compared with JSBSim alone: python benchmarks/closed_loop.py

Prints one line of JSON. Times are processor time of the thread that flies; with `--wall`, wall time. Bare stepping and
flights take turns for some rounds, and the least time of each counts, because other work on the machine can only add to
it. `--processes` measures wall time.

- `bare_us`: one control step of the plant alone, that is JSBSim's `run()`, from trim in the scenario's air, with constant
  commands, and with nothing read or written.
- `closed_loop_us`: one control step of a complete flight, `simulation.assembly.Lockstep`: start of failures and gusts, reading
  properties, logging the truth and checking for the end of the flight, sensors, estimation, monitor and mode switches,
  outer loops, inversion, logging telemetry, writing commands, `run()`.
- `ratio` of the two; `steps_per_s` and `real_time_factor` of the closed loop.
- `outside_ms`: what a flight costs outside its steps, in a process that has flown before: `scenario` (from the YAML tree
  to a checked scenario, as in a sweep's worker), `assemble`, `conclude`, and their sum; `of_which` has the parts of the
  last two.

With `--processes N`: `speed_up` is the rate of whole flights with N processes over that with one.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import math
import os
import statistics
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import Any

from testbed.aircraft.shipped import find_scenario
from testbed.flight.flight import Flight
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.overrides import apply
from testbed.plant.jsbsim import Plant
from testbed.scenario.load import Scenario, load_scenario
from testbed.simulation import Assembly, assemble, assembly, check, conclude, fly
from testbed.simulation.assembly import Lockstep
from testbed.studies.drawing.builder import Builder, Task, Variant

SCENARIO = "scenarios/left_tail_fail.yaml"
_clock = time.thread_time
_STRETCH_S = 10.0  # of bare stepping from one trim: without control the aircraft is still in ordinary flight after this time
_PARTS = (
    (assembly, "check"),
    (assembly, "Plant"),
    (check, "unknown_names"),
    (assembly, "RealSensors"),
    (assembly, "Weather"),
    (assembly, "Injector"),
    (assembly, "_setup"),
    (conclude, "table"),
    (conclude, "measure"),
    (conclude, "judge"),
    (conclude, "controller_events"),
    (Plant, "settle"),
    (Plant, "catalog"),
)


def settings(options: argparse.Namespace) -> list[str]:
    """The options as --set takes them."""
    chosen = [f"sensors={options.sensors}"]
    if options.turbulence:
        chosen.append(f"atmosphere.turbulence_w20_m_s={options.turbulence}")
    if options.sensors != "ideal" or options.turbulence:
        chosen.append("controller.estimation=weighted")
    return chosen


def bare(scenario: Scenario) -> float:
    """Seconds for each control step of the plant alone."""
    count = min(scenario.steps, round(_STRETCH_S * scenario.rate_hz))
    best = math.inf
    for _ in range(max(1, scenario.steps // count)):
        step = assemble(scenario).plant.step
        begin = _clock()
        for _ in range(count):
            step()
        best = min(best, (_clock() - begin) / count)
    return best


def closed(scenario: Scenario, outside: dict[str, list[float]]) -> float:
    """Seconds for each control step of a flight; adds the seconds of assembling and concluding to `outside`."""
    begin = _clock()
    parts: Assembly = assemble(scenario)
    ready = _clock()
    loop = Lockstep(parts)
    loop.advance(scenario.steps)
    flown = _clock()
    judged(loop)
    outside["assemble"].append(ready - begin)
    outside["conclude"].append(_clock() - flown)
    return (flown - ready) / loop.done


def judged(loop: Lockstep) -> Flight:
    """The flight that was flown to its end."""
    assert loop.outcome is not None
    return conclude.conclude(loop.parts, loop.parts.scenario, loop.outcome, loop.recorded)


@contextlib.contextmanager
def watched(spent: dict[str, float]) -> Iterator[None]:
    """While this context lasts, add the seconds spent in each of _PARTS to `spent`."""
    kept = [(owner, name, getattr(owner, name)) for owner, name in _PARTS]

    def timed(name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*args: Any, **more: Any) -> Any:
            begin = _clock()
            try:
                return function(*args, **more)
            finally:
                spent[name.lstrip("_")] += _clock() - begin

        return call

    for owner, name, function in kept:
        setattr(owner, name, timed(name, function))
    try:
        yield
    finally:
        for owner, name, function in kept:
            setattr(owner, name, function)


def consists_of(scenario: Scenario, rounds: int) -> dict[str, float]:
    """Least time of each of _PARTS [ms], the longest first; `settle` and `catalog` are also part of other entries."""
    least: dict[str, float] = {}
    for _ in range(rounds):
        spent: dict[str, float] = defaultdict(float)
        with watched(spent):
            loop = Lockstep(assemble(scenario))
            loop.advance(scenario.steps)
            judged(loop)
        least = {name: min(least.get(name, math.inf), 1e3 * value) for name, value in spent.items()}
    return {name: round(value, 2) for name, value in sorted(least.items(), key=lambda item: -item[1])}


def checking(options: argparse.Namespace, scenario: Scenario) -> float:
    """Seconds from the tree of a sweep's base scenario to a checked scenario."""
    source = yamlfile.read(find_scenario(options.scenario))
    apply(source, settings(options))
    builder, task = Builder(source, (Variant("", {}),)), Task(0, 0, scenario.seed, {})
    builder.scenario(task)
    begin = _clock()
    builder.scenario(task)
    return _clock() - begin


def measured(options: argparse.Namespace) -> dict[str, Any]:
    """The numbers of the JSON line, but for those of `--processes`."""
    scenario = load_scenario(options.scenario, settings(options))
    flown = fly(scenario)  # compiles, trims, and fills the caches
    outside: dict[str, list[float]] = defaultdict(list)
    alone, together = [], []
    for _ in range(options.rounds):
        alone.append(bare(scenario))
        together.append(closed(scenario, outside))
        outside["scenario"].append(checking(options, scenario))
    least = {name: 1e3 * min(times) for name, times in outside.items()}
    step = min(together)
    return {
        "scenario": scenario.name,
        "sensors": options.sensors,
        "turbulence_w20_m_s": options.turbulence,
        "clock": "wall" if options.wall else "thread",
        "rounds": options.rounds,
        "flown_s": flown.end_time_s,
        "bare_us": round(1e6 * min(alone), 3),
        "closed_loop_us": round(1e6 * step, 3),
        "ratio": round(step / min(alone), 3),
        "ratio_median": round(statistics.median(b / a for a, b in zip(alone, together, strict=True)), 3),
        "steps_per_s": round(1.0 / step),
        "real_time_factor": round(1.0 / (step * scenario.rate_hz)),
        "outside_ms": {
            **{name: round(value, 2) for name, value in least.items()},
            "sum": round(sum(least.values()), 2),
            "of_which": consists_of(scenario, options.rounds),
        },
    }


def flights(path: str, chosen: list[str], start_s: float, count: int) -> float:
    """In a process of its own: fly once to warm up, wait until `start_s`, fly `count` times; returns the time after that [s]."""
    scenario = load_scenario(path, chosen)
    fly(scenario)
    time.sleep(max(0.0, start_s - time.time()))
    for _ in range(count):
        fly(scenario)
    return time.time()


def speed_up(options: argparse.Namespace) -> float:
    """Flights per second of N processes over those of one; of each the best round counts, and the rounds take turns."""
    os.environ.update(dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "NUMBA_NUM_THREADS"), "1"))
    count, best = 20, {1: 0.0, options.processes: 0.0}
    with ProcessPoolExecutor(options.processes, get_context("spawn")) as pool:
        wanted = (options.scenario, settings(options))
        list(pool.map(flights, *zip(*[(*wanted, 0.0, 0)] * options.processes, strict=True)))  # all started
        for _ in range(options.rounds):
            for n in best:
                start = time.time() + 0.5
                jobs = [pool.submit(flights, *wanted, start, count) for _ in range(n)]
                best[n] = max(best[n], n * count / (max(job.result() for job in jobs) - start))
    return best[options.processes] / best[1]


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("scenario", nargs="?", default=SCENARIO, help=f"scenario file ({SCENARIO})")
    parser.add_argument("--sensors", choices=("ideal", "mems"), default="ideal")
    parser.add_argument("--turbulence", type=float, default=0.0, metavar="W20", help="wind at 20 ft [m/s]")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--processes", type=int, default=0, metavar="N", help="also time N processes")
    parser.add_argument(
        "--guard", type=float, metavar="RATIO", help="exit status 1 if the ratio is above this"
    )
    parser.add_argument(
        "--wall", action="store_true", help="measure wall time, on a machine without other work"
    )
    options = parser.parse_args()
    if options.wall:
        global _clock
        _clock = time.perf_counter
    found = measured(options)
    if options.processes:
        found["processes"] = options.processes
        found["speed_up"] = round(speed_up(options), 3)
    print(json.dumps(found))
    if options.guard is not None and not found["ratio"] <= options.guard:
        print(f"the ratio {found['ratio']} is above {options.guard:g}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""What a flight costs, as multiples of what JSBSim alone costs: python benchmarks/closed_loop.py

Prints one line of JSON. Times are of the thread that flies, on the processor, and the least of all rounds, in which
bare stepping and flights take turns: other work on the machine only ever adds. Of processes it is the clock's time.

- `bare_us`: one control step of the plant alone: `run()` of the flown aircraft in the scenario's air, from its trim,
  commands as they are, nothing read or written.
- `closed_loop_us`: one control step of a complete flight, `simulation.lockstep`: failures and gusts that are due, all
  properties read, truth logged and the end watched for, sensors, estimation, monitor and mode switches, outer loops,
  inversion, telemetry logged, commands written, `run()`.
- `ratio` of the two; `steps_per_s` and `real_time_factor` of the closed loop.
- `outside_ms`: what a flight costs outside its steps when the process has flown before: `scenario` (tree to checked
  scenario, as a sweep's worker does it), `assemble`, `conclude`, their sum; and what the two consist of.

With `--processes N`: `speed_up` of N processes over one, whole flights, in turns.
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

from testbed import simulation
from testbed.aircraft.shipped import find_scenario
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.overrides import apply
from testbed.plant.jsbsim import Plant
from testbed.scenario.load import Scenario, load_scenario
from testbed.simulation import Assembly, assemble, conclude, fly, lockstep
from testbed.sweeps.drawing.builder import Builder, Task, Variant

SCENARIO = "scenarios/left_tail_fail.yaml"
_clock = time.thread_time
_STRETCH_S = 10.0  # of bare stepping from one trim; the aircraft is still in ordinary flight after it
_PARTS = (
    (simulation, "load_aircraft"),
    (simulation, "Plant"),
    (simulation, "unknown_names"),
    (simulation, "make_sensors"),
    (simulation, "Weather"),
    (simulation, "Injector"),
    (simulation, "_setup"),
    (simulation, "table"),
    (simulation, "measure"),
    (simulation, "judge"),
    (simulation, "controller_events"),
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
    """Seconds for each control step of a flight; notes what the rest of it took."""
    begin = _clock()
    parts: Assembly = assemble(scenario)
    ready = _clock()
    outcome, recorded = lockstep(parts)
    flown = _clock()
    conclude(parts, outcome, recorded)
    outside["assemble"].append(ready - begin)
    outside["conclude"].append(_clock() - flown)
    return (flown - ready) / len(recorded[0])


@contextlib.contextmanager
def watched(spent: dict[str, float]) -> Iterator[None]:
    """Add up what the parts of assembling and concluding take."""
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
    """Least ms of each part of a flight outside its steps; `settle` and `catalog` are inside others of them."""
    least: dict[str, float] = {}
    for _ in range(rounds):
        spent: dict[str, float] = defaultdict(float)
        with watched(spent):
            parts = assemble(scenario)
            conclude(parts, *lockstep(parts))
        least = {name: min(least.get(name, math.inf), 1e3 * value) for name, value in spent.items()}
    return {name: round(value, 2) for name, value in sorted(least.items(), key=lambda item: -item[1])}


def checking(options: argparse.Namespace, scenario: Scenario) -> float:
    """Seconds from a sweep's tree to a checked scenario."""
    source = yamlfile.read(find_scenario(options.scenario))
    apply(source, settings(options))
    builder, task = Builder(source, (Variant("", {}),)), Task(0, 0, scenario.seed, {})
    builder.scenario(task)
    begin = _clock()
    builder.scenario(task)
    return _clock() - begin


def measured(options: argparse.Namespace) -> dict[str, Any]:
    """All but the processes."""
    scenario = load_scenario(options.scenario, settings(options))
    flown = fly(scenario)  # compiles, trims, fills what is kept
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
    """In a process of its own: fly, first to warm up, then `count` times from a time on; returns when it was done."""
    scenario = load_scenario(path, chosen)
    fly(scenario)
    time.sleep(max(0.0, start_s - time.time()))
    for _ in range(count):
        fly(scenario)
    return time.time()


def speed_up(options: argparse.Namespace) -> float:
    """Flights per second of N processes over those of one: best of the rounds for each, which take turns."""
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
    parser.add_argument("--guard", type=float, metavar="RATIO", help="exit status 1 when the ratio is above")
    parser.add_argument("--wall", action="store_true", help="time by the wall's clock: for a quiet machine")
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

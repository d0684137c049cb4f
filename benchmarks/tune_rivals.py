"""Settings of all controllers, by one procedure with one budget: each candidate flies the same tuning draws on every aircraft.

    python benchmarks/tune_rivals.py                                     # every rival as it is, and those that are told the truth
    python benchmarks/tune_rivals.py --candidates                        # what was tried for each, and what each holds
    python benchmarks/tune_rivals.py --aircraft ./c172p ./A320 --draws 60

What belongs to an aircraft follows from its design model (`controllers.scaling`, `controllers.pid`). What is left are a few
numbers that are the same for all aircraft: `BUDGET` candidates for each controller, the default law among them; what has
fewer numbers to choose has fewer. A draw is 80 s with real sensors, a turn and
a climb, weather, and none, one or two failures. It is held if it is flown to the end with altitude and heading within limits by the
aircraft's speed. The best candidate holds most, or of equal ones is within the limits longest. No seed from 50000 on is flown here.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.controllers.rivals import INFORMED, RIVALS
from testbed.flight.flight import Flight
from testbed.inputs.yaml_source import parse
from testbed.metrics import readings
from testbed.scenario.load import scenario_from
from testbed.simulation import fly

TUNING_SEEDS = range(40000, 50000)
BUDGET = 6
DURATION_S, BROKEN_S = 80.0, 15.0
CANDIDATES: Mapping[str, Sequence[Mapping[str, Any]]] = {
    "adaptive_inversion": [{}, *({"threshold": x} for x in (0.04, 0.09)), *({"filter_rad_s": x} for x in (10.0, 30.0)),
                           {"persistence_s": 0.2}],
    "fixed_inversion": [{}, {"released": []}],
    "pid": [{}, {"released": []}, *({"roll_max_deg": x} for x in (20.0, 40.0)), {"heading_ki": 0.0}, {"altitude_ki": 0.0}],
    "indi": [{}, {"released": []}, *({"filter_rad_s": x} for x in (10.0, 15.0, 30.0, 40.0))],
    "adaptive_indi": [{"mu_s": mu, "factor_max": most} for mu, most in product((0.03, 0.1, 0.3), (2.0, 10.0))],
    "mrac": [{"adaptation": x, "authority_max": most} for x, most in product((0.1, 0.25, 0.5), (1.0, 3.0))],
    "l1_inversion": [{"fast_gamma": x, "control_rad_s": k} for x, k in product((10.0, 20.0, 40.0), (5.0, 10.0))],
    "rls_inversion": [{"forgetting_s": x, "lambda_min": y} for x, y in product((1.0, 2.0, 5.0), (0.1, 0.3))],
    "imm_inversion": [{"probability": x, "persistence_s": y} for x, y in product((0.9, 0.99), (0.1, 0.2, 0.5))],
}  # fmt: skip
"""What is tried for each: settings beside its type."""


def draw(seed: int, aircraft: str) -> dict[str, Any]:
    """One scenario without its controller; aircraft and seed decide everything."""
    generator = np.random.default_rng([seed, 27])
    known = load_aircraft(aircraft)
    at = known.reference
    count = int(generator.choice(3, p=(0.1, 0.6, 0.3)))
    broken = generator.choice(list(known.actuators), count, replace=False)
    begins = BROKEN_S + np.array([0.0, generator.uniform(5.0, 25.0)])[:count]
    return {
        "name": f"draw {seed}",
        "aircraft": aircraft,
        "duration_s": DURATION_S,
        "seed": seed,
        "initial": {"altitude_m": at.altitude_m, "airspeed_m_s": at.airspeed_m_s, "heading_deg": 90.0},
        "sensors": "mems",
        "atmosphere": {"turbulence_w20_m_s": float(generator.choice([0.0, 4.57, 7.62]))},
        "command_rates": {
            "heading_deg_s": round(min(4.0, math.degrees(1.8 / at.airspeed_m_s)), 3),
            "altitude_m_s": round(0.055 * at.airspeed_m_s, 3),
        },
        "commands": [
            {"at_s": 5.0, "heading_deg": 120.0},
            {"at_s": 25.0, "altitude_m": at.altitude_m + 0.6 * at.airspeed_m_s},
            {"at_s": 45.0, "heading_deg": 90.0},
        ],
        "failures": [
            _failure(generator, known, str(n), float(t)) for n, t in zip(broken, begins, strict=True)
        ],
    }


def _failure(generator: np.random.Generator, aircraft: Aircraft, name: str, at_s: float) -> dict[str, Any]:
    surface = aircraft.actuators[name].kind == "servo"
    kinds: list[dict[str, Any]] = [
        {"type": "effectiveness", "value": 0.0},
        {"type": "effectiveness", "value": round(float(generator.uniform(0.1, 0.7)), 3)},
        {"type": "stuck"},
        {"type": "intermittent", "value": 0.0, "off_s": 1.0, "on_s": 3.0},
        *([{"type": "reversal"}, {"type": "bias", "value": 5.0}, {"type": "float"}] if surface else []),
    ]
    failure = {**kinds[int(generator.integers(len(kinds)))], "actuator": name, "at_s": round(at_s, 3)}
    if generator.uniform() < 0.3:
        failure["until_s"] = failure["at_s"] + round(float(generator.uniform(2.0, 15.0)), 3)
    return failure


def judged(flight: Flight) -> tuple[float, float, float]:
    """1 if flown to the end, 1 if held, and the share of the planned time within the limits, from the first failure on."""
    v, log = flight.scenario.initial.airspeed_m_s, readings(flight)
    row = log.row_at(BROKEN_S)
    inside = np.abs(log.error("altitude")[row:]) < max(5.0, 0.3 * v)
    inside &= np.abs(log.error("heading")[row:]) < 15.0
    share = float(inside.sum()) / ((DURATION_S - BROKEN_S) * flight.scenario.rate_hz)
    survived = flight.outcome == "completed"
    return float(survived), float(survived and bool(inside.all())), min(share, 1.0)


def flown(task: tuple[int, str, Mapping[str, Any]]) -> tuple[float, float, float]:
    """`judged` of the draw of a seed and aircraft, flown by a controller."""
    seed, aircraft, controller = task
    text = yaml.safe_dump({**draw(seed, aircraft), "controller": dict(controller)})
    return judged(fly(scenario_from(parse(text, "draw"))))


def tasks(count: int, aircraft: Sequence[str]) -> Iterator[tuple[int, str]]:
    """(seed, aircraft) of each draw: the aircraft take turns."""
    for i in range(count):
        yield TUNING_SEEDS[i], aircraft[i % len(aircraft)]


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--aircraft", nargs="+", default=["vtail", "vtail_aft", "aerosonde"])
    parser.add_argument("--draws", type=int, default=48)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--candidates", action="store_true", help="what was tried, in place of what is")
    parser.add_argument("--controllers", nargs="+", metavar="NAME", help="only these")
    options = parser.parse_args(arguments)
    known = {**RIVALS, **INFORMED}
    if options.candidates:
        each = ((kind, one) for kind, some in CANDIDATES.items() for one in some[:BUDGET])
        known = {f"{kind} {dict(one)}": {"type": kind, **one} for kind, one in each}
    wanted = {
        n: c for n, c in known.items() if not options.controllers or n.split()[0] in options.controllers
    }
    aircraft = [str(Path(a).resolve()) if "/" in a else a for a in options.aircraft]
    plan = list(tasks(options.draws, aircraft))
    best = np.zeros((len(plan), 3))
    heads = [
        "controller",
        "survived",
        "held",
        "share of time within limits",
        *(f"held: {Path(a).name}" for a in aircraft),
    ]
    print(f"| {' | '.join(heads)} |\n|{' --- |' * len(heads)}")
    with ProcessPoolExecutor(options.jobs) as pool:
        for name, controller in wanted.items():
            results = np.array(list(pool.map(flown, [(*task, controller) for task in plan])))
            best = np.maximum(best, results)
            print(_row(name, results, len(aircraft)), flush=True)
    print(_row("best of all", best, len(aircraft)))


def _row(name: str, results: np.ndarray, aircraft: int) -> str:
    """A row of the table: the means of all draws, and the share held on each aircraft, which take turns."""
    own = [results[i::aircraft, 1].mean() for i in range(aircraft)]
    return f"| {name} | " + " | ".join(f"{x:.3f}" for x in [*results.mean(axis=0), *own]) + " |"


if __name__ == "__main__":
    main()

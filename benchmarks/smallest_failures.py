"""The smallest failure that breaks altitude or heading, for every type of failure and each controller: who needs the bigger one?

    python benchmarks/smallest_failures.py --csv runs/smallest.csv             # may be stopped and run again
    python benchmarks/smallest_failures.py --csv runs/smallest.csv --controllers default --budget 1000    # the check
    python benchmarks/smallest_failures.py --csv runs/smallest.csv --page      # docs/results/smallest_failures.md from the CSV

What is searched is the failure's severity, if its type has one, and a gust three seconds after it. All controllers meet the same
distributions, so that a larger distance means a larger failure.
"""

from __future__ import annotations

import argparse
import csv
import math
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from missions import CONTROLLERS

from testbed.aircraft.description import load_aircraft
from testbed.failures import TABLE as FAILURES
from testbed.inputs.yaml_source import parse
from testbed.reliability import smallest_failure
from testbed.studies.drawing.builder import Builder, Task, Variant
from testbed.studies.drawing.distributions import Distribution
from testbed.studies.flying.flight import Job
from testbed.studies.flying.pool import FlyAll, workers
from testbed.studies.search.plan import Coordinate, Origin, Space
from testbed.studies.search.run import robustness

PAGE = Path(__file__).parents[1] / "docs" / "results" / "smallest_failures.md"
COMPARED = ("default", "indi")
BUDGET, CHECK = 300, 1000
"""Most flights of each search, and of one that checks it."""
BASE = """\
name: smallest failure
aircraft: vtail
duration_s: 10
rate_hz: 100
physics_hz: 100
initial: {altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
atmosphere: {gusts: [{at_s: 5, magnitude_m_s: [0, 0, 0], frame: ned, duration_s: 0.5, hold_s: 2}]}
requirements:
  - {metric: altitude_error_max_m, at_most: 3}
  - {metric: heading_error_max_deg, at_most: 8}
"""
FAILURE_S, SEED = 2.0, 90001
GUST_M_S = 1.3
"""Standard deviation of the gust's velocity to the north and down."""
BESIDE, APART = 8, 0.01
"""Flights beside each failure found, and how many standard deviations they are from it."""
SEVERITIES: dict[str, tuple[str, list[float], Origin]] = {
    "effectiveness": ("value", [0.0, 1.0], "high"),
    "command_scale": ("value", [0.0, 1.0], "high"),
    "decay": ("value", [0.0, 1.0], "high"),
    "intermittent": ("value", [0.0, 1.0], "high"),
    "bias": ("value", [0.0, 15.0], "low"),
    "oscillation": ("amplitude", [0.0, 15.0], "low"),
    "delay": ("delay_s", [0.0, 0.5], "low"),
    "lag": ("lag_rad_s", [1.0, 30.0], "high"),
    "rate_limit": ("value", [0.5, 100.0], "high"),
}
"""Key, range, and end without effect of the severity of each type that has one; drawn uniformly."""
HEAD = (
    "failure",
    "actuator",
    "controller",
    "budget",
    "distance",
    "severity",
    "north_m_s",
    "down_m_s",
    "flights",
    "beside",
    "reason",
)
TIE = 0.9
"""A distance above this share of the largest one is as large: a longer search once found 8 % less (`lag`, law 5e452cd2)."""
Row = dict[str, Any]


def main(arguments: Sequence[str] | None = None) -> None:
    options = _parser().parse_args(arguments)
    rows = read(options.csv)
    if not options.page:
        rows += fly(options, {_search(row) for row in rows})
    PAGE.write_text(page(rows), encoding="utf-8") if options.page else print("\n".join(table(rows)))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--csv", type=Path, required=True, help="results, kept as they come")
    parser.add_argument(
        "--failures", default=",".join(["none", *(name for name in FAILURES if name != "property")])
    )
    parser.add_argument("--controllers", default=",".join(COMPARED))
    parser.add_argument("--budget", type=int, default=BUDGET, help="most flights of each search")
    parser.add_argument("--jobs", type=int)
    parser.add_argument("--page", action="store_true", help=f"write {PAGE.name} from the CSV, without flying")
    return parser


def _search(row: Row) -> tuple[str, str, int]:
    return row["failure"], row["controller"], int(row["budget"])


def read(file: Path) -> list[Row]:
    """The searches of a CSV that have been made."""
    if not file.is_file():
        return []
    with file.open(newline="") as stream:
        return list(csv.DictReader(stream))


def fly(options: argparse.Namespace, done: set[tuple[str, str, int]]) -> list[Row]:
    """Make every search that is missing; each is written as it is done."""
    file, rows = options.csv, []
    file.parent.mkdir(parents=True, exist_ok=True)
    job = Job(
        Builder(parse(BASE, "smallest failures"), (Variant("", {}),)), save_logs="none", time_limit_s=600.0
    )
    with workers(job, options.jobs) as flying, file.open("a", newline="") as stream:
        writer = csv.DictWriter(stream, HEAD)
        if not done:
            writer.writeheader()
        for name in options.failures.split(","):
            for controller in options.controllers.split(","):
                if (name, controller, options.budget) not in done:
                    rows.append(searched(name, controller, flying, options.budget))
                    writer.writerow(rows[-1])
                    stream.flush()
                    print(rows[-1], flush=True)
    return rows


def searched(name: str, controller: str, flying: FlyAll, budget: int) -> Row:
    """The smallest failure of one type with one controller."""
    failures, space = failures_of(name), space_of(name)

    def limit_state(u: np.ndarray) -> np.ndarray:
        tasks = [
            Task(i, 0, SEED, {"controller": dict(CONTROLLERS[controller]), "failures": failures, **values})
            for i, values in enumerate(space.values(u))
        ]
        records = {flown.record.run: flown.record for flown in flying(tasks)}
        return np.array([robustness(records[i]) for i in range(len(u))])

    actuator = failures[0]["actuator"] if failures else ""
    row: Row = {"failure": name, "actuator": actuator, "controller": controller, "budget": budget}
    origin = np.zeros((1, len(space)))
    if limit_state(origin)[0] <= 0.0:
        return (
            row
            | _values(space, origin[0])
            | {"distance": 0.0, "flights": 1, "beside": "", "reason": "without a gust already"}
        )
    found = smallest_failure(
        limit_state, len(space), seed=SEED, budget=budget, starts=2, mirrored=space.mirrored
    )
    said: Row = {"distance": found.distance, "flights": found.evaluations, "reason": found.reason}
    if found.design_point is not None:
        beside = int(np.sum(limit_state(neighbours(found.design_point)) <= 0.0))
        said |= _values(space, found.design_point) | {"beside": beside}
    return row | said


def neighbours(point: np.ndarray) -> np.ndarray:
    """Points [n, d] around a point [d], none nearer to the origin: where a region fails that is wider than APART, so do they."""
    turned = np.random.default_rng(SEED).standard_normal((BESIDE, len(point)))
    outward = turned * np.where(turned @ point < 0.0, -1.0, 1.0)[:, None]
    return point + APART * outward / np.linalg.norm(turned, axis=1, keepdims=True)


def failures_of(name: str) -> list[dict[str, Any]]:
    """The failure as its type's own example has it, of the left ruddervator or, of a type for motors only, propeller."""
    if name == "none":
        return []
    kind, fields = next(iter(FAILURES[name].examples.items()))  # type: ignore[attr-defined]
    aircraft = load_aircraft("vtail")
    actuator = next(n for n, each in aircraft.actuators.items() if each.kind == kind and n.startswith("left"))
    return [{"type": name, "actuator": actuator, "at_s": FAILURE_S, **fields}]


def space_of(name: str) -> Space:
    """Severity, if the type has one, and the gust's velocity north and down."""
    gust = Distribution.model_validate({"normal": [0.0, GUST_M_S]})
    coordinates = [Coordinate(f"atmosphere.gusts.0.magnitude_m_s.{axis}", gust) for axis in (0, 2)]
    if name in SEVERITIES:
        key, ends, origin = SEVERITIES[name]
        severity = Distribution.model_validate({"uniform": ends})
        coordinates.insert(0, Coordinate(f"failures.0.{key}", severity, origin))
    return Space(tuple(coordinates))


def _values(space: Space, point: np.ndarray) -> Row:
    values = list(space.values(point[None])[0].values())
    return dict(zip(("north_m_s", "down_m_s"), values[-2:], strict=True)) | {
        "severity": values[0] if len(values) > 2 else ""
    }


def table(rows: Sequence[Mapping[str, Any]]) -> Iterator[str]:
    """Markdown: a line for each type, the distance with each controller, which needs the biggest failure, and the check."""
    searches, checks = ([row for row in rows if int(row["budget"]) == budget] for budget in (BUDGET, CHECK))
    controllers = list(dict.fromkeys(row["controller"] for row in searches))
    yield f"| failure | actuator | {' | '.join(controllers)} | breaks last | over that of a longer search |"
    yield f"| --- | --- | {' | '.join('---' for _ in controllers)} | --- | --- |"
    known = {row["failure"] for row in searches}
    for name in [each for each in ("none", *FAILURES) if each in known]:
        own, longer = _by_controller(name, searches), _by_controller(name, checks)
        cells = [_cell(own[c]) if c in own else "" for c in controllers]
        ratios = ", ".join(f"{_ratio(own[c], longer[c])} ({c})" for c in own if c in longer)
        yield f"| `{name}` | {next(iter(own.values()))['actuator']} | {' | '.join(cells)} | {_best(own)} | {ratios} |"


def _by_controller(name: str, rows: Sequence[Mapping[str, Any]]) -> dict[str, Mapping[str, Any]]:
    return {row["controller"]: _no_worse(row, rows) for row in rows if row["failure"] == name}


def _ratio(row: Mapping[str, Any], longer: Mapping[str, Any]) -> str:
    """`1.02`: the distance over that of the longer search; the same, if neither needs a gust or finds anything."""
    distance, nearest = float(row["distance"]), float(longer["distance"])
    return "1.00" if distance == nearest else f"{distance / nearest:.2f}" if nearest else "none"


def _no_worse(row: Mapping[str, Any], rows: Sequence[Mapping[str, Any]]) -> Mapping[str, Any]:
    """The row, or that of the gust alone if this is nearer: with a severity without effect it is in the same space."""
    alone = [r for r in rows if r["failure"] == "none" and r["controller"] == row["controller"]]
    if row["failure"] not in SEVERITIES or not alone or float(alone[0]["distance"]) >= float(row["distance"]):
        return row
    return {**alone[0], "actuator": row["actuator"]}


def _cell(row: Mapping[str, Any]) -> str:
    """`2.31 (value 0.12; gust 2.2, -0.4; 5 of 8)`."""
    distance = float(row["distance"])
    if distance == 0.0:
        return "0: breaks without a gust"
    if not math.isfinite(distance):
        return f"none in {row['flights']}"
    key = SEVERITIES.get(row["failure"], ("", [], "low"))[0]
    severity = f"{key} {float(row['severity']):.3g}; " if row["severity"] != "" else ""
    gust = f"gust {float(row['north_m_s']):+.1f}, {float(row['down_m_s']):+.1f}"
    beside = f"; {row['beside']} of {BESIDE}" if int(row["beside"]) < BESIDE else ""
    return f"{distance:.2f} ({severity}{gust}{beside})"


def _best(own: Mapping[str, Mapping[str, Any]]) -> str:
    distances = {name: float(row["distance"]) for name, row in own.items()}
    most = max(distances.values())
    near = [name for name, distance in distances.items() if distance == most or distance > TIE * most]
    return ", ".join(near) if most > 0.0 else "none"


def alone(rows: Sequence[Mapping[str, Any]]) -> str:
    """For how many types each controller alone breaks last."""
    kinds = {row["failure"]: None for row in rows if row["failure"] != "none"}
    last = [_best(_by_controller(name, rows)) for name in kinds]
    return ", ".join(f"`{name}` at {last.count(name)}" for name in COMPARED) + f" of {len(last)} types"


def missed(rows: Sequence[Mapping[str, Any]]) -> float:
    """Largest share by which a longer search found a smaller distance."""
    searches, checks = ([row for row in rows if int(row["budget"]) == budget] for budget in (BUDGET, CHECK))
    shares = [0.0]
    for check in checks:
        own = _by_controller(check["failure"], searches).get(check["controller"])
        distance = float(own["distance"]) if own else 0.0
        if distance > 0.0 and math.isfinite(distance):
            shares.append(1.0 - float(check["distance"]) / distance)
    return max(shares)


def page(rows: Sequence[Mapping[str, Any]]) -> str:
    """The page of the documentation."""
    made = [row for row in rows if int(row["budget"]) == BUDGET]
    said = {"searches": len(made), "flights": sum(int(row["flights"]) for row in made), "seed": SEED, "at_s": FAILURE_S,
            "alone": alone(made), "less": 100.0 * missed(rows), "sd": GUST_M_S, "budget": BUDGET, "check": CHECK,
            "beside": BESIDE, "apart": APART}  # fmt: skip
    return _PAGE.format(**said, table="\n".join(table(rows)))


_PAGE = """\
# Smallest failures

This page says how big the smallest failure is that breaks a requirement, for every type of failure and two controllers.

Made by `benchmarks/smallest_failures.py` from {searches} searches of at most {budget} flights, {flights} in all (seed {seed}).
The v-tail flies at 18 m/s; the actuator fails at {at_s:g} s, and a gust of 2 s comes at 5 s. What is searched is the severity
of the failure, if its type has one, drawn uniformly from its range, and the gust's velocity north and down, drawn from a normal
distribution with a standard deviation of {sd} m/s each. The air is otherwise calm and the sensors are ideal. A type without a
severity is flown as [its example](../reference/failures.md) has it, and what is left to search is the gust.
Broken means an altitude error above 3 m, a heading error above 8 deg, or the loss of the aircraft.

The number is the distance, in standard deviations of these distributions, from no failure and no gust to the nearest flight
that breaks a requirement: larger is better. In brackets is what this flight has: the severity, the gust in m/s
towards north and down, and, unless all do, how many of {beside} flights beside it break a requirement too. These {beside} are
{apart:g} standard deviations from it, and none is nearer to the origin: beside a region that fails they all fail, and beside a
failure that stands alone among flights that pass, hardly any. *Breaks last* names all controllers within 10 %
of the largest distance: the longer searches found up to {less:.0f} % less.
The last column is the distance found over that of a search of at most {check} flights with the
same seed, where one was made.

{table}

Breaks last alone: {alone}. With `none` the gust alone does it; it also counts for a failure
with a severity, where it was the nearest. Where a failure's distance is about that of `none`, it is the gust that breaks, and
not the failure.
Distances of different failures are not to be compared: each has a severity with a range of its own.
"""


if __name__ == "__main__":
    main()

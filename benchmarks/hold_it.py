"""How well one broken actuator is held, in weather, with real sensors. Writes docs/results/hold_it.md.

    python benchmarks/hold_it.py            # every cell, 20 seeds: some 1800 flights, minutes on two cores
    python benchmarks/hold_it.py --quick    # 2 seeds

Each flight turns by 30 deg and climbs by 10 m before the failure at 40 s, and turns back and descends after it. Errors
are distances from the rate-limited references, from 20 s after the failure on. Seeds begin at 91001, above all that are
for tuning (below 50000), so no gain was chosen on any of these.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
from flights import Record, Values, coefficient_errors, fly_all

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model
from testbed.flight.flight import Outcome
from testbed.inputs.yaml_source import parse
from testbed.simulation import fly
from testbed.studies.drawing.builder import Builder, Task, Variant

CONTROLLER = "{type: adaptive_inversion}"
BASE = """\
name: hold it
aircraft: vtail
duration_s: 110
rate_hz: 200
initial: {{altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}}
controller: {controller}
commands:
  - {{at_s: 10, heading_deg: 120}}
  - {{at_s: 22, altitude_m: 310}}
  - {{at_s: 70, heading_deg: 90}}
  - {{at_s: 85, altitude_m: 300}}
command_rates: {{heading_deg_s: 4, altitude_m_s: 1}}
sensors: mems
requirements:
  - {{signal: altitude_m, from_s: 60, within: 5, of: altitude_command_m}}
  - {{signal: heading_deg, from_s: 60, within: 10, of: heading_command_deg}}
"""
FAILURE_S = 40.0
FIRST_SEED = 91001
MODEL_ERROR = 0.2
LONG_S = 600
FT_S = 0.3048
AIRCRAFT = load_aircraft("vtail")
ACTUATORS = tuple(AIRCRAFT.actuators)
COEFFICIENTS = load_design_model(AIRCRAFT.folder / DESIGN_MODEL).coefficient_names()


@dataclass(frozen=True)
class Cell:
    """One kind of failure in one weather.

    Attributes:
        group: the row of the first table that it is part of.
        lost: (actuator, remaining effectiveness) of each actuator that breaks.
        w20_ft_s: wind at 20 ft, which sets the turbulence [ft/s].
        altitude_m, heading_deg: largest error allowed; infinite where errors are not judged.
        model_error: relative error of every coefficient of the design model; the seed decides each sign.
        from_start: whether errors count from 0 s on, not from 20 s after the failure.
        long: 10 minutes of turns and climbs, judged by false alarms alone.
    """

    group: str
    lost: tuple[tuple[str, float], ...]
    w20_ft_s: float
    altitude_m: float = math.inf
    heading_deg: float = math.inf
    model_error: float = 0.0
    from_start: bool = False
    long: bool = False

    def values(self, seed: int) -> Values:
        """What differs from BASE in the flight of this seed."""
        values: dict[str, Any] = {"atmosphere.turbulence_w20_m_s": self.w20_ft_s * FT_S}
        values["failures"] = [
            {"type": "effectiveness", "actuator": actuator, "at_s": FAILURE_S, "value": value}
            for actuator, value in self.lost
        ]
        if self.model_error:
            values["controller.model_error"] = coefficient_errors(COEFFICIENTS, self.model_error, seed)
        if self.long:
            values["duration_s"] = LONG_S
            values["commands"] = [
                {"at_s": t, "heading_deg": 90 + turn, "altitude_m": 300 + turn // 3}
                for t, turn in zip(range(10, LONG_S, 30), [30, 0] * LONG_S, strict=False)
            ]
        return values

    @property
    def title(self) -> str:
        what = " + ".join(
            f"{actuator} {'lost' if value == 0 else f'at {value:g}'}" for actuator, value in self.lost
        )
        return (what or "nothing") + (f", model {self.model_error:.0%} off" if self.model_error else "")


NONE = "none"
PARTIAL = "one actuator at 0.3, 0.6, 0.9"
LOST = "one actuator totally lost"
PARTIAL_ERROR = "one actuator at 0.3, 0.6, 0.9; 20 % model error"
LOST_ERROR = "one actuator totally lost; 20 % model error"
LONG = "none, 10 minutes"
FIFTH = "a propeller at 0.2"
PAIRS = "two actuators totally lost"
GROUPS = (NONE, PARTIAL, LOST, PARTIAL_ERROR, LOST_ERROR, LONG, FIFTH, PAIRS)


def cells(weathers: Sequence[float]) -> list[Cell]:
    """Every cell, by group and then by W20: each group in every weather [W20 in ft/s], and the pairs in calm air too."""
    table = []
    for w in weathers:
        table.append(Cell(NONE, (), w, 4, 6, from_start=True))
        for a in ACTUATORS:
            for value in (0.3, 0.6, 0.9):
                table.append(Cell(PARTIAL, ((a, value),), w, 6, 10))
                table.append(Cell(PARTIAL_ERROR, ((a, value),), w, 6, 12, MODEL_ERROR))
            table.append(Cell(LOST, ((a, 0.0),), w, 5, 10))
            table.append(Cell(LOST_ERROR, ((a, 0.0),), w, 6, 12, MODEL_ERROR))
            if a.endswith("propeller"):
                table.append(Cell(FIFTH, ((a, 0.2),), w, 6, 10))
        table.append(Cell(LONG, (), w, from_start=True, long=True))
    for w in (0.0, *weathers):
        table += [Cell(PAIRS, ((a, 0.0), (b, 0.0)), w, 5, 10) for a, b in combinations(ACTUATORS, 2)]
    return sorted(table, key=lambda cell: (GROUPS.index(cell.group), cell.w20_ft_s))


@dataclass(frozen=True)
class Result:
    """The records of a cell's flights, one for each seed, and what they say."""

    cell: Cell
    records: tuple[Record, ...]

    @property
    def lost(self) -> list[Record]:
        return [record for record in self.records if record["outcome"] != "completed"]

    def errors(self, record: Record) -> tuple[float, float]:
        """Largest altitude [m] and heading [deg] error of one flight; infinite if it was lost."""
        if record["outcome"] != "completed":
            return math.inf, math.inf
        if self.cell.from_start:
            return record["metrics"]["altitude_error_max_m"], record["metrics"]["heading_error_max_deg"]
        return record["requirements"][0][1], record["requirements"][1][1]

    def worst(self, i: int) -> float:
        """Largest altitude (i = 0) [m] or heading (i = 1) [deg] error of the flights that were flown to the end."""
        flown = [self.errors(r)[i] for r in self.records if r["outcome"] == "completed"]
        return max(flown, default=math.nan)

    def total(self, metric: str) -> float:
        return sum(record["metrics"][metric] for record in self.records)

    @property
    def delays(self) -> list[float]:
        found = [record["metrics"]["detection_delay_s"] for record in self.records]
        return [delay for delay in found if not math.isnan(delay)]

    def severity(self, record: Record) -> float:
        altitude, heading = self.errors(record)
        limits = (min(self.cell.altitude_m, 1e3), min(self.cell.heading_deg, 1e3))
        return max(altitude / limits[0], heading / limits[1]) + record["metrics"]["false_alarms"]

    @property
    def failed(self) -> list[Record]:
        """Records of the flights that were lost or passed a limit; of `long` ones, with a false alarm."""
        return [record for record in self.records if not self._held(record)]

    def _held(self, record: Record) -> bool:
        altitude, heading = self.errors(record)
        sound = altitude <= self.cell.altitude_m and heading <= self.cell.heading_deg
        alarmed = self.cell.long and record["metrics"]["false_alarms"] > 0
        return record["outcome"] == "completed" and sound and not alarmed

    @property
    def worst_seed(self) -> int:
        return int(max(self.records, key=self.severity)["seed"])


def fly_cells(table: Sequence[Cell], seeds: Sequence[int], controller: str, jobs: int | None) -> list[Result]:
    """Fly every cell with every seed."""
    flights = [(seed, cell.values(seed)) for cell in table for seed in seeds]
    records = fly_all(BASE.format(controller=controller), flights, jobs)
    n = len(seeds)
    return [Result(cell, tuple(records[i * n : (i + 1) * n])) for i, cell in enumerate(table)]


def summary_row(group: str, results: Sequence[Result]) -> str:
    """One row of the first table: all cells of a group in one weather."""
    worst = max(results, key=lambda result: max(map(result.severity, result.records)))
    cell, flown = results[0].cell, sum(len(result.records) for result in results)
    failed = sum(len(result.failed) for result in results)
    asked = (
        "no false alarm; errors not judged"
        if cell.long
        else f"{cell.altitude_m:g} m, {cell.heading_deg:g} deg"
    )
    altitude, heading = (_most(result.worst(i) for result in results) for i in (0, 1))
    parts = (
        group, f"{cell.w20_ft_s:g}", asked, f"{altitude:.1f} m", f"{heading:.1f} deg",
        f"{sum(len(result.lost) for result in results)} of {flown}",
        f"{sum(result.total('false_alarms') for result in results):.0f}",
        f"{worst.cell.title}, seed {worst.worst_seed}", "held" if not failed else f"**{failed} not held**",
    )  # fmt: skip
    return f"| {' | '.join(parts)} |"


def cell_row(result: Result) -> str:
    """One row of the tables by cell."""
    cell, delays = result.cell, result.delays
    delay = f"{np.median(delays):.2f} / {max(delays):.2f}" if delays else ""
    parts = (
        cell.title, f"{cell.w20_ft_s:g}", str(len(result.records)), f"{result.worst(0):.1f}", f"{result.worst(1):.1f}",
        str(len(result.lost)), delay, f"{result.total('missed_detections'):.0f}", f"{result.total('false_alarms'):.0f}",
        str(result.worst_seed), "held" if not result.failed else f"**{len(result.failed)} not held**",
    )  # fmt: skip
    return f"| {' | '.join(parts)} |"


def _most(values: Any) -> float:
    return max((value for value in values if not math.isnan(value)), default=math.nan)


def document(results: Sequence[Result], seeds: Sequence[int], controller: str) -> str:
    """The Markdown of docs/results/hold_it.md."""
    lines = [
        "# Hold it: one broken actuator, in weather, with real sensors",
        "",
        "<!-- Written by python benchmarks/hold_it.py: change that, not this. -->",
        "",
        "This page shows how well the default controller holds altitude and heading after the loss of one actuator or",
        "two, in turbulence and with real sensors. Each row names the worst flight of its kind.",
        "",
        f"`controller: {controller}`, `sensors: mems`,",
        f"seeds {seeds[0]} to {seeds[-1]} ({len(seeds)} a cell). No gain was chosen on any of these seeds. W20 is the",
        "wind at 20 ft of MIL-F-8785C [ft/s]. Headings change by 30 deg at 4 deg/s and altitudes by 10 m at 1 m/s,",
        "before the failure at 40 s and after it. Errors are distances from these rate-limited references, from 60 s",
        "on (without a failure: from 0 s). The worst errors are those of flights that were flown to the end.",
        "",
        '**Held** means: flown to the end, with altitude and heading within the limits of the column "asked" all that time.',
        "The flights of 10 minutes are the exception. They have one requirement only: no healthy actuator is ever flagged.",
        "Their errors are shown but not judged, so a flight far from its altitude may count as held there. **Lost** means",
        "that the aircraft left its flight envelope or hit the ground.",
        "",
        "To fly one row again: `python benchmarks/hold_it.py --group GROUP --first-seed SEED --seeds 1 --out FILE`.",
        "",
        "| failure | W20 | asked | worst altitude | worst heading | lost | false alarms | worst case | verdict |",
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    keys = list(dict.fromkeys((result.cell.group, result.cell.w20_ft_s) for result in results))
    for key in keys:
        lines.append(summary_row(key[0], [r for r in results if (r.cell.group, r.cell.w20_ft_s) == key]))
    lines += [
        "",
        "## Every cell",
        "",
        "Detection: median / longest time from a total loss to its flag [s]. Missed: losses that were never flagged.",
    ]
    for group in dict.fromkeys(result.cell.group for result in results):
        lines += ["", f"### {group.capitalize()}", ""]
        lines.append(
            "| failure | W20 | flights | altitude m | heading deg | lost | detection s | missed | false alarms "
            "| worst seed | verdict |"
        )
        lines.append("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
        lines += [cell_row(result) for result in results if result.cell.group == group]
    return "\n".join([*lines, *diagnoses(results, controller), *lost_flights(results)]) + "\n"


def diagnoses(results: Sequence[Result], controller: str) -> list[str]:
    """The controller's diagnoses when two actuators are lost, in the worst flight of each cell; flown again for this."""
    lines = [
        "",
        "## What the controller says of the pairs",
        "",
        "| failure | W20 | seed | said |",
        "| --- | --- | --- | --- |",
    ]
    for result in results:
        if result.cell.group != PAIRS:
            continue
        source = Builder(parse(BASE.format(controller=controller)), (Variant("", {}),))
        flight = fly(source.scenario(Task(0, 0, result.worst_seed, result.cell.values(result.worst_seed))))
        said = [f"{e['time_s']:.1f} s: {e['text']}" for e in flight.events if e["kind"] == "diagnosis"]
        about = (
            result.cell.title,
            f"{result.cell.w20_ft_s:g}",
            str(result.worst_seed),
            "; ".join(said) or "nothing",
        )
        lines.append(f"| {' | '.join(about)} |")
    return lines if len(lines) > 5 else []


def lost_flights(results: Sequence[Result]) -> list[str]:
    """Each flight that was not flown to the end: when and how it ended."""
    lines = [
        f"| {result.cell.title} | {result.cell.w20_ft_s:g} | {record['seed']} | {Outcome(record['outcome']).sentence} "
        f"| {record['end_time_s']:.1f} |"
        for result in results
        for record in result.lost
    ]
    head = ["", "## Flights that were lost", ""]
    if not lines:
        return [*head, "None."]
    return [*head, "| failure | W20 | seed | how | at s |", "| --- | --- | --- | --- | --- |", *lines]


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--seeds", type=int, default=20, help="flights a cell")
    parser.add_argument("--first-seed", type=int, default=FIRST_SEED)
    parser.add_argument("--w20", type=float, nargs="+", default=[25.0, 50.0], metavar="FT_S")
    parser.add_argument("--controller", default=CONTROLLER, help="the scenario's controller block")
    parser.add_argument("--group", choices=GROUPS, action="append", help="only these rows")
    parser.add_argument("--jobs", type=int, help="processes (default: one a core)")
    parser.add_argument("--quick", action="store_true", help="2 seeds")
    parser.add_argument(
        "--out", type=Path, default=Path(__file__).parents[1] / "docs" / "results" / "hold_it.md"
    )
    options = parser.parse_args(arguments)
    seeds = range(options.first_seed, options.first_seed + (2 if options.quick else options.seeds))
    table = [cell for cell in cells(options.w20) if not options.group or cell.group in options.group]
    text = document(fly_cells(table, seeds, options.controller, options.jobs), seeds, options.controller)
    options.out.write_text(text, encoding="utf-8")
    print(text.split("## Every cell")[0])
    print(f"wrote {options.out}")


if __name__ == "__main__":
    main()

"""Fly controllers on missions with failures and compare them, paired by seed. Prints tables and keeps every flight in a CSV.

    python benchmarks/missions.py --list
    python benchmarks/missions.py --missions hard,slow --seeds 6 --controllers default,oracle --jobs 1
    python benchmarks/missions.py --missions tail_jam --controller 'new={type: adaptive_inversion, threshold: 0.1}'

The flights of a report, in pieces; each may be stopped and run again:

    python benchmarks/missions.py --reporting --resume --csv runs/reporting.csv
    python benchmarks/missions.py --reporting --resume --csv runs/reporting.csv --controllers default,ablations
    python benchmarks/missions.py --reporting --resume --csv runs/reporting.csv --w20 0
    python benchmarks/missions.py --reporting --resume --csv runs/reporting.csv --model-error 0.2
    python benchmarks/missions.py --reporting --resume --csv runs/reporting.csv --model-error 0 0.2 --aircraft vtail_aft

A choice of missions is a word of their names, or several joined by `_`. Seeds for tuning are below 50000 and those for
reporting are from 90001 on; the two are never mixed. `--against FILE` compares with the flights of an earlier CSV, such as
those of the program before a change.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any, get_args

from flights import fly_each
from mission_list import BASE, MISSIONS, Condition, Mission, chosen
from mission_results import Row, Table, by_mission, loses, totals

from testbed.controllers.config import Part
from testbed.inputs.yaml_source import parse

TUNING_END, REPORTING_START = 50000, 90001
"""Seeds for tuning are below the first; those for reporting start at the second."""
CONTROLLERS: dict[str, Mapping[str, Any]] = {
    "default": {"type": "adaptive_inversion"},
    "oracle": {"type": "informed_inversion"},
    "imm_inversion": {"type": "imm_inversion"},
    "indi_monitor": {"type": "indi", "monitor": True},
    "indi": {"type": "indi"},
    "rls_inversion": {"type": "rls_inversion"},
    "fixed_inversion": {"type": "fixed_inversion"},
    "pid": {"type": "pid"},
}
"""Those that are flown if nothing else is asked for."""
ABLATED: dict[str, Mapping[str, Any]] = {
    f"without_{part}": {"type": "adaptive_inversion", "ablate": [part]} for part in get_args(Part)
}
OTHERS: dict[str, Mapping[str, Any]] = {
    "paper": {"type": "adaptive_inversion", "preset": "paper", "filter_rad_s": 20.0},
    "l1_inversion": {"type": "l1_inversion"},
}
KNOWN = {**CONTROLLERS, **ABLATED, **OTHERS}


def main(arguments: Sequence[str] | None = None) -> None:
    options = _parser().parse_args(arguments)
    if options.list:
        return print("\n".join(mission.name for mission in MISSIONS))
    missions, controllers = chosen(MISSIONS, options.missions), _controllers(options)
    seeds = _seeds(options.reporting, options.seeds, options.first_seed)
    conditions = [Condition(*each) for each in product(options.aircraft, options.w20, options.model_error)]
    plan = [
        (name, mission, condition, seed)
        for condition in conditions
        for mission in missions
        for name in controllers
        for seed in seeds
    ]
    earlier = Table(options.against).read() if options.against else []
    table = Table(options.csv)
    before = table.read() if options.resume else []
    wanted = {(name, mission.name, condition, seed) for name, mission, condition, seed in plan}
    every = table.write(fly(plan, controllers, before, options.jobs))
    rows = [row for row in every if (row.controller, *row.key) in wanted]
    rows.sort(key=lambda row: list(controllers).index(row.controller))
    reference = next(iter(controllers))
    for condition in conditions:
        _print(condition.title, [row for row in rows if row.condition == condition], reference)
    if options.against:
        print(f"\n## Compared with {options.against}\n")
        print("\n".join(against(rows, earlier)))
    print(f"\n{len(rows)} flights in {options.csv}")


def fly(
    plan: Sequence[tuple[str, Mission, Condition, int]],
    controllers: Mapping[str, Mapping[str, Any]],
    before: Iterable[Row],
    jobs: int | None,
) -> Iterator[Row]:
    """The rows `before`, then those of the plan that are missing there, as each has flown."""
    done = set()
    for row in before:
        done.add((row.controller, *row.key))
        yield row
    missing = [each for each in plan if (each[0], each[1].name, each[2], each[3]) not in done]
    flights = [
        (seed, {"controller": dict(controllers[name]), **condition.values(mission, seed)})
        for name, mission, condition, seed in missing
    ]
    for number, record in fly_each(BASE, flights, jobs):
        name, mission, condition, _ = missing[number]
        yield Row.of(name, mission, condition, record)


def against(rows: Sequence[Row], earlier: Sequence[Row]) -> list[str]:
    """Markdown table of each controller's totals now and in earlier flights, paired."""
    lines: list[str] = []
    for name in dict.fromkeys(row.controller for row in rows):
        old = [replace(row, controller=f"{name}, before") for row in earlier if row.controller == name]
        keys = {row.key for row in old}
        now = [row for row in rows if row.controller == name and row.key in keys]
        common = {row.key for row in now}
        both = [*now, *(row for row in old if row.key in common)]
        if now:
            lines += [*by_mission(both), "", *totals(both, name), ""]
    return lines


def _print(title: str, rows: Sequence[Row], reference: str) -> None:
    print(f"\n## {title}\n\nheld/survived/flights; one number where all survived\n")
    print("\n".join([*by_mission(rows), "", *totals(rows, reference)]))
    print("\n".join(["", *loses(rows, reference)]))


def _controllers(options: argparse.Namespace) -> dict[str, Mapping[str, Any]]:
    own = {}
    for text in options.controller:
        name, equals, settings = text.partition("=")
        if not equals:
            raise SystemExit(f"--controller {text}: expected NAME={{type: ..., ...}}")
        own[name] = parse(settings, "--controller").tree
    asked = options.controllers.split(",") if options.controllers else list(CONTROLLERS)
    names = [name for word in asked for name in (ABLATED if word == "ablations" else (word,))]
    unknown = [name for name in names if name not in KNOWN]
    if unknown:
        raise SystemExit(f"--controllers: {unknown[0]} is none of {', '.join(KNOWN)}")
    return {**{name: KNOWN[name] for name in names}, **own}


def _seeds(reporting: bool, count: int | None, first: int | None) -> range:
    """The seeds of each cell; exits if seeds for tuning and for reporting would be mixed."""
    start = first if first is not None else REPORTING_START if reporting else 1
    seeds = range(start, start + (count or (20 if reporting else 6)))
    if reporting and seeds.start < REPORTING_START:
        raise SystemExit(f"--reporting: seeds are {REPORTING_START} or more")
    if not reporting and seeds.stop > TUNING_END:
        raise SystemExit(f"seeds of {TUNING_END} and more are not for tuning; for a report: --reporting")
    return seeds


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    add = parser.add_argument
    add("--list", action="store_true", help="print the names of the missions")
    add("--missions", metavar="A,B", help="only missions with these words in their names")
    add(
        "--controllers",
        metavar="A,B",
        help=f"some of {', '.join(KNOWN)}; the first is the reference; `ablations` is all without_...",
    )
    add("--controller", action="append", default=[], metavar="NAME={...}", help="one more, by its settings")
    add("--seeds", type=int, help="flights a cell: 6, with --reporting 20")
    add("--first-seed", type=int)
    add("--reporting", action="store_true", help="seeds kept for reports; no gain is chosen on them")
    add("--w20", type=float, nargs="+", default=[25.0], metavar="FT_S")
    add("--model-error", type=float, nargs="+", default=[0.0], metavar="SHARE")
    add("--aircraft", nargs="+", default=["vtail"])
    add("--jobs", type=int, help="processes (default: one a core)")
    add("--csv", type=Path, default=Path("runs") / "missions.csv", help="where every flight is kept")
    add("--resume", action="store_true", help="keep every flight that the CSV has, and fly the missing ones")
    add("--against", type=Path, metavar="CSV", help="compare with earlier flights of the same controllers")
    return parser


if __name__ == "__main__":
    main()

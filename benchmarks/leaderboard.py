"""Compare every controller for every type of failure, with the same seeds. Writes docs/results/leaderboard.md.

python benchmarks/leaderboard.py            # 3 seeds, calm air and W20 = 25 ft/s: some 1500 flights
python benchmarks/leaderboard.py --quick    # 1 seed
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from flights import Record, fly_all
from hold_it import BASE, FAILURE_S, FIRST_SEED, FT_S

from testbed.failures import TABLE as FAILURES
from testbed.flight.flight import Flight, Outcome
from testbed.metrics import readings
from testbed.metrics.flight_view import settled_after
from testbed.scenario.load import Scenario
from testbed.simulation import fly

CONTROLLERS: Mapping[str, Mapping[str, Any]] = {
    "adaptive_inversion, paper": {"type": "adaptive_inversion", "preset": "paper", "filter_rad_s": 20.0},
    "adaptive_inversion": {"type": "adaptive_inversion"},
    "fixed_inversion": {"type": "fixed_inversion"},
    "pid": {"type": "pid"},
    "indi": {"type": "indi"},
    "rls_inversion": {"type": "rls_inversion"},
    "imm_inversion": {"type": "imm_inversion"},
    "l1_inversion": {"type": "l1_inversion"},
}
ACTUATOR = {"servo": "left_ruddervator", "motor": "right_propeller"}
PROPERTY = {"set": {"fcs/left-ruddervator/effectiveness": 0.5, "fcs/right-propeller/effectiveness": 0.5}}
BAND = {"altitude": 5.0, "heading": 10.0}
"""A flight has recovered once both errors stay within these limits [m, deg]."""


def failures() -> list[tuple[str, dict[str, Any]]]:
    """(title, failure) of each type, with its own `examples`: on a servo and on a motor, where the type is for both."""
    found: list[tuple[str, dict[str, Any]]] = []
    for name, kind in FAILURES.items():
        for of, fields in kind.examples.items():
            failure = {"type": name, "actuator": ACTUATOR[of], "at_s": FAILURE_S, **fields}
            words = ", ".join(f"{key} {value}" for key, value in fields.items())
            found.append((f"{name} {words}".strip() + f", {ACTUATOR[of]}", failure))
        if not kind.examples:
            found.append(
                (f"{name}: both at 0.5 by their properties", {"type": name, "at_s": FAILURE_S, **PROPERTY})
            )
    return found


def fly_and_judge(scenario: Scenario) -> Flight:
    """Fly, and add the metric `recovery_s`: time from the failure until both errors stay within BAND, NaN if never."""
    flight = fly(scenario)
    log = readings(flight)
    errors = {name: np.abs(log.error(name)) for name in BAND}
    start = log.row_at(FAILURE_S)
    outside = ~((errors["altitude"] <= BAND["altitude"]) & (errors["heading"] <= BAND["heading"]))
    row = settled_after(outside, start) if flight.outcome is Outcome.completed else None
    found = {"recovery_s": math.nan if row is None else float(log.time_s[row]) - FAILURE_S}
    return replace(flight, metrics={**flight.metrics, **found})


def cell(records: Sequence[Record]) -> str:
    """A cell of the table by failure: share flown to the end, slowest recovery, largest errors, effort in thousands [1/s]."""
    flown = [record["metrics"] for record in records if record["outcome"] == "completed"]
    if not flown:
        return f"**0/{len(records)}**"
    share = f"{len(flown)}/{len(records)}"
    recoveries = [m["recovery_s"] for m in flown]
    recovered = "never" if any(map(math.isnan, recoveries)) else f"{max(recoveries):.1f} s"
    altitude, heading = (
        max(m[f"{name}_excursion_failed_{unit}"] for m in flown)
        for name, unit in (("altitude", "m"), ("heading", "deg"))
    )
    effort = median(m["control_effort_per_s"] for m in flown) / 1e3
    shown = share if len(flown) == len(records) else f"**{share}**"
    return f"{shown}; {recovered}; {altitude:.1f} m, {heading:.0f} deg; {effort:.0f}"


def totals(records: Sequence[Record]) -> list[str]:
    """Cells for all flights of a controller: survived, recovered, median of the survivors' worst errors, median effort."""
    flown = [record["metrics"] for record in records if record["outcome"] == "completed"]
    recovered = [m for m in flown if not math.isnan(m["recovery_s"])]
    n = len(records)

    def middle(metric: str) -> float:
        return median(m[metric] for m in flown) if flown else math.nan

    return [
        f"{len(flown)} of {n}", f"{len(recovered)} of {n}",
        f"{middle('altitude_excursion_failed_m'):.1f} m", f"{middle('heading_excursion_failed_deg'):.1f} deg",
        f"{middle('control_effort_per_s') / 1e3:.0f}",
    ]  # fmt: skip


Flown = Mapping[str, Sequence[Sequence[Record]]]
"""Records by controller, then by failure, then by seed."""


def document(kinds: Sequence[str], weathers: Mapping[float, Flown], seeds: Sequence[int]) -> str:
    """The Markdown of docs/results/leaderboard.md; `kinds` are titles of failures, `weathers` the flights by W20 [ft/s]."""
    lines = [
        "# Leaderboard: every controller against every type of failure",
        "",
        "<!-- Written by python benchmarks/leaderboard.py: change that, not this. -->",
        "",
        "This page compares the built-in controllers for every type of failure, each flown with the same seeds.",
        "",
        f"MEMS sensors, seeds {', '.join(map(str, seeds))}; the turns and climbs of [Hold it](hold_it.md), failure at "
        f"{FAILURE_S:g} s, end at 110 s. `fixed_inversion`, `pid` and `indi` were tuned on healthy flights alone.",
        "",
        f"**Recovered** means: after the failure there is a time from which on altitude stays within {BAND['altitude']:g} m "
        f"and heading within {BAND['heading']:g} deg of their references. **Effort** is the median of `control_effort_per_s`, in "
        "thousands.",
        "Worst errors and effort are those of the flights that were flown to the end.",
    ]
    for w20, records in weathers.items():
        lines += ["", f"## {title(w20)}", ""]
        lines.append(
            "| controller | settings | survived | recovered | worst altitude (median) | heading | effort |"
        )
        lines.append("| --- | --- | --- | --- | --- | --- | --- |")
        for name, by_failure in records.items():
            settings = ", ".join(f"{key}: {value}" for key, value in CONTROLLERS[name].items())
            every = [record for cases in by_failure for record in cases]
            lines.append(f"| {name} | `{settings}` | {' | '.join(totals(every))} |")
    lines += [
        "",
        "## By failure",
        "",
        "Each cell has: flights flown to the end; the slowest recovery of these (`never` if one of them did not recover); the",
        "largest errors of altitude and heading after the failure; effort. Failures such as stuck, bias and reversal are not a",
        "loss of effectiveness, so the paper's assumption does not hold for them.",
    ]
    for w20, records in weathers.items():
        lines += ["", f"### {title(w20)}: by failure", ""]
        lines += [f"| failure | {' | '.join(records)} |", f"| --- |{' --- |' * len(records)}"]
        for i, kind in enumerate(kinds):
            lines.append(f"| {kind} | {' | '.join(cell(by_failure[i]) for by_failure in records.values())} |")
    return "\n".join(lines) + "\n"


def title(w20_ft_s: float) -> str:
    return f"W20 = {w20_ft_s:g} ft/s" if w20_ft_s else "Calm air"


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--seeds", type=int, default=3, help="flights a cell")
    parser.add_argument("--first-seed", type=int, default=FIRST_SEED)
    parser.add_argument("--quick", action="store_true", help="1 seed")
    parser.add_argument("--w20", type=float, nargs="+", default=[0.0, 25.0], metavar="FT_S")
    parser.add_argument(
        "--only", nargs="+", choices=FAILURES, metavar="TYPE", help="only these types of failure"
    )
    parser.add_argument("--jobs", type=int, help="processes (default: one a core)")
    parser.add_argument(
        "--out", type=Path, default=Path(__file__).parents[1] / "docs" / "results" / "leaderboard.md"
    )
    options = parser.parse_args(arguments)
    seeds = range(options.first_seed, options.first_seed + (1 if options.quick else options.seeds))
    kinds = [(t, f) for t, f in failures() if not options.only or f["type"] in options.only]
    plan = [
        (seed, {"controller": settings, "failures": [failure], "atmosphere.turbulence_w20_m_s": w20 * FT_S})
        for w20 in options.w20
        for settings in CONTROLLERS.values()
        for _, failure in kinds
        for seed in seeds
    ]
    flown = iter(
        fly_all(BASE.format(controller="{type: pid}"), plan, options.jobs, "leaderboard:fly_and_judge")
    )
    weathers = {
        w20: {name: [[next(flown) for _ in seeds] for _ in kinds] for name in CONTROLLERS}
        for w20 in options.w20
    }
    text = document([title for title, _ in kinds], weathers, seeds)
    options.out.write_text(text, encoding="utf-8")
    print(text.split("## By failure")[0])
    print(f"wrote {options.out}")


if __name__ == "__main__":
    main()

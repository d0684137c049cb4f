"""Write the pages of the documentation that rest on missions, from a CSV of `missions.py --reporting`.

    python benchmarks/mission_report.py runs/reporting.csv            # results/missions.md, explanation/when_adaptation_pays.md
    python benchmarks/mission_report.py runs/reporting.csv --trims    # and which missions can be flown at all: minutes

Exits if a seed for tuning is among the flights.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path

import mission_figures
import mission_findings
from mission_list import (
    ALTITUDE_M,
    DURATION_S,
    FAILURE_S,
    HEADING_DEG,
    MISSIONS,
    ROUTES,
    SECOND_S,
    Condition,
    Mission,
)
from mission_results import (
    FAMILIES,
    Row,
    Table,
    by_mission,
    cell,
    delays,
    errors,
    family,
    loses,
    share,
    totals,
)
from missions import ABLATED, KNOWN, REPORTING_START, TUNING_END
from true_trims import table as trims_of
from true_trims import words

DOCS = Path(__file__).parents[1] / "docs"
REFERENCE, BOUND = "default", "oracle"
INTRODUCTION = f"""\
# Missions: every controller, flown hard

<!-- Written by python benchmarks/mission_report.py: change that, not this. -->

This page compares the controllers on missions with failures: slow and fast flight, hard turns and climbs, references
that move through the failure, single and double losses, jams, reversals and more.

**Survived** means flown to the end, without ground contact and within the flight envelope. **Held** means survived, and
within {ALTITUDE_M:g} m of the altitude and {HEADING_DEG:g} deg of the heading asked for, all the time from the first failure on.

`vtail` is the shipped aircraft, and `vtail_aft` the same with its mass so far aft that it is unstable in pitch. W20 is the
wind at 20 ft by which MIL-F-8785C gives the strength of turbulence. With the model 20 % off, each aerodynamic coefficient
of the design model is 20 % too large or too small, by chance. A *cell* is the flights of one mission in one condition by
one controller, which differ by seed. All fly with MEMS sensors.

`{REFERENCE}` is `{{{{type: adaptive_inversion}}}}` and nothing else. `{BOUND}` is the same law, told the truth about every
actuator at once. It is no bound: with other commands it meets other moments of the turbulence, and it gives up a propeller
that works on and off each time that it stops. [The others](../reference/controllers.md) have the same released axis,
allocation and limits, and all but `pid` the same outer loops. Seeds are {{first}} to {{last}}; those below {TUNING_END} were
for tuning, and no gain was chosen on these. Intervals are of paired differences, 95 % (Newcombe).

**Detection** is the longest time in a flight from a failure to the flag of its actuator: the median over flights, and
what 95 % do not exceed ([how soon a loss could be known](detection.md)). **Missed** are losses (effectiveness 0.1 or less
for over 2 s) that were never flagged, and false alarms are flags of actuators that were not broken.

To fly one again: `python benchmarks/missions.py --reporting --missions NAME --first-seed SEED --seeds 1 --w20 25`; `--help`
says how the conditions are chosen. [When adaptation pays](../explanation/when_adaptation_pays.md) is from the same flights.
"""
STEADY = """\
The last column has the steady flights of the broken v-tail on JSBSim itself, looked for in steps of 0.5 m/s
(`benchmarks/true_trims.py`), so that one in a narrower range is missed. The margin is how far the actuator nearest to a stop
is from it, as a share of half its travel, at the airspeed where this is largest.
"""


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("csv", type=Path)
    parser.add_argument("--docs", type=Path, default=DOCS, help="folder to write into")
    parser.add_argument("--trims", action="store_true", help="look for the steady flights of every mission")
    options = parser.parse_args(arguments)
    rows = reporting_rows(options.csv)
    trims = {m.name: words(found) for m, found in _trims()} if options.trims else {}
    for folder in ("results", "explanation", "figures"):
        (options.docs / folder).mkdir(parents=True, exist_ok=True)
    mission_figures.draw(rows, options.docs / "figures")
    mission_findings.draw(rows, options.docs / "figures")
    pages = {"results/missions.md": document(rows, trims)}
    pages["explanation/when_adaptation_pays.md"] = mission_findings.page(rows, trims, BOUND)
    for name, text in pages.items():
        (options.docs / name).write_text(text, encoding="utf-8")
        print(f"wrote {options.docs / name}")


def reporting_rows(file: Path) -> list[Row]:
    """The flights of a CSV, in the order of KNOWN; exits if there are none or one has a seed for tuning."""
    rows = Table(file).read()
    if not rows:
        raise SystemExit(f"{file}: no flights")
    tuned = sorted({row.seed for row in rows if row.seed < REPORTING_START})
    if tuned:
        raise SystemExit(
            f"{file}: seed {tuned[0]} is for tuning; a report is of seeds from {REPORTING_START} on"
        )
    order = list(KNOWN)
    return sorted(
        rows, key=lambda row: order.index(row.controller) if row.controller in order else len(order)
    )


def document(rows: Sequence[Row], trims: Mapping[str, str]) -> str:
    """The Markdown of docs/results/missions.md."""
    rows = [row for row in rows if row.controller not in ABLATED]
    seeds, conditions = sorted({row.seed for row in rows}), sorted({row.condition for row in rows})
    lines = [
        INTRODUCTION.format(first=seeds[0], last=seeds[-1]),
        f"## Where another holds more than `{REFERENCE}`",
        "",
        "By two flights of a cell or more:",
        "",
        *(loses(rows, REFERENCE) or ["Nowhere."]),
        "",
        "## All flights",
        "",
        *totals(rows, REFERENCE),
        "",
        f"The best of all of them in each cell holds {best_of_each_cell(rows):.3f}.",
        "",
        "![Share of missions held, by kind of failure](../figures/missions_families.png)",
        "",
        "## By kind of failure",
        "",
        *by_family(rows),
        "",
        "## By condition",
        "",
        *by_condition(rows, conditions),
        "",
        "## Single losses",
        "",
        f"`{REFERENCE}`: flights held / survived / flown (where all survived, held / flown), and the worst errors.",
        "",
        *single_losses(rows, conditions),
        "",
        "## Each mission",
        "",
        "Flights held / survived / flown in all conditions together; where all survived, held / flown.",
        "",
        *by_mission(rows),
        "",
        *_missions(trims),
    ]
    return "\n".join(lines) + "\n"


def best_of_each_cell(rows: Sequence[Row]) -> float:
    """Share of the flights that would be held if in each cell the controller flew that holds the most of it."""
    held: dict[tuple[str, Condition], dict[str, list[bool]]] = {}
    for row in rows:
        held.setdefault((row.mission, row.condition), {}).setdefault(row.controller, []).append(row.held)
    best = [max(of.values(), key=sum) for of in held.values()]
    return sum(map(sum, best)) / sum(map(len, best))


def single_losses(rows: Sequence[Row], conditions: Sequence[Condition]) -> list[str]:
    """Markdown table: how the reference holds each single loss in each condition."""
    own = [row for row in rows if row.controller == REFERENCE and family(row.mission) == "one actuator lost"]
    lines = [
        f"| mission | {' | '.join(c.title for c in conditions)} |",
        f"| --- |{' --- |' * len(conditions)}",
    ]
    for mission in dict.fromkeys(row.mission for row in own):
        of = [[r for r in own if (r.mission, r.condition) == (mission, c)] for c in conditions]
        lines.append(
            f"| {mission} | {' | '.join(f'{cell(each)}; {errors(each)}' if each else '' for each in of)} |"
        )
    return lines


def by_family(rows: Sequence[Row]) -> list[str]:
    """Markdown table: share held by kind of failure and controller, and how soon the reference flags it.

    The last column is told apart by kind, because a jam near the trim position is found only when its surface is needed."""
    names = list(dict.fromkeys(row.controller for row in rows))
    lines = [
        f"| kind | {' | '.join(names)} | {REFERENCE}: detection s: median, 95 % |",
        "| --- |" + " --- |" * (len(names) + 1),
    ]
    for kind in FAMILIES:
        of = [[r for r in rows if family(r.mission) == kind and r.controller == name] for name in names]
        if any(of):
            own = [r for each in of for r in each if r.controller == REFERENCE]
            lines.append(f"| {kind} | {' | '.join(map(share, of))} | {delays(own)} |")
    return lines


def by_condition(rows: Sequence[Row], conditions: Sequence[Condition]) -> list[str]:
    """Markdown table: share held by condition and controller."""
    names = list(dict.fromkeys(row.controller for row in rows))
    lines = [f"| condition | {' | '.join(names)} |", f"| --- |{' --- |' * len(names)}"]
    for condition in conditions:
        of = [[r for r in rows if r.condition == condition and r.controller == name] for name in names]
        lines.append(f"| {condition.title} | {' | '.join(map(share, of))} |")
    return lines


def _missions(trims: Mapping[str, str]) -> list[str]:
    """What each mission is, and the steady flights that the truth has in it, if they were looked for."""
    times = f"Each lasts {DURATION_S:g} s, so that a slow loss may come later; failures begin at {FAILURE_S:g} s, a second one at"
    lines = [
        "## What each mission is",
        "",
        f"{times} {SECOND_S:g} s.",
        "The first word of a name is the route.",
        "",
    ]
    lines += ["| route | airspeed m/s | what |", "| --- | --- | --- |"]
    lines += [f"| {name} | {route.airspeed_m_s:g} | {route.words} |" for name, route in ROUTES.items()]
    heads = ["mission", "failures", *(["steady flight"] if trims else [])]
    lines += ["", *([STEADY] if trims else []), f"| {' | '.join(heads)} |", f"|{' --- |' * len(heads)}"]
    for mission in MISSIONS:
        cells = [mission.name, "; ".join(map(_said, mission.failures)) or "none"]
        lines.append(f"| {' | '.join([*cells, trims[mission.name]] if trims else cells)} |")
    return lines


def _said(failure: Mapping[str, object]) -> str:
    """`stuck left_propeller at_s 35`."""
    fields = {key: value for key, value in failure.items() if key != "at_s" or value != FAILURE_S}
    words = (str(value) if key in ("type", "actuator") else f"{key} {value:g}" if isinstance(value, float) else f"{key} {value}"
             for key, value in fields.items())  # fmt: skip
    return f"`{' '.join(words)}`"


def _trims() -> list[tuple[Mission, list]]:
    found = trims_of(MISSIONS, "vtail")
    return [(mission, found[mission.name]) for mission in MISSIONS]


if __name__ == "__main__":
    main()

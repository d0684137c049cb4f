"""Diagnose our own flights from their logs, for every type of failure. Writes docs/results/own_logs.md.

    python benchmarks/diagnose_own_flights.py --seeds 2 --first-seed 96001

Each type breaks a servo and a motor where it can, in calm air with ideal sensors, and in weather with MEMS sensors. The log that is
read has commands and what sensors read, 100 rows a second; the truth is only compared with.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from aside import aside

import testbed
from testbed.failures import TABLE
from testbed.flight.flight import Flight
from testbed.inputs.yaml_source import dump
from testbed.logs.diagnosis import Diagnosis

PAGE = Path(__file__).parents[1] / "docs" / "results" / "own_logs.md"
AT_S, END_S = 20.0, 70.0
HEALTHY = 15  # flights for each seed
ACTUATORS = {"servo": "left_ruddervator", "motor": "right_propeller"}
BASE: dict[str, Any] = {
    "aircraft": "vtail", "duration_s": END_S, "log_hz": 100,
    "commands": [{"at_s": 5, "heading_deg": 110}, {"at_s": 12, "altitude_m": 306}, {"at_s": 24, "heading_deg": 80},
                 {"at_s": 36, "altitude_m": 300}, {"at_s": 48, "heading_deg": 110}, {"at_s": 58, "airspeed_m_s": 20}],
    "command_rates": {"heading_deg_s": 6, "altitude_m_s": 1},
}  # fmt: skip
WEATHER: dict[str, dict[str, Any]] = {
    "calm": {},
    "MEMS": {"sensors": {"model": "mems"}, "atmosphere": {"turbulence_w20_m_s": 5}},
}
NAMES: dict[str, set[str]] = {
    "effectiveness": {"weak", "lost"}, "command_scale": {"weak", "lost"}, "stuck": {"held"}, "stuck_at": {"held"},
    "hardover": {"held"}, "float": {"lost", "held"}, "bias": {"offset"}, "position_limit": {"held", "weak"},
    "rate_limit": {"slow"}, "lag": {"slow"}, "delay": {"late"}, "oscillation": {"swings"}, "runaway": {"held"},
    "reversal": {"reversed"}, "intermittent": {"weak"}, "decay": {"weak", "lost"}, "prop_loss": {"lost"},
    "motor_stop": {"lost", "held"}, "surface_lost": {"lost"}, "property": {"weak"},
}  # fmt: skip
"""The states that are right for each type."""


_ABOUT = """# Our own flights, from their logs

<!-- Written by python benchmarks/diagnose_own_flights.py: change that, not this. -->

This page shows what [`testbed diagnose`](../reference/diagnose.md) says of flights of the v-tail whose truth is known.

A flight of {end_s:g} s turns, climbs and changes speed; one actuator fails at {at_s:g} s with the values of the catalogue.
Seeds {first} to {last}. MEMS is with such sensors, and turbulence of W20 5 m/s. *Named* counts the state of the longest finding.
The error is that of the effectiveness in windows of 10 s, where there is one.
*Aboard* is the delay of the flag of the controller that flew.
"""


class Row(NamedTuple):
    """What came of one flight; NaN and empty where there is nothing to say."""

    failure: str
    kind: str
    found: bool
    named: bool
    said: str
    delay_s: float
    error: float
    aboard_s: float
    others: int
    early: int


def main(arguments: Sequence[str] | None = None) -> None:
    options = _parser().parse_args(arguments)
    seeds = range(options.first_seed, options.first_seed + options.seeds)
    rows = {weather: [row for seed in seeds for row in _rows(weather, seed)] for weather in WEATHER}
    whole = range(options.first_seed + 100, options.first_seed + 100 + HEALTHY * options.seeds)
    healthy = {weather: [len(_healthy(weather, seed).findings) for seed in whole] for weather in WEATHER}
    each = aside(failures(rows), options.page.with_suffix(".csv"))
    options.page.write_text("\n".join([page(rows, healthy, seeds), *each, ""]), encoding="utf-8")
    print(f"wrote {options.page}")


def _rows(weather: str, seed: int) -> Iterator[Row]:
    for name in TABLE:
        for kind, failure in _failures(name):
            flight, found = flown({**BASE, **WEATHER[weather], "seed": seed, "failures": [failure]})
            yield judged(name, kind, flight, found)


def _failures(name: str) -> Iterator[tuple[str, dict[str, Any]]]:
    """(kind, failure) of a type, with the values of the catalogue."""
    if name == "property":
        yield "servo", {"type": name, "at_s": AT_S, "set": {"fcs/left-ruddervator/effectiveness": 0.4}}
        return
    for kind, values in TABLE[name].examples.items():
        if kind in ACTUATORS:
            yield kind, {"type": name, "actuator": ACTUATORS[kind], "at_s": AT_S, **values}


def _healthy(weather: str, seed: int) -> Diagnosis:
    return flown({**BASE, **WEATHER[weather], "seed": seed})[1]


def flown(scenario: Mapping[str, Any]) -> tuple[Flight, Diagnosis]:
    """The flight of a scenario, and what its log says."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "scenario.yaml"
        file.write_text(dump({"name": "own log", **scenario}))
        flight = testbed.fly(file)
        return flight, testbed.diagnose(flight.save(Path(folder) / "run"))


def judged(name: str, kind: str, flight: Flight, found: Diagnosis) -> Row:
    """The findings against the truth, and the delay of what flew."""
    actuator = ACTUATORS[kind]
    own = [f for f in found.findings if f.actuator == actuator and f.until_s > AT_S]
    others = [f for f in found.findings if f.actuator != actuator]
    longest = max(own, key=lambda f: f.until_s - f.from_s, default=None)
    flags = [e["time_s"] for e in flight.events if e["kind"] == "detection" and e["actuator"] == actuator]
    aboard = flags[0] - AT_S if flags else np.nan
    return Row(
        name, kind, bool(own), longest is not None and longest.state in NAMES[name],
        longest.state if longest else "-", own[0].from_s - AT_S if own else np.nan,
        _error(found, actuator), aboard, len(others), sum(f.from_s < AT_S - 1.0 for f in own),
    )  # fmt: skip


def _error(found: Diagnosis, actuator: str) -> float:
    """Root mean square of the effectiveness in windows of 10 s, after the failure, where truth and log say one."""
    i = found.actuators.index(actuator)
    truth = np.interp(found.time_s, found.log.time_s, found.log.truth[actuator])
    late = found.time_s > AT_S + 1.0
    error = (found.effectiveness[:, i] - truth)[late]
    means = [np.mean(part) for part in np.array_split(error, max(len(error) // 50, 1))]
    return float(np.sqrt(np.nanmean(np.square(means)))) if np.any(np.isfinite(means)) else np.nan


def page(rows: Mapping[str, Sequence[Row]], healthy: Mapping[str, Sequence[int]], seeds: range) -> str:
    """The page in Markdown."""
    about = _ABOUT.format(end_s=END_S, at_s=AT_S, first=seeds[0], last=seeds[-1])
    heads = "| | flights | found | named | others flagged | flagged early | median delay, s | aboard, s |"
    lines = [about, heads, "| --- " * 8 + "|"]
    for weather, all_rows in rows.items():
        early, others = (sum(getattr(r, what) > 0 for r in all_rows) for what in ("early", "others"))
        delays = [np.nanmedian([getattr(r, what) for r in all_rows]) for what in ("delay_s", "aboard_s")]
        counts = (
            len(all_rows),
            sum(r.found for r in all_rows),
            sum(r.named for r in all_rows),
            others,
            early,
        )
        cells = [*map(str, counts), *(f"{delay:.2f}" for delay in delays)]
        lines.append(f"| {weather} | {' | '.join(cells)} |")
    counted = "; ".join(
        f"{weather} {sum(map(bool, each))} of {len(each)}" for weather, each in healthy.items()
    )
    lines += ["", f"Healthy flights in which something was found: {counted}.", ""]
    wrong = sorted({f"`{r.failure}` of a {r.kind}" for each in rows.values() for r in each if not r.named})
    return "\n".join(
        [*lines, f"Not found, or named otherwise, in a flight at least: {', '.join(wrong)}.", ""]
    )


def failures(rows: Mapping[str, Sequence[Row]]) -> list[str]:
    """The table of each failure, kind of actuator and weather."""
    lines = [
        "| failure | | weather | said | delay, s | effectiveness error | aboard, s |",
        "| --- " * 7 + "|",
    ]
    for name in TABLE:
        for kind in ACTUATORS:
            for weather, all_rows in rows.items():
                same = [r for r in all_rows if (r.failure, r.kind) == (name, kind)]
                if same:
                    said = ", ".join(f"{r.said} (right)" if r.named else r.said for r in same)
                    cells = [
                        _cell([getattr(r, what) for r in same]) for what in ("delay_s", "error", "aboard_s")
                    ]
                    lines.append(f"| {name} | {kind} | {weather} | {said} | {' | '.join(cells)} |")
    return lines


def _cell(values: Sequence[float]) -> str:
    known = [value for value in values if np.isfinite(value)]
    return f"{np.median(known):.2f}" if known else "-"


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--first-seed", type=int, default=96001)
    parser.add_argument("--page", type=Path, default=PAGE)
    return parser


if __name__ == "__main__":
    main()

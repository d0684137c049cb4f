"""Fly the gallery: each aircraft healthy, with each actuator at 0.4 and at 0, in calm air and turbulence. Writes a page.

    python benchmarks/gallery.py FOLDER...
    python benchmarks/gallery.py FOLDER... --results runs/gallery --document docs/results/gallery.md

A FOLDER is an aircraft's name or folder, as in a scenario; `testbed adopt` makes those of the jsbsim package. Flights that are
in the results' folder already are not flown again. `--seeds 3` flies each in three turbulences; calm air has one.

The mission takes 90 s: a turn by 30 deg at 5 s, a climb by 20 m at 25 s, and the failure at 20 s, in the turn. A glider does not
climb. An aircraft survives if it is flown to the end. It holds if altitude stays within half a second of flight of its
reference, and heading within 15 deg, from the failure on.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml
from aside import aside

from testbed import fly
from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.common.statistics import proportion
from testbed.inputs.problems import BadInput

OTHERS = Path(__file__).parents[1] / "docs" / "results" / "gallery.csv"
DURATION_S, TURN_S, FAILURE_S, CLIMB_S = 90.0, 5.0, 20.0, 25.0
TURN_DEG, CLIMB_M = 30.0, 20.0
HEADING_DEG, ALTITUDE_S = 15.0, 0.5
W20_M_S = {"calm": 0.0, "turbulent": 7.62}
CONTROLLERS: Mapping[str, Mapping[str, Any]] = {
    "default": {"type": "adaptive_inversion"},
    "indi": {"type": "indi"},
}
SEED = 94001
"""Of the first turbulence."""
Row = dict[str, Any]
Case = tuple[str, str, str, float, int]
"""Controller, air, actuator that breaks, its effectiveness, seed."""


def main(arguments: Sequence[str] | None = None) -> None:
    options = _parser().parse_args(arguments)
    options.results.mkdir(parents=True, exist_ok=True)
    folders = {Path(folder).name: folder for folder in options.folders}  # one that is named twice counts once
    rows = [row for folder in folders.values() for row in rows_of(folder, options)]
    if options.document:
        options.document.write_text("\n".join(page(rows)) + "\n", encoding="utf-8")


def rows_of(folder: str, options: argparse.Namespace) -> list[Row]:
    """The rows of an aircraft's flights: those on disk, then the others as they are flown."""
    aircraft = load_aircraft(folder)
    file = options.results / f"{aircraft.name}.jsonl"
    rows = [json.loads(line) for line in file.read_text().splitlines()] if file.is_file() else []
    if options.flown:
        return rows
    done = {(row["controller"], row["air"], row["actuator"], row["value"], row["seed"]) for row in rows}
    for case in _cases(aircraft, options):
        if case not in done:
            row = flown(folder, aircraft, *case)
            rows.append(row)
            with file.open("a") as stream:
                stream.write(json.dumps(row) + "\n")
            print(_words(row), flush=True)
    return rows


def _cases(aircraft: Aircraft, options: argparse.Namespace) -> Iterator[Case]:
    """What is flown with an aircraft."""
    for controller in options.controllers.split(","):
        for air in options.air.split(","):
            for seed in range(SEED, SEED + (options.seeds if W20_M_S[air] else 1)):
                for actuator, value in _failures(aircraft, options):
                    yield controller, air, actuator, value, seed


def _failures(aircraft: Aircraft, options: argparse.Namespace) -> Iterator[tuple[str, float]]:
    """(actuator, effectiveness) of each flight; the first has no failure."""
    yield "", 1.0
    words = options.actuators.split(",")
    for value in map(float, options.values.split(",")):
        for actuator in aircraft.actuators:
            if any(word in actuator for word in words):
                yield actuator, value


def scenario(
    folder: str, aircraft: Aircraft, controller: str, air: str, actuator: str, value: float, seed: int
) -> dict[str, Any]:
    """One flight of the mission."""
    at, glider = aircraft.reference, not powered(aircraft)
    start = {"altitude_m": at.altitude_m, "airspeed_m_s": at.airspeed_m_s, "heading_deg": 90.0}
    climb = [] if glider else [{"at_s": CLIMB_S, "altitude_m": at.altitude_m + CLIMB_M}]
    failure = {"type": "effectiveness", "actuator": actuator, "at_s": FAILURE_S, "value": value}
    return {
        "name": f"gallery {aircraft.name}", "aircraft": folder, "duration_s": DURATION_S, "rate_hz": 200, "seed": seed,
        "initial": start, "controller": dict(CONTROLLERS[controller]),
        "commands": [{"at_s": 0, **start}, {"at_s": TURN_S, "heading_deg": 90.0 + TURN_DEG}, *climb],
        "failures": [failure] if actuator else [],
        **({"atmosphere": {"turbulence_w20_m_s": W20_M_S[air]}} if W20_M_S[air] else {}),
    }  # fmt: skip


def flown(
    folder: str, aircraft: Aircraft, controller: str, air: str, actuator: str, value: float, seed: int
) -> Row:
    """Fly one and say what came of it."""
    case = controller, air, actuator, value, seed
    with tempfile.TemporaryDirectory() as scratch:
        file = Path(scratch) / "gallery.yaml"
        file.write_text(yaml.safe_dump(scenario(folder, aircraft, *case)))
        try:
            flight = fly(file)
        except BadInput as error:  # such as a controller that has no design for this aircraft
            return _row(aircraft, case, refused=str(error.problems[0]))
    since = flight.log[flight.log["time_s"] >= (FAILURE_S if actuator else 0.0)]
    altitude = (since["altitude_m"] - since["altitude_command_m"]).abs().max()
    heading = ((since["heading_deg"] - since["heading_command_deg"] + 180.0) % 360.0 - 180.0).abs().max()
    end_s = float(flight.log["time_s"].iloc[-1])
    survived = end_s >= DURATION_S - 0.1
    within = not powered(aircraft) or altitude <= ALTITUDE_S * aircraft.reference.airspeed_m_s
    held = survived and bool(within) and bool(heading <= HEADING_DEG)
    errors = {"altitude_m": float(altitude), "heading_deg": float(heading)}
    return _row(aircraft, case, survived=survived, held=held, end_s=end_s, **errors)


def _row(aircraft: Aircraft, case: Case, **result: Any) -> Row:
    what = {"aircraft": aircraft.name, "powered": powered(aircraft)}
    names = "controller", "air", "actuator", "value", "seed"
    none = {
        "survived": False,
        "held": False,
        "end_s": 0.0,
        "altitude_m": 0.0,
        "heading_deg": 0.0,
        "refused": "",
    }
    return {**what, **dict(zip(names, case, strict=True)), **none, **result}


def powered(aircraft: Aircraft) -> bool:
    """Whether it has an engine or motor."""
    return any(each.kind != "servo" for each in aircraft.actuators.values())


def _words(row: Row) -> str:
    what = f"{row['actuator']} at {row['value']:g}" if row["actuator"] else "healthy"
    if row.get("refused"):
        return f"{row['aircraft']}, {what}, {row['air']}, {row['controller']}: {row['refused']}"
    end = "held" if row["held"] else "survived" if row["survived"] else f"lost at {row['end_s']:.0f} s"
    errors = f"{row['altitude_m']:.1f} m, {row['heading_deg']:.1f} deg"
    return f"{row['aircraft']}, {what}, {row['air']}, {row['controller']}: {end}, {errors}"


AIRS = ("calm", "turbulent")
KINDS: Mapping[str, Callable[[Row], bool]] = {
    "healthy": lambda row: not row["actuator"],
    "one at 0.4": lambda row: row["value"] == 0.4,
    "one lost": lambda row: row["value"] == 0.0,
}


def _table(kinds: Mapping[str, Sequence[Row]], keys: Sequence[tuple[str, str]]) -> Iterator[str]:
    """A line for each aircraft and controller."""
    yield "| aircraft | controller | " + " | ".join(kinds) + " |"
    yield "| --- | --- |" + " --- |" * len(kinds)
    for key in keys:
        cells = [_cell([r for r in of if (r["aircraft"], r["controller"]) == key]) for of in kinds.values()]
        yield f"| {' | '.join([*key, *cells])} |"


def page(rows: Sequence[Row]) -> Iterator[str]:
    """The page, in lines: one row for each aircraft, condition and controller."""
    yield "# Gallery"
    yield ""
    yield (
        "This page flies each aircraft of the gallery whole and broken. It is written by `python benchmarks/gallery.py`. "
        + " ".join((__doc__ or "").split("\n\n")[-1].split())
    )
    yield "Cells are `held/survived/flown`, then the largest errors of those that survived."
    yield "The default controller is not tuned for any of them. Sensors are ideal, in turbulence too. An empty cell was not flown."
    yield ""
    yield "![Each aircraft as its replay draws it; what moves is coloured](../figures/gallery.png)"
    yield ""
    kinds = {
        f"{air}, {name}": [r for r in rows if r["air"] == air and of(r)]
        for air in AIRS
        for name, of in KINDS.items()
    }
    kinds = {name: of for name, of in kinds.items() if of}
    keys = dict.fromkeys((row["aircraft"], row["controller"]) for row in rows)
    compared = {aircraft for aircraft, controller in keys if controller != "default"}
    yield from _table(kinds, [key for key in keys if key[0] in compared])
    yield ""
    yield "Of the others, which only the default flies:"
    yield from aside(_table(kinds, [key for key in keys if key[0] not in compared]), OTHERS)
    yield ""
    yield "Of powered aircraft, with the 95 % interval of Wilson:"
    yield ""
    yield "| lost | air | controller | aircraft | flown | held | survived |"
    yield "| --- | --- | --- | --- | --- | --- | --- |"
    counted = [row for row in rows if row["powered"] and (row["value"] == 0.0 or not row["actuator"])]
    for key in sorted({(_part(r), r["air"], r["controller"]) for r in counted}):
        these = [r for r in counted if (_part(r), r["air"], r["controller"]) == key]
        kinds_flown = len({r["aircraft"] for r in these})
        shares = (_share(these, "held"), _share(these, "survived"))
        yield f"| {' | '.join(key)} | {kinds_flown} | {len(these)} | {' | '.join(shares)} |"


def _share(rows: Sequence[Row], what: str) -> str:
    """A count of flights, and the interval of their share."""
    count = sum(row[what] for row in rows)
    interval = proportion(count, len(rows))
    return f"{count} ({100 * interval.low:.0f} to {100 * interval.high:.0f} %)"


def _part(row: Row) -> str:
    if not row["actuator"]:
        return "nothing"
    parts = ("elevator", "aileron", "rudder", "engine", "propeller", "ruddervator")
    return next((part for part in reversed(parts) if part in row["actuator"]), row["actuator"])


def _cell(rows: Sequence[Row]) -> str:
    if not rows:
        return ""
    alive = [row for row in rows if row["survived"]]
    count = f"{sum(r['held'] for r in rows)}/{len(alive)}/{len(rows)}"
    if not alive:
        return count
    return f"{count}; {max(r['altitude_m'] for r in alive):.1f} m, {max(r['heading_deg'] for r in alive):.1f} deg"


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folders", nargs="+", metavar="FOLDER")
    parser.add_argument("--results", type=Path, default=Path("runs/gallery"))
    parser.add_argument("--document", type=Path, help="page to write")
    parser.add_argument(
        "--flown", action="store_true", help="fly no more: the page of what is in the results' folder"
    )
    parser.add_argument("--controllers", default="default,indi")
    parser.add_argument("--air", default="calm,turbulent")
    parser.add_argument("--values", default="0.4,0", help="effectiveness of the broken actuator")
    parser.add_argument("--seeds", type=int, default=1, help="turbulences in which each is flown")
    parser.add_argument(
        "--actuators", default="", help="words in the names of those to break; all by default"
    )
    return parser


if __name__ == "__main__":
    main()

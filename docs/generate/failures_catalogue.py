"""Write the table of the page of failures and its figures from the table of failure types; every figure shows a flight.

python docs/generate/failures_catalogue.py            fly, draw and write docs/reference/failures.md and its figures
python docs/generate/failures_catalogue.py --check    write nothing; exit 1 if anything is not as it would be written
python docs/generate/failures_catalogue.py --out D    the same in folder D instead of docs
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))
from blocks import with_block

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.failures import TABLE
from testbed.flight.flight import Flight
from testbed.scenario.load import Scenario, dump
from testbed.simulation import fly

REFERENCE = Path(__file__).parents[1] / "reference"
AIRCRAFT = "vtail"
START_S, END_S, DURATION_S = 1.0, 2.5, 3.5
WIDTH_CM, HEIGHT_CM, DPI = 6.0, 4.0, 200
_SHARED = {"type", "actuator", "at_s", "until_s", "when"}


def shown(aircraft: Aircraft, name: str) -> tuple[str, dict[str, Any]]:
    """The actuator on which a type is shown, and the fields of the failure."""
    kind = TABLE[name]
    actuator = next(a for a, what in aircraft.actuators.items() if what.kind in kind.kinds)
    what = aircraft.actuators[actuator]
    fields: dict[str, Any] = {"type": name, "at_s": START_S}
    if kind.undone:
        fields["until_s"] = END_S
    if name == "property":
        return actuator, {**fields, "set": {f"{what.prefix}/command-scale": 0.5}}
    return actuator, {**fields, "actuator": actuator, **kind.examples[what.kind]}


def scenario(aircraft: Aircraft, failure: Mapping[str, Any]) -> Scenario:
    """A flight with a turn, so that the actuators move."""
    commands = [{"at_s": 0.4, "heading_deg": 95}]
    initial = {**aircraft.reference.model_dump(), "heading_deg": 90}
    return Scenario.model_validate(
        {
            "name": f"catalogue {failure['type']}",
            "aircraft": aircraft.name,
            "duration_s": DURATION_S,
            "initial": initial,
            "commands": commands,
            "failures": [failure],
        }
    )


def draw(flight: Flight, actuator: str, unit: str, file: Path) -> None:
    """Draw command, position and effective position of the broken actuator; the file's metadata hold the scenario."""
    from matplotlib.figure import Figure

    log = flight.log
    figure = Figure(figsize=(WIDTH_CM / 2.54, HEIGHT_CM / 2.54), layout="constrained")
    axes = figure.subplots()
    failure = flight.scenario.failures[0]
    axes.axvspan(START_S, failure.until_s or DURATION_S, color="0.92", lw=0)
    time, position = log["time_s"], log[f"{actuator}_position"]
    effective = position * log[f"{actuator}_effectiveness"]
    axes.plot(time, log[f"{actuator}_command"], color="0.45", lw=0.7, label="command")
    axes.plot(time, position, color="C0", lw=1.1, label="position")
    axes.plot(time, effective, color="C3", lw=1.1, ls=(0, (3, 1.5)), label="effective")
    axes.set_xlabel("time [s]", fontsize=6)
    axes.set_ylabel(f"{actuator.replace('_', ' ')} [{unit}]", fontsize=6)
    axes.tick_params(labelsize=5.5, width=0.5, length=2)
    axes.legend(
        fontsize=5, frameon=False, ncols=3, loc="lower center", bbox_to_anchor=(0.5, 0.98), borderpad=0
    )
    axes.set_xlim(0, DURATION_S)
    for spine in axes.spines.values():
        spine.set_linewidth(0.5)
    file.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(file, dpi=DPI, metadata={"Description": dump(flight.scenario), "Software": None})


def fields_of(name: str) -> str:
    """A type's own fields, each with its default where it has one."""
    texts = []
    for field, info in TABLE[name].model_fields.items():
        if field not in _SHARED:
            optional = "" if info.is_required() else f" = {str(info.default).lower()}"
            texts.append(f"`{field}{optional}`".replace(" = none", " (optional)"))
    return ", ".join(texts) or "-"


def rows() -> Iterator[str]:
    """The page's table of types."""
    yield "| type | actuators | fields | can end | meaning | in flight |\n| --- | --- | --- | --- | --- | --- |"
    for name, kind in TABLE.items():
        meaning = (kind.__doc__ or "").strip().partition("\n")[0]
        on = "any" if name == "property" else ", ".join(kind.kinds)
        undone = "yes" if kind.undone else "no"
        figure = f"![{name}](figures/failures/{name}.png)"
        yield f"| `{name}` | {on} | {fields_of(name)} | {undone} | {meaning} | {figure} |"


def page() -> str:
    """The page's text: docs/reference/failures.md with the table of today."""
    text = (REFERENCE / "failures.md").read_text(encoding="utf-8")
    return with_block(text, "types", "\n".join(rows()))


def write(docs: Path) -> None:
    """Fly and draw every type, and write the page."""
    aircraft = load_aircraft(AIRCRAFT)
    for name in TABLE:
        actuator, failure = shown(aircraft, name)
        flight = fly(scenario(aircraft, failure))
        draw(flight, actuator, aircraft.actuators[actuator].unit, _figure(docs, name))
    docs.mkdir(parents=True, exist_ok=True)
    (docs / "failures.md").write_text(page(), encoding="utf-8")


def stale(docs: Path) -> list[str]:
    """Files that are out of date: the page, and figures that are missing or show another scenario."""
    from PIL import Image

    aircraft = load_aircraft(AIRCRAFT)
    file = docs / "failures.md"
    found = [] if file.is_file() and file.read_text(encoding="utf-8") == page() else [str(file)]
    for name in TABLE:
        figure = _figure(docs, name)
        flown = Image.open(figure).info.get("Description") if figure.is_file() else None
        if flown != dump(scenario(aircraft, shown(aircraft, name)[1])):
            found.append(str(figure))
    return found


def _figure(docs: Path, name: str) -> Path:
    return docs / "figures" / "failures" / f"{name}.png"


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description="Write the page of failures and its figures.")
    parser.add_argument(
        "--check", action="store_true", help="write nothing; exit 1 if anything is out of date"
    )
    parser.add_argument(
        "--out", type=Path, metavar="DOCS", help="folder of the page (default: docs/reference)"
    )
    options = parser.parse_args(arguments)
    docs = options.out or REFERENCE
    if not options.check:
        write(docs)
        return 0
    found = stale(docs)
    for name in found:
        print(f"{name}: out of date; run python docs/generate/failures_catalogue.py", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

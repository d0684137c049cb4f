"""The tables of docs/results/paper_table.md: two shipped scenarios, with and without adaptation.

python benchmarks/results_table.py
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from blocks import write

from testbed import fly
from testbed.flight.flight import Flight
from testbed.scenario.load import load_scenario

PAGE = Path(__file__).parents[1] / "docs" / "results" / "paper_table.md"
SCENARIOS = ("left_tail_fail", "left_propeller_fail")
CONTROLLERS = ("adaptive_inversion", "fixed_inversion")


def main() -> None:
    """Fly both scenarios and write the tables."""
    write(PAGE, "measured", "\n\n".join("\n".join(table(name)) for name in SCENARIOS))


def table(name: str) -> Iterator[str]:
    """Markdown of a scenario: a row for each requirement, a column for each controller."""
    flights = [
        fly(load_scenario(f"scenarios/{name}.yaml", [f"controller.type={kind}"])) for kind in CONTROLLERS
    ]
    yield f"| `{name}` | asked | adaptive | fixed |\n| --- | --- | --- | --- |"
    yield f"| flown | 60 s | {' | '.join(map(ending, flights))} |"
    yield f"| flagged failed | | {' | '.join(map(flags, flights))} |"
    for rows in zip(*(flight.requirements for flight in flights), strict=True):
        if "within" in rows[0]["limit"]:
            what = rows[0]["name"].replace(rows[0]["limit"], "").replace(" ,", ",")
            yield f"| {what} | {rows[0]['limit']} | {' | '.join(map(value, rows))} |"


def value(row: Mapping[str, Any]) -> str:
    return "not reached" if math.isnan(row["value"]) else f"{row['value']:.2g}"


def ending(flight: Flight) -> str:
    return f"{flight.end_time_s:g} s" if flight.outcome == "completed" else f"lost at {flight.end_time_s:g} s"


def flags(flight: Flight) -> str:
    kinds = ("detection", "false_alarm")
    found = [f"{e['actuator']} at {e['time_s']:.2f} s" for e in flight.events if e["kind"] in kinds]
    return ", ".join(found) or "none"


if __name__ == "__main__":
    main()

"""Write docs/explanation/when_adaptation_pays.md and its figures, from a CSV of `missions.py --reporting`.

    python benchmarks/when_adaptation_pays.py runs/reporting.csv
    python benchmarks/when_adaptation_pays.py runs/reporting.csv --trims    # and which missions can be flown at all: minutes

Exits if a seed for tuning is among the flights.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

import mission_findings
from mission_list import MISSIONS
from mission_results import Row, Table
from missions import KNOWN, REPORTING_START
from true_trims import table as trims_of
from true_trims import words

DOCS = Path(__file__).parents[1] / "docs"
BOUND = "oracle"


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("csv", type=Path)
    parser.add_argument("--docs", type=Path, default=DOCS, help="folder to write into")
    parser.add_argument("--trims", action="store_true", help="look for the steady flights of every mission")
    options = parser.parse_args(arguments)
    rows = reporting_rows(options.csv)
    found = trims_of(MISSIONS, "vtail") if options.trims else {}
    trims = {name: words(steady) for name, steady in found.items()}
    for folder in ("explanation", "figures"):
        (options.docs / folder).mkdir(parents=True, exist_ok=True)
    mission_findings.draw(rows, options.docs / "figures")
    page = options.docs / "explanation" / "when_adaptation_pays.md"
    page.write_text(mission_findings.page(rows, trims, BOUND), encoding="utf-8")
    print(f"wrote {page}")


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


if __name__ == "__main__":
    main()

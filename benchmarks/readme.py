"""The picture of the README and its sentences, flown; and its table of controllers, from docs/results/benchmark.md.

    python benchmarks/readme.py

One failure, in five turbulences. Each rival flies with the axes released that follow from the design model and with none,
and counts with the better of the two. A test flies all of it again and compares the sentences, with the same kernel of OpenBLAS.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_CORETYPE", "Haswell")  # as in the tests, before numpy is imported

from blocks import write

import testbed
from testbed.flight.flight import Flight
from testbed.reporting.comparison.compare import Comparison
from testbed.reporting.comparison.figure import picture
from testbed.scenario.load import load_scenario

ROOT = Path(__file__).parents[1]
README, BENCHMARK = ROOT / "README.md", ROOT / "docs" / "results" / "benchmark.md"
FIGURE = ROOT / "docs" / "figures" / "reversed_in_turbulence.png"
SCENARIO = "scenarios/reversed_in_turbulence.yaml"
SEEDS = range(97001, 97006)
ALTITUDE_M, HEADING_DEG = 5.0, 15.0
"""Held: flown to the end within these of altitude and heading, from the failure on."""
DEFAULT = {"type": "adaptive_inversion"}
RIVALS: Mapping[str, Mapping[str, Any]] = {
    "indi": {"type": "indi"},
    "rls_inversion": {"type": "rls_inversion"},
    "fixed_inversion": {"type": "fixed_inversion"},
    "pid": {"type": "pid"},
    "imm_inversion": {"type": "imm_inversion"},
    "indi with the default's diagnosis": {"type": "indi", "monitor": True},
    "l1_inversion": {"type": "l1_inversion"},
    "preset: paper": {"type": "adaptive_inversion", "preset": "paper"},
}
DRAWN = ("imm_inversion", "indi", "rls_inversion", "pid")
WITHOUT_DIAGNOSIS = ("indi", "rls_inversion", "fixed_inversion", "pid")
TEXT = """\
The left ruddervator of an aircraft that is unstable in pitch acts against its commands, in turbulence, with MEMS sensors
(`{scenario}`, seeds {first} to {last}; held is within 5 m and 15 deg).
Of {n} flights (OpenBLAS kernel {kernel}) the paper's own law holds {paper}, `imm_inversion` {imm}, and
`indi` with the default's diagnosis {indi}. The default flags the surface within {delay_s:.2f} s and holds {default}, within
{altitude_m:.1f} m and {heading_deg:.0f} deg; `l1_inversion` with the same diagnosis holds {l1}.
`indi`, `rls_inversion`, `fixed_inversion` and `pid`, which diagnose nothing, lose the aircraft in {lost} of {flights} flights.
Each rival flew with and without its roll axis released, and counts with the better.
"""


@dataclass(frozen=True)
class Tally:
    """The flights of one controller, one for each seed."""

    flights: tuple[Flight, ...]

    @property
    def survived(self) -> int:
        """Flown to the end."""
        return sum(flight.outcome == "completed" for flight in self.flights)

    @property
    def held(self) -> int:
        """Flown to the end within the limits."""
        return sum(
            flight.outcome == "completed"
            and flight.metrics["altitude_excursion_failed_m"] <= ALTITUDE_M
            and flight.metrics["heading_excursion_failed_deg"] <= HEADING_DEG
            for flight in self.flights
        )

    def worst(self, metric: str) -> float:
        """The largest value of a metric."""
        return max(flight.metrics[metric] for flight in self.flights)


def flown(controller: Mapping[str, Any], seeds: Sequence[int] = SEEDS) -> Tally:
    """The scenario, flown by a controller with each seed."""
    changes = f"controller={json.dumps(dict(controller))}"  # JSON is YAML
    return Tally(tuple(testbed.fly(load_scenario(SCENARIO, [f"seed={seed}", changes])) for seed in seeds))


def at_its_best(controller: Mapping[str, Any]) -> Tally:
    """The better of the tallies with the axes released that follow from the design model, and with none."""
    tallies = [flown({**controller, "released": axes}) for axes in ("auto", [])]
    return max(tallies, key=lambda tally: (tally.held, tally.survived))


def sentences(default: Tally, rivals: Mapping[str, Tally]) -> str:
    """What the flights of the picture show, as the README says it."""
    n = len(SEEDS)
    without = [rivals[name] for name in WITHOUT_DIAGNOSIS]
    return TEXT.format(
        scenario=SCENARIO,
        first=SEEDS[0],
        last=SEEDS[-1],
        n=n,
        kernel=os.environ.get("OPENBLAS_CORETYPE", "of this machine"),
        paper=rivals["preset: paper"].held,
        imm=rivals["imm_inversion"].held,
        indi=rivals["indi with the default's diagnosis"].held,
        l1=rivals["l1_inversion"].held,
        default=default.held,
        delay_s=default.worst("detection_delay_s"),
        altitude_m=default.worst("altitude_excursion_failed_m"),
        heading_deg=default.worst("heading_excursion_failed_deg"),
        lost=sum(n - tally.survived for tally in without),
        flights=n * len(without),
    ).strip()


def table(page: str) -> str:
    """The README's table of controllers, from the page of results."""
    told = page.partition("\n## All\n")[2].partition("\n## ")[0].splitlines()
    cells = [re.split(r"\s*\|\s*", line.strip("| ")) for line in told]
    rows = [row for row in cells if row[0].strip("`") in WORDS]
    lines = ["| | survived | held | held, minus the default (95 %) |", "| --- | --- | --- | --- |"]
    said = ((WORDS[row[0].strip("`")], row[1].split()[0], row[2].split()[0], row[4]) for row in rows)
    return "\n".join([*lines, *(f"| {' | '.join(cells)} |" for cells in said)])


WORDS = {
    "default": "the default",
    "imm_inversion": "`imm_inversion`: one model for each loss",
    "indi": "`indi`: incremental inversion",
    "indi_monitor": "`indi` with the default's diagnosis",
    "l1_inversion": "`l1_inversion`: adapts behind a filter, the default's diagnosis",
    "mrac": "`mrac`: model reference, adaptive",
    "rls_inversion": "`rls_inversion`: adapts, no diagnosis",
    "fixed_inversion": "`fixed_inversion`: no adaptation",
    "pid": "`pid`: a conventional autopilot",
    "best of all": "the best of all in each flight",
}
"""Controllers of the table in the words of the README."""


def main() -> None:
    """Write the picture and both blocks of the README."""
    default = flown(DEFAULT)
    rivals = {name: at_its_best(controller) for name, controller in RIVALS.items()}
    FIGURE.write_bytes(
        picture(Comparison([default.flights[0], *(rivals[name].flights[0] for name in DRAWN)]))
    )
    write(README, "picture", sentences(default, rivals))
    write(README, "benchmark", table(BENCHMARK.read_text(encoding="utf-8")))


if __name__ == "__main__":
    main()

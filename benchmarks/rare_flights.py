"""How rare is rare in flight: plain sampling as the check of a failure of 1 in 1000, and one of 1 in 100 000 that it cannot check.

    nice python benchmarks/rare_flights.py --out runs/rare_flights          # may be stopped and run again
    python benchmarks/rare_flights.py --out runs/rare_flights --page        # docs/results/rare_flights.md from what is there

The case is `scenarios/searches/rare_gust.yaml`, with its limits and with wider ones. Flights are short, so that many can be made.
"""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import testbed
from testbed.common.statistics import Proportion, proportion
from testbed.studies.folder import store
from testbed.studies.search.plan import coordinates
from testbed.studies.search.run import failed

PAGE = Path(__file__).parents[1] / "docs" / "results" / "rare_flights.md"
CASE = "scenarios/searches/rare_gust.yaml"
BUDGET, COV = 8000, 0.3
PLAIN_SEED = 2


@dataclass(frozen=True)
class Limits:
    """What a flight may be off by before it counts as broken."""

    altitude_m: float
    heading_deg: float

    @property
    def setting(self) -> str:
        return (
            f"scenario.requirements=[{{metric: altitude_error_max_m, at_most: {self.altitude_m:g}}}, "
            f"{{metric: heading_error_max_deg, at_most: {self.heading_deg:g}}}]"
        )

    def __str__(self) -> str:
        return f"{self.altitude_m:g} m, {self.heading_deg:g} deg"


CHECKED, RARE = Limits(4, 9), Limits(5.75, 12.5)
SEARCHES = [
    (limits, method, seed)
    for method, seeds in (("adaptive", (1, 2, 3)), ("subset", (1,)))
    for limits in (RARE, CHECKED)
    for seed in seeds
]
"""In the order in which they are made: the rarer case, which plain sampling cannot check, first."""


def main(arguments: Sequence[str] | None = None) -> None:
    options = _parser().parse_args(arguments)
    if options.page:
        PAGE.write_text(page(options.out), encoding="utf-8")
        return
    for limits, method, seed in SEARCHES:
        folder = _folder(options.out, limits, method, seed)
        search(folder, options.jobs, limits, method, seed, BUDGET, COV)
    plain = _folder(options.out, CHECKED, "plain", PLAIN_SEED)
    search(plain, options.jobs, CHECKED, "plain", PLAIN_SEED, options.plain, 0.001)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--out", type=Path, required=True, help="folder of the searches, kept as they come")
    parser.add_argument("--plain", type=int, default=30_000, help="plain flights")
    parser.add_argument("--jobs", type=int)
    parser.add_argument("--page", action="store_true", help=f"write {PAGE.name}, without flying")
    return parser


def _folder(out: Path, limits: Limits, method: str, seed: int) -> Path:
    return out / f"{method}-{limits.altitude_m:g}m-seed{seed}"


def search(
    folder: Path, jobs: int | None, limits: Limits, method: str, seed: int, budget: int, cov: float
) -> None:
    """Make a search, or what is missing of it."""
    if (folder / "summary.json").is_file() and not _more(folder, budget):
        return
    settings = [limits.setting, f"method={method}", f"cov={cov:g}"]
    found = testbed.search(
        CASE, folder, budget=budget, seed=seed, settings=settings, jobs=jobs, resume=True, figures=False
    )
    print(f"{folder.name}: {found!r}".splitlines()[0], flush=True)


def _more(folder: Path, budget: int) -> bool:
    """Whether the budget is larger than that of the search in the folder."""
    known: int = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["budget"]
    return budget > known


def plain(folder: Path) -> tuple[int, int]:
    """Failures and flights of plain sampling, also of a search that is under way; without the flight at the origin."""
    with store.reading(folder) as flights:
        drawn = [record for key, record in flights.records() if any(coordinates(key))]
    return sum(map(failed, drawn)), len(drawn)


def page(out: Path) -> str:
    """The page of the documentation."""
    failures, flights = plain(_folder(out, CHECKED, "plain", PLAIN_SEED))
    known = proportion(failures, flights, method="exact")
    rows = [_row(CHECKED, "plain", PLAIN_SEED, known.estimate, (known.low, known.high),
                 math.sqrt((1 - known.estimate) / max(failures, 1)), flights)]  # fmt: skip
    return _PAGE.format(case=CASE, checked=CHECKED, rare=RARE, failures=failures, flights=flights, budget=BUDGET,
                        cov=COV, agreement=_agreement(out, known), table="\n".join([*_HEAD, *rows, *_searched(out)]))  # fmt: skip


def _agreement(out: Path, known: Proportion) -> str:
    """How the searches of the checked case compare with plain sampling, in a sentence."""
    found = [said for limits, *_, said in _ended(out) if limits is CHECKED]
    inside = sum(said["low"] <= known.high and known.low <= said["high"] for said in found)
    ratios = [said["estimate"] / known.estimate for said in found]
    return (
        f"Of the {len(found)} searches of the same limits the intervals of {inside} overlap its own; their probabilities are "
        f"{min(ratios):.2f} to {max(ratios):.2f} of its."
    )


def _searched(out: Path) -> Iterator[str]:
    for limits, method, seed, known in _ended(out):
        ends, cov = (known["low"], known["high"]), known["coefficient_of_variation"]
        yield _row(limits, method, seed, known["estimate"], ends, cov, known["flights"])


def _ended(out: Path) -> Iterator[tuple[Limits, str, int, dict[str, Any]]]:
    """The searches that have ended, those that plain sampling checks first, each with its probability."""
    for limits, method, seed in sorted(SEARCHES, key=lambda one: one[0] is RARE):
        file = _folder(out, limits, method, seed) / "summary.json"
        if file.is_file():
            yield limits, method, seed, json.loads(file.read_text(encoding="utf-8"))["probability"]


def _row(limits: Limits, method: str, seed: int, estimate: float, ends: tuple[float, float], cov: float,
         flights: int) -> str:  # fmt: skip
    """A line of the table; plain flights are counted, the others are compared with how many plain ones do as well."""
    needed = (1 - estimate) / (estimate * cov**2) if estimate and cov else math.nan
    cells = [str(limits), f"`{method}`", seed, f"{estimate:.2e}", f"{ends[0]:.1e} to {ends[1]:.1e}", f"{cov:.2f}",
             flights, f"{needed:.2g}" if method != "plain" else ""]  # fmt: skip
    return f"| {' | '.join(map(str, cells))} |"


_HEAD = (
    "| broken beyond | method | seed | probability | 95 % interval | c.o.v. | flights | plain sampling needs |",
    "| --- | --- | --- | --- | --- | --- | --- | --- |",
)
_PAGE = """\
# Rare failures in flight

This page checks the probability of a rare failure, as a search finds it, against plain flights. The same methods
[on limit states with known answers](rare_failures.md); [what they compute](../explanation/rare_failures.md).

The case is `{case}`: INDI flies the v-tail at 18 m/s, the left propeller is lost, and two gusts come. Nine values are drawn:
when the propeller fails, when each gust comes, and its velocity north, east and down. A flight of 6 s is broken when it
misses the altitude or the heading by more than a limit: {checked} in the first rows, {rare} in the others. A search
ends when its coefficient of variation (c.o.v.) is at most {cov:g}, looked at after each of its rounds, or with its {budget}
flights. Measured by
`python benchmarks/rare_flights.py --out runs/rare_flights`.

{table}

Plain sampling had {failures} failures in {flights} flights. {agreement}
It cannot check the rarer case, for which it would need as many flights as the last column says: so many give the same
coefficient of variation.
"""


if __name__ == "__main__":
    main()

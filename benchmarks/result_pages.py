"""The pages of results: how each is made, with which seeds, at which cost, and what it depends on. `pages.py` flies them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from digests import FLOWN, ROOT

DOCS = ROOT / "docs"


@dataclass(frozen=True)
class Page:
    """A page of results.

    Attributes:
        name: of the page.
        commands: Python scripts with their arguments, which write it when they are run in turn.
        seeds: that they fly, in words.
        cost_s: processor time of the commands [s], as it was when they were last run.
        on: the parts of the program and of the data that it depends on.
        files: below docs/; `results/NAME.md` if none are named.
        stamped: whether its files carry a stamp. The README does not, because a test flies its numbers again; nor does a page on
            flights of others, whose data has a digest instead.
    """

    name: str
    commands: tuple[str, ...]
    seeds: str
    cost_s: float
    on: tuple[str, ...] = FLOWN
    named: tuple[str, ...] = ()
    stamped: bool = True

    @property
    def files(self) -> list[Path]:
        """The pages of Markdown that it writes."""
        return [DOCS / name for name in self.named or (f"results/{self.name}.md",)]

    @property
    def command(self) -> str:
        """Of a shell, which flies the page again."""
        return f"python benchmarks/pages.py {self.name}"


_AFT = (*FLOWN, "aircraft/vtail_aft")
_LOSSES = ("scenarios/left_tail_fail.yaml", "scenarios/left_propeller_fail.yaml")
_SWEPT = ("sweeps", *FLOWN, *_LOSSES[:1], "scenarios/mems_turbulence.yaml", "scenarios/sweeps")
_SEARCHED = ("searches", *FLOWN)
_THEORY = ("theory", *FLOWN)
_GALLERY = "benchmarks/gallery.py --results runs/gallery"
_NAMED = "vtail vtail_aft aerosonde " + " ".join(
    f"runs/adopted/{name}" for name in ("SGS", "c172p", "737", "c310", "f16")
)
PAGES: tuple[Page, ...] = (
    Page("readme", ("benchmarks/readme.py",), "97001 to 97005", 20, _AFT, ("../README.md",), stamped=False),
    Page("paper_table", ("benchmarks/results_table.py",), "1", 3, (*FLOWN, *_LOSSES)),
    Page("time_step", ("benchmarks/time_step.py",), "1", 11, (*FLOWN, *_LOSSES[:1]), ("explanation/pure_function.md",)),
    Page("performance", ("benchmarks/performance.py",), "1", 30),
    Page("monte_carlo", ("benchmarks/monte_carlo_page.py",), "drawn from those of the sweeps", 340, _SWEPT),
    Page(
        "benchmark",
        ("benchmarks/benchmark_page.py runs/benchmark runs/healthy --fly",),
        "from the word and the law's digest",
        9000,
        (*_AFT, "adoption", "scenarios/suites"),
    ),
    Page("detection", ("benchmarks/detection.py",), "95001 to 95020", 270, (*FLOWN, "aircraft/vtail_aft")),
    Page("own_logs", ("benchmarks/diagnose_own_flights.py",), "96001 to 96002", 290, (*FLOWN, "logs")),
    Page(
        "real_flights",
        ("benchmarks/real_flights.py ../fault_detection ../alfa ../htm-state",),
        "none",
        60,
        ("logs",),
        stamped=False,
    ),
    Page(
        "what_a_log_tells",
        ("benchmarks/what_a_log_tells.py",),
        "96301",
        9,
        (*FLOWN, "logs"),
        ("explanation/what_a_log_tells.md",),
    ),
    Page("jam_trims", ("benchmarks/jam_trims.py",), "none", 380),
    Page("section4_noise", ("benchmarks/section4_noise.py --parts runs/section4_noise",), "1 to 4", 430, _THEORY),
    Page("section4_input_matrix", ("benchmarks/section4_input_matrix.py",), "1", 170, _THEORY),
    Page("section4_bandwidth", ("benchmarks/section4_bandwidth.py",), "1", 90, _THEORY),
    Page(
        "decoupling",
        ("benchmarks/decoupling.py --csv runs/decoupling.csv",),
        "90001 to 90006",
        390,
        (*_THEORY, "aircraft/vtail_aft"),
    ),
    Page(
        "smallest_failures",
        (
            "benchmarks/smallest_failures.py --csv runs/smallest.csv",
            "benchmarks/smallest_failures.py --csv runs/smallest.csv --controllers default --budget 1000",
            "benchmarks/smallest_failures.py --csv runs/smallest.csv --page",
        ),
        "90001",
        820,
        _SEARCHED,
    ),
    Page("rare_failures", ("benchmarks/rare_failures.py",), "0 to 99", 320, ("searches",)),
    Page(
        "rare_flights",
        (
            "benchmarks/rare_flights.py --out runs/rare_flights",
            "benchmarks/rare_flights.py --out runs/rare_flights --page",
        ),
        "1 to 3",
        1740,
        (*_SEARCHED, "scenarios/searches/rare_gust.yaml"),
    ),
    Page("f16_collision", ("benchmarks/f16_collision.py",), "0 to 4", 140, ("searches",)),
    Page(
        "adoption",
        ("benchmarks/adopt_all.py runs/adopted --document docs/results/adoption.md",),
        "none",
        230,
        ("adoption", "plant", "simulation"),
    ),
    Page(
        "gallery",
        (
            "benchmarks/adopt_all.py runs/adopted",
            f"{_GALLERY} {_NAMED} --air calm",
            f"{_GALLERY} {_NAMED} --air turbulent --values 0 --seeds 2",
            f"{_GALLERY} runs/adopted/* --controllers default --values 0 --seeds 2 --actuators aileron,rudder",
            f"{_GALLERY} {_NAMED} runs/adopted/* --flown --document docs/results/gallery.md",
            f"benchmarks/aircraft_pictures.py {_NAMED} runs/adopted/*",
        ),
        "1 and 2",
        560,
        ("adoption", *FLOWN, "aircraft"),
    ),
)  # fmt: skip
"""Every page of results."""

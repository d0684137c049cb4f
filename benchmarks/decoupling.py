"""Decoupling the speed of adaptation from robustness (the paper's 5.2): `l1_inversion` beside its rivals.

    python benchmarks/decoupling.py --jobs 1
    python benchmarks/decoupling.py --tune --jobs 1

Writes docs/results/decoupling.md and its figure: missions on reporting seeds, delay margins, recovery of the rates after a loss,
and speed against noise with the bounds of `paper.decoupling`. `--tune` prints the margins of other corners of the
control channel on tuning seeds, and writes nothing.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import missions
import numpy as np
from decoupling_page import DELAYS, LOSS_S, REMAINS, SEEDS, draw, milliseconds, page
from flights import Record, fly_all
from mission_list import BASE, MISSIONS, ROUTES, Condition, chosen
from mission_results import Table

from testbed.common.units import METRES_PER_FOOT
from testbed.flight.flight import Flight
from testbed.metrics import readings
from testbed.scenario.model import Scenario
from testbed.simulation import fly

DOCS = Path(__file__).parents[1] / "docs"
Values = Mapping[str, Any]
RIVALS = ("default", "paper", "indi", "indi_monitor", "l1_inversion")
FLOWN = (
    "hard_healthy,hard_left_tail_lost,hard_right_propeller_lost,slow_left_propeller_lost,hard_tails_weak,cruise_all_weak,"
    "cruise_tail_reversed,cruise_tail_jam_plus5,hard_tail_delay,cruise_second_tail_after_propeller"
)
TUNING_SEEDS = range(301, 305)
ACTUATORS = ("left_ruddervator", "right_ruddervator", "left_propeller", "right_propeller")


def l1(**settings: float) -> Values:
    return {"type": "l1_inversion", **settings}


def paper(gamma: float) -> Values:
    """The paper's law with the released axis of the others, so that only the law differs."""
    return {**missions.KNOWN["paper"], "gamma": gamma, "released": "auto"}


MARGINS: Mapping[str, Values] = {
    **{name: missions.KNOWN[name] for name in ("default", "indi", "indi_monitor")},
    **{f"paper, gamma {gamma:g}": paper(gamma) for gamma in (2.0, 8.0, 32.0)},
    **{f"l1, Gamma {gamma:g}": l1(fast_gamma=gamma) for gamma in (5.0, 20.0, 80.0)},
    **{f"l1, k {k:g}": l1(control_rad_s=k) for k in (2.0, 5.0, 20.0)},
}
"""Whose delay margin is measured. One k is the default's."""
TUNED = {f"l1, k {k:g}": l1(control_rad_s=k) for k in (5.0, 10.0, 15.0, 20.0)}


# --- delay margin ------------------------------------------------------------------------------------------------------------


CALM = {"sensors": "ideal"}
WEATHER = {"atmosphere.turbulence_w20_m_s": 25.0 * METRES_PER_FOOT}


def margin_flights(
    laws: Mapping[str, Values], seeds: Sequence[int], air: Values
) -> Iterator[tuple[int, dict[str, Any]]]:
    """The hard route with both tails at 0.3, and every actuator late from the start."""
    weak = [
        {"type": "effectiveness", "actuator": name, "at_s": LOSS_S, "value": REMAINS}
        for name in ACTUATORS[:2]
    ]
    for settings in laws.values():
        for delay in DELAYS:
            late = [{"type": "delay", "actuator": name, "at_s": 0, "delay_s": delay} for name in ACTUATORS]
            failures = [*(late if delay else []), *weak]
            for seed in seeds:
                yield (
                    seed,
                    {**ROUTES["hard"].values, "controller": dict(settings), "failures": failures, **air},
                )


def margins(
    laws: Mapping[str, Values], seeds: Sequence[int], jobs: int | None, air: Values = WEATHER
) -> dict[str, list[float]]:
    """For each law the largest delay [s] with which no flight is lost, and the largest with which all are held; NaN for none."""
    flown = iter(fly_all(BASE, list(margin_flights(laws, seeds, air)), jobs))
    found = {}
    for name in laws:
        cells = [[next(flown) for _ in seeds] for _ in DELAYS]
        found[name] = [until(cells, survived), until(cells, held)]
    return found


def until(cells: Sequence[Sequence[Record]], good: Any) -> float:
    """The last delay before the first at which not all flights are good."""
    last = math.nan
    for delay, records in zip(DELAYS, cells, strict=True):
        if not all(map(good, records)):
            break
        last = delay
    return last


def survived(record: Record) -> bool:
    return bool(record["outcome"] == "completed")


def held(record: Record) -> bool:
    found = record["metrics"]
    return (
        survived(record) and found["altitude_error_max_m"] <= 5.0 and found["heading_error_max_deg"] <= 15.0
    )


# --- recovery of the rates ---------------------------------------------------------------------------------------------------


def recovery_flights() -> Iterator[tuple[int, dict[str, Any]]]:
    """Level flight in calm air with ideal sensors, and the left tail at 0.3 from LOSS_S on."""
    lost = {"type": "effectiveness", "actuator": ACTUATORS[0], "at_s": LOSS_S, "value": REMAINS}
    for settings in MARGINS.values():
        yield 1, {"controller": dict(settings), "failures": [lost], "sensors": "ideal", "duration_s": 30}


def fly_and_measure(scenario: Scenario) -> Flight:
    """Fly, and add how the rates that were asked for came back after the loss: their error's peak, and its time until a tenth."""
    flight = fly(scenario)
    log = readings(flight)
    rate, asked = log.log["q_dot_deg_s2"], log.log["q_dot_desired_deg_s2"]
    start = log.row_at(LOSS_S)
    error = np.abs(rate - asked)[start:] - np.abs(rate - asked)[start - 200 : start].mean()
    peak = float(error[:100].max())
    outside = np.flatnonzero(error[: 5 * 200] > 0.1 * peak)
    found = {"error_peak_deg_s2": peak, "error_recovery_s": float((outside[-1] + 1) / scenario.rate_hz)}
    return replace(flight, metrics={**flight.metrics, **found})


def tune(jobs: int | None) -> None:
    for name, found in margins(TUNED, TUNING_SEEDS, jobs).items():
        print(name, *map(milliseconds, found))


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--jobs", type=int, help="processes (default: one a core)")
    parser.add_argument(
        "--tune", action="store_true", help="other corners of the control channel, on tuning seeds"
    )
    parser.add_argument(
        "--csv", type=Path, default=Path("runs") / "decoupling.csv", help="where the missions are kept"
    )
    parser.add_argument("--docs", type=Path, default=DOCS, help="where results/ and figures/ are")
    options = parser.parse_args(arguments)
    if options.tune:
        return tune(options.jobs)
    calm, weather = margins(MARGINS, [1], options.jobs, CALM), margins(MARGINS, SEEDS, options.jobs)
    found = {name: [*calm[name], *weather[name]] for name in MARGINS}
    flights = fly_all(BASE, list(recovery_flights()), options.jobs, "decoupling:fly_and_measure")
    recovered = dict(zip(MARGINS, flights, strict=True))
    plan = [
        (name, mission, Condition(), seed)
        for mission in chosen(MISSIONS, FLOWN)
        for name in RIVALS
        for seed in SEEDS
    ]
    table = Table(options.csv)
    rows = list(table.write(missions.fly(plan, missions.KNOWN, table.read(), options.jobs)))
    rows.sort(key=lambda row: RIVALS.index(row.controller))
    text = page(rows, found, recovered)
    (options.docs / "results" / "decoupling.md").write_text(text, encoding="utf-8")
    draw(options.docs / "figures" / "decoupling_noise.png")
    print(text)


if __name__ == "__main__":
    main()

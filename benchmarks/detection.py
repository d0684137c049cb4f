"""How soon a lost actuator is flagged, beside how soon its loss could be seen at all. Writes docs/results/detection.md.

    python benchmarks/detection.py --seeds 20 --first-seed 95001

A lost surface that stands near its neutral position is missed by nobody: its force was about zero before. So the delay from the
failure says as much about the mission as about the diagnosis. This benchmark weighs the force that is missing against gusts:
the evidence E of a loss is the integral of (missing acceleration / gust density)^2 over the four rates. sqrt(E) is the number of
standard deviations by which the best test, told which actuator broke and when, could tell a lost actuator from a whole one.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from flights import Record, fly_all
from mission_list import BASE, FAILURE_S, MISSIONS, Condition, Mission

import testbed
from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, DesignModel, load_design_model
from testbed.controllers.scaling import gust_density
from testbed.flight.flight import Flight
from testbed.scenario.load import Scenario

PAGE = Path(__file__).parents[1] / "docs" / "results" / "detection.md"
VISIBLE_SIGMA = 5.0
"""Standard deviations between lost and whole at which a loss counts as visible: chance shows so much once in 2 million looks."""
NOT_LOST, SURE_SIGMA = 0.1, 20.0
"""Effectiveness with which a surface is used further, and the standard deviations between lost and whole at which it is 2 of them
from lost."""
CONDITIONS = (Condition(), Condition(w20_ft_s=0.0), Condition(model_error=0.2), Condition("vtail_aft"))


def main(arguments: Sequence[str] | None = None) -> None:
    options = _parser().parse_args(arguments)
    seeds = range(options.first_seed, options.first_seed + options.seeds)
    plan = [(c, m, seed) for c in CONDITIONS for m in losses() for seed in seeds]
    flights = [
        (seed, {"controller": {"type": "adaptive_inversion"}, **c.values(m, seed)}) for c, m, seed in plan
    ]
    sys.path.insert(0, str(Path(__file__).parent))  # for the workers, which import `fly_and_weigh`
    records = fly_all(BASE, flights, options.jobs, fly="detection:fly_and_weigh")
    options.page.write_text(page(plan, records, seeds), encoding="utf-8")
    print(f"wrote {options.page}")


def losses() -> list[Mission]:
    """The missions in which one actuator is lost, and nothing else."""
    return [m for m in MISSIONS if len(m.failures) == 1 and _is_loss(m.failures[0])]


def _is_loss(failure: Mapping[str, Any]) -> bool:
    return failure["type"] == "effectiveness" and failure["value"] == 0.0


def fly_and_weigh(scenario: Scenario) -> Flight:
    """Fly, and add to the metrics `visible_s`, `sure_s`: when sqrt(E) reached VISIBLE_SIGMA and SURE_SIGMA after the failure."""
    flight = testbed.fly(scenario)
    log, actuator = flight.log, str(scenario.failures[0].actuator)
    model = load_design_model(load_aircraft(scenario.aircraft).folder / DESIGN_MODEL)
    after = log["time_s"].to_numpy() >= FAILURE_S
    position, airspeed = (log[name].to_numpy()[after] for name in (f"{actuator}_position", "airspeed_m_s"))
    time_s = log["time_s"].to_numpy()[after] - FAILURE_S
    found = evidence(model, actuator, position, airspeed, float(np.diff(time_s[:2])[0]))
    metrics: Any = flight.metrics
    for name, sigma in (("visible_s", VISIBLE_SIGMA), ("sure_s", SURE_SIGMA)):
        metrics[name] = float(time_s[np.argmax(found > sigma**2)]) if found[-1] > sigma**2 else math.nan
    return flight


def evidence(
    model: DesignModel, actuator: str, position: np.ndarray, airspeed: np.ndarray, dt: float
) -> np.ndarray:
    """[rows] evidence E until each row that this actuator, which stands at `position` [deg or N], has no effect."""
    j = list(model.actuators).index(actuator)
    servo = model.kinds[j] == "servo"
    scaled = np.radians(position) * (airspeed / model.airspeed_m_s) ** 2 if servo else position
    column = np.array(model.input_matrix)[:4, j] / gust_density(model)
    return np.cumsum(scaled**2 * (column @ column) * dt)


def page(plan: Sequence[tuple[Condition, Mission, int]], records: Sequence[Record], seeds: range) -> str:
    """The Markdown of docs/results/detection.md."""
    rows = [(c, m, record["metrics"]) for (c, m, _), record in zip(plan, records, strict=True)]
    return "\n".join(
        [
            "# How soon a loss is flagged",
            "",
            "<!-- Written by python benchmarks/detection.py: change that, not this. -->",
            "",
            "This page shows how soon the default controller flags a lost actuator as failed,",
            "beside how soon the loss could be known.",
            "",
            "Each mission of `benchmarks/missions.py` with one lost actuator is flown in four conditions with MEMS sensors,",
            f"seeds {seeds[0]} to {seeds[-1]}, on which nothing was chosen.",
            "The missions are told apart in the first condition only.",
            "Each cell has two times: the median, and what 95 % of the flights do not exceed. *Missed* is never flagged.",
            "",
            "A surface that stands near its neutral position has no force, and when it is lost nothing changes: in slow",
            "flight a ruddervator trims there. So the table also tells when the loss could be known. The missing",
            "accelerations are weighed against gusts: the square root of the integral of (missing acceleration / gust",
            "density of the design)^2 is the number of standard deviations between lost and whole, for the best test",
            "that is told which actuator broke and when.",
            "",
            f"- **Visible** is {VISIBLE_SIGMA:g} standard deviations.",
            f"- **Sure** is {SURE_SIGMA:g}. A surface that keeps {NOT_LOST:g} of its effect is not to be flagged, since it can",
            "  still be used. At",
            "  this moment it is 2 standard deviations from a lost one. A flag that comes",
            "  sooner counts as negative in the last column.",
            "",
            *_table(rows),
            "",
            "False alarms are counted in the [benchmark](benchmark.md).",
            "",
        ]
    )


def _table(rows: Sequence[tuple[Condition, Mission, Mapping[str, float]]]) -> list[str]:
    head = "| | flights | missed | failure to visible, s | to sure, s | to the flag, s | from sure to the flag, s |"
    lines = [head, "| --- | --- | --- | --- | --- | --- | --- |"]
    for condition in CONDITIONS:
        mine = [(m, metrics) for c, m, metrics in rows if c == condition]
        lines.append(_line(f"**{condition.title}**", [metrics for _, metrics in mine]))
        if condition == CONDITIONS[0]:
            for mission in losses():
                lines.append(_line(f"`{mission.name}`", [metrics for m, metrics in mine if m == mission]))
    return lines


def _line(title: str, metrics: Sequence[Mapping[str, float]]) -> str:
    delay, visible, sure = (
        np.array([each[name] for each in metrics]) for name in ("detection_delay_s", "visible_s", "sure_s")
    )
    times = (_quantiles(each) for each in (visible, sure, delay, delay - sure))
    cells = (len(metrics), int(np.sum(np.isnan(delay))), *times)
    return f"| {title} | {' | '.join(map(str, cells))} |"


def _quantiles(values: np.ndarray) -> str:
    return f"{np.nanmedian(values):.2f}, {np.nanquantile(values, 0.95):.2f}"


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--first-seed", type=int, default=95001)
    parser.add_argument("--jobs", type=int)
    parser.add_argument("--page", type=Path, default=PAGE)
    return parser


if __name__ == "__main__":
    main()

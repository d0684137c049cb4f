"""The flights of `missions.py` as rows of a CSV file, and the tables that are made of them."""

from __future__ import annotations

import csv
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from statistics import median
from typing import Any

from flights import Record
from mission_list import ALTITUDE_M, HEADING_DEG, Condition, Mission

from testbed.common.statistics import Paired, paired

Key = tuple[str, Condition, int]
"""Mission, condition and seed: flights of two controllers with the same key are a pair."""


@dataclass(frozen=True)
class Row:
    """One flight: what flew in what, and how it went. Errors are the largest from the first failure on; infinite if lost."""

    controller: str
    mission: str
    aircraft: str
    w20_ft_s: float
    model_error: float
    seed: int
    outcome: str
    altitude_m: float
    heading_deg: float
    detection_delay_s: float
    missed: float
    false_alarms: float

    @classmethod
    def of(cls, controller: str, mission: Mission, condition: Condition, record: Record) -> Row:
        """The row of a flight's record. Without a failure, errors count from the start."""
        metrics, flown = record["metrics"], record["outcome"] == "completed"
        names = (
            ("altitude_excursion_failed_m", "heading_excursion_failed_deg")
            if mission.failures
            else ("altitude_error_max_m", "heading_error_max_deg")
        )
        altitude, heading = (metrics[name] if flown else math.inf for name in names)
        return cls(
            controller,
            mission.name,
            **asdict(condition),
            seed=record["seed"],
            outcome=record["outcome"],
            altitude_m=altitude,
            heading_deg=heading,
            detection_delay_s=metrics["detection_delay_s"],
            missed=metrics["missed_detections"],
            false_alarms=metrics["false_alarms"],
        )

    @property
    def condition(self) -> Condition:
        """In what it was flown."""
        return Condition(self.aircraft, self.w20_ft_s, self.model_error)

    @property
    def key(self) -> Key:
        """What it has in common with the flights of other controllers that it is compared with."""
        return self.mission, self.condition, self.seed

    @property
    def survived(self) -> bool:
        """Flown to the end."""
        return self.outcome == "completed"

    @property
    def held(self) -> bool:
        """Flown to the end, within the limits of altitude and heading all the time from the first failure on."""
        return self.survived and self.altitude_m <= ALTITUDE_M and self.heading_deg <= HEADING_DEG


class Table:
    """A CSV file of rows, to which rows are added as flights finish; a cut last line is dropped."""

    def __init__(self, file: Path) -> None:
        self.file = file

    def read(self) -> list[Row]:
        """The rows so far; none if there is no file."""
        if not self.file.is_file():
            return []
        kinds: Mapping[str, Callable[[str], Any]] = {"str": str, "float": float, "int": int}
        casts = {field.name: kinds[str(field.type)] for field in fields(Row)}
        with self.file.open(newline="", encoding="utf-8") as lines:
            whole = [row for row in csv.DictReader(lines) if None not in row.values()]
        return [Row(**{name: cast(row[name]) for name, cast in casts.items()}) for row in whole]

    def write(self, rows: Iterable[Row]) -> Iterator[Row]:
        """Replace the file by these rows, each written as it comes; yields them."""
        self.file.parent.mkdir(parents=True, exist_ok=True)
        with self.file.open("w", newline="", encoding="utf-8") as stream:
            writer = csv.DictWriter(stream, [field.name for field in fields(Row)])
            writer.writeheader()
            for row in rows:
                writer.writerow(asdict(row))
                stream.flush()
                yield row


FAMILIES: Mapping[str, tuple[str, ...]] = {
    "nothing broken": ("healthy",),
    "a second failure": ("second",),
    "one actuator lost": ("lost",),
    "weak actuators": ("weak",),
    "reversed": ("reversed",),
    "jammed": ("jam",),
    "hardover, runaway, stop": ("hardover", "runaway", "stop"),
    "intermittent, late, shaking, bent, floating": ("intermittent", "delay", "pulses", "bias", "float"),
}
"""Kinds of mission by words of their names; the first that fits counts."""


def family(mission: str) -> str:
    """The kind of a mission, of FAMILIES."""
    return next(kind for kind, words in FAMILIES.items() if set(words) & set(mission.split("_")))


def cell(rows: Sequence[Row]) -> str:
    """`held/survived/flights`; the number that survived is left out where it is all of them."""
    held, survived, n = sum(r.held for r in rows), sum(r.survived for r in rows), len(rows)
    return f"{held}/{n}" if survived == n else f"{held}/**{survived}**/{n}"


def by_mission(rows: Sequence[Row]) -> list[str]:
    """Markdown table: a row for each mission, a column for each controller, `cell` in each."""
    controllers = list(dict.fromkeys(row.controller for row in rows))
    lines = [f"| mission | {' | '.join(controllers)} |", f"| --- |{' --- |' * len(controllers)}"]
    for mission in dict.fromkeys(row.mission for row in rows):
        of = [[r for r in rows if (r.mission, r.controller) == (mission, name)] for name in controllers]
        lines.append(f"| {mission} | {' | '.join(map(cell, of))} |")
    return lines


def totals(rows: Sequence[Row], reference: str) -> list[str]:
    """Markdown table: a row for each controller, over all missions that it and the reference have flown."""
    lines = [
        f"| controller | survived | held | {reference} holds more by (95 %) | only {reference} holds | only it holds | "
        "altitude, heading: median of the worst | detection s: median, 95 % | missed | false alarms |",
        "| --- |" + " --- |" * 9,
    ]
    for name in dict.fromkeys(row.controller for row in rows):
        own = [row for row in rows if row.controller == name]
        difference = held_more([r for r in rows if r.controller == reference], own)
        words = ["", "", ""]
        if name != reference and difference:
            d = difference
            words = [f"{d.difference:+.3f} ({d.low:+.3f} to {d.high:+.3f})", str(d.only_first), str(d.only_second)]  # fmt: skip
        flown = [row for row in own if row.survived] or own
        worst = f"{median(r.altitude_m for r in flown):.1f} m, {median(r.heading_deg for r in flown):.1f} deg"
        missed, alarms = (_sum(getattr(r, of) for r in own) for of in ("missed", "false_alarms"))
        shares = f"{sum(r.survived for r in own) / len(own):.3f} | {sum(r.held for r in own) / len(own):.3f}"
        lines.append(
            f"| {name} | {shares} | {' | '.join(words)} | {worst} | {delays(own)} | {missed} | {alarms} |"
        )
    return lines


def _sum(counts: Iterable[float]) -> str:
    """How many in all; a controller that says nothing of failures is not judged."""
    total = math.fsum(counts)
    return "not judged" if math.isnan(total) else f"{total:.0f}"


def held_more(first: Sequence[Row], second: Sequence[Row]) -> Paired | None:
    """How much more often the first is held than the second, over the flights that both have; None if there are none."""
    other = {row.key: row.held for row in second}
    pairs = [(row.held, other[row.key]) for row in first if row.key in other]
    return paired(*zip(*pairs, strict=True)) if pairs else None


def delays(rows: Sequence[Row]) -> str:
    """Median and 95 % quantile of the detection delays [s]; empty if nothing was detected."""
    found = sorted(row.detection_delay_s for row in rows if not math.isnan(row.detection_delay_s))
    return f"{median(found):.2f}, {found[math.ceil(0.95 * len(found)) - 1]:.2f}" if found else ""


def loses(rows: Sequence[Row], reference: str, by: int = 2) -> list[str]:
    """Markdown list: the cells in which another controller holds `by` flights more than the reference, or more."""
    cells: dict[tuple[Condition, str, str], int] = {}
    for row in rows:
        key = row.condition, row.mission, row.controller
        cells[key] = cells.get(key, 0) + row.held
    return [
        f"- {mission} ({condition.title}): {name} holds {held}, {reference} {cells[condition, mission, reference]}"
        for (condition, mission, name), held in cells.items()
        if held >= cells.get((condition, mission, reference), held) + by
    ]

"""The page "When adaptation pays", from the flights of a mission report: one comparison, one figure for each finding."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
from mission_results import FAMILIES, Row, family, held_more

from testbed.common.statistics import Paired


@dataclass(frozen=True)
class Finding:
    """A question that the paired difference of two controllers answers, with its figure's name."""

    name: str
    title: str
    words: str
    first: str
    second: str


FINDINGS = (
    Finding(
        "compensation",
        "What compensation brings",
        "The law divides each reference by the estimated effectiveness. Without this the estimates serve the monitor alone.",
        "default",
        "without_estimate",
    ),
    Finding(
        "diagnosis",
        "What diagnosis and goal switching bring",
        "The monitor flags lost actuators, and each flag releases an axis and puts another regulator and trim in force. Without "
        "it the law keeps the goals of healthy flight, and adapts.",
        "default",
        "without_monitor",
    ),
    Finding(
        "jam_test",
        "What the test for jams brings",
        "A jammed or reversed actuator is no loss of effectiveness. Without the test it is taken for one, or for nothing.",
        "default",
        "without_jam_test",
    ),
    Finding(
        "model_error",
        "What estimating the model's own error brings",
        "The estimator has a state for the design model's error in each rate. Without these, "
        "what the design model leaves out is taken for lost effectiveness.",
        "default",
        "without_model_error",
    ),
    Finding(
        "speed_rule",
        "What the speed rule brings",
        "On one propeller the law flies faster, and a slow aircraft gives up altitude.",
        "default",
        "without_speed_rule",
    ),
    Finding(
        "adaptation_alone",
        "Against adaptation without diagnosis",
        "`rls_inversion` estimates effectiveness by recursive least squares, and never flags.",
        "default",
        "rls_inversion",
    ),
    Finding(
        "diagnosis_alone",
        "Diagnosis without compensation",
        "`indi_monitor` is incremental inversion with the monitor, the jam test and the modes of the law; no command is divided by "
        "an estimate. The difference to plain `indi` is what diagnosis brings to a law that needs no compensation.",
        "indi_monitor",
        "indi",
    ),
    Finding(
        "textbook",
        "Against a textbook diagnosis",
        "`imm_inversion` weighs one model for each failure by its probability.",
        "default",
        "imm_inversion",
    ),
    Finding(
        "bound",
        "Told the truth",
        "`oracle` is told the true effectiveness and the true failures at once. What it holds more is about what better "
        "diagnosis could still gain. It knows the moment, not what follows: it gives up a propeller that works on and off "
        "each time that it stops, where `default` waits.",
        "oracle",
        "default",
    ),
)


def page(rows: Sequence[Row], trims: Mapping[str, str], bound: str = "oracle") -> str:
    """The Markdown of docs/explanation/when_adaptation_pays.md."""
    lines = [
        "# When adaptation pays",
        "",
        "<!-- Written by python benchmarks/when_adaptation_pays.py: change that, not this. -->",
        "",
        "This page says what adaptation, diagnosis and goal switching each bring, by comparisons of paired flights.",
        "",
        "The flights are of 56 missions of 70 s with MEMS sensors: slow and fast flight, hard turns and climbs, failures of all",
        "kinds (`python benchmarks/missions.py --list`), in calm air, at W20 = 25 ft/s, with the design model 20 % off, and on",
        "`vtail_aft`. *Held* means flown to the end, within 5 m and 15 deg from the first failure on. A difference is the share",
        "of flights held by the first less that held by the second, in percentage points, over those that both have flown with",
        "the same mission, condition and seed. The parts (`without_...`) were flown with a few of the seeds, the controllers",
        "with all. Intervals are of 95 % each. A part pays where its interval is above zero. With eight kinds of failure for each",
        "of nine findings, some three or four such intervals would miss zero by chance alone:",
        "an interval of one kind that hardly does says little.",
        "",
        *summary(rows),
    ]
    for finding, difference in known(rows):
        lines += ["", f"## {finding.title}", "", finding.words, ""]
        lines += [sentence(finding, difference), by_kind(rows, finding), ""]
        lines += [f"![{finding.title}](../figures/finding_{finding.name}.png)"]
    return "\n".join([*lines, "", *remaining(rows, trims, bound)]) + "\n"


def known(rows: Sequence[Row]) -> Iterator[tuple[Finding, Paired]]:
    """The findings whose two controllers have flights in common, with their differences."""
    for finding in FINDINGS:
        difference = between(rows, finding)
        if difference is not None:
            yield finding, difference


def between(rows: Sequence[Row], finding: Finding) -> Paired | None:
    """The paired difference of a finding's controllers on these flights."""
    first, second = (
        [row for row in rows if row.controller == name] for name in (finding.first, finding.second)
    )
    return held_more(first, second)


def kinds(rows: Sequence[Row], finding: Finding) -> dict[str, Paired]:
    """The difference for each kind of failure that both have flown."""
    found = {kind: between([r for r in rows if family(r.mission) == kind], finding) for kind in FAMILIES}
    return {kind: difference for kind, difference in found.items() if difference is not None}


def points(d: Paired) -> str:
    """`+4.2 (-1.0 to +9.1)`: difference and interval in points."""
    return f"{100 * d.difference:+.1f} ({100 * d.low:+.1f} to {100 * d.high:+.1f})"


def summary(rows: Sequence[Row]) -> list[str]:
    """Markdown table of all findings."""
    lines = ["| finding | first | second | percentage points (95 %) |", "| --- | --- | --- | --- |"]
    for finding, difference in known(rows):
        lines.append(f"| {finding.title} | {finding.first} | {finding.second} | {points(difference)} |")
    return lines


def sentence(finding: Finding, d: Paired) -> str:
    """The result in words."""
    n = d.both + d.only_first + d.only_second + d.neither
    first, second = (100 * (d.both + only) / n for only in (d.only_first, d.only_second))
    return f"`{finding.first}` holds {first:.1f} % and `{finding.second}` {second:.1f} % of {n} flights: {points(d)} points."


def by_kind(rows: Sequence[Row], finding: Finding) -> str:
    """For which kinds of failure the interval is above or below zero."""
    found = kinds(rows, finding)
    above, below = [k for k, d in found.items() if d.low > 0], [k for k, d in found.items() if d.high < 0]
    parts = [
        f"It holds {side} with: {'; '.join(f'{kind} ({points(found[kind])})' for kind in clear)}."
        for side, clear in (("more", above), ("less", below))
        if clear
    ]
    return " ".join(parts) or "With no kind of failure alone is the interval clear of zero."


def remaining(rows: Sequence[Row], trims: Mapping[str, str], bound: str) -> list[str]:
    """Markdown: the missions that even the bound does not hold in one flight of ten or more; the truth's trims, if looked for."""
    heads = ["mission", f"{bound} survives", f"{bound} holds", "default holds"]
    lines = ["## What remains lost", "", f"Missions of which `{bound}` does not hold nine of ten."]
    if trims:
        heads.append("steady flight on JSBSim")
        lines += ["The last column has the steady flights that JSBSim itself has after the failure, at steps of 0.5 m/s",
                  "(`benchmarks/true_trims.py`). The margin is how far the nearest actuator is from its stop, of half its travel.",
                  "A jam whose level trim is far from the speed before it has to be flown there first."]  # fmt: skip
    lines += ["", f"| {' | '.join(heads)} |", f"|{' --- |' * len(heads)}"]
    for mission in dict.fromkeys(row.mission for row in rows):
        own = [row for row in rows if (row.mission, row.controller) == (mission, bound)]
        default = [row for row in rows if (row.mission, row.controller) == (mission, "default")]
        if own and sum(row.held for row in own) < 0.9 * len(own):
            counted = ([r.survived for r in own], [r.held for r in own], [r.held for r in default])
            cells = [mission, *(f"{sum(flags)}/{len(flags)}" for flags in counted)]
            lines.append(f"| {' | '.join([*cells, trims[mission]] if trims else cells)} |")
    return lines


def draw(rows: Sequence[Row], folder: Path) -> None:
    """A figure for each finding: its difference for each kind of failure, and for all."""
    for finding, whole in known(rows):
        shown = {**kinds(rows, finding), "all": whole}
        figure, axes = plt.subplots(figsize=(7, 0.36 * len(shown) + 1.2), layout="constrained")
        for i, d in enumerate(shown.values()):
            errors = [[100 * (d.difference - d.low)], [100 * (d.high - d.difference)]]
            colour = "C0" if d.low > 0 else "C3" if d.high < 0 else "0.45"
            axes.errorbar([100 * d.difference], [i], xerr=errors, fmt="o", color=colour, capsize=3)
        axes.axvline(0.0, color="0.5", lw=0.8)
        axes.set_yticks(range(len(shown)), list(shown))
        axes.invert_yaxis()
        axes.set_xlabel(f"flights held, percentage points (95 %):\n{finding.first} minus {finding.second}")
        figure.savefig(folder / f"finding_{finding.name}.png", dpi=110)
        plt.close(figure)

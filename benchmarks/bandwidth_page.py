"""The page and the figure of `section4_bandwidth.py`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import matplotlib
import numpy as np
from bandwidth_ideal import REMAINS, W
from bandwidth_limits import ALTITUDE_M, HEADING_DEG, LIMITED, LOSS_S, OLDER, SLOWER
from matplotlib.axes import Axes
from prediction_errors import summary

from paper import bandwidth

matplotlib.use("agg")
import matplotlib.pyplot as plt


@dataclass(frozen=True)
class Row:
    """A prediction beside what was measured.

    Attributes:
        predicted: by a closed form, or by an equation integrated.
        ideal: by the flying law on the ideal plant, in the same condition.
        same_r: by (13) alone for the reference that was flown (`benchmarks/paper/replay.py`).
        flown: in JSBSim.
    """

    what: str
    x: float
    predicted: float
    ideal: float
    same_r: float
    flown: float


HEADS = {
    "moving": f"""\
## A command that moves, behind a servo slower than the law knows

Mean of the estimate, true value 1, of altitude references that go up and down at w = {W:g} rad/s. Prediction:
`offset_reading_within(F / F_m)`, with the share of the reference that moves as it was flown.""",
    "limited": f"""\
## A command that moves, behind a rate limit that the law does not know

As before, at w = {W:g} rad/s. Prediction: `rate_limited_offset_reading`, by the describing function of a rate limit, with the share
and the amplitude of the reference as they were flown. The limit acts from R / A w = 1 on. It makes the position late, and the
more so the larger the command is; where the pitch loop swings by itself, there is no reading.""",
    "sampled": f"""\
## A loss, seen in large steps

Lowest estimate after a loss to {REMAINS:g}, compensated law. Prediction: `sampled_extreme`.""",
    "lag": f"""\
## A loss behind a slow servo, plain

Lowest estimate after a loss to {REMAINS:g}. Prediction: `extreme`, which takes the reference for constant.""",
    "late": f"""\
## A loss seen late

Lowest estimate after a loss to {REMAINS:g}, compensated law. Prediction: `late_extreme`, which takes the reference for constant
and all sensors for equally late.""",
    "mixed": f"""\
## Late rates alone

As before, with gyro and accelerometer late and the other sensors on time: f_m is that of another moment than the rates. No
prediction is made for this; that of equally late sensors stands beside it. True value {REMAINS:g}.""",
    "stops": """\
## Stops

Mean of the estimate at the end. Prediction: `stop_reading`; the effectiveness is 1 before a stop that the law does not know.""",
}
INTRODUCTION = """\
# Bandwidth and saturation: predictions beside flights

<!-- Written by python benchmarks/section4_bandwidth.py: change that, not this. -->

This page compares what [theory predicts](../explanation/bandwidth.md) of slow servos and late sensors with the ideal plant
and with flights in JSBSim.

Calm air, ideal sensors, `preset: paper` without monitor and jam test. *(13) with the flown r* is the adaptive law alone, one
actuator by itself, for the reference that was flown (`benchmarks/paper/replay.py`): what it has in common with the flight is due to
servo and sensor. What the prediction lacks beside it is a reference that reacts to the error.

![Predictions as lines, the ideal plant as crosses, flights as dots](../figures/section4_bandwidth.png)"""


def page(
    rows: Mapping[str, Sequence[Row]],
    known: Sequence[tuple[str, float, float]],
    limits: Mapping[str, tuple[float, float, float]],
) -> str:
    """The Markdown of docs/results/section4_bandwidth.md: flights, limits on the ideal plant, and what each law withstands."""
    lines = [INTRODUCTION]
    for group, head in HEADS.items():
        lines += ["", head, "", *table(rows[group])]
    lines += [
        "",
        "## How far the predictions are off",
        "",
        "Flown beside the prediction; *same r* beside (13) with the flown r.",
        "",
    ]
    lines += summary(pairs(rows))
    lines += ["", "## Stops, rate limits and late errors, on the ideal plant", ""]
    lines += ["| condition | predicted | measured | error |", "| --- | --- | --- | --- |"]
    lines += [f"| {what} | {p:.3f} | {m:.3f} | {relative(m, p)} |" for what, p, m in known]
    lines += [
        "",
        *withstanding(),
        "",
        "| law | slowest servo | lowest rate limit | oldest sensors |",
        "|" + " --- |" * 4,
    ]
    for name, found in limits.items():
        words = [
            "none" if math.isnan(value) else f"{value * factor:g} {unit}"
            for value, factor, unit in zip(found, (1, 1, 1000), ("rad/s", "deg/s", "ms"), strict=True)
        ]
        lines.append(f"| {name} | {' | '.join(words)} |")
    return "\n".join(lines) + "\n"


NAMES = {
    "moving": "reading behind a lag", "limited": "reading behind a rate limit", "sampled": "loss in large steps",
    "lag": "loss behind a lag", "late": "loss seen late", "stops": "stop",
}  # fmt: skip
"""The groups for which a prediction is made, by its quantity."""


def pairs(rows: Mapping[str, Sequence[Row]]) -> dict[str, list[tuple[float, float]]]:
    found = {}
    for group, name in NAMES.items():
        read = [row for row in rows[group] if not math.isnan(row.flown)]
        found[f"{name}, ideal plant"] = [(row.predicted, row.ideal) for row in read]
        found[f"{name}, flown"] = [(row.predicted, row.flown) for row in read]
        found[f"{name}, flown, same r"] = [(row.same_r, row.flown) for row in read]
    return found


def withstanding() -> list[str]:
    slower, limited = (", ".join(f"{value:g}" for value in values) for values in (SLOWER, LIMITED))
    older = ", ".join(f"{1000 * age:g}" for age in OLDER)
    return [
        "## How slow may a servo be, how late a sensor",
        "",
        f"Turns at 4 deg/s and a climb, the left tail at 0.3 from {LOSS_S:g} s on. From the start both tails' servos are slow",
        "or limited in rate, or all sensors late; no law knows. Held: no healthy actuator flagged, and all the time within",
        f"{ALTITUDE_M:g} m and {HEADING_DEG:g} deg. The last value held of {slower} rad/s,",
        f"of {limited} deg/s, and of {older} ms.",
    ]


def table(rows: Sequence[Row]) -> list[str]:
    head = ("condition", "predicted", "flown", "error", "(13) with the flown r")
    lines = [f"| {' | '.join(head)} |", f"|{' --- |' * len(head)}"]
    for row in rows:
        numbers = (row.predicted, row.flown)
        cells = (row.what, *map(number, numbers), relative(row.flown, row.predicted), number(row.same_r))
        lines.append(f"| {' | '.join(cells)} |")
    return lines


def number(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.3f}"


def relative(measured: float, predicted: float) -> str:
    error = measured / predicted - 1.0
    return "" if math.isnan(error) else f"{100.0 * error:+.1f} %"


def draw(rows: Mapping[str, Sequence[Row]], file: Path) -> None:
    figure, panels = plt.subplots(1, 3, figsize=(11, 3.8), layout="constrained")
    x = np.geomspace(0.03, 4.0, 80)
    panels[0].plot(
        x,
        [bandwidth.moving_reading(bandwidth.lag(v, 1.0)) for v in x],
        color="0.6",
        label="about zero, plain",
    )
    panels[1].plot(x, [bandwidth.extreme(1.0, REMAINS, v) for v in x], color="0.3", label="predicted")
    panels[2].plot(
        x, [bandwidth.late_extreme(1.0, REMAINS, v, 100) for v in x], color="0.3", label="predicted"
    )
    for axes, group in zip(panels, ("moving", "lag", "late"), strict=True):
        scatter(axes, rows[group], group == "moving")
    panels[0].set(xlabel="w tau [-]", ylabel="mean estimate, truth 1 [-]", xlim=(0.0, 1.0), ylim=(0.4, 1.1))
    panels[1].set(
        xlabel="gamma tau [-]",
        ylabel=f"lowest estimate, truth {REMAINS:g} [-]",
        xlim=(0.1, 4.0),
        ylim=(0.0, 0.25),
    )
    panels[2].set(
        xlabel="gamma T [-]",
        ylabel=f"lowest estimate, truth {REMAINS:g} [-]",
        xlim=(0.03, 1.6),
        ylim=(0.0, 0.25),
    )
    panels[1].axvline(bandwidth.OVERSHOOT_LIMIT, color="0.7", lw=0.8)
    panels[2].axvline(1.0 / math.e, color="0.7", lw=0.8)
    for axes, title in zip(
        panels, ("a moving command", "a loss behind a lag", "a loss seen late"), strict=True
    ):
        axes.set_title(title)
        axes.legend(fontsize="small")
    figure.savefig(file, dpi=110)
    plt.close(figure)


def scatter(axes: Axes, rows: Sequence[Row], lines: bool) -> None:
    """Predictions of the rows (where they are no line), the ideal plant, (13) with the flown r, flights."""
    x = [row.x for row in rows]
    if lines:
        axes.plot(
            x, [row.predicted for row in rows], "_", color="0.3", ms=14, label="predicted, with its offset"
        )
    axes.plot(x, [row.ideal for row in rows], "x", color="C0", ms=6, label="ideal plant")
    axes.plot(x, [row.same_r for row in rows], "s", mfc="none", color="C2", ms=6, label="(13), flown r")
    axes.plot(x, [row.flown for row in rows], "o", color="C1", ms=4, label="flown")

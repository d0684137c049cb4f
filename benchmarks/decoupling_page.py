"""The page and the figure of `decoupling.py`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path

import matplotlib
import numpy as np
from flights import Record
from matplotlib.ticker import NullFormatter
from mission_results import Row, by_mission, totals
from paper.l1_plant import measured

from paper import decoupling

matplotlib.use("agg")
import matplotlib.pyplot as plt

SEEDS = range(90001, 90007)
DELAYS = (0.0, 0.02, 0.04, 0.06, 0.08, 0.1, 0.12, 0.15, 0.2)
LOSS_S, REMAINS = 20.0, 0.3
INTRODUCTION = """\
# Decoupling adaptation from robustness

<!-- Written by python benchmarks/decoupling.py: change that, not this. -->

This page compares `l1_inversion`, which adapts fast behind a low-pass filter and diagnoses apart, with the paper's law, the default
and incremental inversion; [the explanation](../explanation/decoupling.md) has the theory.
"""


MARGIN_TEXT = f"""\
## Delay margin, and how fast the rates come back

Margin: the hard route, both tails at {REMAINS:g} from {LOSS_S:g} s on, every actuator late from the start by
{", ".join(f"{1000 * delay:g}" for delay in DELAYS)} ms. Calm: in calm air with ideal sensors. Weather: as above, all
{len(SEEDS)} seeds. The error is that of the pitch acceleration that was asked for, after the left tail's loss
to {REMAINS:g} in calm air with ideal sensors. Where k or Gamma is not named it is the default of `l1_inversion`.
Here the paper's law gives up the same axis as the others (`released: auto`); in the missions above it gives up none."""


def margin_table(found: Mapping[str, Sequence[float]], recovered: Mapping[str, Record]) -> list[str]:
    head = (
        "law", "calm: flown up to", "held up to", "weather: none lost up to", "all held up to", "error after the loss",
        "until a tenth of it",
    )  # fmt: skip
    lines = [f"| {' | '.join(head)} |", "|" + " --- |" * len(head)]
    for name, delays in found.items():
        back = recovered[name]["metrics"]
        cells = (
            name, *map(milliseconds, delays), f"{back['error_peak_deg_s2']:.0f} deg/s2",
            f"{back['error_recovery_s']:.2f} s",
        )  # fmt: skip
        lines.append(f"| {' | '.join(cells)} |")
    return lines


def milliseconds(delay: float) -> str:
    return "no delay" if math.isnan(delay) else f"{1000 * delay:g} ms"


def page(rows: Sequence[Row], found: Mapping[str, Sequence[float]], recovered: Mapping[str, Record]) -> str:
    lines = [
        INTRODUCTION,
        "## Missions",
        "",
        f"W20 = 25 ft/s, MEMS sensors, seeds {SEEDS.start} to {SEEDS.stop - 1}; held is within 5 m and 15 deg from the first",
        "failure on.",
        "",
        *totals(rows, "default"),
        "",
        "held/survived/flights; where all survived, held/flights",
        "",
        *by_mission(rows),
        "",
        *MARGIN_TEXT.splitlines(),
        "",
        *margin_table(found, recovered),
        "",
        "## Speed against noise",
        "",
        "Time to 5 % and variance under white noise after a small loss, both by the flying law on the ideal plant. On a line their",
        "product is the same.",
        "",
        "![Laws and the bounds of any linear estimator](../figures/decoupling_noise.png)",
    ]
    return "\n".join(lines) + "\n"


def draw(file: Path) -> None:
    """Lines of equal product, and the closed forms of the laws for several gains."""
    figure, axes = plt.subplots(figsize=(6.5, 4.2), layout="constrained")
    t = np.geomspace(0.2, 8.0, 50)
    bounds = {"any linear estimator: 0.90": (decoupling.LINEAR_BOUND, ":"), "the paper: 1.50": (decoupling.PAPER, "-"),
              "two equal poles: 1.19": (decoupling.cascade(1.0, 1.0), "--")}  # fmt: skip
    for name, (product, style) in bounds.items():
        axes.loglog(t, product / t, style, color="0.4", label=name)
    for mark, (name, pairs) in zip("o^s", POINTS.items(), strict=True):
        times, variances = zip(*(measured(*pair) for pair in pairs), strict=True)
        axes.plot(times, variances, mark, ms=6, mfc="none", label=name)
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set(xlabel="time to 5 % after a small loss [s]", ylabel="variance over s / r^2 [1/s]")
    axes.legend(fontsize="small")
    figure.savefig(file, dpi=110)
    plt.close(figure)


POINTS: Mapping[str, Sequence[tuple[float, float | None]]] = {
    "the paper, gamma 1, 2, 4, 8": [(gamma, None) for gamma in (1.0, 2.0, 4.0, 8.0)],
    "l1, Gamma 20, k 2, 5, 10, 20": [(20.0, k) for k in (2.0, 5.0, 10.0, 20.0)],
    "l1, Gamma = k = 1, 2, 5": [(k, k) for k in (1.0, 2.0, 5.0)],
}

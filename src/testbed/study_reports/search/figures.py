"""Figures of a search: convergence, the path to the answer, and probability by level. To add one, name it in TABLE."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from testbed.reporting.palette import nth
from testbed.reporting.words import setting
from testbed.study_reports.drawing import Draw, figure, legend

Summary = Mapping[str, Any]
CAPTIONS = {
    "convergence": "Distance of the nearest failure found, by the number of flights made.",
    "path": "The way to the answer: the coordinates of each nearer failure that was found, the last on the right.",
    "levels": "Probability that the robustness is at most a value, by level, with 95 % intervals; at 0, the answer.",
}
_MOST_INPUTS, _MOST_PANELS = 12, 6


def convergence(summary: Summary) -> Figure | None:
    """Distance of the nearest failure against flights made, a line for each part."""
    shown = [part for part in summary["parts"] if part.get("path")]
    if not shown:
        return None
    drawn, ((axes,),) = figure(8.0, 4.0)
    for i, part in enumerate(shown):
        flights, distance = ([step[what] for step in part["path"]] for what in ("flights", "distance"))
        flights.append(max(part["flights"], flights[-1]))  # points that were asked for twice are flown once
        look = {"label": _label(part, shown), "ms": 4, **nth(i, "marker")}
        axes.step(flights, [*distance, distance[-1]], where="post", **look)
    axes.set(xlabel="flights", ylabel="distance of the nearest failure")
    legend(axes, beside=True)
    axes.set_ylim(0.0, 1.1 * max(part["path"][0]["distance"] for part in shown) or 1.0)
    axes.set_xlim(left=0.0)
    return drawn


def path(summary: Summary) -> Figure | None:
    """The values of each nearer failure, a panel for each part and a line for each input."""
    shown = [part for part in summary["parts"] if len(part.get("path", ())) > 1][:_MOST_PANELS]
    if not shown:
        return None
    drawn, grid = figure(8.0, 2.6 * len(shown), len(shown))
    for axes, part in zip(grid.flat, shown, strict=True):
        names = sorted(part["point"], key=lambda name: -part["point"][name]["share"])[:_MOST_INPUTS]
        for j, name in enumerate(names):
            values = [step["coordinates"][name] for step in part["path"]]
            axes.plot(range(1, len(values) + 1), values, label=setting(name), ms=4, **nth(j, "marker"))
        axes.set(ylabel="standard deviations", title=part["label"])
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
        legend(axes, beside=True)
    grid[-1, 0].set_xlabel("nearer failures, in the order in which they were found")
    return drawn


def levels(summary: Summary) -> Figure | None:
    """P(robustness at most g) against g, in logarithms."""
    shown = [part for part in summary["parts"] if len(part.get("levels", ())) > 1]
    if not shown:
        return None
    drawn, ((axes,),) = figure(8.0, 4.0)
    for i, part in enumerate(shown):
        known = [level for level in part["levels"] if level["threshold"] is not None and level["probability"]]
        products = np.cumprod([level["probability"] for level in known])
        spread = np.sqrt(np.cumsum([(level["cov"] or 0.0) ** 2 for level in known]))
        ends = products * np.exp(np.outer([-1.96, 1.96], np.sqrt(np.log1p(spread**2))))
        look = {"capsize": 3, "ms": 4, "label": _label(part, shown), **nth(i, "marker")}
        thresholds = [level["threshold"] for level in known]
        axes.errorbar(thresholds, products, yerr=[products - ends[0], ends[1] - products], **look)
    axes.set_yscale("log")
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.set(xlabel="robustness", ylabel="probability of at most this")
    axes.axvline(0.0, color="0.35", ls=":")
    legend(axes, beside=True)
    return drawn


def _label(part: Summary, among: list[Summary]) -> str | None:
    """The name of a part in the legend, if it is not the only one."""
    return part["label"] or None if len(among) > 1 else None


TABLE: dict[str, Draw] = {"convergence": convergence, "path": path, "levels": levels}

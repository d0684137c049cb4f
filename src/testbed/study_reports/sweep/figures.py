"""Figures of a sweep. To add one, write a function of a plan, its table and its folder, and name it in TABLE."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from testbed.common.statistics import proportion
from testbed.reporting.palette import COLOURS, MET, MISSED, nth
from testbed.reporting.words import passing, setting
from testbed.studies.folder.table import groups_of
from testbed.studies.plan import Plan
from testbed.studies.summary import requirement_shares, sensitivity
from testbed.studies.verdicts import judged, requirements_of, state
from testbed.study_reports.drawing import Draw, draw_all, figure, legend
from testbed.study_reports.sweep.curves import errors, is_number, shares

if TYPE_CHECKING:
    import pandas as pd

_ENDINGS: dict[str, dict[str, Any]] = {
    "passed": {"marker": "o", "facecolors": "none", "edgecolors": MET, "s": 22},
    "missed": {"marker": "^", "color": MISSED, "s": 24},
    "lost": {"marker": "x", "color": "black", "s": 30, "linewidths": 2},
    "no result": {"marker": "s", "facecolors": "none", "edgecolors": "0.5", "s": 22},
    "not judged": {"marker": "D", "facecolors": "none", "edgecolors": "0.5", "s": 22},
}
_HATCHES = ("", "//", "..", "xx")
_MOST_PANELS, _MOST_POINTS = 9, 3000


def draw_sweep(plan: Plan, frame: pd.DataFrame, folder: Path) -> list[Path]:
    """Draw every figure for which the table has data into folder/figures; returns the files."""
    return draw_all(TABLE, folder, plan, frame, folder)


def probabilities(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Probability that all requirements are met, and that each is met, with 95 % intervals."""
    titles = [requirement.title for requirement in requirements_of(plan)]
    names = [passing(titles), *titles]
    drawn, ((axes,),) = figure(8.0, 0.9 + 0.42 * len(names))
    for i, (label, rows) in enumerate(groups_of(plan, frame)):
        total = judged(rows["passed"])
        each = (requirement_shares(rows, j) for j in range(len(titles)))
        known = [proportion(*count) for count in ((int(total.sum()), len(total)), *each)]
        at = np.array([(share.estimate, share.low, share.high) for share in known])
        _intervals(axes, at, i, label, len(plan.variants), "x")
    axes.set(yticks=range(len(names)), yticklabels=[_short(n) for n in names], xlim=(-0.02, 1.02))
    axes.invert_yaxis()
    axes.set_xlabel("probability of being met, 95 % interval")
    legend(axes)
    return drawn


def _intervals(axes: Axes, known: np.ndarray, i: int, label: str, variants: int, along: str) -> None:
    """Draw [names, 3] shares with their lowest and highest values, those of the i-th variant beside the others'."""
    share, low, high = known.T
    where = np.arange(len(share)) + 0.12 * (i - (variants - 1) / 2)
    error = np.maximum([share - low, high - share], 0.0)
    at = (share, where) if along == "x" else (where, share)
    look: dict[str, Any] = {f"{along}err": error, "label": label or None, **nth(i, "marker")}
    axes.errorbar(*at, ls="", capsize=2, ms=4, **look)


def pass_share(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Share of flights that pass along each varied value, with its 95 % interval."""
    panels = shares(plan, frame)[:_MOST_PANELS]
    if not panels:
        return None
    columns = min(len(panels), 3)
    rows = -(-len(panels) // columns)
    drawn, grid = figure(1.0 + 3.6 * columns, 0.6 + 2.7 * rows, rows, columns)
    for axes in grid.flat[len(panels) :]:
        axes.set_visible(False)
    for k, (axes, panel) in enumerate(zip(grid.flat, panels, strict=False)):
        for i, (points, variant) in enumerate(zip(panel["variants"], plan.variants, strict=True)):
            _share(axes, points, i, variant.label, len(plan.variants))
        axes.set(xlabel=panel["path"], ylim=(-0.02, 1.02))
        axes.set_ylabel("" if k % columns else "share that passes")
    legend(grid[0, 0])
    return drawn


def _share(axes: Axes, points: list[list[Any]], i: int, label: str, variants: int) -> None:
    """The points [at, share, low, high, flights] of a variant: beside each other for names, as a line for numbers."""
    at, known = [point[0] for point in points], np.array([point[1:4] for point in points], dtype=float)
    if at and isinstance(at[0], str):
        _intervals(axes, known, i, label, variants, "y")
        axes.set_xticks(range(len(at)), [_short(name) for name in at])
        axes.set_xlim(-0.5, len(at) - 0.5)
        return
    if not at:  # no flight of it was judged
        return
    share, low, high = known.T
    axes.plot(at, share, ms=4, label=label or None, **nth(i, "marker", "ls"))
    axes.fill_between(at, low, high, color=COLOURS[i % 6], alpha=0.2)


def flight_map(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Every flight by the first two varied numbers: passed, missed and lost, each with a marker of its own."""
    numbers = [path for path in plan.paths if is_number(frame[path])][:2]
    if len(numbers) < 2:
        return None
    drawn, (cells,) = figure(1.0 + 3.4 * len(plan.variants), 3.6, 1, len(plan.variants), share=True)
    for axes, (label, rows) in zip(cells, groups_of(plan, frame), strict=True):
        ended = np.array([state(str(o), p) for o, p in zip(rows["outcome"], rows["passed"], strict=True)])
        for name, style in _ENDINGS.items():
            if (count := int((ended == name).sum())) > 0:
                first = rows[ended == name].head(_MOST_POINTS)
                axes.scatter(first[numbers[0]], first[numbers[1]], label=f"{name} ({count})", **style)
        axes.set(xlabel=setting(numbers[0]), title=label)
        axes.legend(fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2, frameon=False)
    cells[0].set_ylabel(setting(numbers[1]))
    return drawn


def envelope(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Errors in time, for each variant: median, 5 to 95 %, and the flight with the largest; headings without jumps."""
    panels, count = list(errors(plan, frame, folder)), len(plan.variants)
    if not panels:
        return None
    drawn, grid = figure(1.2 + 3.8 * count, 2.7 * len(panels), len(panels), count, share=True)
    for panel, row in zip(panels, grid, strict=True):
        for i, (axes, band) in enumerate(zip(row, panel["variants"], strict=True)):
            if band is not None:
                _band(axes, panel["times"], band, i)
            for limit in panel["limits"]:
                for size in (-limit["size"], limit["size"]):
                    axes.plot([limit["from_s"], limit["until_s"]], [size, size], color=MISSED, ls=":", lw=1.2)
        row[0].set_ylabel(panel["title"])
        _linear_then_logarithmic(row[0], panel["linear"])  # of all the row, which shares its axis
    for above, below, variant in zip(grid[0], grid[-1], plan.variants, strict=True):
        above.set_title(variant.label, fontsize=10)
        below.set_xlabel("time [s]")
    return drawn


def _linear_then_logarithmic(axes: Axes, linear: float) -> None:
    """A y axis that is linear up to a size, and logarithmic beyond: a loss and a good flight are seen in one picture."""
    most = 1.3 * max(map(abs, axes.get_ylim()))
    axes.set_yscale("asinh", linear_width=linear)
    sizes = [linear * 10.0**k for k in range(8) if linear * 10.0**k <= most]
    axes.set_yticks([*(-size for size in sizes), 0.0, *sizes], minor=False)
    axes.set_yticks([], minor=True)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.set_ylim(-most, most)


def _band(axes: Axes, times: list[float], band: dict[str, Any], i: int) -> None:
    low, median, high, largest = (np.array(band[k], float) for k in ("low", "median", "high", "largest"))
    axes.fill_between(times, low, high, color=COLOURS[i % 6], alpha=0.25, label="5 to 95 %")
    axes.plot(times, median, color=COLOURS[i % 6], lw=1.8, label="median")
    axes.plot(times, largest, color="0.25", lw=0.9, ls="--", label=f"largest, run {band['run']}")
    axes.legend(fontsize=7, loc="upper left")


def detection_delay(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Cumulative distribution of the detection delay: share of detections within a delay, against that delay."""
    if "detection_delay_s" not in frame or not frame["detection_delay_s"].notna().any():
        return None
    drawn, ((axes,),) = figure(7.0, 4.0)
    for i, (label, rows) in enumerate(groups_of(plan, frame)):
        delays = rows["detection_delay_s"].dropna().to_numpy(dtype=float)
        if len(delays):
            axes.ecdf(delays, label=f"{label or 'all'}: {len(delays)} of {len(rows)} flights", **nth(i, "ls"))
    axes.set(xlabel="detection delay [s]", ylabel="share of detections", ylim=(0, 1.02))
    legend(axes)
    return drawn


def drivers(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """PAWN sensitivity of passing to each varied value, with the index that chance alone would give."""
    found = [sensitivity(rows, plan.paths, ["passed"])["passed"] for _, rows in groups_of(plan, frame)]
    if not any("inputs" in result for result in found):
        return None
    drawn, ((axes,),) = figure(7.0, 1.2 + 0.5 * len(plan.paths))
    for i, (result, variant) in enumerate(zip(found, plan.variants, strict=True)):
        if inputs := result.get("inputs"):
            where = [plan.paths.index(name) + 0.25 * (i - (len(found) - 1) / 2) for name in inputs]
            look = {"color": COLOURS[i % 6], "hatch": _HATCHES[i % 4], "edgecolor": "white"}
            axes.barh(where, [r["pawn"] for r in inputs.values()], 0.22, label=variant.label or None, **look)
            axes.axvline(next(iter(inputs.values()))["pawn_by_chance"], color=COLOURS[i % 6], ls=":", lw=1)
    indicative = ", indicative" if any(result.get("indicative") for result in found) else ""
    axes.set_yticks(range(len(plan.paths)), plan.paths)
    axes.set_xlabel(f"PAWN index on passing{indicative}; dotted: by chance")
    axes.invert_yaxis()
    legend(axes)
    return drawn


TABLE: dict[str, Draw] = {
    "probabilities": probabilities,
    "map": flight_map,
    "pass_share": pass_share,
    "envelope": envelope,
    "detection_delay": detection_delay,
    "drivers": drivers,
}


def _short(text: str) -> str:
    return text if len(text) <= 48 else text[:45] + "..."

"""Figures of a sweep. To add one, write a function of a plan, its table and its folder, and name it in TABLE."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from testbed.common.statistics import proportion
from testbed.reporting.figures.sheet import Drawing, plain_text, save
from testbed.reporting.palette import COLOURS, MET, MISSED, nth
from testbed.studies.folder.reading import groups_of, unit
from testbed.studies.plan import Plan
from testbed.studies.summary import requirement_titles
from testbed.studies.verdicts import state
from testbed.study_reports.sweep.curves import is_number
from testbed.study_reports.sweep.flights import errors, shares

if TYPE_CHECKING:
    import pandas as pd

_ENDINGS: dict[str, dict[str, Any]] = {
    "passed": {"marker": "o", "facecolors": "none", "edgecolors": MET, "s": 22},
    "missed": {"marker": "^", "color": MISSED, "s": 24},
    "lost": {"marker": "x", "color": "black", "s": 30, "linewidths": 2},
    "no result": {"marker": "s", "facecolors": "none", "edgecolors": "0.5", "s": 22},
}
_HATCHES = ("", "//", "..", "xx")
_MOST_PANELS, _MOST_POINTS = 9, 3000


def draw_sweep(plan: Plan, frame: pd.DataFrame, folder: Path) -> list[Path]:
    """Draw every figure for which the table has data into folder/figures; returns the files."""
    files = []
    for name, draw in TABLE.items():
        with plain_text():
            figure = draw(plan, frame, folder)
            if figure is not None:
                files.append(save(figure, folder, name))
    return files


def probabilities(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Probability that all requirements are met, and that each is met, with 95 % intervals."""
    titles = requirement_titles(plan)
    names = ["all requirements", *titles]
    columns = ["passed", *(f"requirements.{j}.passed" for j in range(len(titles)))]
    figure, axes = _figure(8.0, 0.9 + 0.42 * len(names))
    for i, (label, rows) in enumerate(groups_of(plan, frame)):
        offset = 0.12 * (i - (len(plan.variants) - 1) / 2)
        for j, column in enumerate(columns):
            known = proportion(int((rows[column] == True).sum()) if column in rows else 0, len(rows))  # noqa: E712
            error = [[max(0.0, known.estimate - known.low)], [max(0.0, known.high - known.estimate)]]
            named = (label or None) if j == 0 else None
            axes.errorbar(
                known.estimate,
                j + offset,
                xerr=error,
                ls="",
                ms=4,
                capsize=2,
                label=named,
                **nth(i, "marker"),
            )
    axes.set(yticks=range(len(names)), yticklabels=[_short(n) for n in names], xlim=(-0.02, 1.02))
    axes.invert_yaxis()
    axes.set_xlabel("probability of being met, 95 % interval")
    _legend(axes)
    return figure


def pass_share(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Share of flights that pass along each varied value, with its 95 % interval."""
    drawn = shares(plan, frame)[:_MOST_PANELS]
    if not drawn:
        return None
    columns = min(len(drawn), 3)
    rows = -(-len(drawn) // columns)
    figure, grid = _figure(1.0 + 3.6 * columns, 0.6 + 2.7 * rows, rows, columns, share_x=False)
    for axes in np.ravel(grid)[len(drawn) :]:
        axes.set_visible(False)
    for k, (axes, panel) in enumerate(zip(np.ravel(grid), drawn, strict=False)):
        for i, (points, variant) in enumerate(zip(panel["variants"], plan.variants, strict=True)):
            _share(axes, points, i, variant.label, len(plan.variants))
        axes.set(xlabel=_axis(panel["path"]), ylim=(-0.02, 1.02))
        if k % columns == 0:
            axes.set_ylabel("share that passes")
    _legend(np.ravel(grid)[0])
    return figure


def _share(axes: Any, points: list[list[Any]], i: int, label: str, variants: int) -> None:
    """The points [at, share, low, high, flights] of a variant: beside each other for names, as a line for numbers."""
    at = [point[0] for point in points]
    share, low, high = np.array([point[1:4] for point in points], dtype=float).T
    if at and isinstance(at[0], str):
        where = np.arange(len(at)) + 0.12 * (i - (variants - 1) / 2)
        error = np.maximum([share - low, high - share], 0.0)
        axes.errorbar(
            where, share, yerr=error, ls="", capsize=2, ms=4, label=label or None, **nth(i, "marker")
        )
        axes.set_xticks(range(len(at)), map(_short, at))
        axes.set_xlim(-0.5, len(at) - 0.5)
        return
    axes.plot(at, share, ms=4, label=label or None, **nth(i, "marker", "ls"))
    axes.fill_between(at, low, high, color=COLOURS[i % 6], alpha=0.2)


def flight_map(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Every flight by the first two varied numbers: passed, missed and lost, each with a marker of its own."""
    numbers = [path for path in plan.paths if is_number(frame[path])][:2]
    if len(numbers) < 2:
        return None
    count = len(plan.variants)
    figure, grid = _figure(1.0 + 3.4 * count, 3.6, 1, count)
    for axes, (label, rows) in zip(np.ravel(grid), groups_of(plan, frame), strict=True):
        ended = np.array(
            [state(str(o), bool(p)) for o, p in zip(rows["outcome"], rows["passed"], strict=True)]
        )
        for name, style in _ENDINGS.items():
            those = rows[ended == name]
            if len(those):
                first = those.head(_MOST_POINTS)
                axes.scatter(first[numbers[0]], first[numbers[1]], label=f"{name} ({len(those)})", **style)
        axes.set(xlabel=_axis(numbers[0]), title=label)
        axes.legend(fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2, frameon=False)
    np.ravel(grid)[0].set_ylabel(_axis(numbers[1]))
    return figure


def envelope(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Errors in time, for each variant: median, 5 to 95 %, and the flight with the largest; headings without jumps."""
    panels, count = list(errors(plan, frame, folder)), len(plan.variants)
    if not panels:
        return None
    figure, grid = _figure(1.2 + 3.8 * count, 2.7 * len(panels), len(panels), count)
    cells = np.reshape(grid, (len(panels), count))
    for panel, row in zip(panels, cells, strict=True):
        for i, (axes, band) in enumerate(zip(row, panel["variants"], strict=True)):
            if band is not None:
                _band(axes, panel["times"], band, i)
            for limit in panel["limits"]:
                span = [limit["from_s"], limit["until_s"]]
                for size in (-limit["size"], limit["size"]):
                    axes.plot(span, [size, size], color=MISSED, ls=":", lw=1.2)
        row[0].set_ylabel(panel["title"])
        _linear_then_logarithmic(row[0], panel["linear"])  # of all the row, which shares its axis
    for axes, variant in zip(cells[0], plan.variants, strict=True):
        axes.set_title(variant.label, fontsize=10)
    for axes in cells[-1]:
        axes.set_xlabel("time [s]")
    return figure


def _linear_then_logarithmic(axes: Any, linear: float) -> None:
    """A y axis that is linear up to a size, and logarithmic beyond: a loss and a good flight are seen in one picture."""
    most = 1.3 * max(map(abs, axes.get_ylim()))
    axes.set_yscale("asinh", linear_width=linear)
    sizes = [linear * 10.0**k for k in range(8) if linear * 10.0**k <= most]
    axes.set_yticks([*(-size for size in sizes), 0.0, *sizes], minor=False)
    axes.set_yticks([], minor=True)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.set_ylim(-most, most)


def _band(axes: Any, times: list[float], band: dict[str, Any], i: int) -> None:
    low, median, high, largest = (np.array(band[k], float) for k in ("low", "median", "high", "largest"))
    axes.fill_between(times, low, high, color=COLOURS[i % 6], alpha=0.25, label="5 to 95 %")
    axes.plot(times, median, color=COLOURS[i % 6], lw=1.8, label="median")
    axes.plot(times, largest, color="0.25", lw=0.9, ls="--", label=f"largest, run {band['run']}")
    axes.legend(fontsize=7, loc="upper left")


def detection_delay(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Cumulative distribution of the detection delay: share of detections within a delay, against that delay."""
    if "detection_delay_s" not in frame or not frame["detection_delay_s"].notna().any():
        return None
    figure, axes = _figure(7.0, 4.0)
    for i, (label, rows) in enumerate(groups_of(plan, frame)):
        delays = np.sort(rows["detection_delay_s"].dropna().to_numpy(dtype=float))
        if len(delays):
            words = f"{label or 'all'}: {len(delays)} of {len(rows)} flights"
            shares_within = np.arange(1, len(delays) + 1) / len(delays)
            axes.step(delays, shares_within, where="post", label=words, **nth(i, "ls"))
    axes.set(xlabel="detection delay [s]", ylabel="share of detections", ylim=(0, 1.02))
    _legend(axes)
    return figure


def drivers(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """PAWN sensitivity of passing to each varied value, with the index that chance alone would give."""
    from testbed.studies.sensitivity import sensitivity

    found = {
        label: sensitivity(rows, plan.paths, ["passed"])["passed"] for label, rows in groups_of(plan, frame)
    }
    usable = {label: result["inputs"] for label, result in found.items() if "inputs" in result}
    if not usable:
        return None
    figure, axes = _figure(7.0, 1.2 + 0.5 * len(plan.paths))
    labels = [v.label for v in plan.variants]
    for label, inputs in usable.items():
        i = labels.index(label)
        where = [plan.paths.index(name) + 0.25 * (i - (len(labels) - 1) / 2) for name in inputs]
        axes.barh(
            where, [r["pawn"] for r in inputs.values()], height=0.22, color=COLOURS[i % 6], hatch=_HATCHES[i % 4],
            edgecolor="white", label=label or None,
        )  # fmt: skip
        axes.axvline(next(iter(inputs.values()))["pawn_by_chance"], color=COLOURS[i % 6], ls=":", lw=1)
    indicative = ", indicative" if any(result.get("indicative") for result in found.values()) else ""
    axes.set(
        yticks=range(len(plan.paths)),
        yticklabels=plan.paths,
        xlabel=f"PAWN index on passing{indicative}; dotted: by chance",
    )
    axes.invert_yaxis()
    _legend(axes)
    return figure


Draw = Callable[[Plan, "pd.DataFrame", Path], Figure | None]

TABLE: dict[str, Draw] = {
    "probabilities": probabilities,
    "map": flight_map,
    "pass_share": pass_share,
    "envelope": envelope,
    "detection_delay": detection_delay,
    "drivers": drivers,
}


def _figure(
    width: float, height: float, rows: int = 1, columns: int = 1, *, share_x: bool = True
) -> tuple[Figure, Any]:
    figure = Drawing(figsize=(width, height), layout="constrained")
    axes = figure.subplots(rows, columns, squeeze=False, sharex=share_x and rows * columns > 1, sharey="row")
    for each in axes.flat:
        each.grid(alpha=0.3)
    return figure, axes if rows * columns > 1 else axes[0, 0]


def _legend(axes: Any) -> None:
    if axes.get_legend_handles_labels()[1]:
        axes.legend(fontsize=8)


def _axis(name: str) -> str:
    return f"{name} [{unit(name)}]" if unit(name) else name


def _short(text: str) -> str:
    return text if len(text) <= 48 else text[:45] + "..."

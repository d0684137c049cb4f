"""Figures of a sweep. To add one, write a function of a plan, its table and its folder, and name it in TABLE."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from testbed.common.statistics import proportion
from testbed.reporting.figures.page import Drawing, plain_text, save
from testbed.reporting.sweep_page.curves import Band, Point, drawn_inputs, error_band, is_number, pass_shares
from testbed.reporting.sweep_page.flights import LINEAR, limits
from testbed.studies.folder import histories
from testbed.studies.folder.reading import groups_of, unit
from testbed.studies.plan import Plan
from testbed.studies.summary import requirement_titles
from testbed.studies.verdicts import requirements_of, state

if TYPE_CHECKING:
    import pandas as pd

_COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
"""Colours by Okabe and Ito, which colour-blind readers can tell apart."""
_MARKERS, _LINES = "os^Dvp", ("-", "--", ":", "-.")
_LIMIT = "#b3261e"
_ENDINGS: dict[str, dict[str, Any]] = {
    "passed": {"marker": "o", "facecolors": "none", "edgecolors": "#23753a", "s": 22},
    "missed": {"marker": "^", "color": "#b3261e", "s": 24},
    "lost": {"marker": "x", "color": "black", "s": 30, "linewidths": 2},
    "no result": {"marker": "s", "facecolors": "none", "edgecolors": "0.5", "s": 22},
}
_HATCHES = ("", "//", "..", "xx")
_MOST_PANELS, _MOST_POINTS = 9, 3000


def draw_sweep(plan: Plan, frame: pd.DataFrame, folder: Path) -> list[Path]:
    """Draw every figure for which the table has data into folder/figures; returns the files."""
    target = folder / "figures"
    target.mkdir(exist_ok=True)
    files = []
    for name, draw in TABLE.items():
        with plain_text():
            figure = draw(plan, frame, folder)
            if figure is not None:
                files.append(save(figure, target / f"{name}.png"))
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
            axes.errorbar(known.estimate, j + offset, xerr=error, fmt=_marker(i), ms=4, capsize=2, color=_colour(i),
                          label=(label or None) if j == 0 else None)  # fmt: skip
    axes.set(yticks=range(len(names)), yticklabels=[_short(n) for n in names], xlim=(-0.02, 1.02))
    axes.invert_yaxis()
    axes.set_xlabel("probability of being met, 95 % interval")
    _legend(axes)
    return figure


def pass_share(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Share of flights that pass along each varied value, with its 95 % interval."""
    paths = drawn_inputs(frame, plan.paths)[:_MOST_PANELS]
    if not paths:
        return None
    columns = min(len(paths), 3)
    rows = -(-len(paths) // columns)
    figure, grid = _figure(1.0 + 3.6 * columns, 0.6 + 2.7 * rows, rows, columns, share_x=False)
    for k, axes in enumerate(np.ravel(grid)):
        if k >= len(paths):
            axes.set_visible(False)
            continue
        for i, (label, flights) in enumerate(groups_of(plan, frame)):
            _share(axes, pass_shares(flights, paths[k]), i, label, len(plan.variants))
        axes.set(xlabel=_axis(paths[k]), ylim=(-0.02, 1.02))
        if k % columns == 0:
            axes.set_ylabel("share that passes")
    _legend(np.ravel(grid)[0])
    return figure


def _share(axes: Any, points: list[Point], i: int, label: str, variants: int) -> None:
    style = {"color": _colour(i), "marker": _marker(i), "ms": 4}
    shares = [point.share for point in points]
    if isinstance(points[0].at, str):
        where = np.arange(len(points)) + 0.12 * (i - (variants - 1) / 2)
        errors = [[p.estimate - p.low for p in shares], [p.high - p.estimate for p in shares]]
        axes.errorbar(
            where,
            [p.estimate for p in shares],
            yerr=np.maximum(errors, 0.0),
            ls="",
            capsize=2,
            label=label or None,
            **style,
        )
        axes.set_xticks(range(len(points)), [_short(str(point.at)) for point in points])
        axes.set_xlim(-0.5, len(points) - 0.5)
        return
    x = [point.at for point in points]
    axes.plot(x, [p.estimate for p in shares], ls=_LINES[i % len(_LINES)], label=label or None, **style)
    axes.fill_between(x, [p.low for p in shares], [p.high for p in shares], color=_colour(i), alpha=0.2)


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
    count = len(plan.variants)
    figure, grid = _figure(1.2 + 3.8 * count, 8.0, len(histories.CHANNELS), count)
    duration_s = float(plan.builder.scenario(plan.task(0)).duration_s)
    times, drawn = histories.times_s(duration_s), False
    cells = np.reshape(grid, (len(histories.CHANNELS), count))
    for i, (label, rows) in enumerate(groups_of(plan, frame)):
        flights = rows["run"].to_numpy() * count + i
        for j, channel in enumerate(histories.CHANNELS):
            axes, band = cells[j][i], error_band(folder, flights, channel)
            if band is None:
                continue
            drawn = True
            _band(axes, times, band, i, count)
            for limit in limits(requirements_of(plan), channel, duration_s):
                for sign in (-1, 1):
                    axes.plot(
                        [limit["from_s"], limit["until_s"]],
                        [sign * limit["size"]] * 2,
                        color=_LIMIT,
                        ls=":",
                        lw=1.2,
                    )
            if i == 0:
                axes.set_ylabel(_axis(channel))
        cells[0][i].set_title(label, fontsize=10)
        cells[-1][i].set_xlabel("time [s]")
    for j, channel in enumerate(histories.CHANNELS):  # now that all of a row is drawn, which shares its axis
        _linear_then_logarithmic(cells[j][0], LINEAR[channel])
    return figure if drawn else None


def _linear_then_logarithmic(axes: Any, linear: float) -> None:
    """A y axis that is linear up to a size, and logarithmic beyond: a loss and a good flight are seen in one picture."""
    most = 1.3 * max(map(abs, axes.get_ylim()))
    axes.set_yscale("asinh", linear_width=linear)
    sizes = [linear * 10.0**k for k in range(8) if linear * 10.0**k <= most]
    axes.set_yticks([*(-size for size in sizes), 0.0, *sizes], minor=False)
    axes.set_yticks([], minor=True)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.set_ylim(-most, most)


def _band(axes: Any, times: np.ndarray, band: Band, i: int, count: int) -> None:
    axes.fill_between(times, band.low, band.high, color=_colour(i), alpha=0.25, label="5 to 95 %")
    axes.plot(times, band.median, color=_colour(i), lw=1.8, label="median")
    axes.plot(
        times, band.largest, color="0.25", lw=0.9, ls="--", label=f"largest, run {band.flight // count}"
    )
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
            axes.step(
                delays,
                np.arange(1, len(delays) + 1) / len(delays),
                where="post",
                color=_colour(i),
                ls=_LINES[i % len(_LINES)],
                label=words,
            )
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
            where, [r["pawn"] for r in inputs.values()], height=0.22, color=_colour(i), hatch=_HATCHES[i % 4],
            edgecolor="white", label=label or None,
        )  # fmt: skip
        axes.axvline(next(iter(inputs.values()))["pawn_by_chance"], color=_colour(i), ls=":", lw=1)
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


def _colour(i: int) -> str:
    return _COLOURS[i % len(_COLOURS)]


def _marker(i: int) -> str:
    return _MARKERS[i % len(_MARKERS)]


def _axis(name: str) -> str:
    return f"{name} [{unit(name)}]" if unit(name) else name


def _short(text: str) -> str:
    return text if len(text) <= 48 else text[:45] + "..."

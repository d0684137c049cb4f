"""Figures of a sweep. To add one, write a function of a plan, its table and its folder, and name it in TABLE."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from testbed.reporting.figures.page import Drawing, plain_text, save
from testbed.sweeps.folder import histories
from testbed.sweeps.folder.reading import groups_of, unit
from testbed.sweeps.plan import Plan
from testbed.sweeps.statistics import proportion
from testbed.sweeps.summary import requirement_titles

if TYPE_CHECKING:
    import pandas as pd

_COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
"""Colours by Okabe and Ito, which colour-blind readers can tell apart."""
_BINS = 10
_CHUNK = 2000
"""Error histories that are read at a time."""
_MOST = 20_000
"""Largest number of error histories from which quantiles are computed."""


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
            axes.errorbar(known.estimate, j + offset, xerr=error, fmt="o", ms=4, capsize=2, color=_colour(i),
                          label=(label or None) if j == 0 else None)  # fmt: skip
    axes.set(yticks=range(len(names)), yticklabels=[_short(n) for n in names], xlim=(-0.02, 1.02))
    axes.invert_yaxis()
    axes.set_xlabel("probability of being met, 95 % interval")
    _legend(axes)
    return figure


def survival(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Share of flights that pass, against the effectiveness that the failure leaves, with its 95 % band."""
    path = remaining_effectiveness(plan, frame)
    if path is None:
        return None
    figure, axes = _figure(7.0, 4.2)
    for i, (label, rows) in enumerate(groups_of(plan, frame)):
        x, passed = rows[path].to_numpy(dtype=float), rows["passed"].to_numpy(dtype=bool)
        edges = np.unique(np.quantile(x, np.linspace(0, 1, min(_BINS, max(2, len(x) // 10)) + 1)))
        which = np.clip(np.searchsorted(edges, x, side="right") - 1, 0, max(len(edges) - 2, 0))
        found = [(x[which == b].mean(), proportion(int(passed[which == b].sum()), int((which == b).sum())))
                 for b in np.unique(which)]  # fmt: skip
        centres = [centre for centre, _ in found]
        axes.plot(centres, [p.estimate for _, p in found], "o-", color=_colour(i), label=label or None)
        axes.fill_between(
            centres, [p.low for _, p in found], [p.high for _, p in found], color=_colour(i), alpha=0.2
        )
    words = "remaining effectiveness, " if path.endswith(".value") else ""
    axes.set(xlabel=words + _axis(path), ylabel="P(all requirements met)", ylim=(-0.02, 1.02))
    _legend(axes)
    return figure


def remaining_effectiveness(plan: Plan, frame: pd.DataFrame) -> str | None:
    """Path of the varied `value` of an effectiveness failure; without one, the first varied number; None without either."""
    tree = plan.builder.base.tree
    numbers = [p for p in plan.paths if frame[p].dtype.kind in "fi" and frame[p].nunique() > 1]
    for path in numbers:
        first, *rest = path.split(".")
        if first == "failures" and rest[1:] == ["value"]:
            failure = tree["failures"][int(rest[0])]
            if isinstance(failure, dict) and failure.get("type") == "effectiveness":
                return path
    return numbers[0] if numbers else None


def envelope(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """Altitude and heading error against time, for each variant: median, 5 to 95 %, and the flight with the largest error."""
    count, channels = len(plan.variants), list(histories.CHANNELS)[:2]
    figure, grid = _figure(1.0 + 4.2 * count, 5.6, rows=len(channels), columns=count)
    times = histories.times_s(float(plan.builder.scenario(plan.task(0)).duration_s))
    drawn = False
    for i, (label, rows) in enumerate(groups_of(plan, frame)):
        flights = rows["run"].to_numpy() * count + i
        for j, channel in enumerate(channels):
            axes, band = grid[j][i], _band(folder, flights, list(histories.CHANNELS).index(channel))
            if band is None:
                continue
            drawn = True
            low, median, high, worst, run = band
            axes.fill_between(times, low, high, color=_colour(i), alpha=0.25, label="5 to 95 %")
            axes.plot(times, median, color=_colour(i), label="median")
            axes.plot(times, worst, color="0.25", lw=0.9, ls="--", label=f"largest, run {run // count}")
            axes.legend(fontsize=7, loc="best")
            axes.set_ylabel(_axis(channel))
        grid[0][i].set_title(label, fontsize=10)
        grid[-1][i].set_xlabel("time [s]")
    return figure if drawn else None


def _band(folder: Path, flights: np.ndarray, channel: int) -> tuple[Any, ...] | None:
    """(5 % quantile, median, 95 % quantile, worst flight's error, worst flight's number); None without histories.

    Quantiles at each time are over the flights that are still flying. If there are more than _MOST flights, an evenly
    spaced part of them is used. The worst flight is that with the largest error of all flights.
    """
    file, every = folder / "histories.f32", -(-len(flights) // _MOST)
    sampled, largest, worst, number = [], -1.0, None, -1
    for first in range(0, len(flights), _CHUNK):
        chunk = flights[first : first + _CHUNK]
        data = histories.read(file, chunk)[:, channel]
        sampled.append(data[-first % every :: every])
        size = np.nan_to_num(np.abs(data), nan=-1.0).max(axis=1)
        if size.max() > largest:
            k = int(np.argmax(size))
            largest, worst, number = float(size[k]), data[k], int(chunk[k])
    if worst is None:
        return None
    data = np.concatenate(sampled)
    bands = np.full((3, data.shape[1]), np.nan)
    flying = np.isfinite(data).any(axis=0)
    bands[:, flying] = np.nanquantile(data[:, flying], [0.05, 0.5, 0.95], axis=0)
    return (*bands, worst, number)


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
                label=words,
            )
    axes.set(xlabel="detection delay [s]", ylabel="share of detections", ylim=(0, 1.02))
    _legend(axes)
    return figure


def drivers(plan: Plan, frame: pd.DataFrame, folder: Path) -> Figure | None:
    """PAWN sensitivity of passing to each varied value, with the index that chance alone would give."""
    from testbed.sweeps.sensitivity import sensitivity

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
            where, [r["pawn"] for r in inputs.values()], height=0.22, color=_colour(i), label=label or None
        )
        axes.axvline(next(iter(inputs.values()))["pawn_by_chance"], color=_colour(i), ls=":", lw=1)
    axes.set(
        yticks=range(len(plan.paths)),
        yticklabels=plan.paths,
        xlabel="PAWN index on passing; dotted: by chance",
    )
    axes.invert_yaxis()
    _legend(axes)
    return figure


Draw = Callable[[Plan, "pd.DataFrame", Path], Figure | None]

TABLE: dict[str, Draw] = {
    function.__name__: function for function in (probabilities, survival, envelope, detection_delay, drivers)
}


def _figure(width: float, height: float, rows: int = 1, columns: int = 1) -> tuple[Figure, Any]:
    figure = Drawing(figsize=(width, height), layout="constrained")
    axes = figure.subplots(rows, columns, squeeze=False, sharex=rows * columns > 1, sharey="row")
    for each in axes.flat:
        each.grid(alpha=0.3)
    return figure, axes if rows * columns > 1 else axes[0, 0]


def _legend(axes: Any) -> None:
    if axes.get_legend_handles_labels()[1]:
        axes.legend(fontsize=8)


def _colour(i: int) -> str:
    return _COLOURS[i % len(_COLOURS)]


def _axis(name: str) -> str:
    return f"{name} [{unit(name)}]" if unit(name) else name


def _short(text: str) -> str:
    return text if len(text) <= 48 else text[:45] + "..."

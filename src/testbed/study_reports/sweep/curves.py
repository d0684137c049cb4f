"""What the pictures of a sweep show, as figures and the page's script draw it: flights, the share that passes, errors in time."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from testbed.common.angles import unwrapped_deg
from testbed.common.statistics import proportion
from testbed.reporting.panels import TRACKED, error_panel
from testbed.reporting.words import setting
from testbed.scenario.requirement import Requirement
from testbed.studies.folder import logs
from testbed.studies.folder.logs import in_file_names, log_file
from testbed.studies.folder.table import groups_of
from testbed.studies.plan import Plan
from testbed.studies.verdicts import STATES, judged, missed, requirements_of, state
from testbed.study_reports.sweep.flight_page import page_of

if TYPE_CHECKING:
    import pandas as pd

_BINS = 10
_FLIGHTS_OF_A_BIN = 8
MOST_NAMES = 12
"""A varied value with more names than these is not drawn."""
_CHUNK = 2000  # error histories that are read at a time
_MOST = 20_000  # error histories from which quantiles are computed
MOST_FLIGHTS = 6000
"""Flights that the page has, those of the first runs; its numbers and curves are of all flights."""
_NOTHING, _LOG, _PAGE = range(3)
"""What there is of a flight beside its row in the table."""
_RESULTS = ("altitude_error_max_m", "heading_error_max_deg", "airspeed_error_max_m_s", "detection_delay_s")
"""Metrics that the map can have on an axis."""


def is_number(values: pd.Series) -> bool:
    """Whether a varied value has numbers, and more than one."""
    return values.dtype.kind in "fiu" and values.nunique() > 1


def drawn_inputs(frame: pd.DataFrame, paths: list[str]) -> list[str]:
    """The varied values that can be drawn, those with numbers first; of the others, those with more names than one, but few."""
    numbers = [path for path in paths if is_number(frame[path])]
    others = [path for path in paths if frame[path].dtype.kind not in "fiu"]
    return numbers + [path for path in others if 1 < frame[path].astype(str).nunique() <= MOST_NAMES]


def pass_shares(rows: pd.DataFrame, path: str) -> list[list[Any]]:
    """The share of flights that pass in each part of an input's values, or for each of its names: [at, share, low, high, flights].

    `at` is the mean value of a part, or the name.

    The parts have as equal numbers of flights as can be: ten, or fewer so that each has 8 flights. Of ten different numbers or
    fewer, such as those of a choice, each is a part.
    """
    passed = judged(rows["passed"])
    values = rows[path][passed.index]
    names = None if is_number(values) else values.astype(str)
    found = []
    for at, part in passed.groupby(_parts(values) if names is None else names):
        known = proportion(int(part.sum()), len(part))
        where = str(at) if names is not None else rounded(float(values[part.index].mean()))
        found.append([where, *map(rounded, (known.estimate, known.low, known.high)), known.n])
    return found


def _parts(values: pd.Series) -> pd.Series:
    """The part in which each number is."""
    import pandas as pd

    if values.nunique() <= _BINS:
        return values
    most = min(_BINS, max(2, len(values) // _FLIGHTS_OF_A_BIN))
    return pd.qcut(values, most, labels=False, duplicates="drop")


def error_band(folder: Path, flights: np.ndarray, channel: str, variants: int = 1) -> dict[str, Any] | None:
    """Errors in time of some flights; None without histories. Errors of heading go on beyond a half turn.

    They are 5 % quantile `low`, `median`, 95 % quantile `high`, and `largest`: those of the flight with the largest error, `run`.
    Quantiles at each time are over the flights that are still flying. If there are more than 20 000 flights, an evenly
    spaced part of them is used. The largest error is that of all flights.

    Args:
        folder: the sweep folder.
        flights: their numbers k (see `Plan.task`).
        channel: one of `logs.HISTORY_CHANNELS`.
        variants: of each run.
    """
    every = -(-len(flights) // _MOST)
    index = list(logs.HISTORY_CHANNELS).index(channel)
    sampled, largest, worst, number = [], -1.0, None, -1
    for first in range(0, len(flights), _CHUNK):
        chunk = flights[first : first + _CHUNK]
        data = logs.read_histories(folder, chunk)[:, index]
        if channel.endswith("_deg"):
            data = unwrapped_deg(data)
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
    curves = zip(("low", "median", "high", "largest"), (*bands, worst), strict=True)
    return {**{name: [*map(rounded, values)] for name, values in curves}, "run": number // variants}


def shares(plan: Plan, frame: pd.DataFrame) -> list[dict[str, Any]]:
    """{path, in words, variants} of each that can be drawn: of each variant its points [at, share, low, high, flights]."""
    groups = [rows for _, rows in groups_of(plan, frame)]
    return [
        {"path": setting(path), "variants": [pass_shares(rows, path) for rows in groups]}
        for path in drawn_inputs(frame, plan.paths)
    ]


def errors(plan: Plan, frame: pd.DataFrame, folder: Path) -> Iterator[dict[str, Any]]:
    """{title, linear, limits, times, variants} of each error whose histories there are: of each variant its band, or None."""
    duration_s = float(plan.builder.scenario(plan.task(0)).duration_s)
    times, count = logs.history_times_s(duration_s), len(plan.variants)
    groups = [rows["run"].to_numpy() * count + i for i, (_, rows) in enumerate(groups_of(plan, frame))]
    for quantity, drawn in TRACKED.items():
        channel = drawn.error
        bands = [error_band(folder, flights, channel, count) for flights in groups]
        if any(band is not None and band["median"] != [None] * logs.HISTORY_POINTS for band in bands):
            yield {
                "title": error_panel(quantity).heading,
                "linear": drawn.linear,
                "limits": list(limits(requirements_of(plan), channel, duration_s)),
                "times": [*map(rounded, times)],
                "variants": bands,
            }


def limits(
    requirements: Sequence[Requirement], channel: str, duration_s: float
) -> Iterator[dict[str, float]]:
    """{from_s, until_s, size} of the requirements on an error: on its largest value, or on its signal in a window."""
    signal, reference = logs.HISTORY_CHANNELS[channel]
    metric = channel.replace("_error_", "_error_max_")
    for requirement in requirements:
        if requirement.eventually or requirement.never_for_longer_than_s:
            continue  # its limit may be left
        if requirement.metric == metric and requirement.at_most is not None:
            yield {"from_s": 0.0, "until_s": duration_s, "size": requirement.at_most}
        if requirement.signal == signal and requirement.of == reference and requirement.within is not None:
            end = duration_s if requirement.until_s is None else requirement.until_s
            yield {"from_s": requirement.begins_s, "until_s": end, "size": requirement.within}


def rounded(value: float | None) -> float | None:
    """A number with four digits, which is more than a picture shows; None for one that is not finite."""
    return None if value is None or not math.isfinite(value) else float(f"{value:.4g}")


def for_the_script(plan: Plan, frame: pd.DataFrame, folder: Path) -> dict[str, Any]:
    """Everything that the script draws and lists, as JSON's types (NaN becomes None)."""
    groups = list(groups_of(plan, frame))
    # The flights of the first runs, so many that the page stays small.
    runs = frame["run"].drop_duplicates().sort_values().head(max(MOST_FLIGHTS // len(plan.variants), 1))
    shown = frame[frame["run"].isin(runs)]
    return {
        "folder": folder.name,
        "variants": [label for label, _ in groups],
        "in_file_names": [in_file_names(label) for label, _ in groups],
        "states": STATES,
        "requirements": [requirement.title for requirement in requirements_of(plan)],
        "inputs": [_axis(path, shown) for path in drawn_inputs(frame, plan.paths)],
        "results": [
            _axis(name, shown)
            for name in _RESULTS
            if name in shown and shown[name].notna().any() and is_number(shown[name])
        ],
        "flights": list(_flights(plan, shown, folder)),
        "all": len(frame),
        "shares": shares(plan, frame),
        "errors": list(errors(plan, frame, folder)),
    }


def _axis(name: str, frame: pd.DataFrame) -> dict[str, Any]:
    """{path, in words with the unit, names, values}: values by flight, numbers, or indices of `names`."""
    column = frame[name]
    if column.dtype.kind in "fiu":
        values = [rounded(value) for value in column.to_numpy(dtype=float)]
        return {"path": setting(name), "names": None, "values": values}
    names, codes = np.unique(column.astype(str).to_numpy(), return_inverse=True)
    return {"path": setting(name), "names": names.tolist(), "values": codes.tolist()}


def _flights(plan: Plan, frame: pd.DataFrame, folder: Path) -> Iterator[dict[str, Any]]:
    """{run, variant, state, missed, value, margin, others, end_s, kept} of each flight, and the `reason` if it has no result."""
    requirements = requirements_of(plan)
    variant_of: dict[Any, int] = {}
    for i, (_, rows) in enumerate(groups_of(plan, frame)):
        variant_of |= dict.fromkeys(rows.index, i)
    for index, row in zip(frame.index, frame.to_dict("records"), strict=True):
        run, variant = int(row["run"]), variant_of[index]
        worst = missed(requirements, row)
        yield {
            "run": run,
            "variant": variant,
            "state": STATES.index(state(str(row["outcome"]), row["passed"])),
            "missed": None if worst is None else worst.number,
            "value": None if worst is None else rounded(worst.value),
            "margin": None if worst is None else rounded(worst.margin),
            "others": 0 if worst is None else worst.others,
            "end_s": rounded(row["end_time_s"]),
            "kept": _kept(log_file(folder, run, plan.variants[variant].label)),
            **({"reason": row["reason"]} if row.get("reason") else {}),
        }


def _kept(log: Path) -> int:
    return _PAGE if page_of(log).is_file() else _LOG if log.is_file() else _NOTHING

"""What the page's script is given: the flights with their verdicts, and the curves. `web/src/sweep.js` reads it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from testbed.reporting.panels import TRACKED, error_of, error_panel
from testbed.reporting.words import setting
from testbed.scenario.requirement import Requirement
from testbed.studies.folder import histories
from testbed.studies.folder.names import in_file_names, log_file
from testbed.studies.folder.reading import groups_of
from testbed.studies.plan import Plan
from testbed.studies.verdicts import STATES, missed, requirements_of, state
from testbed.study_reports.sweep.curves import Band, Point, drawn_inputs, error_band, is_number, pass_shares
from testbed.study_reports.sweep.flight_page import page_of

if TYPE_CHECKING:
    import pandas as pd

MOST_FLIGHTS = 6000
"""Flights that the page has, those of the first runs; its numbers and curves are of all flights."""
_NOTHING, _LOG, _PAGE = range(3)
"""What there is of a flight beside its row in the table."""
_RESULTS = ("altitude_error_max_m", "heading_error_max_deg", "airspeed_error_max_m_s", "detection_delay_s")
"""Metrics that the map can have on an axis."""


def for_the_script(plan: Plan, frame: pd.DataFrame, folder: Path) -> dict[str, Any]:
    """Everything that the script draws and lists, as JSON's types (NaN becomes None)."""
    groups = list(groups_of(plan, frame))
    shown = _first_runs(frame, len(plan.variants))
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


def shares(plan: Plan, frame: pd.DataFrame) -> list[dict[str, Any]]:
    """{path, in words, variants} of each that can be drawn: of each variant its points [at, share, low, high, flights]."""
    groups = [rows for _, rows in groups_of(plan, frame)]
    return [
        {"path": setting(path), "variants": [[_point(p) for p in pass_shares(rows, path)] for rows in groups]}
        for path in drawn_inputs(frame, plan.paths)
    ]


def _first_runs(frame: pd.DataFrame, variants: int) -> pd.DataFrame:
    """The flights of the first runs, so many that the page stays small."""
    most = frame["run"].drop_duplicates().sort_values().head(max(MOST_FLIGHTS // variants, 1))
    return frame[frame["run"].isin(most)]


def _axis(name: str, frame: pd.DataFrame) -> dict[str, Any]:
    """{path, in words with the unit, names, values}: values by flight, numbers, or indices of `names`."""
    column = frame[name]
    if column.dtype.kind in "fiu":
        values = [_rounded(value) for value in column.to_numpy(dtype=float)]
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
            "value": None if worst is None else _rounded(worst.value),
            "margin": None if worst is None else _rounded(worst.margin),
            "others": 0 if worst is None else worst.others,
            "end_s": _rounded(row["end_time_s"]),
            "kept": _kept(log_file(folder, run, plan.variants[variant].label)),
            **({"reason": row["reason"]} if row.get("reason") else {}),
        }


def _kept(log: Path) -> int:
    return _PAGE if page_of(log).is_file() else _LOG if log.is_file() else _NOTHING


def _point(point: Point) -> list[Any]:
    at = point.at if isinstance(point.at, str) else _rounded(point.at)
    share = point.share
    return [at, _rounded(share.estimate), _rounded(share.low), _rounded(share.high), share.n]


def errors(plan: Plan, frame: pd.DataFrame, folder: Path) -> Iterator[dict[str, Any]]:
    """{title, linear, limits, times, variants} of each error whose histories there are: of each variant its band, or None."""
    duration_s = float(plan.builder.scenario(plan.task(0)).duration_s)
    times, count = histories.times_s(duration_s), len(plan.variants)
    groups = [rows["run"].to_numpy() * count + i for i, (_, rows) in enumerate(groups_of(plan, frame))]
    for quantity, drawn in TRACKED.items():
        channel = error_of(quantity)
        bands = [error_band(folder, flights, channel) for flights in groups]
        if any(band is not None and np.isfinite(band.median).any() for band in bands):
            yield {
                "title": error_panel(quantity).heading,
                "linear": drawn.linear,
                "limits": list(limits(requirements_of(plan), channel, duration_s)),
                "times": _all_rounded(times),
                "variants": [_band(band, count) for band in bands],
            }


def _band(band: Band | None, variants: int) -> dict[str, Any] | None:
    if band is None:
        return None
    curves = {name: _all_rounded(getattr(band, name)) for name in ("low", "median", "high", "largest")}
    return {**curves, "run": band.flight // variants}


def limits(
    requirements: Sequence[Requirement], channel: str, duration_s: float
) -> Iterator[dict[str, float]]:
    """{from_s, until_s, size} of the requirements on an error: on its largest value, or on its signal in a window."""
    signal, reference = histories.CHANNELS[channel]
    metric = channel.replace("_error_", "_error_max_")
    for requirement in requirements:
        if requirement.eventually or requirement.never_for_longer_than_s:
            continue  # its limit may be left
        if requirement.metric == metric and requirement.at_most is not None:
            yield {"from_s": 0.0, "until_s": duration_s, "size": requirement.at_most}
        if requirement.signal == signal and requirement.of == reference and requirement.within is not None:
            end = duration_s if requirement.until_s is None else requirement.until_s
            yield {"from_s": requirement.begins_s, "until_s": end, "size": requirement.within}


def _all_rounded(values: np.ndarray) -> list[float | None]:
    return [_rounded(value) for value in values]


def _rounded(value: float | None) -> float | None:
    """A number with four digits, which is more than a picture shows; None for one that is not finite."""
    return None if value is None or not math.isfinite(value) else float(f"{value:.4g}")

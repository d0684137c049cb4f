"""What the page's script is given: the flights with their verdicts, and the `curves`. `web/src/sweep.js` reads it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from testbed.reporting.words import setting
from testbed.studies.folder.names import in_file_names, log_file
from testbed.studies.folder.reading import groups_of
from testbed.studies.plan import Plan
from testbed.studies.verdicts import STATES, missed, requirements_of, state
from testbed.study_reports.sweep.curves import drawn_inputs, errors, is_number, rounded, shares
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


def _first_runs(frame: pd.DataFrame, variants: int) -> pd.DataFrame:
    """The flights of the first runs, so many that the page stays small."""
    most = frame["run"].drop_duplicates().sort_values().head(max(MOST_FLIGHTS // variants, 1))
    return frame[frame["run"].isin(most)]


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

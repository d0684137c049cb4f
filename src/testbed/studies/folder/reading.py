"""Read a sweep folder as a DataFrame, whether the sweep is finished or not; needs no simulator."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from testbed.common.units import unit
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.received import read_frame, refuse_links
from testbed.studies.folder import store, table
from testbed.studies.load import load_sweep
from testbed.studies.plan import Plan
from testbed.studies.record import OUTCOMES, Record, key_of
from testbed.studies.verdicts import counted

if TYPE_CHECKING:
    import pandas as pd

TABLE = "results.parquet"
_ALWAYS = ("run", "seed", "outcome", "passed", "end_time_s")
_LARGEST_KEY = 2**64 - 1
"""A key has eight bytes (see `record.key_of`)."""


def load(folder: str | Path) -> pd.DataFrame:
    """The table of a sweep folder, with a row for each flight; for an unfinished sweep, for each flight that has finished.

    Its `attrs` have the sweep's `name`, its `folder`, a `summary` in one sentence, and `units` {column: unit}.
    Raises BadInput when the folder is not a sweep folder.
    """

    folder = Path(folder)
    plan = load_plan(folder)
    try:
        frame = finished(plan, folder) if is_finished(folder) else _unfinished(plan, folder)
    except (OSError, ValueError) as error:
        problem = Problem(f"cannot be read: {error}", str(folder), expected="a sweep folder")
        raise BadInput([problem]) from None
    for name in ["outcome", *plan.study.compare]:
        frame[name] = frame[name].astype("category")
    frame.attrs |= {
        "name": plan.name,
        "folder": str(folder),
        "summary": _sentence(plan, frame),
        "units": {name: unit(name) for name in frame.columns},
    }
    return frame


def finished(plan: Plan, folder: Path) -> pd.DataFrame:
    """The table of a folder of which every flight is flown; raises BadInput when it is not one of this study."""
    file, expected = folder / TABLE, f"the table of a {plan.study.word}"
    needed = (*_ALWAYS, *plan.study.compare, *plan.paths)
    frame = read_frame(file, needed, expected)
    if problem := _wrong(plan, frame):
        raise BadInput([Problem(problem, str(file), expected=expected)])
    return frame


def _wrong(plan: Plan, frame: pd.DataFrame) -> str:
    """What rows have that no flight of this study has; "" if nothing."""
    run = frame["run"]
    if len(frame) > plan.size:
        return f"has {len(frame)} rows for {plan.size} flights"
    if len(frame) and not (run.dtype == "int64" and run.between(0, plan.runs - 1).all()):
        return f"has runs other than 0 to {plan.runs - 1}"
    if frame.duplicated(["run", *plan.study.compare]).any():
        return "has a flight twice"
    if not frame["outcome"].isin(OUTCOMES).all():
        return f"has outcomes other than {', '.join(OUTCOMES)}"
    passed = frame["passed"].dropna()  # a flight of which nothing can be judged has none
    if not passed.map(lambda value: isinstance(value, bool)).all():
        return "does not say of each flight whether it passed"
    return ""


def load_plan(folder: Path) -> Plan:
    """The sweep of a folder; raises BadInput when there is none."""
    file = folder / "sweep.yaml"
    if not file.is_file():
        raise BadInput([Problem("is missing from the sweep folder", str(file))])
    refuse_links(folder)
    return load_sweep(file)


def _sentence(plan: Plan, frame: pd.DataFrame) -> str:
    """`small: 12 of 12 runs flown; passed: adaptive_inversion 11 of 12, pid 3 of 12`."""
    shares = ", ".join(f"{label} {counted(rows['passed'])}".strip() for label, rows in groups_of(plan, frame))
    return f"{plan.name}: {frame['run'].nunique()} of {plan.runs} runs flown; passed: {shares}"


def records(plan: Plan, stored: store.Store, runs: int | None = None) -> Iterator[Record]:
    """The records of the flights of the first `runs` runs, all by default, in the order of runs and variants.

    Raises BadInput for one that is not of this sweep.
    """
    variants = len(plan.variants)
    end = key_of((plan.runs if runs is None else runs) * variants)
    for key, record in stored.records():
        if key >= end:
            return
        place = min(record.run * variants + record.variant, _LARGEST_KEY)
        if record.variant >= variants or key_of(place) != key:
            what = f"has run {record.run}, variant {record.variant} in place of another flight"
            raise BadInput([Problem(what, str(stored.folder / store.NAME))])
        yield record


def groups_of(plan: Plan, frame: pd.DataFrame) -> Iterator[tuple[str, pd.DataFrame]]:
    """(label, rows) of each variant; its rows are those with its values in the compared columns."""
    for variant in plan.variants:
        mask = np.ones(len(frame), dtype=bool)
        for path, value in variant.values.items():
            column = frame[path].astype(object)
            text = len(column) and isinstance(column.iloc[0], str) and not isinstance(value, str)
            mask &= (column == (json.dumps(value, ensure_ascii=False) if text else value)).to_numpy()
        yield variant.label, frame[mask]


def is_finished(folder: Path) -> bool:
    """Whether a folder has its table, which is there for exactly as long as it has every flight (see `begin.remove_results`)."""
    return (folder / TABLE).is_file()


def _unfinished(plan: Plan, folder: Path) -> pd.DataFrame:
    import pandas as pd

    with store.reading(folder) as stored:
        flown = list(records(plan, stored))
    kinds = table.columns(plan, flown)
    dtypes = {bool: "bool", int: "int64", float: "float64", str: "str"}
    frame = pd.DataFrame(list(table.rows(plan, flown)), columns=list(kinds))
    return frame.astype({n: dtypes[k] for n, k in kinds.items() if k in (float, str)})

"""The table of a study, results.csv and results.parquet: a row for each flight, in the order of runs and variants.

It is written, and read back as a DataFrame; of a sweep also before it is finished. Reading needs no simulator.
"""

from __future__ import annotations

import codecs
import csv
import itertools
import json
import math
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from testbed.common.text import cell
from testbed.common.units import unit
from testbed.common.writing import replacing
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.received import read_frame, refuse_links
from testbed.studies.folder import store
from testbed.studies.load import load_sweep
from testbed.studies.plan import Plan
from testbed.studies.record import OUTCOMES, Record, key_of
from testbed.studies.verdicts import counted

if TYPE_CHECKING:
    import pandas as pd

Records = Callable[[], Iterable[Record]]
_GROUP = 5000
"""Rows held in memory at a time."""
_OF_A_REQUIREMENT = ("passed", "value", "robustness")
TABLE = "results.parquet"
_ALWAYS = ("run", "seed", "outcome", "passed", "end_time_s")
_LARGEST_KEY = 2**64 - 1
"""A key has eight bytes (see `record.key_of`)."""


def rows(plan: Plan, records: Iterable[Record]) -> Iterator[dict[str, Any]]:
    """The row of each record, {column: value}."""
    for record in records:
        yield {
            "run": record.run,
            "seed": record.seed,
            **plan.variants[record.variant].values,
            "outcome": record.outcome,
            "passed": record.passed,
            **record.values,
            "end_time_s": record.end_time_s,
            "robustness": record.robustness,
            **record.metrics,
            **{
                f"requirements.{j}.{name}": value
                for j, verdict in enumerate(record.requirements)
                for name, value in zip(_OF_A_REQUIREMENT, verdict, strict=True)
            },
            **({"environment": record.environment} if record.environment else {}),
            "reason": record.reason,
        }


def columns(plan: Plan, records: Iterable[Record]) -> dict[str, type]:
    """{name: type} of every column, in order. All records are read, because one may have a metric that others lack."""
    kinds: dict[str, set[type]] = {}
    middle: dict[str, None] = {}
    verdicts: dict[str, None] = {}
    for row in rows(plan, records):
        for name, value in row.items():
            if value is not None:
                kinds.setdefault(name, set()).add(_kind(value))
            of_a_verdict = name.startswith("requirements.") and name not in plan.paths
            (verdicts if of_a_verdict else middle).setdefault(name)
    head = ["run", "seed", *plan.study.compare, "outcome", "passed", *plan.paths, "end_time_s", "robustness"]
    rest = [name for name in middle if name not in head and name != "reason"]
    order = sorted(verdicts, key=lambda name: (int(name.split(".")[1]), name))
    for name in ["passed", *verdicts]:
        if name.endswith("passed"):
            kinds.setdefault(name, {bool})  # also where nothing was judged
    return {name: _type(kinds.get(name, set())) for name in dict.fromkeys([*head, *rest, *order, "reason"])}


def write(plan: Plan, records: Records, folder: Path) -> None:
    """Write both files into a folder, completely or not at all. `records` is called twice."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    kinds = columns(plan, records())
    arrow = {bool: pa.bool_(), int: pa.int64(), float: pa.float64(), str: pa.string()}
    schema = pa.schema([(name, arrow[kind]) for name, kind in kinds.items()])
    with ExitStack() as stack:
        text = stack.enter_context(replacing(folder / "results.csv"))
        parquet = stack.enter_context(replacing(folder / "results.parquet"))
        writer = csv.writer(codecs.getwriter("utf-8")(text), lineterminator="\n")
        writer.writerow(map(cell, kinds))
        binary = stack.enter_context(pq.ParquetWriter(parquet, schema, compression="zstd"))
        table = ({name: _value(row.get(name), kind) for name, kind in kinds.items()}
                 for row in rows(plan, records()))  # fmt: skip
        while group := list(itertools.islice(table, _GROUP)):
            writer.writerows(map(_cell, row.values()) for row in group)
            binary.write_table(pa.Table.from_pylist(group, schema))


def _kind(value: Any) -> type:
    """Its type; text for a whole number of more than the 64 bits that a column of whole numbers has."""
    return str if type(value) is int and not -(2**63) <= value < 2**63 else type(value)


def _type(kinds: set[type]) -> type:
    for kind, members in ((bool, {bool}), (int, {int}), (float, {int, float})):
        if kinds and kinds <= members:
            return kind
    return str


def _value(value: Any, kind: type) -> Any:
    """A value converted to its column's type; in a column of texts, any other value becomes JSON."""
    if value is None or (kind is float and isinstance(value, float) and math.isnan(value)):
        return None
    if kind is str and not isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    return kind(value)


def _cell(value: Any) -> str:
    """Shortest text that reads back as the same value; a text is quoted if a spreadsheet could take it for a formula."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return ""
    if isinstance(value, bool):
        return "True" if value else "False"
    return cell(value) if isinstance(value, str) else repr(value)


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
    kinds = columns(plan, flown)
    dtypes = {bool: "bool", int: "int64", float: "float64", str: "str"}
    frame = pd.DataFrame(list(rows(plan, flown)), columns=list(kinds))
    return frame.astype({n: dtypes[k] for n, k in kinds.items() if k in (float, str)})

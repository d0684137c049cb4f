"""The table of a study, results.csv and results.parquet: a row for each flight, in the order of runs and variants."""

from __future__ import annotations

import codecs
import csv
import itertools
import json
import math
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from testbed.common.text import cell
from testbed.common.writing import replacing
from testbed.studies.plan import Plan
from testbed.studies.record import Record

Records = Callable[[], Iterable[Record]]
_GROUP = 5000
"""Rows held in memory at a time."""
_OF_A_REQUIREMENT = ("passed", "value", "robustness")


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

"""The whole log as a table.

Apache Parquet: each field's metadata has its `unit`, the table's `testbed` the summary as JSON.
MATLAB's level 5 format: structs `log` (columns), `units` (text of each) and `flight`, and the struct array `events`.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable
from typing import BinaryIO

import numpy as np

from testbed.flight.flight import Flight
from testbed.reporting.export.place import Origin
from testbed.reporting.words import describe, units_of


def parquet(flight: Flight, stream: BinaryIO, _: Origin) -> None:
    """Write every row of the log in full precision."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    units = units_of(flight)
    fields = [pa.field(name, pa.float64(), metadata={"unit": units[name]}) for name in flight.columns]
    summary = json.dumps(flight.summary, ensure_ascii=False, sort_keys=True)
    schema = pa.schema(fields, metadata={"testbed": summary})
    arrays = [pa.array(np.ascontiguousarray(column)) for column in np.asarray(flight.data, float).T]
    pq.write_table(pa.Table.from_arrays(arrays, schema=schema), stream, compression="zstd")


_LONGEST = 63  # characters of a name in MATLAB
_HEADER = b"MATLAB 5.0 MAT-file, written by testbed".ljust(116)  # scipy's has the time of writing


def mat(flight: Flight, stream: BinaryIO, _: Origin) -> None:
    """Write the log in full precision, each column [rows, 1]."""
    from scipy.io import savemat

    names, units = matlab_names(flight.columns), units_of(flight)
    contents = {
        "log": {names[c]: flight.data[:, i] for i, c in enumerate(flight.columns)},
        "units": {names[c]: units[c] for c in flight.columns},
        "flight": {
            "scenario": flight.scenario.name,
            "controller": flight.controller,
            "outcome": str(flight.outcome),
            "end_time_s": float(flight.end_time_s),
            "passed": math.nan if flight.passed is None else flight.passed,
            "metrics": {name: float(value) for name, value in flight.metrics.items()},
        },
        "events": _events(flight),
    }
    savemat(stream, contents, appendmat=False, long_field_names=True, do_compression=True, oned_as="column")  # type: ignore[arg-type]
    stream.seek(0)
    stream.write(_HEADER)


def matlab_names(columns: Iterable[str]) -> dict[str, str]:
    """{column: name of a field in MATLAB}: a letter first, letters, digits and underscores, at most 63, each once."""
    names: dict[str, str] = {}
    for column in columns:
        stem = re.sub(r"\W", "_", column, flags=re.ASCII)
        stem = (stem if stem[:1].isalpha() else f"x_{stem}")[:_LONGEST]
        name, i = stem, 2
        while name in names.values():
            ending = f"_{i}"
            name, i = stem[: _LONGEST - len(ending)] + ending, i + 1
        names[column] = name
    return names


def _events(flight: Flight) -> np.ndarray:
    """[events, 1] structs of time [s], kind, and the event in words."""
    events = np.zeros((len(flight.events), 1), dtype=[("time_s", "O"), ("kind", "O"), ("words", "O")])
    for i, event in enumerate(flight.events):
        events[i, 0] = (float(event["time_s"]), str(event["kind"]), describe(event, flight))
    return events

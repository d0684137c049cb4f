"""Apache Parquet: every row of the log; each field's metadata has its `unit`, the table's `testbed` the summary as JSON."""

from __future__ import annotations

import json
from typing import BinaryIO

import numpy as np

from testbed.flight.flight import Flight
from testbed.reporting.export.place import Origin
from testbed.reporting.words import units_of


def write(flight: Flight, stream: BinaryIO, _: Origin) -> None:
    """Write the log in full precision."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    units = units_of(flight)
    fields = [pa.field(name, pa.float64(), metadata={"unit": units[name]}) for name in flight.columns]
    summary = json.dumps(flight.summary, ensure_ascii=False, sort_keys=True)
    schema = pa.schema(fields, metadata={"testbed": summary})
    arrays = [pa.array(np.ascontiguousarray(column)) for column in np.asarray(flight.data, float).T]
    pq.write_table(pa.Table.from_arrays(arrays, schema=schema), stream, compression="zstd")

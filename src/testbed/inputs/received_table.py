"""Tables of a received folder, in Parquet: what their metadata say is checked before a row of them is read.

A file of a few kilobytes can stand for a table that fills all memory, and its metadata for columns of another kind.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.inputs.input_file import MEGABYTE
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.yaml_source import describe

if TYPE_CHECKING:
    import pandas as pd

_MOST_COLUMNS = 5000
_CELLS, _CELLS_PER_BYTE = 10_000_000, 20
"""Cells of a table at most: so many, or so many for each byte of the file. Ours have about two."""
_MOST_TEXT = 500 * MEGABYTE
"""Longest sum of all texts [bytes]."""
_KINDS = ("bool", "int64", "float", "double", "string")
"""Types of columns, as arrow calls them."""


def read_frame(file: Path, needed: Iterable[str], expected: str) -> pd.DataFrame:
    """As `read_table`, as a DataFrame."""
    frame: pd.DataFrame = read_table(file, needed, expected).replace_schema_metadata(None).to_pandas()
    return frame


def read_table(file: Path, needed: Iterable[str], expected: str) -> Any:
    """The arrow table in a file.

    Args:
        needed: columns that it must have; further ones may be there.
        expected: what kind of file is wanted.

    Raises BadInput for a file that is no Parquet, lacks a column, has one twice or of another type, or is too vast.
    """
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        with pq.ParquetFile(file) as parquet:
            _refuse(_shape_problem(parquet.metadata, file.stat().st_size), file, expected)
            schema = parquet.schema_arrow
            _refuse(_column_problem(schema, tuple(needed)), file, expected)
        texts = [field.name for field in schema if field.type == pa.string()]
        table = pq.read_table(file, read_dictionary=texts)  # so each text of a file is in memory once
        _refuse(_text_problem(table, texts), file, expected)
        return table.cast(schema)
    except (OSError, ValueError, KeyError, TypeError, MemoryError) as error:  # arrow's are ValueErrors
        raise BadInput([Problem(f"cannot be read: {error}", str(file), expected=expected)]) from None


def _refuse(problem: str, file: Path, expected: str) -> None:
    if problem:
        raise BadInput([Problem(problem, str(file), expected=expected)])


def _shape_problem(metadata: Any, size: int) -> str:
    """Why a table of `size` bytes is not read, by the numbers of its footer; "" if it is."""
    if metadata.num_columns > _MOST_COLUMNS:
        return f"has {metadata.num_columns} columns, more than {_MOST_COLUMNS}"
    groups = [metadata.row_group(i) for i in range(metadata.num_row_groups)]
    said = sum(group.column(j).num_values for group in groups for j in range(group.num_columns))
    cells = max(said, metadata.num_rows * metadata.num_columns)
    return f"stands for {cells} cells in {size} bytes" if cells > _CELLS + _CELLS_PER_BYTE * size else ""


def _column_problem(schema: Any, needed: tuple[str, ...]) -> str:
    names = schema.names
    if missing := [name for name in needed if name not in names]:
        return f"has no column {missing[0]}"
    if len(set(names)) < len(names):
        return "has a column twice"
    strange = [field for field in schema if str(field.type) not in _KINDS]
    return f"has a column {describe(strange[0].name)} of {strange[0].type}" if strange else ""


def _text_problem(table: Any, texts: list[str]) -> str:
    import pyarrow.compute as pc

    total = 0
    for name in texts:
        for chunk in table.column(name).chunks:
            lengths = pc.take(pc.binary_length(chunk.dictionary), chunk.indices)
            total += pc.sum(lengths.cast("int64")).as_py() or 0
    return f"has more than {_MOST_TEXT / MEGABYTE:g} MB of text" if total > _MOST_TEXT else ""

"""Folders that are read back, which anybody may have made: only files and folders are in them, and JSON is as we write it.

Of a table in Parquet, what its metadata say is checked before a row is read: a file of a few kilobytes can stand for a table that
fills all memory, and its metadata for columns of another kind.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.inputs.input_file import MEGABYTE, read_text
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.yaml_source import describe

if TYPE_CHECKING:
    import pandas as pd

_LARGEST_JSON = 20 * MEGABYTE
_DEEPEST = 10
"""Folders in folders: ours are three deep, and a path of thousands is longer than systems open."""
_SHOWN = 3
"""Members that are named."""
_MOST_COLUMNS = 5000
_CELLS, _CELLS_PER_BYTE = 10_000_000, 20
"""Cells of a table at most: so many, or so many for each byte of the file. Ours have about two."""
_MOST_TEXT = 500 * MEGABYTE
"""Longest sum of all texts [bytes]."""
_KINDS = ("bool", "int64", "float", "double", "string")
"""Types of columns, as arrow calls them."""


def refuse_links(folder: Path) -> None:
    """Raise BadInput when anything in a folder, at any depth, is neither a file nor a folder.

    A link may lead out of it: to a file that is to be overwritten, or to one that is not to be shown. A pipe has no end.
    """
    found = [problem for problem, _ in zip(_links(folder), range(_SHOWN), strict=False)]
    if found:
        raise BadInput(found)


def _links(folder: Path) -> Iterator[Problem]:
    waiting = [(folder, 0)]
    while waiting:
        place, depth = waiting.pop()
        if depth > _DEEPEST:
            yield Problem("is nested too deeply", str(place), expected=f"folders {_DEEPEST} deep at most")
            continue
        with os.scandir(place) as members:
            for member in sorted(members, key=lambda each: each.name):
                if member.is_dir(follow_symlinks=False):
                    waiting.append((Path(member.path), depth + 1))
                elif not member.is_file(follow_symlinks=False):
                    what = "is a link" if member.is_symlink() else "is a device or a pipe"
                    yield Problem(
                        what, member.path, expected="files and folders alone in a folder that is read back"
                    )


def read_json(file: Path, expected: str) -> Any:
    """The contents of a JSON file of a received folder.

    Raises BadInput for a file that is too large or no JSON, for a key that stands twice, for NaN and Infinity, which JSON has not,
    and for text that UTF-8 cannot hold.
    """
    return json_of(read_text(file, _LARGEST_JSON, expected), file, expected)


def json_of(text: str, file: Path, expected: str) -> Any:
    """As `read_json`, of text that was read from a file already."""
    try:
        value = json.loads(text, object_pairs_hook=_once, parse_constant=_no_number)
        json.dumps(value, ensure_ascii=False).encode()
    except (ValueError, RecursionError) as error:
        words = "is nested too deeply" if isinstance(error, RecursionError) else f"cannot be read: {error}"
        raise BadInput([Problem(words, str(file), expected=expected)]) from None
    return value


@contextmanager
def believed(file: Path, expected: str) -> Iterator[None]:
    """While what was read from a file is used for the first time: what it lacks, or has of another type, is BadInput."""
    try:
        yield
    except (
        OSError,
        LookupError,
        TypeError,
        ValueError,
        AttributeError,
        ArithmeticError,
        RecursionError,
    ) as error:
        problem = Problem(
            f"does not hold what it should: {type(error).__name__}: {error}", str(file), expected=expected
        )
        raise BadInput([problem]) from None


def _no_number(word: str) -> None:
    raise ValueError(f"{word} is no finite number")


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        raise ValueError("a key stands twice")
    return found


def read_frame(file: Path, needed: Iterable[str], expected: str) -> pd.DataFrame:
    """As `read_table`, as a DataFrame."""
    return read_table(file, needed, expected).replace_schema_metadata(None).to_pandas()


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

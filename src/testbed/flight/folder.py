"""The run folder of a flight: written completely or not at all, and read back."""

from __future__ import annotations

import json
import math
import os
import re
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from testbed.common.text import cell, text_of
from testbed.common.writing import replacing, write
from testbed.flight.damage import Summary, refuse_damaged
from testbed.flight.flight import Flight
from testbed.inputs.output_file import cannot_write
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.received import read_json, refuse_links
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import Source
from testbed.scenario.load import Scenario, dump, load_scenario

_SCENARIO, _SUMMARY, _LOG = "scenario.yaml", "summary.json", "log.csv"
_LONGEST_HEADER = 1_000_000
"""Of a log [characters]: a file of nothing but zeros has a line without end."""
_OWN = "controller"  # folder of the files of a controller of one's own


class FolderExists(BadInput):
    """The folder to be written exists already; nothing is ever overwritten."""


def refuse_existing(folder: Path) -> None:
    """Raise FolderExists when there is anything at this path."""
    if os.path.lexists(folder):
        raise FolderExists(
            [Problem("exists already", str(folder), expected="a folder that does not exist yet")]
        )


def refuse_unwritable(folder: Path) -> None:
    """Raise BadInput when a folder could not be made at this path: better before a flight than after it.

    Folders above it that do not exist are made.
    """
    _partial_of(folder).rmdir()


def write_run_folder(
    flight: Flight, folder: str | Path, add: Callable[[Path], object] = lambda _: None
) -> Path:
    """Write a run folder, completely or not at all; returns its path.

    `add(folder)` may add figures or a report. It is called while the folder still has a temporary name.
    Raises FolderExists when the folder exists, BadInput when it cannot be made, OSError when the disk is full.
    """
    folder = Path(folder)
    refuse_existing(folder)
    partial = _partial_of(folder)
    try:
        _write_files(flight, partial)
        add(partial)
        _sync(partial)
        refuse_existing(folder)  # `rename` would replace an empty folder made meanwhile
        partial.rename(folder)
    except BaseException as error:
        shutil.rmtree(partial, ignore_errors=True)
        if isinstance(error, OSError):  # name the folder that was asked for, not a file of a temporary one
            raise OSError(error.errno, error.strerror or str(error), str(folder)) from error
        raise
    return folder


def _partial_of(folder: Path) -> Path:
    """A new folder beside the one to be made, with a temporary name; raises BadInput when there can be none."""
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        return Path(tempfile.mkdtemp(prefix=f".{folder.name}.", suffix=".partial", dir=folder.parent))
    except OSError as error:
        raise BadInput([cannot_write(folder, error)]) from None
    except ValueError:
        raise BadInput([Problem("has a NUL character in its name", repr(str(folder)))]) from None


def load(folder: str | Path) -> Flight:
    """Read a run folder as the flight that was written.

    Needs neither the simulator nor the aircraft. Raises BadInput when it is not a complete run folder.
    """
    folder = Path(folder)
    scenario_file, summary_file, log_file = folder / _SCENARIO, folder / _SUMMARY, folder / _LOG
    missing = [file for file in (scenario_file, summary_file, log_file) if not file.is_file()]
    if missing:
        raise BadInput([Problem("is missing from the run folder", str(file)) for file in missing])
    refuse_links(folder)
    summary = read_json(summary_file, "the summary of a run")
    try:
        columns, data = _read_log(log_file)
    except (ValueError, KeyError, TypeError) as error:  # pyarrow's errors are ValueErrors
        expected = "the log of a run, as it was written"
        raise BadInput([Problem(_why_not_read(error), str(log_file), expected=expected)]) from None
    scenario = load_scenario(scenario_file, with_aircraft=False)
    return flight_from(scenario, summary, columns, data, summary_file, log_file)


def flight_from(
    scenario: Scenario,
    contents: Any,
    columns: tuple[str, ...],
    data: np.ndarray,
    summary_file: Path,
    log_file: Path,
) -> Flight:
    """The flight of a scenario, the contents of its summary.json, and its log [rows, columns].

    Raises BadInput, with the file in which it is, for what a flight has not.
    """
    said = validated(Summary, Source(str(summary_file), contents))
    plain = said.model_dump(mode="json", exclude_unset=True, exclude={"shape"})
    actuators = {facts.pop("name"): facts for facts in plain["actuators"]}
    flight = Flight(
        scenario=scenario,
        outcome=said.outcome,
        end_time_s=said.end_time_s,
        columns=columns,
        data=data,
        events=plain["events"],
        metrics={name: math.nan if value is None else value for name, value in said.metrics.items()},
        requirements=plain["requirements"],
        actuators=actuators,
        warnings=plain.get("warnings", ()),
        shape=said.shape,
        flown_by=said.flown_by,
        flown_by_sha256=said.flown_by_sha256,
        parts=said.parts_sha256,
    )
    refuse_damaged(flight, str(summary_file), str(log_file))
    return flight


def _write_files(flight: Flight, folder: Path) -> None:
    write(folder / _SCENARIO, dump(flight.scenario))
    text = json.dumps(flight.summary, indent=2, sort_keys=True, ensure_ascii=False, allow_nan=False)
    write(folder / _SUMMARY, text + "\n")
    _write_log(flight, folder / _LOG)
    if flight.files:
        (folder / _OWN).mkdir()
    for name, content in flight.files.items():
        write(folder / _OWN / name, content)


def _write_log(flight: Flight, file: Path) -> None:
    """Write log.csv with arrow: ten times faster than pandas, and its decimal numbers read back to the last bit."""
    import pyarrow as pa
    import pyarrow.csv

    columns = np.ascontiguousarray(np.asarray(flight.data, dtype=np.float64).T)
    # Not by pa.array, which would import pandas; that takes longer than the flight.
    arrays = [pa.Array.from_buffers(pa.float64(), len(c), [None, pa.py_buffer(c)]) for c in columns]
    table = pa.Table.from_arrays(arrays, names=list(flight.columns))
    with replacing(file) as stream:
        stream.write((",".join(map(cell, flight.columns)) + "\n").encode())
        pyarrow.csv.write_csv(table, stream, pyarrow.csv.WriteOptions(include_header=False))


def _read_log(file: Path) -> tuple[tuple[str, ...], np.ndarray]:
    import pyarrow as pa
    import pyarrow.csv

    with file.open(encoding="utf-8-sig") as stream:
        header = stream.readline(_LONGEST_HEADER)
    if len(header) == _LONGEST_HEADER:
        raise ValueError(f"its first line has {_LONGEST_HEADER} characters or more")
    cells = header.rstrip("\n").split(",")
    floats = pyarrow.csv.ConvertOptions(column_types=dict.fromkeys(cells, pa.float64()), null_values=[""])
    table = pyarrow.csv.read_csv(file, convert_options=floats)
    return tuple(map(text_of, cells)), np.array([_numbers(table[name]) for name in cells]).T


def _why_not_read(error: Exception) -> str:
    """What is wrong with a log, in words, without the rows that pyarrow cites."""
    if isinstance(error, UnicodeDecodeError):
        return f"is no text in UTF-8, from byte {error.start} on"
    said = str(error).partition("\n")[0]
    columns = re.search(r"Expected (\d+) columns, got (\d+)", said)
    if columns:
        row = re.search(r"Row #(\d+)", said)
        return f"has {columns[2]} values in {f'line {row[1]}' if row else 'a line'}, and {columns[1]} columns"
    return f"cannot be read: {said[:200]}"


def _numbers(column: Any) -> np.ndarray:
    """The numbers of an arrow column; not `to_numpy`, which imports pandas."""
    if column.null_count:
        column = column.fill_null(math.nan)
    chunks = [c for c in column.chunks if len(c)]
    parts = [np.frombuffer(c.buffers()[1], np.float64, len(c), 8 * c.offset) for c in chunks]
    return np.concatenate([np.zeros(0), *parts])


def _sync(folder: Path) -> None:
    """Flush the folder to disk before it is renamed, and give it the usual permissions, which a temporary folder lacks."""
    for path in [*folder.rglob("*"), folder]:
        handle = os.open(path, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
    mask = os.umask(0)
    os.umask(mask)
    folder.chmod(0o777 & ~mask)

"""What is kept of a flight's course in a sweep folder: its whole log, and its error history of three errors at 200 times.

A log is one Parquet file that can be read back as the flight, without the simulator. Its columns are those of log.csv, in single
precision to save space. Its metadata has the flight's scenario (YAML) and summary (JSON). For full precision `sweep --only` flies
the flight again, bit for bit.
"""

from __future__ import annotations

import io
import json
import os
import re
import shlex
from pathlib import Path
from typing import Any

import numpy as np

from testbed.common.angles import wrap_deg
from testbed.flight.flight import Flight
from testbed.flight.folder import flight_from
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.received import json_of, read_table
from testbed.inputs.yaml_source import Source, describe
from testbed.scenario.load import Scenario, dump, scenario_from
from testbed.studies.folder import store
from testbed.studies.record import key_of

_KEPT = "a log that a sweep kept"
_SCENARIO, _SUMMARY = b"testbed.scenario", b"testbed.summary"
_LABEL = re.compile(r"run-(\d{6,})(?:-(.+))?")
"""The name of a kept log: its run, and the label of its variant where variants are compared."""


def encode(flight: Flight) -> bytes:
    """The contents of the file that keeps a flight."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    # Not by pa.array, which would import pandas; that takes 60 MB in every worker.
    columns = [
        _column(pa, pa.float32(), flight.data[:, j].astype(np.float32)) for j in range(len(flight.columns))
    ]
    columns[0] = _column(pa, pa.float64(), flight.data[:, 0].copy())  # time stays in double precision
    summary = json.dumps(flight.summary, sort_keys=True, ensure_ascii=False, allow_nan=False)
    about = {_SCENARIO: dump(_placeless(flight.scenario)).encode(), _SUMMARY: summary.encode()}
    stream = io.BytesIO()
    table = pa.Table.from_arrays(columns, names=list(flight.columns)).replace_schema_metadata(about)
    pq.write_table(table, stream, compression="zstd", use_byte_stream_split=True, use_dictionary=False)
    return stream.getvalue()


def _column(pa: Any, kind: Any, values: np.ndarray) -> Any:
    return pa.Array.from_buffers(kind, len(values), [None, pa.py_buffer(values)])


def is_kept(path: str | Path) -> bool:
    """Whether a path is a log that a sweep kept, or names a run of a sweep: `SWEEP/17`, `SWEEP/run-000017-pid`."""
    path = Path(path)
    if path.suffix == ".parquet" and path.is_file():
        return True
    known = path.name.isdecimal() or _LABEL.fullmatch(path.name)
    return bool(known) and not path.exists() and file_of(path.parent).is_file()


def logs_of(path: str | Path) -> list[Path]:
    """The kept logs that a path names, which are several for a run of several variants.

    Raises BadInput, with the command that flies it, when no log was kept.
    """
    path = Path(path)
    if path.suffix == ".parquet" and path.is_file():
        return [path]
    run, label = run_and_label(path.name)
    pattern = f"run-{run:06d}-{label}.parquet" if label else f"run-{run:06d}*.parquet"
    named = (file for file in (path.parent / "logs").glob(pattern) if _LABEL.fullmatch(file.stem))
    found = sorted(file for file in named if run_and_label(file.stem)[0] == run)
    if not found:
        runs = runs_of(path.parent)
        if runs is not None and run >= runs:
            raise BadInput([Problem(f"there is no run {run}", str(path), expected=f"0 to {runs - 1}")])
        file = file_of(path.parent)
        command = f"testbed {shlex.join([file.stem, str(file), '--only', str(run)])}"
        expected = f"one of a flight whose log was kept; `{command}` flies it again"
        raise BadInput([Problem("no log of this run was kept", str(path), expected=expected)])
    return found


def load(path: str | Path) -> Flight:
    """The flight of a kept log; raises BadInput when it cannot be read, or when a path names several."""
    found = logs_of(path)
    if len(found) > 1:
        names = ", ".join(file.stem for file in found)
        raise BadInput([Problem("names several flights", str(path), expected=f"one of {names}")])
    return read(found[0])


def read(file: Path) -> Flight:
    """The flight of one file; raises BadInput when it cannot be read."""
    try:
        table = read_table(file, ("time_s",), _KEPT)
        about = table.schema.metadata or {}
        if _SUMMARY not in about:
            expected = "a log kept by a sweep of this version; `sweep --only` flies the run again"
            raise BadInput([Problem("does not say of which flight it is", str(file), expected=expected)])
        source = yamlfile.parsed(about[_SCENARIO].decode(), str(file))
        scenario = scenario_from(source, with_aircraft=False)
        data = np.column_stack([np.asarray(column, dtype=float) for column in table.columns])
        contents = json_of(about[_SUMMARY].decode(), file, _KEPT)
        return flight_from(scenario, contents, tuple(table.column_names), data, file, file)
    except (ValueError, KeyError, TypeError) as error:
        problem = Problem(f"cannot be read: {error}", str(file), expected=_KEPT)
        raise BadInput([problem]) from None


def kept(folder: Path, run: int, variant: str) -> Flight | None:
    """The flight of a run and a variant's label if its log was kept; None also for one made by the user's function, which has no
    actuators."""
    file = log_file(folder, run, variant)
    flight = read(file) if file.is_file() else None
    return flight if flight is not None and flight.actuators else None


def run_and_label(name: str) -> tuple[int, str]:
    """The run and the label of the variant of a kept log, from its name; "" where nothing is compared."""
    if name.isdecimal():
        return int(name), ""
    found = _LABEL.fullmatch(name)
    return (int(found[1]), found[2] or "") if found else (0, "")


def _placeless(scenario: Scenario) -> Scenario:
    """The scenario with its aircraft's name in place of its folder, which is another one on each machine of a cluster."""
    aircraft = scenario.aircraft
    if isinstance(aircraft, str):
        return scenario.model_copy(update={"aircraft": Path(aircraft).name})
    return scenario.model_copy(
        update={"aircraft": aircraft.model_copy(update={"name": Path(aircraft.name).name})}
    )


def file_of(folder: Path) -> Path:
    """The file of the study in a folder that keeps logs: matrix.yaml of a matrix, else sweep.yaml."""
    matrix = folder / "matrix.yaml"
    return matrix if matrix.is_file() else folder / "sweep.yaml"


def runs_of(folder: Path) -> int | None:
    """Number of runs in the sweep.yaml of a folder; None if there is none. Raises BadInput if the file does not say."""
    file = folder / "sweep.yaml"
    return runs_in(yamlfile.read(file)) if os.path.isfile(file) else None


def runs_in(source: Source) -> int:
    """The number of runs that a folder's sweep.yaml says; raises BadInput if it does not say one."""
    runs = source.tree.get("runs")
    if not isinstance(runs, int) or isinstance(runs, bool) or runs < 1:
        raise BadInput([source.problem(("runs",), f"is {describe(runs)}", "the number of runs, at least 1")])
    return runs


def flight_label(run: int, variant: str) -> str:
    """The flight of a run and the label of its variant in file names: `run-000012-adaptive_inversion`."""
    return f"run-{run:06d}" + (f"-{in_file_names(variant)}" if variant else "")


def log_file(folder: Path, run: int, variant: str) -> Path:
    """Where the log of a flight is kept."""
    return folder / "logs" / f"{flight_label(run, variant)}.parquet"


def in_file_names(label: str) -> str:
    """The label of a variant as file names have it."""
    return "".join(c if c.isalnum() or c in "_-." else "-" for c in label)


HISTORY_CHANNELS = {
    "altitude_error_m": ("altitude_m", "altitude_command_m"),
    "heading_error_deg": ("heading_deg", "heading_command_deg"),
    "airspeed_error_m_s": ("airspeed_m_s", "airspeed_command_m_s"),
}
"""Name of the error: (signal, its reference), both columns of the log."""
HISTORY_POINTS = 200
"""Of each error, at equal intervals of time."""
HISTORY_SHAPE = (len(HISTORY_CHANNELS), HISTORY_POINTS)
HISTORY_BYTES = 4 * len(HISTORY_CHANNELS) * HISTORY_POINTS


def history_times_s(duration_s: float) -> np.ndarray:
    """[HISTORY_POINTS] times of the points [s] in a flight of this duration [s]."""
    return np.arange(HISTORY_POINTS) * (duration_s / HISTORY_POINTS)


def history(flight: Flight) -> bytes:
    """A flight's history: [channels, points] little-endian float32, in their units; NaN after the flight's end."""
    result = np.full(HISTORY_SHAPE, np.nan, dtype="<f4")
    if len(flight.data):
        column = {name: flight.data[:, j] for j, name in enumerate(flight.columns)}
        rows = np.searchsorted(column["time_s"], history_times_s(flight.scenario.duration_s) - 1e-9)
        rows = rows[rows < len(flight.data)]
        for j, (signal, command) in enumerate(HISTORY_CHANNELS.values()):
            error = column[signal][rows] - column[command][rows]
            if signal.startswith("heading"):
                error = wrap_deg(error)
            result[j, : len(rows)] = error
    return result.tobytes()


def read_histories(folder: Path, flights: np.ndarray) -> np.ndarray:
    """[flights, channels, points] histories of a sweep's flights with these numbers; NaN for those that it does not have."""
    result = np.full((len(flights), *HISTORY_SHAPE), np.nan, dtype=np.float32)
    if store.exists(folder):
        with store.reading(folder) as stored:
            for row, k in enumerate(flights.tolist()):
                if len(data := stored.history(key_of(k))) == HISTORY_BYTES:
                    result[row] = np.frombuffer(data, "<f4").reshape(HISTORY_SHAPE)
    return result

"""How file names tell the flights of a sweep or a matrix apart, and which of them a folder has. All workers import this module."""

from __future__ import annotations

import os
from pathlib import Path

from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.problems import BadInput
from testbed.inputs.yaml_source import Source, describe


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

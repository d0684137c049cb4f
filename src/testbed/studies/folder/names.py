"""How file names tell the flights of a sweep or a matrix apart."""

from __future__ import annotations

from pathlib import Path

from testbed.studies.plan import Plan


def file_of(folder: Path) -> Path:
    """The file of the study in a folder that keeps logs: matrix.yaml of a matrix, else sweep.yaml."""
    matrix = folder / "matrix.yaml"
    return matrix if matrix.is_file() else folder / "sweep.yaml"


def flight_label(plan: Plan, k: int) -> str:
    """Flight k in file names: `run-000012-adaptive_inversion`."""
    run, variant = divmod(k, len(plan.variants))
    label = in_file_names(plan.variants[variant].label)
    return f"run-{run:06d}" + (f"-{label}" if label else "")


def log_file(folder: Path, plan: Plan, k: int) -> Path:
    """Where the log of flight k is kept."""
    return folder / "logs" / f"{flight_label(plan, k)}.parquet"


def in_file_names(label: str) -> str:
    """The label of a variant as file names have it."""
    return "".join(c if c.isalnum() or c in "_-." else "-" for c in label)

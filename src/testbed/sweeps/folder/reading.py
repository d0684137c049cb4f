"""A sweep's folder as a DataFrame; needs no simulator, and reads unfinished ones too."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.inputs.problems import BadInput, Problem
from testbed.sweeps.folder import results
from testbed.sweeps.folder.journal import records
from testbed.sweeps.plan import Plan, load_sweep

if TYPE_CHECKING:
    import pandas as pd

_UNITS = {
    "_deg_s2": "deg/s^2", "_m_s2": "m/s^2", "_deg_s": "deg/s", "_m_s": "m/s", "_deg": "deg", "_rad": "rad",
    "_hz": "Hz", "_m": "m", "_s": "s", "_n": "N", "_percent": "%",
}  # fmt: skip


def is_sweep_folder(folder: str | Path) -> bool:
    """Whether a folder is a sweep's, finished or not."""
    return (Path(folder) / "sweep.yaml").is_file()


def load(folder: str | Path) -> pd.DataFrame:
    """The table of a sweep folder, a row a flight, with dtypes; `attrs["units"]` has each column's unit.

    Of an unfinished sweep, the flights that have finished. Raises BadInput when it is not a sweep folder.
    """
    folder = Path(folder)
    plan = load_plan(folder)
    try:
        frame = _finished(folder) if (folder / "results.parquet").is_file() else _unfinished(plan, folder)
    except (OSError, ValueError) as error:  # pyarrow's errors are ValueErrors
        problem = Problem(f"cannot be read: {error}", str(folder), expected="a sweep folder")
        raise BadInput([problem]) from None
    for name in ["outcome", *plan.sweep.compare]:
        frame[name] = frame[name].astype("category")
    frame.attrs["units"] = {name: unit(name) for name in frame.columns}
    frame.attrs["folder"] = str(folder)
    return frame


def load_plan(folder: Path) -> Plan:
    """The sweep of a folder; raises BadInput when there is none."""
    if not is_sweep_folder(folder):
        raise BadInput([Problem("is missing from the sweep folder", str(folder / "sweep.yaml"))])
    return load_sweep(folder / "sweep.yaml")


def finished(plan: Plan, folder: Path) -> list[Mapping[str, Any]]:
    """What the journal has, in the order of runs; read without locking, beside a sweep being flown."""
    return sorted(_flights(folder), key=lambda record: (record["run"], record["variant"]))


def unit(column: str) -> str:
    """Unit of a column by the end of its name; "" when it has none."""
    last = column.rpartition(".")[2]
    return next((unit for ending, unit in _UNITS.items() if last.endswith(ending)), "")


def _flights(folder: Path) -> Iterator[Mapping[str, Any]]:
    file = folder / "journal.jsonl"
    if file.is_file():
        latest = {(r["run"], r["variant"]): r for _, r in records(file) if "run" in r}
        yield from latest.values()


def _finished(folder: Path) -> pd.DataFrame:
    import pandas as pd

    return pd.read_parquet(folder / "results.parquet")


def _unfinished(plan: Plan, folder: Path) -> pd.DataFrame:
    import pandas as pd

    kept = finished(plan, folder)
    kinds = results.columns(plan, kept)
    dtypes = {bool: "bool", int: "int64", float: "float64", str: "str"}
    frame = pd.DataFrame(list(results.rows(plan, kept)), columns=list(kinds))
    return frame.astype({n: dtypes[k] for n, k in kinds.items() if k in (float, str)})

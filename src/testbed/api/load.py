"""Read any folder that the testbed wrote: one flight, a sweep or a search."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.inputs.problems import BadInput, Problem

if TYPE_CHECKING:
    import pandas as pd

    from testbed.reporting.flight import ReportedFlight


def load(folder: str | Path) -> ReportedFlight | pd.DataFrame:
    """Read a run folder as a Flight, or a sweep or search folder as a DataFrame with a row for each flight.

    A flight of a sweep whose log was kept is read as a Flight, too: `SWEEP/logs/run-000017-pid.parquet`, or `SWEEP/17` for
    short where only one variant's log was kept.

    A sweep's table has `plot(figure)`, which draws the sweep's figures: `probabilities`, `map`, ... Its `attrs` hold `name`,
    `folder`, `summary` (a sentence) and `units` (of each column). Needs neither the simulator nor, for a run folder, the
    aircraft. Raises BadInput when the folder is none of these, or the search has not finished.
    """
    if names_kept_log(folder):
        return _kept_flight(folder)
    if is_search_folder(folder):
        import pandas as pd

        return pd.read_parquet(Path(folder) / "results.parquet")
    if is_sweep_folder(folder):
        from testbed.studies.folder import reading
        from testbed.study_reports.sweep.table import table_of

        return table_of(reading.load(folder))
    return _flown_alone(folder)


def is_search_folder(folder: str | Path) -> bool:
    """Whether it is the folder of a search; raises BadInput when it is, but the search has not finished."""
    if not os.path.isfile(Path(folder) / "search.yaml"):
        return False
    if not os.path.isfile(Path(folder) / "results.parquet"):
        expected = "`testbed search --resume` first"
        raise BadInput([Problem("the search has not finished", str(folder), expected=expected)])
    return True


def is_sweep_folder(folder: str | Path) -> bool:
    """True for a sweep folder, False for a run folder; raises BadInput when the folder is neither."""
    folder = Path(folder)
    if not os.path.isdir(folder):
        what = "is a file" if os.path.exists(folder) else "there is no such folder"
        raise BadInput([Problem(what, str(folder), expected="the folder of a run, a sweep or a search")])
    if (folder / "sweep.yaml").is_file():
        return True
    if not any((folder / name).is_file() for name in ("scenario.yaml", "summary.json", "log.csv")):
        expected = "scenario.yaml, summary.json and log.csv of a run, sweep.yaml of a sweep, or search.yaml of a search"
        what = "is the folder neither of a run nor of a sweep or a search"
        raise BadInput([Problem(what, str(folder), expected=expected)])
    return False


def names_kept_log(path: str | Path) -> bool:
    """Whether a path is a log that a sweep kept, or names a run of a sweep, as `SWEEP/17`."""
    path = Path(path)
    if not (path.suffix == ".parquet" or os.path.isfile(path.parent / "sweep.yaml")):
        return False  # quickly, as most paths are folders of runs
    from testbed.studies.folder import logs

    return logs.is_kept(path)


def load_flight(path: str | Path) -> ReportedFlight:
    """Read a run folder or a kept log of a sweep; raises BadInput when it is a sweep, a search, or neither."""
    if names_kept_log(path):
        return _kept_flight(path)
    if os.path.isfile(Path(path) / "search.yaml"):
        expected = "the folder of a flight in it, such as SEARCH/found"
        raise BadInput([Problem("is a search folder", str(path), expected=expected)])
    if is_sweep_folder(path):
        expected = "a run folder, or a flight of the sweep such as SWEEP/17"
        raise BadInput([Problem("is a sweep folder", str(path), expected=expected)])
    return _flown_alone(path)


def _kept_flight(path: str | Path) -> ReportedFlight:
    from testbed.reporting.flight import ReportedFlight
    from testbed.studies.folder import logs

    return ReportedFlight.of(logs.load(path))


def _flown_alone(folder: str | Path) -> ReportedFlight:
    from testbed.flight import folder as run_folder
    from testbed.reporting.flight import ReportedFlight

    return ReportedFlight.of(run_folder.load(folder))

"""Read any folder that the testbed wrote: one flight, a sweep or a search."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.received import read_frame, refuse_links

if TYPE_CHECKING:
    import pandas as pd

    from testbed.reporting.flight import ReportedFlight

STUDIES = ("sweep", "search", "matrix", "benchmark")
"""The kinds of studies, each a module of this package. The folder of one has a file of this name, with .yaml."""

KEEP_LOGS = ("sweep", "matrix")
"""Those whose flights can be told one by one: logs are kept, in order of runs, as is a table."""


def load(folder: str | Path) -> ReportedFlight | pd.DataFrame:
    """Read a run folder as a Flight, or the folder of a study as a DataFrame with a row for each flight.

    A flight of a sweep whose log was kept is read as a Flight, too: `SWEEP/logs/run-000017-pid.parquet`, or `SWEEP/17` for
    short where only one variant's log was kept.

    A sweep's table has `plot(figure)`, which draws the sweep's figures: `probabilities`, `map`, ... Its `attrs` hold `name`,
    `folder`, `summary` (a sentence) and `units` (of each column). Needs neither the simulator nor, for a run folder, the
    aircraft. Raises BadInput when the folder is none of these, or a search or matrix that has not finished.
    """
    kind = kind_of(folder)
    if kind in ("search", "matrix"):
        refuse_unfinished(folder)
        refuse_links(Path(folder))
        return read_frame(Path(folder) / "results.parquet", ("run", "outcome"), f"the table of a {kind}")
    if kind == "benchmark":
        from testbed.api import benchmark

        refuse_links(Path(folder))
        return benchmark.table(folder)
    if kind == "sweep":
        from testbed.studies.folder import table
        from testbed.study_reports.sweep.table import table_of

        return table_of(table.load(folder))
    return load_flight(folder)


def load_flight(path: str | Path) -> ReportedFlight:
    """Read a run folder or a kept log of a sweep; raises BadInput when it is a sweep, a search, or neither."""
    from testbed.flight import folder as run_folder
    from testbed.reporting.flight import ReportedFlight

    kind = kind_of(path)
    if kind == "log":
        from testbed.studies.folder import logs

        return ReportedFlight.of(logs.load(path))
    if kind != "run":
        which = "a run folder, or a flight of the sweep such as SWEEP/17"
        expected = which if kind == "sweep" else "the folder of a flight in it, such as SEARCH/found"
        raise BadInput([Problem(f"is a {kind} folder", str(path), expected=expected)])
    return ReportedFlight.of(run_folder.load(path))


def kind_of(path: str | Path) -> str:
    """What a path names: `run`, `sweep`, `search`, or `log`, a flight whose log a sweep kept. Raises BadInput when it is none."""
    path = Path(path)
    if path.suffix == ".parquet" or any(os.path.isfile(path.parent / f"{kind}.yaml") for kind in KEEP_LOGS):
        from testbed.studies.folder import logs  # only here, as most paths are folders of runs

        if logs.is_kept(path):
            return "log"
    if not os.path.isdir(path):
        what = "is a file" if os.path.exists(path) else "there is no such folder"
        raise BadInput([Problem(what, str(path), expected="the folder of a run, a sweep or a search")])
    for kind in STUDIES:
        if (path / f"{kind}.yaml").is_file():
            return kind
    if not any((path / name).is_file() for name in ("scenario.yaml", "summary.json", "log.csv")):
        expected = "scenario.yaml, summary.json and log.csv of a run, sweep.yaml of a sweep, or search.yaml of a search"
        what = "is the folder neither of a run nor of a sweep or a search"
        raise BadInput([Problem(what, str(path), expected=expected)])
    return "run"


def refuse_unfinished(folder: str | Path) -> None:
    """Raise BadInput when a search or a matrix has not finished."""
    from testbed.studies.folder.table import is_finished

    if not is_finished(Path(folder)):
        kind = kind_of(folder)
        expected = f"`testbed {kind} --resume` first"
        raise BadInput([Problem(f"the {kind} has not finished", str(folder), expected=expected)])

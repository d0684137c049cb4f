"""Read any folder that the testbed wrote: one flight or a sweep."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.inputs.problems import BadInput, Problem

if TYPE_CHECKING:
    import pandas as pd

    from testbed.flight.flight import Flight


def load(folder: str | Path) -> Flight | pd.DataFrame:
    """Read a run folder as a Flight, or a sweep folder as a DataFrame with a row for each flight.

    The table's `plot(figure)` draws the sweep's figures: `probabilities`, `survival`, ... Its `attrs` hold `name`, `folder`,
    `summary` (a sentence) and `units` (of each column). Needs neither the simulator nor, for a run folder, the aircraft.
    Raises BadInput when the folder is neither a run nor a sweep.
    """
    if is_sweep_folder(folder):
        from testbed.reporting.sweep_table import table_of
        from testbed.sweeps.folder import reading

        return table_of(reading.load(folder))
    from testbed.flight import folder as run_folder

    return run_folder.load(folder)


def is_sweep_folder(folder: str | Path) -> bool:
    """True for a sweep folder, False for a run folder; raises BadInput when the folder is neither."""
    folder = Path(folder)
    if not os.path.isdir(folder):
        what = "is a file" if os.path.exists(folder) else "there is no such folder"
        raise BadInput([Problem(what, str(folder), expected="a run folder or a sweep folder")])
    if (folder / "sweep.yaml").is_file():
        return True
    if not any((folder / name).is_file() for name in ("scenario.yaml", "summary.json", "log.csv")):
        expected = "scenario.yaml, summary.json and log.csv in a run folder, or sweep.yaml in a sweep folder"
        raise BadInput(
            [Problem("is neither a run folder nor a sweep folder", str(folder), expected=expected)]
        )
    return False

"""One function reads whatever folder the testbed wrote."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pandas as pd

    from testbed.flight.flight import Flight


def load(folder: str | Path) -> Flight | pd.DataFrame:
    """A run folder as a Flight, a sweep folder as the DataFrame of its results.

    Needs neither the simulator nor the aircraft of a run. Raises BadInput when the folder is neither.
    """
    if (Path(folder) / "sweep.yaml").is_file():
        from testbed.sweeps.folder import reading

        return reading.load(folder)
    from testbed.flight import folder as run_folder

    return run_folder.load(folder)

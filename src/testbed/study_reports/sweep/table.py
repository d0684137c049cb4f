"""The table of a sweep as users get it: a DataFrame that begins with its sentence in a notebook, and draws its figures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pandas as pd
from pandas.plotting import PlotAccessor

from testbed.inputs.problems import BadInput, Problem, guess
from testbed.reporting.html import Html, joined, tag
from testbed.studies.folder.table import load_plan


class SweepTable(pd.DataFrame):
    """The table of a sweep folder (see `testbed.load`). What is selected from it is an ordinary DataFrame."""

    @property
    def plot(self) -> SweepPlot:  # type: ignore[override]
        """`plot()` and `plot("map")` draw the sweep's figures; with other arguments, pandas does."""
        return SweepPlot(self)

    def _repr_html_(self) -> str | None:
        """What a notebook shows: the sentence, then the table."""
        table = Html(super()._repr_html_())  # type: ignore[misc]
        return joined([tag("p", str(self.attrs.get("summary", ""))), table])


class SweepPlot(PlotAccessor):
    """pandas's accessor `plot`, which also knows the figures of a sweep by their names."""

    def __call__(self, name: str | None = "probabilities", *args: Any, **options: Any) -> Any:
        """The figure of this name, as a matplotlib Figure; None if these flights do not have it. Raises BadInput for another name.

        With any further argument it is pandas's own `DataFrame.plot`.
        """
        if args or options:
            return super().__call__(*(() if name == "probabilities" else (name,)), *args, **options)
        from testbed.study_reports.sweep.figures import TABLE

        if name not in TABLE:
            raise BadInput([Problem(f"is no figure: {name}", "plot", None, "", *guess(str(name), TABLE))])
        frame: pd.DataFrame = self._parent  # type: ignore[attr-defined]
        folder = Path(frame.attrs["folder"])
        return TABLE[name](load_plan(folder), pd.DataFrame(frame), folder)


def table_of(frame: pd.DataFrame) -> SweepTable:
    """The table that `studies.folder.table` has read, for users."""
    table = SweepTable(frame)
    table.attrs |= frame.attrs
    return table

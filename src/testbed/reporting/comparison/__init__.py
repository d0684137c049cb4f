"""Flights side by side: what differs between them, from which step on, and by how much."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.flight.flight import Flight
from testbed.inputs.problems import BadInput, Problem
from testbed.reporting.comparison.differences import (
    FirstDifference,
    Setting,
    first_difference,
    names_of,
    settings,
)

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["MOST", "Comparison", "compare"]

MOST = 6
"""Most flights in one comparison."""


class Comparison:
    """Flights side by side, each with a name. The first is the one that the others are compared with."""

    def __init__(self, flights: Sequence[Flight]) -> None:
        self.flights = tuple(flights)
        self.names = names_of(self.flights)

    @property
    def settings(self) -> list[Setting]:
        """What the scenarios have that differs: {path, values}, a value for each flight."""
        return settings(self.flights)

    @property
    def first_differences(self) -> list[FirstDifference]:
        """Where the log of each other flight first differs from that of the first."""
        return [first_difference(self.flights[0], flight) for flight in self.flights[1:]]

    @property
    def metrics(self) -> pd.DataFrame:
        """The metrics, a row for each, with a column for each flight."""
        import pandas as pd

        named = zip(self.names, self.flights, strict=True)
        return pd.DataFrame({name: dict(flight.metrics) for name, flight in named})

    def __repr__(self) -> str:
        from testbed.reporting.comparison.page import sentences

        return "\n".join(sentences(self))

    def _repr_html_(self) -> str:
        """What a notebook shows: the sentences, and the metrics that differ."""
        from testbed.reporting.comparison.page import summary

        return summary(self)

    def write(self, file: str | Path) -> Path:
        """Write the page of the comparison; returns its file. Raises OSError when it cannot be written."""
        from testbed.reporting.comparison.page import write

        return write(self, Path(file))


def compare(flights: Sequence[Flight], out: str | Path | None = None) -> Comparison:
    """Compare two to six flights, as `testbed.fly` and `testbed.load` give them. The first is the one compared with.

    Args:
        flights: the flights.
        out: page to write, an HTML file; None for none.

    Raises BadInput for fewer than two flights, or more than six.
    """
    if not 2 <= len(flights) <= MOST:
        raise BadInput([Problem(f"compares {len(flights)}", "flights", expected=f"from 2 to {MOST}")])
    comparison = Comparison(flights)
    if out is not None:
        comparison.write(out)
    return comparison

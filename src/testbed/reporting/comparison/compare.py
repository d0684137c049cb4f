"""Compare flights: sentences in a terminal and a notebook, and a page."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from string import ascii_uppercase
from typing import TYPE_CHECKING

from testbed.common.text import printable
from testbed.flight.flight import Flight
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.yaml_source import describe
from testbed.reporting.comparison import page
from testbed.reporting.comparison.differences import (
    FirstDifference,
    Setting,
    first_difference,
    names_of,
    settings,
)

if TYPE_CHECKING:
    import pandas as pd

MOST = 6
"""Most flights in one comparison."""
_MOST_LETTERS = 80  # of all names together, that one line or the heads of a table can take


class Comparison:
    """Flights side by side, each with a name. The first is the one that the others are compared with.

    Attributes:
        names: what tells each flight from the others.
        keys: the same, short: letters, with which the names begin then, where the names are long together.
    """

    def __init__(
        self, flights: Sequence[Flight], names: Sequence[str] | None = None, folders: Sequence[str] = ()
    ) -> None:
        """Without `names` each flight is named by what is different about it, else by its folder if those are given."""
        self.flights = tuple(flights)
        own = names_of(self.flights, folders) if names is None else list(names)
        long = len(own) > 2 and sum(map(len, own)) > _MOST_LETTERS
        self.keys = list(ascii_uppercase[: len(own)]) if long else own
        self.names = [f"{key}: {name}" for key, name in zip(self.keys, own, strict=True)] if long else own

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

        named = zip(self.keys, self.flights, strict=True)
        return pd.DataFrame({name: dict(flight.metrics) for name, flight in named})

    def __repr__(self) -> str:
        return printable("\n".join(page.sentences(self)))

    def _repr_html_(self) -> str:
        """What a notebook shows: the sentences, and the metrics that differ."""
        return page.summary(self)

    def write(self, file: str | Path) -> Path:
        """Write the page of the comparison; returns its file. Raises OSError when it cannot be written."""
        return page.write(self, Path(file))


def compare(flights: Sequence[Flight], out: str | Path | None = None) -> Comparison:
    """Compare two to six flights, as `testbed.fly` and `testbed.load` give them. The first is the one compared with.

    Args:
        flights: the flights.
        out: page to write, an HTML file; None for none.

    Raises BadInput for fewer than two flights, or more than six, or what is no flight.
    """
    if not 2 <= len(flights) <= MOST:
        raise BadInput([Problem(f"compares {len(flights)}", "flights", expected=f"from 2 to {MOST}")])
    for i, flight in enumerate(flights):
        if not isinstance(flight, Flight):
            expected = "a flight, as `testbed.fly` and `testbed.load` give it"
            raise BadInput([Problem(f"is {describe(flight)}", path=f"flights.{i}", expected=expected)])
    comparison = Comparison(flights)
    if out is not None:
        comparison.write(out)
    return comparison

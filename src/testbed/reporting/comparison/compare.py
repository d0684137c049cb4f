"""Compare flights: what differs between their scenarios and, step by step, their logs; in a terminal, a notebook and a page."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from testbed.common.text import printable
from testbed.flight.flight import Flight
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.yaml_source import describe
from testbed.reporting import html
from testbed.reporting.comparison import page
from testbed.reporting.comparison.differences import Compared

MOST = 6
"""Most flights in one comparison."""


class Comparison(Compared):
    """Flights side by side, each with a name: as text, in a notebook, and as a page."""

    def __repr__(self) -> str:
        return printable("\n".join(page.sentences(self)))

    def _repr_html_(self) -> str:
        """What a notebook shows: the sentences, and the metrics that differ."""
        return html.joined([html.listed(page.sentences(self), "story"), page.metrics(self)])

    def write(self, file: str | Path) -> Path:
        """Write the page of the comparison; returns its file. Raises OSError when it cannot be written."""
        from testbed.reporting.comparison.figure import picture

        return page.write(self, Path(file), picture(self))


def compare(flights: Sequence[Flight], out: str | Path | None = None) -> Comparison:
    """Compare two to six flights, as `testbed.fly` and `testbed.load` give them. The first is the one compared with.

    `out` is a page to write, an HTML file. Raises BadInput for fewer than two flights, or more than six, or what is no flight.
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

"""Numbers that say how well a controller did in a flight, computed from the log and the events.

A metric is a function of the flight's `Readings`, and has the name of that function. The name ends in the unit; counts and
ratios have none. The first line of the docstring is its definition, which `list` and the report print. A metric that has
no value in a flight is NaN, such as a detection delay without a detection.

A new metric is one function in the module of its subject, and its name in that module's TABLE.
"""

from __future__ import annotations

from collections.abc import Callable

from testbed.metrics import effort, estimation, monitoring, tracking
from testbed.metrics.flight_view import Readings, adaptation_rates, readings

__all__ = ["TABLE", "Metric", "Readings", "adaptation_rates", "measure", "readings"]

Metric = Callable[[Readings], float]

TABLE: dict[str, Metric] = {
    function.__name__: function
    for function in (*tracking.TABLE, *monitoring.TABLE, *estimation.TABLE, *effort.TABLE)
}


def measure(readings: Readings) -> dict[str, float]:
    """The value of every metric in TABLE for one flight, by name."""
    return {name: metric(readings) for name, metric in TABLE.items()}
